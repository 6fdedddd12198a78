//! The quadratic problem shifted and inverted: a linear operator whose largest eigenvalues belong to those nearest to a shift.
//!
//! With λ = σ + ρ/θ the problem reads θ² Q(σ) x + θ ρ Q′(σ) x + ρ² M x = 0, so θ (x, u) = (−Q(σ)⁻¹ (ρ Q′(σ) x + ρ² M u), x) with
//! u = x/θ. Eigenvalues within ρ of σ have |θ| ≥ 1, and infinite ones θ = 0.

use super::shift::ShiftedFactor;
use crate::StructureError;
use crate::quadratic::{MatrixSide, Quadratic};
use faer::{Mat, MatRef, c64};

/// The operator on (x, u), for right vectors or for left ones.
pub(super) struct LinearisedOperator<'a> {
    pub(super) problem: &'a Quadratic,
    pub(super) factor: &'a ShiftedFactor,
    pub(super) side: MatrixSide,
    /// ρ.
    pub(super) reach: f64,
}

impl LinearisedOperator<'_> {
    /// Length of (x, u).
    pub(super) fn rows(&self) -> usize {
        2 * self.problem.size()
    }

    /// The operator on a block of vectors.
    ///
    /// # Errors
    /// [`StructureError::OutOfMemory`].
    pub(super) fn through(&self, block: MatRef<'_, c64>) -> Result<Mat<c64>, StructureError> {
        let (size, width) = (self.problem.size(), block.ncols());
        let (x, u) = (block.subrows(0, size), block.subrows(size, size));
        let mut image = self.problem.slope(self.side, self.factor.shift(), x);
        self.problem.add_mass(self.side, c64::new(self.reach, 0.0), u, &mut image);
        self.factor.solve(self.side, &mut image)?;
        Ok(Mat::from_fn(2 * size, width, |row, column| {
            if row < size { image[(row, column)] * -self.reach } else { x[(row - size, column)] }
        }))
    }

    /// λ of an eigenvalue θ that is not zero.
    pub(super) fn value(&self, theta: c64) -> c64 {
        self.factor.shift() + self.reach / theta
    }
}
