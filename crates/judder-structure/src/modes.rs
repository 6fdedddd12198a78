//! Undamped modes: K φ = λ M φ, the lowest or those of a band, with a count that shows whether one is missing.

mod lanczos;

use crate::StructureError;
use crate::assembly::Sparse;
use crate::dense::{Eigen, generalised};
use crate::factor::SymmetricFactor;
use crate::statics::{dot, product};
use faer::Mat;
use faer::sparse::ops::binary_op;
use lanczos::Lanczos;
use std::f64::consts::TAU;

/// Which modes are wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wanted {
    /// So many, from the lowest on.
    Lowest(usize),
    /// All between two frequencies in Hz.
    Band(f64, f64),
}

/// A mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// λ = ω² in 1/s²; of a rigid motion zero but for rounding.
    pub eigenvalue: f64,
    /// φ with φᵀ M φ = 1, in 1/√kg.
    pub shape: Vec<f64>,
    /// ‖K φ − λ M φ‖/((‖K‖ + |λ| ‖M‖) ‖φ‖), the normalised backward error.
    pub residual: f64,
}

impl Mode {
    /// ω/2π in Hz; of a rigid motion zero.
    #[must_use]
    pub fn frequency_hz(&self) -> f64 {
        self.eigenvalue.max(0.0).sqrt() / TAU
    }
}

/// Modes by rising frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes {
    /// The modes.
    pub modes: Vec<Mode>,
    /// An eigenvalue above the last mode and how many modes lie below it, counted by the signs of a factorisation.
    pub counted: (f64, usize),
}

/// Rounds of the search before it gives up on modes that the count knows of.
const ROUNDS: usize = 20;

/// The modes of a structure by shift-invert Lanczos in the inner product of the mass (T. Ericsson and A. Ruhe, 1980).
///
/// A shift below zero lets rigid motions come out as what they are. Sylvester's law of inertia counts the eigenvalues below a
/// value above the last mode; while there are more than were found, the search goes on from a start of its own.
///
/// # Errors
/// [`StructureError::MissingModes`] where the count is not reached, [`StructureError::OutOfMemory`], numbers that are not finite.
pub fn modes(stiffness: &Sparse, mass: &Sparse, wanted: Wanted) -> Result<Modes, StructureError> {
    let shift = -shift_scale(stiffness, mass)?;
    let factor = SymmetricFactor::new(&shifted(stiffness, mass, shift)?)?;
    let mut search = Lanczos::new(&factor, mass, shift);
    let size = stiffness.nrows();
    let aim = match wanted {
        Wanted::Lowest(count) => count.min(size),
        Wanted::Band(_, to) => below(stiffness, mass, (TAU * to).powi(2))?,
    };
    let mut target = aim;
    for _ in 0..ROUNDS {
        let found = search.converged((target + 1).min(size))?;
        let limit = limit_above(&found, target, wanted);
        let count = below(stiffness, mass, limit)?;
        let known = found.iter().filter(|(value, _)| *value < limit).count();
        if known >= count {
            let first = match wanted {
                Wanted::Lowest(_) => 0,
                Wanted::Band(from, _) => {
                    found.iter().filter(|(value, _)| *value < (TAU * from).powi(2)).count()
                }
            };
            let last = if matches!(wanted, Wanted::Lowest(_)) { aim.min(known) } else { known };
            let found = rayleigh_ritz(stiffness, mass, found)?;
            let modes = found.into_iter().take(last).skip(first);
            let modes = modes.map(|(value, shape)| finished(stiffness, mass, value, shape)).collect();
            return Ok(Modes { modes, counted: (limit, count) });
        }
        target = target.max(count);
        search.start_anew()?;
    }
    Err(StructureError::MissingModes { wanted: aim })
}

