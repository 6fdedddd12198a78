//! Eigenvalues and solutions of dense matrices that need not be symmetric.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, EvdParams, evd_cplx, evd_real, evd_scratch};
use faer::linalg::lu::partial_pivoting::factor::{PartialPivLuParams, lu_in_place, lu_in_place_scratch};
use faer::linalg::lu::partial_pivoting::solve::{solve_in_place_scratch, solve_in_place_with_conj};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_unit_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::traits::ComplexField;
use faer::{Accum, Conj, Mat, MatMut, MatRef, Par, Spec, c64};
use rayon::prelude::*;

/// A v = λ v for a complex matrix: the values, and vectors as columns. `None` where the iteration does not end.
#[must_use]
pub fn complex_eigen(matrix: MatRef<'_, c64>) -> Option<(Vec<c64>, Mat<c64>)> {
    let size = matrix.nrows();
    let finite = |entry: c64| entry.re.is_finite() && entry.im.is_finite();
    if !(0..size).all(|j| (0..size).all(|i| finite(matrix[(i, j)]))) {
        return None;
    }
    let parameters = Spec::<EvdParams, c64>::default();
    let (none, all) = (ComputeEigenvectors::No, ComputeEigenvectors::Yes);
    let mut memory = MemBuffer::try_new(evd_scratch::<c64>(size, none, all, Par::Seq, parameters)).ok()?;
    let (mut values, mut vectors) = (Diag::<c64>::zeros(size), Mat::zeros(size, size));
    let stack = MemStack::new(&mut memory);
    evd_cplx(matrix, values.as_mut(), None, Some(vectors.as_mut()), Par::Seq, stack, parameters).ok()?;
    Some(((0..size).map(|k| values.column_vector()[k]).collect(), vectors))
}

/// X with A X = B, in place of B; `None` where A is singular.
#[must_use]
pub fn solve(mut matrix: Mat<f64>, right: &mut Mat<f64>) -> Option<()> {
    solve_in_place(matrix.as_mut(), right.as_mut()).map(|_| ())
}

/// The same with factors in place of A: 1 where the determinant of A is positive, −1 where it is negative.
#[must_use]
pub fn solve_in_place(matrix: MatMut<'_, f64>, right: MatMut<'_, f64>) -> Option<f64> {
    /// Rows from which on cores share the work.
    const LARGE: usize = 512;
    if matrix.nrows() >= LARGE { solve_shared(matrix, right) } else { solve_alone(matrix, right) }
}

/// Columns that are eliminated together.
const PANEL: usize = 128;
/// Columns that are changed together: pieces do not depend on the number of threads, so neither does the result.
const TILE: usize = 128;

/// The same by panels whose effects on the columns after them are worked side by side.
fn solve_shared(mut matrix: MatMut<'_, f64>, mut right: MatMut<'_, f64>) -> Option<f64> {
    let size = matrix.nrows();
    let parameters = Spec::<PartialPivLuParams, f64>::default();
    let mut exchanges = 0;
    for start in (0..size).step_by(PANEL) {
        let (rows, width) = (size - start, PANEL.min(size - start));
        let left = matrix.as_mut().submatrix_mut(start, start, rows, rows);
        let (mut panel, rest) = left.split_at_col_mut(width);
        let (mut forward, mut inverse) = (vec![0_usize; rows], vec![0; rows]);
        let needed = lu_in_place_scratch::<usize, f64>(rows, width, Par::Seq, parameters);
        let mut memory = MemBuffer::try_new(needed).ok()?;
        let stack = MemStack::new(&mut memory);
        let (done, _) = lu_in_place(panel.as_mut(), &mut forward, &mut inverse, Par::Seq, stack, parameters);
        exchanges += done.transposition_count;
        let (panel, exchanged) = (panel.as_ref(), exchanged_rows(&forward, width));
        rest.par_col_chunks_mut(TILE).for_each(|tile| eliminate_from(panel, &exchanged, tile));
        eliminate_from(panel, &exchanged, right.as_mut().subrows_mut(start, rows));
    }
    solve_upper_triangular_in_place(matrix.as_ref(), right.as_mut(), Par::Seq);
    let sign = sign_of(matrix.as_ref(), exchanges);
    right.is_all_finite().then_some(sign)
}

