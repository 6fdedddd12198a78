//! When a 2×2 matrix is a mass matrix: symmetric and positive definite.

use judder_keys::problem::Problem;
use thiserror::Error;

/// A matrix that is no mass matrix.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("the mass matrix {mass:?} is {problem}")]
pub struct NoMass {
    /// M, row-major.
    pub mass: [[f64; 2]; 2],
    /// What is wrong with it.
    pub problem: MassProblem,
}

impl Problem for NoMass {
    fn kind(&self) -> &'static str {
        "Mass"
    }

    fn label(&self) -> &'static str {
        "not a mass matrix"
    }

    fn help(&self) -> Option<String> {
        Some(self.problem.help().to_owned())
    }
}

/// Why a matrix of finite numbers is no mass matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum MassProblem {
    /// The two entries beside the diagonal differ.
    #[error("not symmetric")]
    NotSymmetric,
    /// The determinant is zero to rounding: some motion has no inertia.
    #[error("singular")]
    Singular,
    /// Some motion has negative inertia.
    #[error("not positive definite")]
    NotPositiveDefinite,
}

impl MassProblem {
    fn help(self) -> &'static str {
        match self {
            Self::NotSymmetric => "let mass[0][1] and mass[1][0] be equal, as in [[2, 1], [1, 2]]",
            Self::Singular | Self::NotPositiveDefinite => {
                "mass[0][0] and the determinant must be positive, as in [[2, 1], [1, 2]]"
            }
        }
    }
}

/// Checks that M, row-major and finite, is symmetric and positive definite.
pub(crate) fn check_mass(mass: [[f64; 2]; 2]) -> Result<(), MassProblem> {
    let [[a, b], [c, d]] = mass;
    if b != c {
        return Err(MassProblem::NotSymmetric);
    }
    if a == 0.0 {
        return Err(if b == 0.0 { MassProblem::Singular } else { MassProblem::NotPositiveDefinite });
    }
    // the determinant over a: it neither overflows nor vanishes because the masses are large or small
    let rest = d - b * (b / a);
    if rest.abs() <= 4.0 * f64::EPSILON * d.abs() {
        return Err(MassProblem::Singular);
    }
    if a > 0.0 && rest > 0.0 { Ok(()) } else { Err(MassProblem::NotPositiveDefinite) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mass_is_symmetric_and_positive_definite() {
        let cases = [
            ([[1.0, 0.0], [0.0, 1.0]], Ok(())),
            ([[2.0, -1.0], [-1.0, 2.0]], Ok(())),
            ([[1e-200, 0.0], [0.0, 1e-200]], Ok(())),
            ([[1e200, 0.0], [0.0, 1e200]], Ok(())),
            ([[1.0, 0.5], [0.4, 1.0]], Err(MassProblem::NotSymmetric)),
            ([[0.0, 0.0], [0.0, 0.0]], Err(MassProblem::Singular)),
            ([[0.0, 0.0], [0.0, 1.0]], Err(MassProblem::Singular)),
            ([[1.0, 0.0], [0.0, 0.0]], Err(MassProblem::Singular)),
            ([[1.0, 1.0], [1.0, 1.0]], Err(MassProblem::Singular)),
            ([[0.1, 0.3], [0.3, 0.9]], Err(MassProblem::Singular)),
            ([[0.0, 1.0], [1.0, 0.0]], Err(MassProblem::NotPositiveDefinite)),
            ([[1.0, 2.0], [2.0, 1.0]], Err(MassProblem::NotPositiveDefinite)),
            ([[-1.0, 0.0], [0.0, 1.0]], Err(MassProblem::NotPositiveDefinite)),
            ([[-1.0, 0.0], [0.0, -1.0]], Err(MassProblem::NotPositiveDefinite)),
        ];
        for (mass, expected) in cases {
            assert_eq!(check_mass(mass), expected, "{mass:?}");
        }
    }
}
