//! The edge of a track among the rows of a march.

use super::TravellingContact;
use crate::NonsmoothError;
use judder_sliding::edge::{Edge, EdgePoint, STENCIL};
use judder_sliding::plane::{PlaneVector, along_chord, dot, minus, plus, turned};

/// An edge, its nodes undeformed, and where their rows begin.
#[derive(Debug, Clone)]
pub(super) struct TravelledEdge {
    pub(super) edge: Edge,
    places: Vec<PlaneVector>,
    /// Distances of the nodes from the first along the line to the last, in m.
    arc: Vec<f64>,
    /// Unit vector along that line.
    pub(super) direction: PlaneVector,
    first_row: usize,
}

/// The nodes beside a place of an edge: the first of their rows, how many they are, their weights there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct NearNodes {
    pub(super) row: usize,
    pub(super) count: usize,
    pub(super) weights: [f64; STENCIL],
}

impl TravelledEdge {
    /// That of a contact whose normal out of the track is this.
    pub(super) fn new(
        contact: &TravellingContact,
        normal: PlaneVector,
        first_row: usize,
    ) -> Result<Self, NonsmoothError> {
        let places: Vec<PlaneVector> = contact.nodes.iter().map(|node| node.place).collect();
        let (arc, direction) = along_chord(&places)?;
        let is_left = dot(turned(direction), normal) > 0.0;
        let edge = Edge::new(contact.interpolation, places.len(), is_left);
        Ok(Self { edge, places, arc, direction, first_row })
    }

    /// The place of the undeformed edge that lies beneath another, along the line from its first node to its last; beyond an end that end.
    pub(super) fn beneath(&self, place: PlaneVector) -> EdgePoint {
        let along = dot(minus(place, self.places[0]), self.direction);
        let last = self.arc.len() - 1;
        let segment = self.arc.partition_point(|node| *node <= along).clamp(1, last) - 1;
        let fraction = (along - self.arc[segment]) / (self.arc[segment + 1] - self.arc[segment]);
        EdgePoint { segment, fraction: fraction.clamp(0.0, 1.0) }
    }

    /// Whether there is such a place.
    pub(super) fn has(&self, at: EdgePoint) -> bool {
        at.segment + 1 < self.places.len()
    }

    pub(super) fn near(&self, at: EdgePoint) -> NearNodes {
        NearNodes {
            row: self.first_row + 2 * self.edge.first_node(at.segment),
            count: self.edge.stencil_nodes(),
            weights: self.edge.weights(at).value,
        }
    }

    /// The places of a segment's nodes where these are displaced by so much.
    pub(super) fn displaced(&self, segment: usize, by: &[PlaneVector; STENCIL]) -> [PlaneVector; STENCIL] {
        let (first, count) = (self.edge.first_node(segment), self.edge.stencil_nodes());
        std::array::from_fn(|k| plus(self.places[first + k.min(count - 1)], 1.0, by[k]))
    }
}