/// The sign of the determinant, from the factors.
fn sign_of(factors: MatRef<'_, f64>, exchanges: usize) -> f64 {
    let negative = (0..factors.nrows()).filter(|k| factors[(*k, *k)] < 0.0).count();
    if (negative + exchanges).is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// The exchanges of two rows, one for each column of a panel, that bring rows into an order.
fn exchanged_rows(order: &[usize], width: usize) -> Vec<usize> {
    let (mut rows, mut places): (Vec<usize>, Vec<usize>) =
        ((0..order.len()).collect(), (0..order.len()).collect());
    let exchange = |k: usize| {
        let place = places[order[k]];
        rows.swap(k, place);
        (places[rows[k]], places[rows[place]]) = (k, place);
        place
    };
    (0..width).map(exchange).collect()
}

/// Columns after a panel of L and U: their rows in its order, its own of them divided by L, the rows below less what these bring.
fn eliminate_from(panel: MatRef<'_, f64>, exchanged: &[usize], mut columns: MatMut<'_, f64>) {
    for k in 0..columns.ncols() {
        for (row, other) in exchanged.iter().enumerate().filter(|(row, other)| row != *other) {
            let (before, after) = (columns[(row, k)], columns[(*other, k)]);
            (columns[(row, k)], columns[(*other, k)]) = (after, before);
        }
    }
    let (top, below) = panel.split_at_row(panel.ncols());
    let (mut own, rest) = columns.split_at_row_mut(panel.ncols());
    solve_unit_lower_triangular_in_place(top, own.as_mut(), Par::Seq);
    matmul(rest, Accum::Add, below, own.as_ref(), -1.0, Par::Seq);
}

/// The same for complex matrices.
#[must_use]
pub fn solve_complex(mut matrix: Mat<c64>, right: &mut Mat<c64>) -> Option<()> {
    solve_over(matrix.as_mut(), right.as_mut()).map(|_| ())
}

fn solve_alone(mut matrix: MatMut<'_, f64>, right: MatMut<'_, f64>) -> Option<f64> {
    let exchanges = solve_over(matrix.as_mut(), right)?;
    Some(sign_of(matrix.as_ref(), exchanges))
}

/// How many rows were exchanged.
fn solve_over<T: ComplexField>(mut matrix: MatMut<'_, T>, mut right: MatMut<'_, T>) -> Option<usize> {
    let size = matrix.nrows();
    let (mut forward, mut inverse) = (vec![0_usize; size], vec![0; size]);
    let parameters = Spec::<PartialPivLuParams, T>::default();
    let needed = lu_in_place_scratch::<usize, T>(size, size, Par::Seq, parameters)
        .or(solve_in_place_scratch::<usize, T>(size, right.ncols(), Par::Seq));
    let mut memory = MemBuffer::try_new(needed).ok()?;
    let stack = MemStack::new(&mut memory);
    let (done, rows) = lu_in_place(matrix.as_mut(), &mut forward, &mut inverse, Par::Seq, stack, parameters);
    let exchanges = done.transposition_count;
    let (factors, stack) = (matrix.as_ref(), MemStack::new(&mut memory));
    solve_in_place_with_conj(factors, factors, rows, Conj::No, right.as_mut(), Par::Seq, stack);
    right.is_all_finite().then_some(exchanges)
}

/// The pivots of P A = L U, in place of A, and whether P is an odd number of exchanges; `None` where there is no memory.
#[must_use]
pub fn pivots(matrix: &mut Mat<c64>) -> Option<(Vec<c64>, bool)> {
    let size = matrix.nrows();
    let (mut forward, mut inverse) = (vec![0_usize; size], vec![0; size]);
    let parameters = Spec::<PartialPivLuParams, c64>::default();
    let needed = lu_in_place_scratch::<usize, c64>(size, size, Par::Seq, parameters);
    let mut memory = MemBuffer::try_new(needed).ok()?;
    let stack = MemStack::new(&mut memory);
    let (done, _) = lu_in_place(matrix.as_mut(), &mut forward, &mut inverse, Par::Seq, stack, parameters);
    let odd = done.transposition_count % 2 == 1;
    Some(((0..size).map(|k| matrix[(k, k)]).collect(), odd))
}

/// P A = L U in place of A: which row of A each row of the factors was; `None` where there is no memory.
#[must_use]
pub fn eliminate_complex(matrix: MatMut<'_, c64>) -> Option<Vec<usize>> {
    let size = matrix.nrows();
    let (mut forward, mut inverse) = (vec![0_usize; size], vec![0; size]);
    let parameters = Spec::<PartialPivLuParams, c64>::default();
    let needed = lu_in_place_scratch::<usize, c64>(size, size, Par::Seq, parameters);
    let mut memory = MemBuffer::try_new(needed).ok()?;
    lu_in_place(matrix, &mut forward, &mut inverse, Par::Seq, MemStack::new(&mut memory), parameters);
    Some(forward)
}

/// A v = λ v and wᴴ A = λ wᴴ for a real matrix, those of its eigenvalues that a test picks; vectors are columns, of length one.
pub struct PickedEigenvalues {
    /// λ.
    pub values: Vec<c64>,
    /// v.
    pub right: Mat<c64>,
    /// w.
    pub left: Mat<c64>,
}

/// The eigenvalues of a real matrix; `None` where the iteration does not end or memory is short.
#[must_use]
pub fn real_eigenvalues(matrix: &Mat<f64>) -> Option<Vec<c64>> {
    let size = matrix.nrows();
    let parameters = Spec::<EvdParams, f64>::default();
    let none = ComputeEigenvectors::No;
    let mut memory = MemBuffer::try_new(evd_scratch::<f64>(size, none, none, Par::Seq, parameters)).ok()?;
    let (mut re, mut im) = (Diag::<f64>::zeros(size), Diag::<f64>::zeros(size));
    let stack = MemStack::new(&mut memory);
    evd_real(matrix.as_ref(), re.as_mut(), im.as_mut(), None, None, Par::Seq, stack, parameters).ok()?;
    Some((0..size).map(|k| c64::new(re.column_vector()[k], im.column_vector()[k])).collect())
}

/// The eigenvalues of a real matrix that `pick` takes, with their vectors; `None` where the iteration does not end.
#[must_use]
pub fn real_eigen(matrix: &Mat<f64>, pick: &dyn Fn(c64) -> bool) -> Option<PickedEigenvalues> {
    let size = matrix.nrows();
    if !(0..size).all(|j| (0..size).all(|i| matrix[(i, j)].is_finite())) {
        return None;
    }
    let parameters = Spec::<EvdParams, f64>::default();
    let all = ComputeEigenvectors::Yes;
    let mut memory = MemBuffer::try_new(evd_scratch::<f64>(size, all, all, Par::Seq, parameters)).ok()?;
    let (mut re, mut im) = (Diag::<f64>::zeros(size), Diag::<f64>::zeros(size));
    let (mut left, mut right) = (Mat::zeros(size, size), Mat::zeros(size, size));
    evd_real(
        matrix.as_ref(),
        re.as_mut(),
        im.as_mut(),
        Some(left.as_mut()),
        Some(right.as_mut()),
        Par::Seq,
        MemStack::new(&mut memory),
        parameters,
    )
    .ok()?;
    let value = |k: usize| c64::new(re.column_vector()[k], im.column_vector()[k]);
    let picked: Vec<usize> = (0..size).filter(|k| pick(value(*k))).collect();
    // of a pair the first column is the real and the second the imaginary part of the vector of the upper value
    let entry = |vectors: &Mat<f64>, row: usize, k: usize| match value(k).im {
        above if above > 0.0 => c64::new(vectors[(row, k)], vectors[(row, k + 1)]),
        below if below < 0.0 => c64::new(vectors[(row, k - 1)], -vectors[(row, k)]),
        _ => c64::new(vectors[(row, k)], 0.0),
    };
    let gathered = |vectors: &Mat<f64>| {
        let mut gathered = Mat::from_fn(size, picked.len(), |row, k| entry(vectors, row, picked[k]));
        for k in 0..picked.len() {
            let length = gathered.col(k).norm_l2();
            for row in 0..size {
                gathered[(row, k)] /= length;
            }
        }
        gathered
    };
    Some(PickedEigenvalues {
        values: picked.iter().map(|k| value(*k)).collect(),
        right: gathered(&right),
        left: gathered(&left),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_numerics::counter::uniform;

    #[test]
    fn a_large_system_is_solved_as_a_small_one() {
        let size = 700;
        let matrix = Mat::from_fn(size, size, |i, j| uniform(9, (size * i + j) as u64) - 0.5);
        let right = Mat::from_fn(size, 2, |i, j| uniform(10, (2 * i + j) as u64));
        let (mut shared, mut alone) = (right.clone(), right.clone());
        let signs = [
            solve_shared(matrix.clone().as_mut(), shared.as_mut()).unwrap(),
            solve_alone(matrix.clone().as_mut(), alone.as_mut()).unwrap(),
        ];
        assert_eq!(signs[0], signs[1]);
        assert!((&matrix * &shared - &right).norm_max() < 1e-9);
        assert!((&shared - &alone).norm_max() < 1e-9 * alone.norm_max());
    }

    #[test]
    fn the_sign_is_that_of_the_determinant() {
        let signs = [[2.0, 1.0, 1.0, 3.0], [1.0, 2.0, 3.0, 1.0], [-1.0, 0.5, 0.0, 2.0]];
        for [a, b, c, d] in signs {
            let mut matrix = Mat::from_fn(2, 2, |i, j| [[a, b], [c, d]][i][j]);
            let sign = solve_in_place(matrix.as_mut(), Mat::zeros(2, 1).as_mut()).unwrap();
            assert_eq!(sign, f64::signum(a * d - b * c));
        }
    }

    #[test]
    fn eigenvectors_of_real_matrices_belong_to_their_values_on_both_sides() {
        let matrix = Mat::from_fn(30, 30, |i, j| uniform(3, (30 * i + j) as u64) - 0.5);
        let PickedEigenvalues { values, right, left } =
            real_eigen(&matrix, &|value| value.norm() > 0.5).unwrap();
        assert!(values.len() > 20 && values.iter().any(|value| value.im == 0.0));
        for (k, value) in values.iter().enumerate() {
            let row = |i: usize| (0..30).map(|j| right[(j, k)] * matrix[(i, j)]).sum::<c64>();
            let column = |j: usize| (0..30).map(|i| left[(i, k)].conj() * matrix[(i, j)]).sum::<c64>();
            for i in 0..30 {
                assert!((row(i) - value * right[(i, k)]).norm() < 1e-12);
                assert!((column(i) - value * left[(i, k)].conj()).norm() < 1e-12);
            }
        }
    }
}
