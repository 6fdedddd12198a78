//! How much friction steady sliding bears before it is not the only state, or none.

use super::active_set::{AffinePoint, Guess, Solver};
use crate::AssemblyError;
use faer::Mat;
use judder_dense::general::{real_eigenvalues, solve};

/// Where steady sliding is lost as all friction forces grow alike, over the points that are closed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Uniqueness {
    /// Friction coefficients this many times as large let the closed points move without a change of force, the point of this number
    /// most: sprag-slip begins. Below one it has begun: other states are there beside this one, or this one is not reached.
    LostAt {
        /// By what the friction coefficients are multiplied.
        factor: f64,
        /// The point, in the order of all interfaces.
        point: usize,
    },
    /// At no friction coefficient.
    Kept,
    /// Not looked at: there are too many closed points.
    Unknown,
}

/// Points up to which the dense eigenvalues are computed.
const LARGEST: usize = 600;
/// An eigenvalue is real where its imaginary part is below so much of its size.
const REAL: f64 = 1e-8;

/// The smallest s > 0 at which J₀ + s J₁ is singular, the equations of the points with friction as it is being J₀ + J₁.
pub(super) fn uniqueness(solver: &Solver<'_>, guess: &Guess) -> Result<Uniqueness, AssemblyError> {
    let count = solver.points.len();
    if count > LARGEST {
        return Ok(Uniqueness::Unknown);
    }
    let affine: Vec<AffinePoint> = (0..count).map(|k| solver.affine(k, guess)).collect();
    let compliance = solver.compliance;
    let without = Mat::from_fn(count, count, |i, j| {
        let own = if i == j { affine[j].opening.slope } else { 0.0 };
        let force = affine[j].normal.slope + compliance.spring * affine[j].opening.slope;
        own - compliance.of_normal[(i, j)] * force
    });
    let friction = |i: usize, j: usize| -compliance.of_slip[(i, j)] * affine[j].friction.slope;
    let mut moved = Mat::from_fn(count, count, friction);
    let closed = guess.closed.iter().filter(|closed| **closed).count();
    solve(without.clone(), &mut moved).ok_or(AssemblyError::Undetermined { closed })?;
    let values = real_eigenvalues(&moved).ok_or(AssemblyError::NoEigenvalues { points: count })?;
    let real = values.iter().filter(|value| value.re < 0.0 && value.im.abs() <= REAL * value.norm());
    let Some(steepest) = real.map(|value| value.re).reduce(f64::min) else { return Ok(Uniqueness::Kept) };
    let factor = -1.0 / steepest;
    // one step of inverse iteration beside the singular matrix gives what moves
    let beside = factor * (1.0 + 1e-6);
    let near = Mat::from_fn(count, count, |i, j| without[(i, j)] + beside * friction(i, j));
    let mut shape = Mat::from_fn(count, 1, |i, _| 1.0 + (i as f64).sin());
    solve(near, &mut shape).ok_or(AssemblyError::Undetermined { closed })?;
    let largest = |best: usize, k: usize| if shape[(k, 0)].abs() > shape[(best, 0)].abs() { k } else { best };
    Ok(Uniqueness::LostAt { factor, point: (0..count).fold(0, largest) })
}
