//! The smallest periodic motion of a mode.

use crate::CyclesError;
use crate::balance::{CycleRate, HarmonicBalance};
use crate::point_law::{COMPONENTS, ProjectedForce, projected};
use faer::{Mat, c64};
use judder_assembly::steady::SteadySliding;
use judder_dense::general::solve_complex;
use judder_numerics::complex::ElementaryComplex;

/// How far beside the eigenvalue its vector is sought.
const BESIDE: f64 = 1e-7;

/// A guess of the smallest motion.
pub(super) struct ModeStart {
    /// Unknowns, ω and σ of the frequency.
    pub(super) at: Vec<f64>,
    /// Where motions become larger.
    pub(super) direction: Vec<f64>,
    /// First harmonics of y.
    pub(super) reference: Vec<f64>,
}

/// The guess at a share of the amplitude at which the contact first changes its state.
///
/// About steady sliding the forces of the points are (1 − ∂π/∂λ − ∂π/∂y Γ(λ)) δλ = 0 with the eigenvalue: its null vector, by inverse iteration.
pub(super) fn smallest(
    balance: &HarmonicBalance<'_>,
    steady: &SteadySliding,
    eigenvalue: c64,
    share: f64,
) -> Result<ModeStart, CyclesError> {
    let size = balance.series().coefficients();
    let about = about(balance, steady)?;
    let receptance = balance.bodies().receptance(eigenvalue, 0.0)?;
    // inverse iteration beside the eigenvalue, at which the matrix itself is singular
    let beside = balance.bodies().receptance(eigenvalue * (1.0 + BESIDE), 0.0)?;
    let forces = null_vector(balance, &about, &beside)?;
    let motion =
        |component: usize| -> c64 { (0..forces.len()).map(|k| receptance[(component, k)] * forces[k]).sum() };
    let motions: Vec<c64> = (0..forces.len()).map(motion).collect();
    let factor = share * first_change(balance, steady, &forces, &motions);
    let unknowns = balance.unknowns();
    let mut direction = vec![0.0; unknowns + 2];
    for (component, force) in forces.iter().enumerate() {
        direction[component * size + 1] = factor * force.re / balance.force_scale();
        direction[component * size + 2] = -factor * force.im / balance.force_scale();
    }
    let mut at = balance.steady(steady);
    at.iter_mut().zip(&direction).for_each(|(own, part)| *own += part);
    at.extend([1.0, eigenvalue.re / eigenvalue.im]);
    let reference = motions.iter().flat_map(|own| [factor * own.re, -factor * own.im]).collect();
    Ok(ModeStart { at, direction, reference })
}

/// What the points do in steady sliding.
fn about(balance: &HarmonicBalance<'_>, steady: &SteadySliding) -> Result<Vec<ProjectedForce>, CyclesError> {
    let signals = balance.signals_at(&balance.steady(steady), CycleRate { frequency: 1.0, growth: 0.0 })?;
    let dimension = balance.contact().dimension;
    let of = |values: &Mat<f64>, point: usize| {
        let mut own = [0.0; COMPONENTS];
        own.iter_mut()
            .take(dimension)
            .enumerate()
            .for_each(|(k, own)| *own = values[(0, point * dimension + k)]);
        own
    };
    let at = |point: usize| {
        let (force, motion) = (of(&signals.forces, point), of(&signals.motions, point));
        projected(&balance.contact().points[point], balance.scales()[point], force, motion)
    };
    Ok((0..balance.contact().points.len()).map(at).collect())
}

fn null_vector(
    balance: &HarmonicBalance<'_>,
    about: &[ProjectedForce],
    receptance: &Mat<c64>,
) -> Result<Vec<c64>, CyclesError> {
    let (dimension, size) = (balance.contact().dimension, balance.components());
    let entry = |i: usize, j: usize| {
        let (point, own) = (&about[i / dimension], i % dimension);
        let identity = f64::from(u8::from(i == j));
        let by_force = if i / dimension == j / dimension { point.by_force[own][j % dimension] } else { 0.0 };
        let first = i - own;
        let by_motion: c64 =
            (0..dimension).map(|k| receptance[(first + k, j)] * point.by_motion[own][k]).sum();
        c64::new(identity - by_force, 0.0) - by_motion
    };
    let matrix = Mat::from_fn(size, size, entry);
    let mut vector = Mat::from_fn(size, 1, |k, _| c64::new(1.0, 0.3 * libm::sin(k as f64)));
    for _ in 0..3 {
        solve_complex(matrix.clone(), &mut vector).ok_or(CyclesError::Singular)?;
        let length = vector.col(0).norm_l2();
        (0..size).for_each(|k| vector[(k, 0)] /= length);
    }
    Ok((0..size).map(|k| vector[(k, 0)]).collect())
}

/// How often the mode may be added before a point that is closed opens or sticks, one that is open closes, or a cubic stiffness counts.
fn first_change(
    balance: &HarmonicBalance<'_>,
    steady: &SteadySliding,
    forces: &[c64],
    motions: &[c64],
) -> f64 {
    let dimension = balance.contact().dimension;
    let mut most = f64::INFINITY;
    let mut limit = |room: f64, amplitude: c64| {
        if amplitude.modulus() > 0.0 {
            most = most.min(room.abs() / amplitude.modulus());
        }
    };
    for (point, state) in steady.points.iter().enumerate() {
        let first = point * dimension;
        match state.is_closed {
            true if balance.contact().is_compliant(point) => {
                let own = &balance.contact().points[point];
                let opens = (!own.stays_closed).then_some(state.gap);
                opens.into_iter().chain(own.law.bend()).for_each(|room| limit(room, motions[first]));
            }
            true => limit(state.normal_force, forces[first]),
            false => limit(state.gap, motions[first]),
        }
        if state.is_closed {
            limit(balance.contact().speed(point), motions[first + 1]);
        }
    }
    if most.is_finite() { most } else { 1.0 }
}
