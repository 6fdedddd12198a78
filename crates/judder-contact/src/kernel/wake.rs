//! The kernel of steady sliding: Love's cell and the wake that it leaves.

use super::love;
use super::recurrence::{WakeRecurrence, WakeRow};
use super::substrate::SlidingSubstrate;

/// Kernel values at all differences of two cells of a grid.
///
/// Row-major, `2·columns − 1` values a row: entry (row, column) is the displacement at
/// ((column − columns + 1 − shift) h, row · h) from a unit pressure on the cell at the origin; symmetric in y.
#[derive(Debug, Clone, PartialEq)]
pub struct WakeKernel {
    /// Cells of the grid along x.
    pub columns: usize,
    /// Cells of the grid along y.
    pub rows: usize,
    /// The values, in cells over E0*.
    pub values: Vec<f64>,
}

impl WakeKernel {
    /// The kernel of a grid on a sliding substrate whose lengths are in cells, as
    /// [`in_cells`](SlidingSubstrate::in_cells) gives them; `shift` in cells is where displacements are taken upstream
    /// of the centres, 0 to 1/2.
    ///
    /// For each term of the creep spectrum the wake is g(x) = (1/ℓ) ∫_x^∞ e^{−(s−x)/ℓ} L(s) ds, L being Love's displacement. It
    /// recurs from the far upstream end, g(x) = e^{−h/ℓ} g(x + h) + one cell's integral. Far from the loaded cell that
    /// integral is a product rule of lattice values with the exponential exact; nearer the values stand inside the cell,
    /// and next to the loaded cell Gauss panels are graded towards its edges, where the slope of L is log-singular.
    /// Upstream of the grid panels double until e^{−s/ℓ} is spent. Relative error below 1e-10 for ℓ/h from 1e-8 to 1e8;
    /// the cost is linear in the cells and in the terms.
    #[must_use]
    pub fn new(columns: usize, rows: usize, shift: f64, substrate: &SlidingSubstrate) -> Self {
        let wide = padded(columns);
        let mut values = vec![0.0; wide * rows];
        let recurrences = WakeRecurrence::all(substrate);
        let first = 1.0 - columns as f64 - shift;
        for (row, out) in values.chunks_exact_mut(wide.max(1)).enumerate() {
            let y = row as f64;
            let places =
                WakeRow::new(first, wide, y, |x| love::displacement(x, y), |x, out| love::fill(x, y, out));
            places.add_kernel(substrate, &recurrences, out);
        }
        Self { columns, rows, values }
    }

    /// The displacement at the collocation point of the loaded cell itself, in cells over E0*.
    #[must_use]
    pub fn at_itself(&self) -> f64 {
        self.values.get(self.columns.saturating_sub(1)).copied().unwrap_or_default()
    }
}

/// Cells of a line and of its images at all differences.
pub(super) fn padded(cells: usize) -> usize {
    (2 * cells).saturating_sub(1)
}
