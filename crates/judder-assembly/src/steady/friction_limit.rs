//! How much friction the closed points bear before their forces no longer follow from the loads.

use super::active_set::{AffinePoint, Guess, Solver};
use crate::interface::{FramedPoint, InterfaceLaw};
use faer::Mat;
use judder_dense::general::{real_eigenvalues, solve};
use judder_numerics::complex::ElementaryComplex;

/// Where the equations of the points that are closed become singular as all friction forces grow alike: sprag-slip.
///
/// Of this set of closed points alone: with other sets, that a motion may bring about, the one state may be lost earlier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrictionLimit {
    /// So much friction lets the closed points move without a change of force, the point of this number most. Of a factor below one it has come already: other
    /// states are there beside this one, or this one is not reached.
    At {
        /// How much.
        friction: FrictionAmount,
        /// The point, in the order of all interfaces.
        point: usize,
    },
    /// At no friction coefficient.
    None,
    /// Not known: there are too many points, or their eigenvalues were not found, or cannot be told from real ones.
    Unknown,
}

/// How much friction all points have, as it grows alike at all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrictionAmount {
    /// So many times that of the assembly.
    Factor(f64),
    /// So large a coefficient at all points, of an assembly that has no friction: of it no factor makes any.
    Coefficient(f64),
}

impl FrictionAmount {
    /// By what the friction of the assembly is multiplied, where it has some.
    #[must_use]
    pub fn factor(self) -> Option<f64> {
        match self {
            Self::Factor(factor) => Some(factor),
            Self::Coefficient(_) => None,
        }
    }
}

/// Friction coefficients that grow from nothing, all alike.
pub(crate) struct GrowingFriction {
    is_factor: bool,
}

impl GrowingFriction {
    /// By a factor on all where some point has friction, else as one coefficient of all.
    pub(crate) fn of(points: &[FramedPoint<'_>]) -> Self {
        let has_friction = |point: &FramedPoint<'_>| match point.law {
            InterfaceLaw::Rigid(friction) | InterfaceLaw::Compliant(_, friction) => {
                friction.at(point.frame.speed).coefficient > 0.0
            }
            InterfaceLaw::Asperity(_) => true,
        };
        Self { is_factor: points.iter().any(has_friction) }
    }

    /// The coefficient of a point at the amount of one, where it has this one.
    pub(crate) fn coefficient(&self, own: f64) -> f64 {
        if self.is_factor { own } else { 1.0 }
    }

    /// So many times those coefficients.
    pub(crate) fn amount(&self, size: f64) -> FrictionAmount {
        match self.is_factor {
            true => FrictionAmount::Factor(size),
            false => FrictionAmount::Coefficient(size),
        }
    }
}

/// The smallest s > 0 at which J₀ + s J₁ is singular.
#[derive(Clone, Copy)]
pub(crate) enum Singular {
    /// There, and the row that moves most.
    At {
        size: f64,
        row: usize,
    },
    None,
    Unknown,
}

/// Contact points up to which the dense eigenvalues are computed.
pub(super) const LARGEST: usize = 600;
/// An eigenvalue is real where its imaginary part is below so much of its size,
const REAL: f64 = 1e-8;
/// and may be real where it is below so much: of two or three that are one, rounding makes a pair that lies apart by its square or cube root.
const MAY_BE_REAL: f64 = 1e-5;
/// What pushes on by less than so much of what resists does so by rounding.
const ROUNDING: f64 = 1e-12;

/// Where the closed points move without a change of force.
pub(super) fn friction_limit(solver: &Solver<'_>, guess: &Guess) -> FrictionLimit {
    let growing = GrowingFriction::of(solver.points);
    match singular_friction(solver, guess, &growing) {
        Singular::At { size, row } => FrictionLimit::At { friction: growing.amount(size), point: row },
        Singular::None => FrictionLimit::None,
        Singular::Unknown => FrictionLimit::Unknown,
    }
}

