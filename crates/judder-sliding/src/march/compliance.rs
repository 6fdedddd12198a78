//! What a contact force does at once where it acts and where it is watched.

use crate::edge::{STENCIL, Touch};
use crate::pair::{Pair, PairSide};
use crate::plane::{PlaneVector, dot};

/// A matrix of the plane by rows.
pub(super) type PlaneMatrix = [PlaneVector; 2];

/// Neighbours of a node that a stencil can pair it with.
const NEIGHBOURS: usize = STENCIL;

/// Displacements by unit forces, m/N: Σ g φ φᵀ over the modes, where g is what a unit modal force does to its mode at once.
#[derive(Debug, Clone)]
pub(super) struct ModalCompliance {
    /// Of C by a force at C.
    contact: PlaneMatrix,
    /// Of node k by a force at node k + j.
    nodes: Vec<[PlaneMatrix; NEIGHBOURS]>,
    /// Of each observed displacement by a force at C, or at each node.
    observed: Vec<Vec<PlaneVector>>,
}

/// The blocks of one stencil.
#[derive(Debug, Clone, Copy)]
pub(super) struct StencilCompliance {
    count: usize,
    blocks: [[PlaneMatrix; STENCIL]; STENCIL],
}

impl ModalCompliance {
    /// With the factors g of all modes, those of the slider first.
    pub(super) fn new(pair: &Pair, factors: &[f64]) -> Self {
        let (of_slider, of_track) = factors.split_at(pair.slider().body.modes());
        let contact = &pair.slider().contact.rows;
        let nodes = &pair.track().nodes;
        let pairs = |k: usize| {
            std::array::from_fn(|j| match nodes.get(k + j) {
                Some(other) => block(&nodes[k].rows, &other.rows, of_track),
                None => [[0.0; 2]; 2],
            })
        };
        let observed = |point: &crate::pair::Observed| match point.side {
            PairSide::Slider => vec![[0, 1].map(|j| sum(&point.row, &contact[j], of_slider))],
            PairSide::Track => {
                nodes.iter().map(|node| [0, 1].map(|j| sum(&point.row, &node.rows[j], of_track))).collect()
            }
        };
        Self {
            contact: block(contact, contact, of_slider),
            nodes: (0..nodes.len()).map(pairs).collect(),
            observed: pair.observed().iter().map(observed).collect(),
        }
    }

    /// The blocks of a stencil of so many nodes.
    pub(super) fn stencil(&self, first: usize, count: usize) -> StencilCompliance {
        let entry = |i: usize, j: usize| {
            if i.max(j) >= count {
                [[0.0; 2]; 2]
            } else if j >= i {
                self.nodes[first + i][j - i]
            } else {
                let [[a, b], [c, d]] = self.nodes[first + j][i - j];
                [[a, c], [b, d]]
            }
        };
        StencilCompliance { count, blocks: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))) }
    }

    /// Displacement of C by a force at C.
    #[inline]
    pub(super) fn of_contact(&self, force: PlaneVector) -> PlaneVector {
        times(&self.contact, force)
    }

    /// What an observed displacement gains by the contact's force on the slider; the track feels its opposite.
    #[inline]
    pub(super) fn of_observed(
        &self,
        number: usize,
        first: usize,
        count: usize,
        touch: &Touch,
        force: PlaneVector,
    ) -> f64 {
        let along = |row: &PlaneVector| row[0] * force[0] + row[1] * force[1];
        match &self.observed[number][..] {
            [own] => along(own),
            nodes => -nodes[first..first + count]
                .iter()
                .zip(&touch.weights.value)
                .map(|(row, w)| w * along(row))
                .sum::<f64>(),
        }
    }

    /// What an observed displacement of the slider gains by a force on C alone; nothing where it is one of the track.
    #[inline]
    pub(super) fn of_observed_on_slider(&self, number: usize, force: PlaneVector) -> f64 {
        match &self.observed[number][..] {
            [own] => own[0] * force[0] + own[1] * force[1],
            _ => 0.0,
        }
    }

    /// What opens between C and the track's point by a unit force between them: a matrix of the plane.
    #[inline]
    pub(super) fn between(&self, stencil: &StencilCompliance, weights: &[f64; STENCIL]) -> PlaneMatrix {
        let mut sum = self.contact;
        for i in 0..stencil.count {
            for j in 0..stencil.count {
                let weight = weights[i] * weights[j];
                for (sum, block) in sum.as_flattened_mut().iter_mut().zip(stencil.blocks[i][j].as_flattened())
                {
                    *sum += weight * block;
                }
            }
        }
        sum
    }
}

impl StencilCompliance {
    /// What each node gains by the contact's force on the slider, whose opposite acts on the track.
    #[inline]
    pub(super) fn of_nodes(&self, weights: &[f64; STENCIL], force: PlaneVector) -> [PlaneVector; STENCIL] {
        let mut moved = [[0.0; 2]; STENCIL];
        for (i, moved) in moved.iter_mut().enumerate().take(self.count) {
            for (block, weight) in self.blocks[i].iter().zip(weights).take(self.count) {
                let own = times(block, force);
                moved[0] -= weight * own[0];
                moved[1] -= weight * own[1];
            }
        }
        moved
    }
}

#[inline(always)]
pub(super) fn times(block: &PlaneMatrix, v: PlaneVector) -> PlaneVector {
    [block[0][0] * v[0] + block[0][1] * v[1], block[1][0] * v[0] + block[1][1] * v[1]]
}

fn sum(a: &[f64], b: &[f64], factors: &[f64]) -> f64 {
    a.iter().zip(b).zip(factors).map(|((a, b), g)| g * a * b).sum()
}

fn block(a: &[Vec<f64>; 2], b: &[Vec<f64>; 2], factors: &[f64]) -> PlaneMatrix {
    [0, 1].map(|i| [0, 1].map(|j| sum(&a[i], &b[j], factors)))
}

/// A matrix of the plane along normal and tangent: nn, nt, tn, tt.
#[inline(always)]
pub(super) fn in_frame(between: &PlaneMatrix, touch: &Touch) -> [f64; 4] {
    let (by_normal, by_tangent) = (times(between, touch.normal), times(between, touch.tangent));
    [
        dot(touch.normal, by_normal),
        dot(touch.normal, by_tangent),
        dot(touch.tangent, by_normal),
        dot(touch.tangent, by_tangent),
    ]
}