/// The modes within the space of the shapes that were found: what a factorisation near a rigid motion mixed comes apart.
fn rayleigh_ritz(
    stiffness: &Sparse,
    mass: &Sparse,
    found: Vec<(f64, Vec<f64>)>,
) -> Result<Vec<(f64, Vec<f64>)>, StructureError> {
    let wanted = found.len();
    let shapes: Vec<Vec<f64>> = found.into_iter().map(|(_, shape)| shape).collect();
    let projected = |matrix: &Sparse| {
        let images: Vec<Vec<f64>> = shapes.iter().map(|shape| product(matrix, shape)).collect();
        Mat::from_fn(wanted, wanted, |i, j| dot(&shapes[i], &images[j]))
    };
    let Eigen { values, vectors } =
        generalised(projected(stiffness), &projected(mass)).ok_or(StructureError::MissingModes { wanted })?;
    let combined = |k: usize| -> Vec<f64> {
        let mut sum = vec![0.0; mass.nrows()];
        for (i, shape) in shapes.iter().enumerate() {
            for (s, u) in sum.iter_mut().zip(shape) {
                *s += vectors[(i, k)] * u;
            }
        }
        sum
    };
    Ok(values.into_iter().enumerate().map(|(k, value)| (value, combined(k))).collect())
}

/// A value between the last wanted eigenvalue and the next: halfway, where the two stand apart.
fn limit_above(found: &[(f64, Vec<f64>)], target: usize, wanted: Wanted) -> f64 {
    /// Relative distance of eigenvalues that are not one.
    const APART: f64 = 1e-6;
    if let Wanted::Band(_, to) = wanted {
        return (TAU * to).powi(2);
    }
    let value = |k: usize| found.get(k).map(|(value, _)| *value);
    let last = value(target.saturating_sub(1)).unwrap_or(0.0);
    match value(target) {
        Some(next) if next - last > APART * next.abs() => 0.5 * (last + next),
        _ => last * (1.0 + APART) + f64::MIN_POSITIVE,
    }
}

/// How many eigenvalues lie below a value.
///
/// # Errors
/// [`StructureError::OutOfMemory`].
pub fn below(stiffness: &Sparse, mass: &Sparse, value: f64) -> Result<usize, StructureError> {
    Ok(SymmetricFactor::new(&shifted(stiffness, mass, value)?)?.negative_eigenvalues())
}

/// K − σ M.
fn shifted(stiffness: &Sparse, mass: &Sparse, shift: f64) -> Result<Sparse, StructureError> {
    let entry =
        |k: Option<&f64>, m: Option<&f64>| k.copied().unwrap_or(0.0) - shift * m.copied().unwrap_or(0.0);
    // both have the pattern of the mesh; of other patterns the union
    binary_op(stiffness.as_ref(), mass.as_ref(), entry)
        .map_err(|_| StructureError::OutOfMemory { rows: stiffness.nrows() })
}

/// A small positive eigenvalue for shifts: far below the mean of all, far above what rounding makes of zero.
fn shift_scale(stiffness: &Sparse, mass: &Sparse) -> Result<f64, StructureError> {
    const SHARE: f64 = 1e-8;
    let trace =
        |matrix: &Sparse| (0..matrix.nrows()).map(|k| matrix.get(k, k).copied().unwrap_or(0.0)).sum::<f64>();
    let (of_stiffness, of_mass) = (trace(stiffness), trace(mass));
    for (name, value) in [("the trace of the stiffness", of_stiffness), ("the trace of the mass", of_mass)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(StructureError::InvalidNumber { name, value, requirement: "positive" });
        }
    }
    Ok(SHARE * of_stiffness / of_mass)
}

fn finished(stiffness: &Sparse, mass: &Sparse, eigenvalue: f64, shape: Vec<f64>) -> Mode {
    let (elastic, inertial) = (product(stiffness, &shape), product(mass, &shape));
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let rest: Vec<f64> = elastic.iter().zip(&inertial).map(|(k, m)| k - eigenvalue * m).collect();
    let scale = (norm_of(stiffness) + eigenvalue.abs() * norm_of(mass)) * norm(&shape);
    Mode { eigenvalue, shape, residual: norm(&rest) / scale }
}

/// The largest sum of magnitudes of a column.
fn norm_of(matrix: &Sparse) -> f64 {
    let sum = |column: usize| matrix.val_of_col(column).iter().map(|value| value.abs()).sum::<f64>();
    (0..matrix.ncols()).map(sum).fold(0.0, f64::max)
}
