//! How much friction the closed points bear before their forces no longer follow from the loads.

use super::active_set::{AffinePoint, Guess, Solver};
use faer::Mat;
use judder_dense::general::{real_eigenvalues, solve};

/// Where the equations of the points that are closed become singular as all friction forces grow alike: sprag-slip.
///
/// Of this set of closed points alone: with other sets, that a motion may bring about, the one state may be lost earlier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrictionLimit {
    /// Friction coefficients this many times as large let the closed points move without a change of force, the point of this number
    /// most. Below one it has come already: other states are there beside this one, or this one is not reached.
    At {
        /// By what the friction coefficients are multiplied.
        factor: f64,
        /// The point, in the order of all interfaces.
        point: usize,
    },
    /// At no friction coefficient.
    None,
    /// Not known: there are too many points, or their eigenvalues were not found.
    Unknown,
}

/// Contact points up to which the dense eigenvalues are computed.
pub(super) const LARGEST: usize = 600;
/// An eigenvalue is real where its imaginary part is below so much of its size.
const REAL: f64 = 1e-8;
/// What pushes on by less than so much of what resists does so by rounding.
const ROUNDING: f64 = 1e-12;

/// The smallest s > 0 at which J₀ + s J₁ is singular, the equations of the points with friction as it is being J₀ + J₁.
pub(super) fn friction_limit(solver: &Solver<'_>, guess: &Guess) -> FrictionLimit {
    if solver.points.len() > LARGEST {
        return FrictionLimit::Unknown;
    }
    let count = solver.points.len();
    let affine: Vec<AffinePoint> = (0..count).map(|k| solver.affine(k, guess)).collect();
    let compliance = solver.compliance;
    let without = Mat::from_fn(count, count, |i, j| {
        let own = if i == j { affine[j].opening.slope } else { 0.0 };
        let force = affine[j].normal.slope + compliance.spring * affine[j].opening.slope;
        own - compliance.of_normal[(i, j)] * force
    });
    let friction = |i: usize, j: usize| -compliance.of_slip[(i, j)] * affine[j].friction.slope;
    first_singular(&without, &Mat::from_fn(count, count, friction))
}

/// The smallest s > 0 at which J₀ + s J₁ is singular, and the row that moves most there.
pub(crate) fn first_singular(without: &Mat<f64>, friction: &Mat<f64>) -> FrictionLimit {
    singular(without, friction).unwrap_or(FrictionLimit::Unknown)
}

fn singular(without: &Mat<f64>, friction: &Mat<f64>) -> Option<FrictionLimit> {
    let count = without.nrows();
    let mut moved = friction.clone();
    solve(without.clone(), &mut moved)?;
    let values = real_eigenvalues(&moved)?;
    let real = values.iter().filter(|value| value.re < -ROUNDING && value.im.abs() <= REAL * value.norm());
    let Some(steepest) = real.map(|value| value.re).reduce(f64::min) else {
        return Some(FrictionLimit::None);
    };
    let factor = -1.0 / steepest;
    // one step of inverse iteration beside the singular matrix gives what moves
    let beside = factor * (1.0 + 1e-6);
    let near = Mat::from_fn(count, count, |i, j| without[(i, j)] + beside * friction[(i, j)]);
    let mut shape = Mat::from_fn(count, 1, |i, _| 1.0 + (i as f64).sin());
    solve(near, &mut shape)?;
    let largest = |best: usize, k: usize| if shape[(k, 0)].abs() > shape[(best, 0)].abs() { k } else { best };
    Some(FrictionLimit::At { factor, point: (0..count).fold(0, largest) })
}