/// The smallest s > 0 at which the equations of the points with s times their friction are singular.
pub(super) fn singular_friction(solver: &Solver<'_>, guess: &Guess, growing: &GrowingFriction) -> Singular {
    if solver.points.len() > LARGEST {
        return Singular::Unknown;
    }
    let count = solver.points.len();
    let affine: Vec<AffinePoint> = (0..count).map(|k| solver.affine(k, guess)).collect();
    let compliance = solver.compliance;
    let without = Mat::from_fn(count, count, |i, j| {
        let own = if i == j { affine[j].opening.slope } else { 0.0 };
        let force = affine[j].normal.slope + compliance.spring * affine[j].opening.slope;
        own - compliance.of_normal[(i, j)] * force
    });
    let slope = |own: &AffinePoint| {
        if growing.is_factor { own.friction.slope } else { own.normal.slope }
    };
    let friction = |i: usize, j: usize| -compliance.of_slip[(i, j)] * slope(&affine[j]);
    first_singular(&without, &Mat::from_fn(count, count, friction))
}

/// The smallest s > 0 at which J₀ + s J₁ is singular, and the row that moves most there.
pub(crate) fn first_singular(without: &Mat<f64>, friction: &Mat<f64>) -> Singular {
    singular(without, friction).unwrap_or(Singular::Unknown)
}

fn singular(without: &Mat<f64>, friction: &Mat<f64>) -> Option<Singular> {
    let count = without.nrows();
    let mut moved = friction.clone();
    solve(without.clone(), &mut moved)?;
    let values = real_eigenvalues(&moved)?;
    let steepest = |share: f64| {
        let real = values.iter().filter(|own| own.re < -ROUNDING && own.im.abs() <= share * own.modulus());
        real.map(|own| own.re).reduce(f64::min)
    };
    let size = match (steepest(REAL), steepest(MAY_BE_REAL)) {
        (_, None) => return Some(Singular::None),
        (Some(real), Some(all)) if all == real => -1.0 / real,
        _ => return Some(Singular::Unknown),
    };
    // one step of inverse iteration beside the singular matrix gives what moves
    let beside = size * (1.0 + 1e-6);
    let near = Mat::from_fn(count, count, |i, j| without[(i, j)] + beside * friction[(i, j)]);
    let mut shape = Mat::from_fn(count, 1, |i, _| 1.0 + libm::sin(i as f64));
    solve(near, &mut shape)?;
    let largest = |best: usize, k: usize| if shape[(k, 0)].abs() > shape[(best, 0)].abs() { k } else { best };
    Some(Singular::At { size, row: (0..count).fold(0, largest) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The limit of J₀ = I and J₁ with an eigenvalue −2 that is there twice, with one vector, in turned axes; `apart` makes a pair −2 ± i √apart of it.
    fn of_pair(angle: f64, apart: f64) -> Singular {
        let (s, c) = angle.sin_cos();
        let turn = [[c, -s], [s, c]];
        let own = [[-2.0, 1e3], [-1e-3 * apart, -2.0]];
        let entry = |i: usize, j: usize| -> f64 {
            let sum = |k: usize| (0..2).map(|l| turn[i][k] * own[k][l] * turn[j][l]).sum::<f64>();
            (0..2).map(sum).sum()
        };
        let unit = Mat::from_fn(2, 2, |i, j| if i == j { 1.0 } else { 0.0 });
        first_singular(&unit, &Mat::from_fn(2, 2, entry))
    }

    /// Rounding parts two eigenvalues that are one by 10⁻⁷ or so, along the real axis or off it.
    #[test]
    fn eigenvalues_that_are_one_are_not_taken_for_a_pair() {
        let mut unknown = 0;
        for k in 0..100 {
            match of_pair(0.1 + 0.03 * f64::from(k), 0.0) {
                Singular::At { size, .. } => assert!((size - 0.5).abs() < 1e-5, "{size}"),
                Singular::Unknown => unknown += 1,
                Singular::None => panic!("the pair is lost at {k}"),
            }
        }
        assert!(unknown > 0);
        assert!(matches!(of_pair(0.3, 1e-6), Singular::None));
    }
}
