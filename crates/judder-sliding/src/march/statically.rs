//! The deformation of steady sliding along a path, tabulated: what Subs with the static slope takes its geometry from.

use crate::SlidingError;
use crate::coupling::SteadyFriction;
use crate::pair::Pair;
use crate::plane::{PlaneVector, plus};
use crate::statics::PairEquilibrium;

/// Samples in a segment: the deformation is smooth within one.
const SAMPLES: usize = 8;

/// Displacements of C and of all nodes at sampled positions.
#[derive(Debug, Clone)]
pub(super) struct StaticPath {
    positions: Vec<f64>,
    contact: Vec<PlaneVector>,
    nodes: Vec<Vec<PlaneVector>>,
}

impl StaticPath {
    /// Between two positions, at every node and between.
    pub(super) fn new(
        pair: &Pair,
        ends: [f64; 2],
        load: f64,
        sliding: SteadyFriction,
    ) -> Result<Self, SlidingError> {
        let [from, to] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let between = |pair: &[f64]| {
            let (start, length) = (pair[0], pair[1] - pair[0]);
            (0..SAMPLES).map(move |k| start + length * k as f64 / SAMPLES as f64)
        };
        let inner = pair.node_positions().windows(2).flat_map(between).filter(|x| *x > from && *x < to);
        let positions: Vec<f64> = [from].into_iter().chain(inner).chain([to]).collect();
        let (mut contact, mut nodes) = (Vec::new(), Vec::new());
        for position in &positions {
            let rest = PairEquilibrium::new(pair, *position, load, sliding)?;
            let (of_slider, of_track) = rest.state.split_at(pair.slider().body.modes());
            contact.push(pair.slider().contact.displacement(of_slider));
            nodes.push(pair.track().nodes.iter().map(|node| node.displacement(of_track)).collect());
        }
        Ok(Self { positions, contact, nodes })
    }

    /// The sample below a position and the share of the one above.
    fn place(&self, position: f64) -> (usize, f64) {
        let last = self.positions.len() - 1;
        let below = self.positions.partition_point(|known| *known <= position).clamp(1, last) - 1;
        let width = self.positions[below + 1] - self.positions[below];
        // a held contact has a path without length
        let share =
            if width > 0.0 { ((position - self.positions[below]) / width).clamp(0.0, 1.0) } else { 0.0 };
        (below, share)
    }

    /// Displacement of C at a position.
    pub(super) fn of_contact(&self, position: f64) -> PlaneVector {
        let (below, share) = self.place(position);
        between(self.contact[below], self.contact[below + 1], share)
    }

    /// Displacement of a node at a position.
    pub(super) fn of_node(&self, position: f64, node: usize) -> PlaneVector {
        let (below, share) = self.place(position);
        between(self.nodes[below][node], self.nodes[below + 1][node], share)
    }
}

fn between(a: PlaneVector, b: PlaneVector, share: f64) -> PlaneVector {
    plus([a[0] * (1.0 - share), a[1] * (1.0 - share)], share, b)
}
