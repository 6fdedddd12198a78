//! Linear systems some of whose unknowns stand alone in a row.

use faer::{MatMut, MatRef};
use judder_dense::general::solve_in_place;

/// X with A X = B, in place of B, and 1 or −1 as the determinant of A is positive or negative; `None` where A is singular. Nothing is left of A.
///
/// An unknown that is alone in a row, as the force of a point that is open all along, is known from it, and the others are solved for without it.
pub(crate) fn solve(mut matrix: MatMut<'_, f64>, mut right: MatMut<'_, f64>) -> Option<f64> {
    let (known, sought) = told_apart(matrix.as_ref());
    if known.is_empty() {
        return solve_in_place(matrix, right);
    }
    let mut sign = 1.0;
    for column in 0..right.ncols() {
        for k in &known {
            let value = right[(*k, column)] / matrix[(*k, *k)];
            right[(*k, column)] = value;
            if value != 0.0 {
                sought.iter().for_each(|row| right[(*row, column)] -= matrix[(*row, *k)] * value);
            }
        }
    }
    known.iter().for_each(|k| sign *= matrix[(*k, *k)].signum());
    // what is sought moves to the front: never past what has not been read yet
    for (j, column) in sought.iter().enumerate() {
        for (i, row) in sought.iter().enumerate() {
            matrix[(i, j)] = matrix[(*row, *column)];
        }
    }
    let known_values: Vec<f64> =
        (0..right.ncols()).flat_map(|j| known.iter().map(move |k| (*k, j))).map(|at| right[at]).collect();
    for column in 0..right.ncols() {
        sought.iter().enumerate().for_each(|(i, row)| right[(i, column)] = right[(*row, column)]);
    }
    let left = matrix.submatrix_mut(0, 0, sought.len(), sought.len());
    sign *= solve_in_place(left, right.as_mut().subrows_mut(0, sought.len()))?;
    for column in 0..right.ncols() {
        for (i, row) in sought.iter().enumerate().rev() {
            right[(*row, column)] = right[(i, column)];
        }
        let values = &known_values[column * known.len()..];
        known.iter().zip(values).for_each(|(k, value)| right[(*k, column)] = *value);
    }
    Some(sign)
}

/// The unknowns that are alone in their rows, and the others.
fn told_apart(matrix: MatRef<'_, f64>) -> (Vec<usize>, Vec<usize>) {
    let size = matrix.nrows();
    let mut has_others = vec![false; size];
    for column in 0..size {
        for (row, has) in has_others.iter_mut().enumerate() {
            *has |= matrix[(row, column)] != 0.0 && row != column;
        }
    }
    (0..size).partition(|row| !has_others[*row] && matrix[(*row, *row)] != 0.0)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use faer::Mat;
    use judder_numerics::counter::uniform;

    #[test]
    fn unknowns_that_stand_alone_are_found_with_the_others() {
        let entry = |i: usize, j: usize| match (i % 3 == 1, i == j) {
            (true, false) => 0.0,
            _ => uniform(5, (9 * i + j) as u64) - 0.4,
        };
        let matrix = Mat::from_fn(9, 9, entry);
        let right = Mat::from_fn(9, 2, |i, j| uniform(6, (2 * i + j) as u64));
        let mut solution = right.clone();
        let sign = solve(matrix.clone().as_mut(), solution.as_mut()).unwrap();
        assert_eq!(sign, matrix.determinant().signum());
        assert!((&matrix * &solution - &right).norm_max() < 1e-13);
    }
}
