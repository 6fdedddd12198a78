//! When a matrix is a mass matrix: symmetric and positive definite.

use judder_keys::problem::Problem;
use thiserror::Error;

/// A matrix that is no mass matrix.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("the mass matrix {} is {problem}", shown(.mass))]
pub struct NoMass {
    /// M, row by row.
    pub mass: Vec<Vec<f64>>,
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
        Some(match self.problem {
            MassProblem::NotSymmetric { row, column } => {
                format!(
                    "let mass[{row}][{column}] and mass[{column}][{row}] be equal, as in [[2, 1], [1, 2]]"
                )
            }
            MassProblem::Singular | MassProblem::NotPositiveDefinite if self.mass.len() == 2 => {
                "mass[0][0] and the determinant must be positive, as in [[2, 1], [1, 2]]".to_owned()
            }
            MassProblem::Singular | MassProblem::NotPositiveDefinite => {
                "every motion must have inertia: the determinants of the first rows and columns, one, two and so on, must be positive"
                    .to_owned()
            }
        })
    }
}

/// The matrix, where it is small enough to be read in a message.
fn shown(mass: &[Vec<f64>]) -> String {
    /// Rows of the largest that is shown.
    const ROWS: usize = 4;
    if mass.len() <= ROWS { format!("{mass:?}") } else { format!("of {} rows", mass.len()) }
}

/// Why a matrix of finite numbers is no mass matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum MassProblem {
    /// Two entries beside the diagonal differ.
    #[error("not symmetric")]
    NotSymmetric {
        /// The row of the first.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// The determinant is zero to rounding: some motion has no inertia.
    #[error("singular")]
    Singular,
    /// Some motion has negative inertia.
    #[error("not positive definite")]
    NotPositiveDefinite,
}

/// Checks that M, square and finite, is symmetric and positive definite, by the pivots of M = L D Lᵀ.
pub(crate) fn check_mass(mass: &[Vec<f64>]) -> Result<(), MassProblem> {
    let rows = mass.len();
    for (row, entries) in mass.iter().enumerate() {
        if let Some(column) = (row + 1..rows).find(|column| entries[*column] != mass[*column][row]) {
            return Err(MassProblem::NotSymmetric { row, column });
        }
    }
    let mut left = mass.to_vec();
    for k in 0..rows {
        let pivot = left[k][k];
        // over the pivot before: it neither overflows nor vanishes because the masses are large or small
        if pivot.abs() <= 4.0 * f64::EPSILON * mass[k][k].abs() {
            let is_alone = (k + 1..rows).all(|row| left[row][k] == 0.0);
            return Err(if is_alone { MassProblem::Singular } else { MassProblem::NotPositiveDefinite });
        }
        if pivot < 0.0 {
            return Err(MassProblem::NotPositiveDefinite);
        }
        let (above, below) = left.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / pivot;
            row.iter_mut().zip(&above[k]).for_each(|(entry, own)| *entry -= own * factor);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOT_POSITIVE: Result<(), MassProblem> = Err(MassProblem::NotPositiveDefinite);
    const SINGULAR: Result<(), MassProblem> = Err(MassProblem::Singular);

    #[test]
    fn a_mass_is_symmetric_and_positive_definite() {
        let cases = [
            ([[1.0, 0.0], [0.0, 1.0]], Ok(())),
            ([[2.0, -1.0], [-1.0, 2.0]], Ok(())),
            ([[1e-200, 0.0], [0.0, 1e-200]], Ok(())),
            ([[1e200, 0.0], [0.0, 1e200]], Ok(())),
            ([[1.0, 0.5], [0.4, 1.0]], Err(MassProblem::NotSymmetric { row: 0, column: 1 })),
            ([[0.0, 0.0], [0.0, 0.0]], SINGULAR),
            ([[0.0, 0.0], [0.0, 1.0]], SINGULAR),
            ([[1.0, 0.0], [0.0, 0.0]], SINGULAR),
            ([[1.0, 1.0], [1.0, 1.0]], SINGULAR),
            ([[0.1, 0.3], [0.3, 0.9]], SINGULAR),
            ([[0.0, 1.0], [1.0, 0.0]], NOT_POSITIVE),
            ([[1.0, 2.0], [2.0, 1.0]], NOT_POSITIVE),
            ([[-1.0, 0.0], [0.0, 1.0]], NOT_POSITIVE),
            ([[-1.0, 0.0], [0.0, -1.0]], NOT_POSITIVE),
        ];
        for (mass, expected) in cases {
            let rows = mass.map(|row| row.to_vec());
            assert_eq!(check_mass(&rows), expected, "{mass:?}");
        }
    }

    #[test]
    fn a_mass_may_have_any_number_of_rows() {
        let mass = |corner: f64| vec![vec![2.0, 1.0, 0.0], vec![1.0, 2.0, 1.0], vec![0.0, 1.0, corner]];
        assert_eq!(check_mass(&mass(1.0)), Ok(()));
        assert_eq!(check_mass(&mass(2.0 / 3.0)), SINGULAR);
        assert_eq!(check_mass(&mass(0.5)), NOT_POSITIVE);
        assert_eq!(check_mass(&[vec![3.0]]), Ok(()));
    }
}
