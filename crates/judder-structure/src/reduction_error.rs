//! How far reduced frequencies can be from those of the full structure, told by the reduction alone.
//!
//! With the left-out fixed-interface modes condensed, the full structure has below λ < min Ωⱼ² as many eigenvalues as
//! D(λ) = Kᵣ − λ Mᵣ − λ² Σ mⱼ mⱼᵀ/(Ωⱼ² − λ) has negative ones (W. H. Wittrick and F. W. Williams, *A general algorithm for computing
//! natural frequencies of elastic structures*, Quarterly Journal of Mechanics and Applied Mathematics 24 (1971)). The sum lies between
//! G and G/(1 − λ/min Ωⱼ²), G = Σ mⱼ mⱼᵀ/Ωⱼ², so a count with the larger one bounds the full eigenvalues from below; the reduced ones
//! bound them from above (Rayleigh and Ritz).

use crate::StructureError;
use crate::craig_bampton::CraigBampton;
use crate::modal_form::ModalForm;
use crate::rigid::rigid_limit;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use judder_dense::symmetric::negative_eigenvalues;
use std::f64::consts::TAU;

/// The error of a reduction's frequencies.
#[derive(Debug, Clone)]
pub struct ReductionError {
    /// λ of the reduced structure by rising size.
    eigenvalues: Vec<f64>,
    /// G in the coordinates of the reduced modes, in s².
    inertia: Mat<f64>,
    left_out_from: f64,
}

impl CraigBampton {
    /// The error of its frequencies.
    ///
    /// # Errors
    /// [`StructureError::NoModalForm`].
    pub fn error(&self) -> Result<ReductionError, StructureError> {
        let ModalForm { eigenvalues, shapes, .. } = self.modal_form()?;
        let at_kept = shapes.subrows(0, self.kept);
        let (mut half, mut inertia) =
            (Mat::zeros(self.kept, shapes.ncols()), Mat::zeros(shapes.ncols(), shapes.ncols()));
        matmul(&mut half, Accum::Replace, &self.left_out.inertia, at_kept, 1.0, Par::Seq);
        matmul(&mut inertia, Accum::Replace, at_kept.transpose(), &half, 1.0, Par::Seq);
        Ok(ReductionError { eigenvalues, inertia, left_out_from: self.left_out.from })
    }
}

impl ReductionError {
    /// The reduced frequencies in Hz by rising size; of rigid motions zero.
    #[must_use]
    pub fn frequencies_hz(&self) -> Vec<f64> {
        self.eigenvalues.iter().map(|value| value.max(0.0).sqrt() / TAU).collect()
    }

    /// A bound of (f_reduced − f_full)/f_reduced of a mode, counted from 0; `None` for a mode that is not there, or so high that the
    /// modes that were left out may resonate. Rigid motions have none: they are exact.
    #[must_use]
    pub fn bound(&self, mode: usize) -> Option<f64> {
        /// Shares of the first-order error, in the order in which they are tried.
        const SHARES: [f64; 6] = [1.01, 1.1, 1.3, 2.0, 4.0, 16.0];
        let value = *self.eigenvalues.get(mode)?;
        if self.is_rigid(mode) {
            return Some(0.0);
        }
        let first_order = 0.5 * value * self.amplification(value)? * self.inertia[(mode, mode)];
        let rounding = self.rounding() / value;
        SHARES.iter().map(|share| share * first_order + rounding).find(|bound| self.is_within(mode, *bound))
    }

    /// The frequency in Hz below which every frequency, of the full structure as of the reduced one, has its counterpart within this share
    /// of the reduced one, and none is missing; infinite where no mode was left out.
    ///
    /// The first mode that is not known to be as exact ends the range: not where the reduction has it, but below where the full structure may
    /// have it, which by that very error is lower. Up to there the full structure has no more eigenvalues than the modes before.
    #[must_use]
    pub fn limit_hz(&self, tolerance: f64) -> f64 {
        let first_without = (0..self.eigenvalues.len()).find(|mode| !self.is_within(*mode, tolerance));
        let beyond = first_without.map_or(self.left_out_from, |mode| self.full_from(mode, tolerance));
        beyond.min(self.left_out_from).max(0.0).sqrt() / TAU
    }

    /// A value in 1/s² below which the full structure has no eigenvalue but those of the modes before this one, which are within the error.
    fn full_from(&self, mode: usize, error: f64) -> f64 {
        /// Halvings of the range between two modes.
        const HALVINGS: usize = 30;
        let below = mode.checked_sub(1).map_or(0.0, |before| self.eigenvalues[before].max(0.0));
        let (mut known, mut open) = (below * (1.0 - error).powi(2), self.eigenvalues[mode]);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (known + open);
            if self.full_at_most(middle).is_some_and(|count| count <= mode) {
                known = middle;
            } else {
                open = middle;
            }
        }
        known
    }

    /// Whether the full structure has no more eigenvalues than there are reduced ones before a mode, below the mode's less an error.
    fn is_within(&self, mode: usize, error: f64) -> bool {
        let value = self.eigenvalues[mode];
        if self.is_rigid(mode) {
            return true;
        }
        let below = value * (1.0 - error).max(0.0).powi(2);
        match self.amplification(value) {
            Some(_) if error < 1.0 => self.full_at_most(below).is_some_and(|count| count <= mode),
            _ => false,
        }
    }

    /// 1/(1 − λ/min Ω²) below the modes that were left out.
    fn amplification(&self, value: f64) -> Option<f64> {
        let share = value / self.left_out_from;
        (share < 1.0).then(|| 1.0 / (1.0 - share))
    }

    /// No fewer than the full structure has below a value.
    fn full_at_most(&self, value: f64) -> Option<usize> {
        let weight = value * value * self.amplification(value)?;
        let size = self.eigenvalues.len();
        negative_eigenvalues(&Mat::from_fn(size, size, |i, j| {
            let diagonal = if i == j { self.eigenvalues[i] - value } else { 0.0 };
            diagonal - weight * self.inertia[(i, j)]
        }))
    }

    /// Whether a mode, counted from 0, has no stiffness but for rounding; see [`rigid_limit`].
    #[must_use]
    pub fn is_rigid(&self, mode: usize) -> bool {
        self.eigenvalues.get(mode).is_some_and(|value| *value <= self.rounding())
    }

    /// What rounding makes of an eigenvalue.
    fn rounding(&self) -> f64 {
        rigid_limit(self.eigenvalues.len(), self.eigenvalues.last().copied().unwrap_or(0.0))
    }
}
