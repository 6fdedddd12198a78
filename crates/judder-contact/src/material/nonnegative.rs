//! Least squares with coefficients that must not be negative.

use super::error::MaterialError;
use nalgebra::{DMatrix, DVector};

/// A gradient below this fraction of ‖b‖ is zero: a few hundred units in the last place of the products that make it.
const GRADIENT_TOLERANCE: f64 = 1e-13;
/// A column is dependent on those already taken when this fraction of it, or less, is its own.
const INDEPENDENCE: f64 = 1e-10;

/// The x ≥ 0 that makes ‖A x − b‖ least, and how well it satisfies the conditions of a minimum.
#[derive(Debug, Clone, PartialEq)]
pub struct NonNegativeSolution {
    /// x, exactly zero where the bound holds it.
    pub coefficients: Vec<f64>,
    /// ‖A x − b‖.
    pub residual: f64,
    /// Largest violation of the Karush–Kuhn–Tucker conditions: with w = Aᵀ(b − A x) over columns scaled to length 1, the largest of
    /// |w_j| where x_j > 0 and of w_j where x_j = 0, over ‖b‖.
    pub optimality: f64,
    /// Whether it came to rest.
    pub converged: bool,
}

/// Solves min ‖A x − b‖, x ≥ 0, by the active sets of Lawson and Hanson (*Solving Least Squares Problems*, 1974, chapter 23),
/// each set by Householder reflections on columns scaled to length 1. A column of zeros gets the coefficient 0.
///
/// # Errors
/// [`MaterialError::LeastSquares`] when the sizes differ or a number is not finite.
pub fn non_negative_least_squares(
    matrix: &DMatrix<f64>,
    right: &DVector<f64>,
) -> Result<NonNegativeSolution, MaterialError> {
    let finite = matrix.iter().chain(right.iter()).all(|value| value.is_finite());
    if matrix.nrows() != right.len() || !finite {
        return Err(MaterialError::LeastSquares);
    }
    let mut scaled = matrix.clone();
    let lengths: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
    for (mut column, length) in scaled.column_iter_mut().zip(&lengths) {
        column /= if *length > 0.0 { *length } else { 1.0 };
    }
    let mut solution = ActiveSets::new(&scaled, right).solve();
    for (value, length) in solution.coefficients.iter_mut().zip(&lengths) {
        *value /= if *length > 0.0 { *length } else { 1.0 };
    }
    Ok(solution)
}

struct ActiveSets<'a> {
    matrix: &'a DMatrix<f64>,
    right: &'a DVector<f64>,
    taken: Vec<usize>,
    values: DVector<f64>,
}

impl<'a> ActiveSets<'a> {
    fn new(matrix: &'a DMatrix<f64>, right: &'a DVector<f64>) -> Self {
        Self { matrix, right, taken: Vec::new(), values: DVector::zeros(matrix.ncols()) }
    }

    fn solve(mut self) -> NonNegativeSolution {
        let smallest = GRADIENT_TOLERANCE * self.right.norm();
        // three times the columns is the customary limit; the sets are finite and none comes twice
        let most = 3 * self.matrix.ncols() + 10;
        let mut refused = vec![false; self.matrix.ncols()];
        let mut converged = false;
        for _ in 0..most {
            let gradient = self.gradient();
            let free = |j: &usize| !self.taken.contains(j) && !refused[*j] && gradient[*j] > smallest;
            let steepest =
                (0..gradient.len()).filter(free).max_by(|a, b| gradient[*a].total_cmp(&gradient[*b]));
            let Some(next) = steepest else {
                converged = true;
                break;
            };
            if self.take(next) {
                refused.fill(false);
            } else {
                refused[next] = true;
            }
        }
        let gradient = self.gradient();
        let violation =
            |j: usize| if self.values[j] > 0.0 { gradient[j].abs() } else { gradient[j].max(0.0) };
        let worst = (0..gradient.len()).map(violation).fold(0.0, f64::max);
        let scale = self.right.norm();
        NonNegativeSolution {
            residual: (self.right - self.matrix * &self.values).norm(),
            optimality: if scale > 0.0 { worst / scale } else { 0.0 },
            coefficients: self.values.as_slice().to_vec(),
            converged,
        }
    }

    /// w = Aᵀ(b − A x).
    fn gradient(&self) -> DVector<f64> {
        self.matrix.tr_mul(&(self.right - self.matrix * &self.values))
    }

