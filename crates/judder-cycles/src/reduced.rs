//! Linear systems some of whose unknowns stand alone in a row.

use faer::Mat;
use judder_dense::general;

/// X with A X = B, in place of B; `None` where A is singular.
///
/// An unknown that is alone in a row, as the force of a point that is open all along, is known from it, and the others are solved for without it.
pub(crate) fn solve(matrix: &Mat<f64>, right: &mut Mat<f64>) -> Option<()> {
    let size = matrix.nrows();
    let mut others = vec![0_usize; size];
    for column in 0..size {
        let entries = matrix.col_as_slice(column);
        for (row, entry) in entries.iter().enumerate() {
            others[row] += usize::from(*entry != 0.0 && row != column);
        }
    }
    let (mut known, mut sought) = (Vec::new(), Vec::new());
    for row in 0..size {
        if others[row] == 0 && matrix[(row, row)] != 0.0 { known.push(row) } else { sought.push(row) }
    }
    if known.is_empty() {
        return general::solve(matrix.clone(), right);
    }
    for column in 0..right.ncols() {
        known.iter().for_each(|k| right[(*k, column)] /= matrix[(*k, *k)]);
        let solution = right.col_as_slice_mut(column);
        for k in &known {
            let value = solution[*k];
            if value != 0.0 {
                sought.iter().for_each(|row| solution[*row] -= matrix[(*row, *k)] * value);
            }
        }
    }
    let left = Mat::from_fn(sought.len(), sought.len(), |i, j| matrix[(sought[i], sought[j])]);
    let mut rest = Mat::from_fn(sought.len(), right.ncols(), |i, j| right[(sought[i], j)]);
    general::solve(left, &mut rest)?;
    for column in 0..right.ncols() {
        sought.iter().enumerate().for_each(|(i, row)| right[(*row, column)] = rest[(i, column)]);
    }
    Some(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
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
        solve(&matrix, &mut solution).unwrap();
        assert!((&matrix * &solution - &right).norm_max() < 1e-13);
    }
}
