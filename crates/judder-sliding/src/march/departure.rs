//! Why a contact is far from where it should be: at an end of the track, lifted off, or carried away by growth without bound.

use super::March;
use crate::SlidingError;
use crate::edge::{EdgePoint, RunOff};
use crate::plane::{PlaneVector, length, minus, plus};

/// Share of its way that growth without bound covers in a step; what flies freely, or slides, takes many more.
const LEAP: f64 = 1e-3;
/// Share of the track's length within which deformation carries C beyond an end.
const NEAR: f64 = 0.05;

impl March<'_> {
    /// Why there is a gap beyond all measure.
    #[cold]
    pub(super) fn away(&self, gap: f64, position: f64) -> SlidingError {
        let is_free = self.force == [0.0; 2] && gap > 0.0;
        // no comparison holds of a number that is none
        if is_free && self.leap() < LEAP * gap {
            SlidingError::LiftedOff { position, gap }
        } else {
            SlidingError::NotFinite { step: self.steps + 1, position }
        }
    }

    /// What it means that C is beyond an end of the track while its frame is where it is.
    #[cold]
    pub(super) fn beyond(
        &self,
        end: RunOff,
        position: f64,
        rigid: PlaneVector,
    ) -> Result<RunOff, SlidingError> {
        let track = self.pair.length();
        let (left, fraction) = match end {
            RunOff::First => (position, 0.0),
            RunOff::Last => (track - position, 1.0),
        };
        if left < NEAR * track && self.leap() < LEAP * track {
            return Ok(end);
        }
        let point = plus(rigid, 1.0, self.contact[1]);
        let at = EdgePoint { segment: self.view.segment, fraction };
        let touch = self.pair.edge().touch_at(point, at, &self.view.displaced(&self.view.predicted));
        Err(self.away(touch.gap, position))
    }

    /// How far C or a node of the track moves in this step, m.
    fn leap(&self) -> f64 {
        let [now, predicted] = self.contact;
        let nodes = self.view.predicted.iter().zip(&self.view.now).map(|(next, now)| minus(*next, *now));
        nodes.chain([minus(predicted, now)]).map(length).fold(0.0, f64::max)
    }
}
