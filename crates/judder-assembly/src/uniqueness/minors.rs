//! Whether all principal minors of a matrix are positive.

use super::complementarity::PIVOTED;
use faer::Mat;
use judder_dense::general::solve;

/// Pivots below so much of the diagonal entries they come from prove nothing: what is divided by them grows.
const SMALL: f64 = 1e-6;
/// Nor do those below so much of the largest entry met on the way to them, of which they may be the rounding.
const ROUNDING: f64 = 1e-11;

/// Whether all principal minors are positive, beyond rounding.
///
/// A matrix is a P-matrix exactly if its first entry is positive, and what is left without the first row and column as well as the Schur complement of the first entry
/// are P-matrices (M. J. Tsatsomeros, L. Li, *A recursive test for P-matrices*, BIT 40, 2000): 2ⁿ steps in place of as many determinants.
pub(super) fn has_positive_minors(matrix: &Mat<f64>) -> bool {
    let count = matrix.nrows();
    let sizes: Vec<f64> = (0..count).map(|k| matrix[(k, k)]).collect();
    is_p_matrix(matrix, &sizes, 0.0)
}

fn is_p_matrix(matrix: &Mat<f64>, sizes: &[f64], met: f64) -> bool {
    let count = matrix.nrows();
    if count == 0 {
        return true;
    }
    let pivot = matrix[(0, 0)];
    let met = matrix.norm_max().max(met);
    // so too where it is not a number
    let is_positive = pivot > SMALL * sizes[0] && pivot > ROUNDING * met;
    if !is_positive {
        return false;
    }
    let rest = Mat::from_fn(count - 1, count - 1, |i, j| matrix[(i + 1, j + 1)]);
    let complement = Mat::from_fn(count - 1, count - 1, |i, j| {
        rest[(i, j)] - matrix[(i + 1, 0)] * matrix[(0, j + 1)] / pivot
    });
    is_p_matrix(&rest, &sizes[1..], met) && is_p_matrix(&complement, &sizes[1..], met)
}

/// Whether a matrix of positive diagonal is an H-matrix, of which all principal minors are positive: its columns can be scaled so that every diagonal entry
/// outweighs the others of its row (A. Berman, R. J. Plemmons, *Nonnegative Matrices in the Mathematical Sciences*, 1994, chapter 6).
pub(super) fn is_diagonally_dominant(matrix: &Mat<f64>) -> bool {
    let count = matrix.nrows();
    if !(0..count).all(|k| matrix[(k, k)] > 0.0) {
        return false;
    }
    let compared = Mat::from_fn(count, count, |i, j| {
        let own = matrix[(i, j)] / (matrix[(i, i)] * matrix[(j, j)]).sqrt();
        if i == j { own } else { -own.abs() }
    });
    // B x = 1 with x > 0 is the scaling, for B has no positive entry beside its diagonal
    let mut scaling = Mat::from_fn(count, 1, |_, _| 1.0);
    if solve(compared.clone(), &mut scaling).is_none() {
        return false;
    }
    let largest = scaling.norm_max();
    // B x > 1/2 stays positive as long as entries wrong by their rounding change it by less
    let row = |i: usize| (0..count).map(|j| compared[(i, j)] * scaling[(j, 0)]).sum::<f64>();
    count as f64 * PIVOTED * largest < 0.5 && (0..count).all(|k| scaling[(k, 0)] > 0.0 && row(k) > 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The determinant of these rows and columns, along the first of the rows.
    fn determinant(matrix: &Mat<f64>, rows: &[usize], columns: &[usize]) -> f64 {
        let Some((row, below)) = rows.split_first() else { return 1.0 };
        let term = |(place, column): (usize, &usize)| {
            let beside: Vec<usize> = columns.iter().copied().filter(|other| other != column).collect();
            let sign = if place % 2 == 0 { 1.0 } else { -1.0 };
            sign * matrix[(*row, *column)] * determinant(matrix, below, &beside)
        };
        columns.iter().enumerate().map(term).sum()
    }

    /// B is singular but for rounding, x ≈ 2.4 · 10¹⁶: nothing is shown; with a little more on the diagonal it is.
    #[test]
    fn what_is_dominant_by_rounding_alone_is_not() {
        let entries = [
            [1.447_957_675_109_063_5, -0.561_792_757_077_695_6, -0.886_164_918_031_368],
            [-0.561_792_757_077_695_6, 1.325_242_434_702_861_5, -0.763_449_677_625_165_9],
            [-0.886_164_918_031_368, -0.763_449_677_625_165_9, 1.649_614_595_656_534],
        ];
        let with =
            |more: f64| Mat::from_fn(3, 3, |i, j| entries[i][j] * if i == j { 1.0 + more } else { 1.0 });
        assert!(!is_diagonally_dominant(&with(0.0)));
        assert!(is_diagonally_dominant(&with(1e-6)));
    }

    /// A small pivot makes the entries after it grow until their rounding has the size of a diagonal entry.
    #[test]
    fn minors_beside_a_small_pivot_are_not_shown() {
        let matrix = |pivot: f64| {
            let entries = [[pivot, 1.0, 0.0], [-1.0, 1.0, 0.5], [0.0, -0.5, 1.0]];
            Mat::from_fn(3, 3, |i, j| entries[i][j])
        };
        assert!(has_positive_minors(&matrix(0.01)));
        assert!(!has_positive_minors(&matrix(1e-12)));
    }

    /// Of many matrices of four rows: as by all determinants; what is dominant has positive minors.
    #[test]
    fn minors_are_those_of_determinants() {
        let mut counts = [0; 3];
        for case in 0..400_u32 {
            let entry = |i: usize, j: usize| {
                let angle = f64::from(case) * 1.7 + 3.1 * i as f64 + 5.3 * j as f64;
                let own = (angle * angle).sin();
                if i == j { 1.0 + 0.3 * own } else { own }
            };
            let matrix = Mat::from_fn(4, 4, entry);
            let sets = (1..16_usize).map(|set| (0..4).filter(|k| set >> k & 1 == 1).collect::<Vec<_>>());
            let by_determinants = sets.map(|rows| determinant(&matrix, &rows, &rows)).all(|own| own > 0.0);
            assert_eq!(has_positive_minors(&matrix), by_determinants, "{case}");
            let dominant = is_diagonally_dominant(&matrix);
            assert!(by_determinants || !dominant);
            counts[0] += usize::from(by_determinants);
            counts[1] += usize::from(!by_determinants);
            counts[2] += usize::from(dominant);
        }
        assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    }
}
