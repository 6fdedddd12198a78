//! What a march sees of the track: the nodes about the contact.

use super::compliance::{ModalCompliance, StencilCompliance};
use super::oscillators::{Oscillators, ROWS};
use crate::edge::STENCIL;
use crate::pair::Pair;
use crate::plane::{PlaneVector, plus};

/// The nodes of one segment's stencil, whose rows the track's modes are watched through.
#[derive(Debug, Clone)]
pub(super) struct MarchView {
    pub(super) segment: usize,
    pub(super) first: usize,
    pub(super) count: usize,
    pub(super) compliance: StencilCompliance,
    /// Undeformed.
    pub(super) places: [PlaneVector; STENCIL],
    /// Displacements now.
    pub(super) now: [PlaneVector; STENCIL],
    /// Displacements of the next step without contact.
    pub(super) predicted: [PlaneVector; STENCIL],
}

impl MarchView {
    /// Watches the track about a segment.
    pub(super) fn new(
        pair: &Pair,
        track: &mut Oscillators,
        compliance: &ModalCompliance,
        segment: usize,
    ) -> Self {
        let (first, count) = (pair.edge().first_node(segment), pair.edge().stencil_nodes());
        for (k, node) in pair.track().nodes[first..first + count].iter().enumerate() {
            track.set_row(2 * k, &node.rows[0]);
            track.set_row(2 * k + 1, &node.rows[1]);
        }
        let [now, predicted] = track.seen();
        Self {
            segment,
            first,
            count,
            compliance: compliance.stencil(first, count),
            places: pair.stencil(segment, |_| [0.0; 2]),
            now: vectors(&now, count),
            predicted: vectors(&predicted, count),
        }
    }

    /// Where the nodes are when displaced so far.
    #[inline]
    pub(super) fn displaced(&self, by: &[PlaneVector; STENCIL]) -> [PlaneVector; STENCIL] {
        std::array::from_fn(|k| plus(self.places[k], 1.0, by[k]))
    }
}

/// The displacements of a stencil among what rows see.
#[inline(always)]
pub(super) fn vectors(seen: &[f64; ROWS], count: usize) -> [PlaneVector; STENCIL] {
    std::array::from_fn(|k| if k < count { [seen[2 * k], seen[2 * k + 1]] } else { [0.0; 2] })
}
