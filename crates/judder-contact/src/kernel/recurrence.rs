//! The wake of a loaded cell along one row, cell by cell against the direction of sliding.

use super::quadrature::{panels, product_weights, tail};
use super::substrate::SlidingSubstrate;
use judder_numerics::order::sort_numbers;
use judder_numerics::quadrature::gauss_legendre;
use std::ops::Range;
use std::sync::LazyLock;

/// Lattice values in the product rule of a cell; half of them on either side of its middle.
const STENCIL: usize = 12;
/// Of these, the ones before the cell.
const BEFORE: usize = STENCIL / 2 - 1;
/// Nodes of the product rule of a cell that is too near for lattice values.
const NODES: usize = 10;
/// The nodes' places in the cell.
static CELL_NODES: LazyLock<[f64; NODES]> = LazyLock::new(|| gauss_legendre().map(|(node, _)| node));
/// Distance within which the lattice is too coarse for the stencil: its error is 26000/r¹² at distance r.
const NEAR: f64 = 22.0;
/// Distance along x, and row, within which only graded panels follow the displacement.
const CLOSE: (f64, f64) = (4.0, 3.0);
/// Ratio of neighbouring panels towards an edge of the loaded cell, and their number.
const GRADING: (f64, i32) = (0.3, 10);
/// Distance upstream where the recurrence starts at the latest, so that the tail is smooth.
const TAIL: f64 = 8.0;

/// A row of places at unit distance, with the elastic displacement wherever the wakes of all terms need it.
pub(crate) struct WakeRow<F> {
    displacement: F,
    first: f64,
    y: f64,
    /// Places of the recurrence: those of the row, and more where the row ends near the loaded cell.
    count: usize,
    /// Displacements at first − BEFORE + index.
    lattice: Vec<f64>,
    near: Range<usize>,
    at_nodes: Vec<f64>,
}

impl<F: Fn(f64) -> f64> WakeRow<F> {
    /// The row at `y` whose `places` start at x = `first`; `fill` writes displacements at x, x + 1, …, `displacement`
    /// gives it anywhere. Lengths in cells, the loaded cell at the origin.
    pub(crate) fn new(
        first: f64,
        places: usize,
        y: f64,
        displacement: F,
        fill: impl Fn(f64, &mut [f64]),
    ) -> Self {
        let count = places.max((TAIL - first).ceil().max(0.0) as usize + 1);
        let mut lattice = vec![0.0; count + STENCIL];
        fill(first - BEFORE as f64, &mut lattice);
        let within = |x: f64| ((x - first - 0.5).ceil().max(0.0) as usize).min(count - 1);
        let near = if y <= NEAR { within(-NEAR)..within(NEAR) } else { 0..0 };
        let mut at_nodes = Vec::with_capacity(NODES * near.len());
        for column in near.clone() {
            at_nodes.extend(CELL_NODES.iter().map(|node| displacement(first + column as f64 + node)));
        }
        Self { displacement, first, y, count, lattice, near, at_nodes }
    }

    /// Adds the displacements of a substrate at the places of the row, with the wakes of all its terms.
    pub(crate) fn add_kernel(
        &self,
        substrate: &SlidingSubstrate,
        recurrences: &[WakeRecurrence],
        out: &mut [f64],
    ) {
        for (value, elastic) in out.iter_mut().zip(&self.lattice[BEFORE..]) {
            *value += substrate.instantaneous * elastic;
        }
        let mut wake = Vec::with_capacity(self.count);
        for (term, recurrence) in substrate.terms.iter().zip(recurrences) {
            recurrence.along(self, &mut wake);
            for (value, wake) in out.iter_mut().zip(&wake) {
                *value += term.compliance * wake;
            }
        }
    }

    /// ∫_0^1 κ e^{−κt} L(x + t) dt on panels graded towards the edges of the loaded cell, where the slope of L is
    /// logarithmic on the row of the cell itself.
    fn close_cell(&self, rate: f64, x: f64) -> f64 {
        let mut breaks = vec![0.0, 1.0];
        for edge in [-0.5 - x, 0.5 - x].into_iter().filter(|edge| (-0.5..=1.5).contains(edge)) {
            let grades = if self.y == 0.0 { GRADING.1 } else { 1 };
            breaks.push(edge);
            for grade in 0..grades {
                let distance = 0.5 * GRADING.0.powi(grade);
                breaks.extend([edge - distance, edge + distance]);
            }
        }
        breaks.retain(|at| (0.0..=1.0).contains(at));
        sort_numbers(&mut breaks);
        breaks.windows(2).map(|pair| panels(rate, pair[0], pair[1], |t| (self.displacement)(x + t))).sum()
    }
}

/// One term of the wake: g(x) = e^{−κ} g(x + 1) + ∫_0^1 κ e^{−κt} L(x + t) dt with κ = h/ℓ.
pub(crate) struct WakeRecurrence {
    rate: f64,
    lattice_weights: [f64; STENCIL],
    node_weights: [f64; NODES],
}

impl WakeRecurrence {
    /// The recurrences of a substrate's terms; lengths in cells.
    pub(crate) fn all(substrate: &SlidingSubstrate) -> Vec<Self> {
        substrate.terms.iter().map(|term| Self::new(term.length)).collect()
    }

    /// The recurrence of a term whose length is ℓ/h cells, positive and finite.
    fn new(length: f64) -> Self {
        let rate = 1.0 / length;
        let lattice: [f64; STENCIL] = std::array::from_fn(|index| index as f64 - BEFORE as f64);
        Self {
            rate,
            lattice_weights: product_weights(&lattice, rate),
            node_weights: product_weights(&CELL_NODES, rate),
        }
    }

    /// Writes the wake at the places of the row, and as many more as its recurrence has.
    fn along<F: Fn(f64) -> f64>(&self, row: &WakeRow<F>, wake: &mut Vec<f64>) {
        wake.clear();
        wake.extend(
            row.lattice.windows(STENCIL).take(row.count - 1).map(|values| dot(values, &self.lattice_weights)),
        );
        for (column, values) in row.near.clone().zip(row.at_nodes.chunks_exact(NODES)) {
            let x = row.first + column as f64;
            wake[column] = if row.y <= CLOSE.1 && (x + 0.5).abs() <= CLOSE.0 {
                row.close_cell(self.rate, x)
            } else {
                dot(values, &self.node_weights)
            };
        }
        let end = row.first + (row.count - 1) as f64;
        let mut beyond = tail(self.rate, end, |t| (row.displacement)(end + t));
        let decay = libm::exp(-self.rate);
        wake.push(beyond);
        for value in wake.iter_mut().rev().skip(1) {
            beyond = decay * beyond + *value;
            *value = beyond;
        }
    }
}

#[inline(always)]
fn dot<const N: usize>(values: &[f64], weights: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    for index in 0..N {
        sum += values[index] * weights[index];
    }
    sum
}
