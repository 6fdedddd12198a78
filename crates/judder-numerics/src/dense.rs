//! Small dense systems of linear equations, and the eigenvalues of a small matrix.

use crate::polynomial::{PolynomialError, real_polynomial_roots};
use num_complex::Complex64;
use std::array::from_fn;

/// A square matrix as the product of its triangles, with rows exchanged for size.
#[derive(Debug, Clone, PartialEq)]
pub struct Triangles {
    size: usize,
    entries: Vec<f64>,
    rows: Vec<usize>,
}

impl Triangles {
    /// The triangles of a matrix of `size` rows, given row by row; `None` where it is singular or not finite.
    #[must_use]
    pub fn new(size: usize, mut entries: Vec<f64>) -> Option<Self> {
        let mut rows: Vec<usize> = (0..size).collect();
        for column in 0..size {
            let magnitude = |row: usize| entries[row * size + column].abs();
            let pivot = (column..size)
                .fold(column, |best, row| if magnitude(row) > magnitude(best) { row } else { best });
            let largest = magnitude(pivot);
            if largest == 0.0 || !largest.is_finite() {
                return None;
            }
            if pivot != column {
                rows.swap(pivot, column);
                for k in 0..size {
                    entries.swap(pivot * size + k, column * size + k);
                }
            }
            for row in column + 1..size {
                let factor = entries[row * size + column] / entries[column * size + column];
                entries[row * size + column] = factor;
                for k in column + 1..size {
                    entries[row * size + k] -= factor * entries[column * size + k];
                }
            }
        }
        Some(Self { size, entries, rows })
    }

    /// The solution for one right-hand side, in its place.
    pub fn solve(&self, right: &mut [f64]) {
        let n = self.size;
        let exchanged: Vec<f64> = self.rows.iter().map(|row| right[*row]).collect();
        right[..n].copy_from_slice(&exchanged);
        for row in 0..n {
            let known = (0..row).fold(0.0, |sum, k| sum + self.entries[row * n + k] * right[k]);
            right[row] -= known;
        }
        for row in (0..n).rev() {
            let known = (row + 1..n).fold(0.0, |sum, k| sum + self.entries[row * n + k] * right[k]);
            right[row] = (right[row] - known) / self.entries[row * n + row];
        }
    }
}

/// The eigenvalues of a small matrix, sorted by imaginary, then real part; conjugates are exact.
///
/// Roots of the characteristic polynomial by Faddeev and Le Verrier: meant for a handful of rows of like size.
///
/// # Errors
/// Entries that are not finite, or an iteration that did not settle.
pub fn eigenvalues<const N: usize>(matrix: &[[f64; N]; N]) -> Result<Vec<Complex64>, PolynomialError> {
    let mut coefficients = vec![0.0; N + 1];
    coefficients[N] = 1.0;
    let mut power = [[0.0; N]; N];
    for k in 1..=N {
        let mut shifted = power;
        for (i, row) in shifted.iter_mut().enumerate() {
            row[i] += coefficients[N - k + 1];
        }
        power = product(matrix, &shifted);
        let trace = (0..N).fold(0.0, |sum, i| sum + power[i][i]);
        coefficients[N - k] = -trace / k as f64;
    }
    real_polynomial_roots(&coefficients)
}

/// A · B.
#[must_use]
pub fn product<const N: usize>(a: &[[f64; N]; N], b: &[[f64; N]; N]) -> [[f64; N]; N] {
    from_fn(|i| from_fn(|j| (0..N).fold(0.0, |sum, k| sum + a[i][k] * b[k][j])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn eigenvalues_of_a_companion_matrix_are_the_roots() {
        // (λ − 1)(λ − 2)(λ² + 1) = λ⁴ − 3λ³ + 3λ² − 3λ + 2
        let companion =
            [[0.0, 0.0, 0.0, -2.0], [1.0, 0.0, 0.0, 3.0], [0.0, 1.0, 0.0, -3.0], [0.0, 0.0, 1.0, 3.0]];
        let expected = [(0.0, -1.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0)];
        for (value, (re, im)) in eigenvalues(&companion).unwrap().iter().zip(expected) {
            assert!((value - Complex64::new(re, im)).norm() < 1e-13, "{value}");
        }
    }

    #[test]
    fn a_singular_matrix_has_none() {
        assert!(Triangles::new(2, vec![1.0, 2.0, 2.0, 4.0]).is_none());
        assert!(Triangles::new(1, vec![f64::NAN]).is_none());
    }

    proptest! {
        #[test]
        fn products_with_the_solution_give_the_right_side(
            entries in prop::collection::vec(-1.0..1.0_f64, 25), right in prop::collection::vec(-1.0..1.0_f64, 5)
        ) {
            // a diagonal that outweighs each row keeps the condition small
            let matrix: Vec<f64> = entries.iter().enumerate().map(|(k, a)| if k % 6 == 0 { a + 6.0 } else { *a }).collect();
            let mut x = right.clone();
            Triangles::new(5, matrix.clone()).unwrap().solve(&mut x);
            for row in 0..5 {
                let product: f64 = (0..5).map(|k| matrix[row * 5 + k] * x[k]).sum();
                prop_assert!((product - right[row]).abs() < 1e-13);
            }
        }
    }
}