    /// Lets one more coefficient be positive and moves to the least squares of the set, dropping those that would turn negative.
    /// False, and nothing is changed, if the newcomer itself would not be positive.
    fn take(&mut self, next: usize) -> bool {
        let before = (self.taken.clone(), self.values.clone());
        self.taken.push(next);
        let mut first = true;
        while let Some(target) = self.unbounded() {
            if first && target[target.len() - 1] <= 0.0 {
                break;
            }
            first = false;
            if target.iter().all(|wanted| *wanted > 0.0) {
                self.values.fill(0.0);
                self.taken.iter().zip(target.iter()).for_each(|(j, wanted)| self.values[*j] = *wanted);
                return true;
            }
            self.move_towards(&target);
        }
        (self.taken, self.values) = before;
        false
    }

    /// Goes towards values some of which are not positive until the first coefficient reaches zero, and drops that one.
    fn move_towards(&mut self, target: &DVector<f64>) {
        let negative = (0..self.taken.len()).filter(|k| target[*k] <= 0.0);
        let reach = |k: usize| self.values[self.taken[k]] / (self.values[self.taken[k]] - target[k]);
        let Some((step, dropped)) = negative.map(|k| (reach(k), k)).min_by(|a, b| a.0.total_cmp(&b.0)) else {
            return;
        };
        for (j, wanted) in self.taken.iter().zip(target.iter()) {
            self.values[*j] = (self.values[*j] + step * (wanted - self.values[*j])).max(0.0);
        }
        self.values[self.taken.remove(dropped)] = 0.0;
    }

    /// Least squares over the columns taken; `None` where one of them depends on the others.
    fn unbounded(&self) -> Option<DVector<f64>> {
        let columns = self.matrix.select_columns(&self.taken);
        if columns.ncols() > columns.nrows() {
            return None;
        }
        let factors = columns.qr();
        let triangle = factors.r();
        if triangle.diagonal().iter().any(|own| own.abs() <= INDEPENDENCE) {
            return None;
        }
        let mut projected = self.right.clone();
        factors.q_tr_mul(&mut projected);
        triangle.solve_upper_triangular(&projected.rows(0, self.taken.len()).into_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_bound_that_holds_and_one_that_does_not() {
        // without bounds x = (1, −1); with them x1 is the projection of b on the first column
        let matrix = DMatrix::from_row_slice(3, 2, &[1.0, 0.0, 1.0, 1.0, 0.0, 1.0]);
        let right = DVector::from_column_slice(&[1.0, 0.0, -1.0]);
        let solution = non_negative_least_squares(&matrix, &right).unwrap();
        assert!((solution.coefficients[0] - 0.5).abs() < 1e-15 && solution.coefficients[1] == 0.0);
        assert!(solution.converged && solution.optimality < 1e-15);
    }

    #[test]
    fn a_column_twice_and_a_column_of_zeros_do_no_harm() {
        let matrix = DMatrix::from_row_slice(2, 3, &[1.0, 1.0, 0.0, 2.0, 2.0, 0.0]);
        let solution = non_negative_least_squares(&matrix, &DVector::from_column_slice(&[3.0, 6.0])).unwrap();
        assert!((solution.coefficients[0] + solution.coefficients[1] - 3.0).abs() < 1e-14);
        assert!(solution.converged && solution.coefficients[2] == 0.0);
        let none = DMatrix::from_element(2, 2, f64::NAN);
        assert!(non_negative_least_squares(&none, &DVector::zeros(2)).is_err());
    }

    proptest! {
        #[test]
        fn the_conditions_of_a_minimum_hold(
            entries in prop::collection::vec(-1.0..1.0_f64, 12 * 7),
            right in prop::collection::vec(-1.0..1.0_f64, 12),
        ) {
            let (matrix, right) = (DMatrix::from_row_slice(12, 7, &entries), DVector::from_vec(right));
            let solution = non_negative_least_squares(&matrix, &right).unwrap();
            prop_assert!(solution.converged && solution.optimality < 1e-12, "{:?}", solution);
            prop_assert!(solution.coefficients.iter().all(|x| *x >= 0.0));
            // no step along any column that the bounds allow makes the residual smaller
            let values = DVector::from_column_slice(&solution.coefficients);
            for j in 0..7 {
                for step in [-1e-4, 1e-4] {
                    let mut moved = values.clone();
                    moved[j] = (moved[j] + step).max(0.0);
                    let residual = (&right - &matrix * moved).norm();
                    prop_assert!(residual >= solution.residual - 1e-13);
                }
            }
        }
    }
}
