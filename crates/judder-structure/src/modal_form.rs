//! The modal form of a reduced structure, M = I and K diagonal, and the flexibility of the modes that it is cut off from.

use crate::StructureError;
use crate::craig_bampton::{CraigBampton, CutOff};
use crate::rigid::rigid_limit;
use faer::Mat;
use judder_dense::symmetric::{Eigen, generalised};
use std::f64::consts::TAU;

/// A reduced structure in the coordinates of its own modes: q = Q p with Qᵀ Mᵣ Q = I, Qᵀ Kᵣ Q = diag ω².
#[derive(Debug, Clone)]
pub struct ModalForm {
    /// ω² in 1/s² by rising size; of rigid motions zero but for rounding.
    pub eigenvalues: Vec<f64>,
    /// Q, reduced coordinates by modes, in 1/√kg; its first rows are the kept freedoms.
    pub shapes: Mat<f64>,
    /// How many freedoms are kept.
    pub kept: usize,
    /// R = Σ φ_b φ_bᵀ/ω² over the modes that were cut off, in m/N, kept²: what they yield under loads at the kept freedoms that
    /// vary slowly against them. Of a held structure it is the static flexibility less that of the modes that are there.
    pub residual_flexibility: Mat<f64>,
}

impl CraigBampton {
    /// The modal form with all modes.
    ///
    /// # Errors
    /// [`StructureError::NoModalForm`] where the mass is not positive definite.
    pub fn modal_form(&self) -> Result<ModalForm, StructureError> {
        let eigen = generalised(self.stiffness.clone(), &self.mass);
        let Eigen { values, vectors } = eigen.ok_or(StructureError::NoModalForm)?;
        let residual_flexibility = Mat::zeros(self.kept, self.kept);
        Ok(ModalForm { eigenvalues: values, shapes: vectors, kept: self.kept, residual_flexibility })
    }
}

impl ModalForm {
    /// Frequencies in Hz; of rigid motions zero.
    #[must_use]
    pub fn frequencies_hz(&self) -> Vec<f64> {
        self.eigenvalues.iter().map(|value| value.max(0.0).sqrt() / TAU).collect()
    }

    /// The same structure on fewer modes. What is cut off adds to the residual flexibility.
    ///
    /// # Errors
    /// [`StructureError::CutRigid`] where a mode without stiffness would be cut off: it has no flexibility.
    pub fn cut(&self, cut_off: CutOff) -> Result<Self, StructureError> {
        let modes = self.eigenvalues.len();
        let count = match cut_off {
            CutOff::Count(count) => count.min(modes),
            CutOff::Frequency(limit) => self.frequencies_hz().iter().take_while(|hz| **hz < limit).count(),
        };
        let rigid = rigid_limit(modes, self.eigenvalues.last().copied().unwrap_or(0.0));
        let cut = count..modes;
        if let Some(mode) = cut.clone().find(|k| self.eigenvalues[*k] <= rigid) {
            return Err(StructureError::CutRigid { mode, kept: count });
        }
        let flexibility = |i: usize, j: usize| -> f64 {
            let of_cut = cut.clone().map(|k| self.shapes[(i, k)] * self.shapes[(j, k)] / self.eigenvalues[k]);
            self.residual_flexibility[(i, j)] + of_cut.sum::<f64>()
        };
        Ok(Self {
            eigenvalues: self.eigenvalues[..count].to_vec(),
            shapes: self.shapes.subcols(0, count).to_owned(),
            kept: self.kept,
            residual_flexibility: Mat::from_fn(self.kept, self.kept, flexibility),
        })
    }

    /// Σ φ_b φ_bᵀ/(ω² − ω_e²) + R: the displacements of the kept freedoms by loads at them with this frequency in Hz, in m/N.
    ///
    /// Modes that were cut off count as if the load rested.
    #[must_use]
    pub fn compliance(&self, frequency: f64) -> Mat<f64> {
        let at = (TAU * frequency).powi(2);
        let weights: Vec<f64> = self.eigenvalues.iter().map(|value| 1.0 / (value - at)).collect();
        Mat::from_fn(self.kept, self.kept, |i, j| {
            let of_modes =
                weights.iter().enumerate().map(|(k, w)| w * self.shapes[(i, k)] * self.shapes[(j, k)]);
            self.residual_flexibility[(i, j)] + of_modes.sum::<f64>()
        })
    }
}
