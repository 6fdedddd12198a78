//! A reduced structure beside the full one.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::craig_bampton::CraigBampton;
use crate::factor::SymmetricFactor;
use crate::modes::{Mode, WantedModes, modes};
use crate::statics::sum;
use faer::linalg::solvers::{Lblt, Solve};
use faer::{Mat, Side};
use judder_numerics::parallel;
use std::f64::consts::TAU;

/// The tolerance of the limit that a report names.
pub const TOLERANCE: f64 = 1e-4;

/// A frequency of both structures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComparedFrequency {
    /// In Hz, of the full structure; of rigid motions zero.
    pub full_hz: f64,
    /// In Hz, of the reduced structure.
    pub reduced_hz: f64,
    /// (reduced − full)/reduced; zero of rigid motions. Below zero it is rounding.
    pub relative_error: f64,
    /// What the reduction alone says that it is at most; see [`ReductionError::bound`].
    ///
    /// [`ReductionError::bound`]: crate::reduction_error::ReductionError::bound
    pub bound: Option<f64>,
}

/// How near a reduced structure comes to the full one.
#[derive(Debug, Clone, PartialEq)]
pub struct ReductionReport {
    /// The lowest frequencies.
    pub frequencies: Vec<ComparedFrequency>,
    /// Below it the reduction itself says that every frequency of both structures is within [`TOLERANCE`] of its counterpart, in Hz.
    pub limit_hz: f64,
    /// ‖C_reduced − C_full‖/‖C_full‖ of the displacements of the kept freedoms by loads at them that rest (Frobenius norm); `None`
    /// where the structure can move without force.
    pub static_compliance_error: Option<f64>,
    /// The same by loads with a frequency.
    pub dynamic_compliance_error: f64,
}

impl ReductionReport {
    /// Compares so many of the lowest frequencies, and the compliance at rest and at a frequency in Hz.
    ///
    /// # Errors
    /// What [`modes`] says of the full structure, [`StructureError::NoModalForm`] of the reduced one, [`StructureError::Singular`]
    /// where the frequency is one of its own.
    pub fn new(
        stiffness: &Sparse,
        mass: &Sparse,
        kept: &[usize],
        reduced: &CraigBampton,
        count: usize,
        frequency: f64,
    ) -> Result<Self, StructureError> {
        let error = reduced.error()?;
        let full = modes(stiffness, mass, WantedModes::Lowest(count))?.modes;
        let compared =
            |(mode, (full, reduced_hz)): (usize, (_, f64))| compared(full, reduced_hz, error.bound(mode));
        let of_full = full.iter().map(Mode::frequency_hz);
        let frequencies = of_full.zip(error.frequencies_hz()).enumerate().map(compared).collect();
        let at = |hz: f64| -> Result<f64, StructureError> {
            let full = full_compliance(stiffness, mass, kept, hz)?;
            let reduced = reduced_compliance(reduced, hz);
            Ok((&reduced - &full).norm_l2() / full.norm_l2())
        };
        let is_held = !error.is_rigid(0);
        let static_compliance_error = if is_held { Some(at(0.0)?) } else { None };
        let limit_hz = error.limit_hz(TOLERANCE);
        Ok(Self { frequencies, limit_hz, static_compliance_error, dynamic_compliance_error: at(frequency)? })
    }
}

fn compared(full_hz: f64, reduced_hz: f64, bound: Option<f64>) -> ComparedFrequency {
    let is_rigid = bound == Some(0.0);
    let relative_error = if is_rigid { 0.0 } else { (reduced_hz - full_hz) / reduced_hz };
    ComparedFrequency { full_hz, reduced_hz, relative_error, bound }
}

/// The rows and columns of (K − ω² M)⁻¹ at the kept freedoms.
fn full_compliance(
    stiffness: &Sparse,
    mass: &Sparse,
    kept: &[usize],
    frequency: f64,
) -> Result<Mat<f64>, StructureError> {
    let factor = SymmetricFactor::new(&sum(1.0, stiffness, -(TAU * frequency).powi(2), mass)?)?;
    let column = |loaded: &usize| -> Vec<f64> {
        let mut u = vec![0.0; stiffness.nrows()];
        u[*loaded] = 1.0;
        factor.solve(&mut u);
        kept.iter().map(|read| u[*read]).collect()
    };
    let columns: Vec<Vec<f64>> = parallel::each(kept, column);
    Ok(Mat::from_fn(kept.len(), kept.len(), |i, j| columns[j][i]))
}

fn reduced_compliance(reduced: &CraigBampton, frequency: f64) -> Mat<f64> {
    let (size, kept) = (reduced.mass.nrows(), reduced.kept);
    let at = (TAU * frequency).powi(2);
    let dynamic = Mat::from_fn(size, size, |i, j| reduced.stiffness[(i, j)] - at * reduced.mass[(i, j)]);
    let loads = Mat::from_fn(size, kept, |i, j| f64::from(u8::from(i == j)));
    Lblt::new(dynamic.as_ref(), Side::Lower).solve(loads).subrows(0, kept).to_owned()
}
