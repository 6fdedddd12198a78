//! Where travelling points are, for a checkpoint.

use super::Travel;
use super::forms::PointForm;
use crate::contact_problem::Delassus;
use judder_sliding::edge::EdgePoint;
use judder_sliding::plane::PlaneVector;
use serde::{Deserialize, Serialize};

/// Where a travelling point is after a step, to the bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct TravelledPoint {
    at: EdgePoint,
    directions: [PlaneVector; 2],
    imposed: [f64; 2],
    gap: f64,
}

impl Travel {
    /// Where the points are.
    pub(crate) fn kept(&self) -> Vec<TravelledPoint> {
        let kept = self.points().filter_map(|(number, own)| {
            let directions = self.forms.now(number)?.directions;
            Some(TravelledPoint { at: own.at, directions, imposed: own.imposed, gap: own.gap })
        });
        kept.collect()
    }

    /// Whether these are places of its points.
    pub(crate) fn fits(&self, kept: &[TravelledPoint]) -> bool {
        kept.len() == self.points().count()
            && self.points().zip(kept).all(|((_, own), kept)| self.edges[own.edge].has(kept.at))
    }

    /// Takes the points there, with the compliance between them.
    pub(crate) fn resume(&mut self, kept: &[TravelledPoint], delassus: &mut Delassus) {
        let Self { edges, points, forms } = self;
        let mut kept = kept.iter();
        for (number, own) in points.iter_mut().enumerate() {
            let Some(own) = own else { continue };
            let Some(kept) = kept.next() else { break };
            (own.at, own.imposed, own.gap) = (kept.at, kept.imposed, kept.gap);
            let near = edges[own.edge].near(kept.at);
            forms.next[number] = Some(PointForm { directions: kept.directions, near });
        }
        forms.go_on(delassus);
    }
}
