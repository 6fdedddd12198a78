//! Products of a real sparse matrix with blocks of complex vectors, for some of which it is read together.

use super::MatrixSide;
use crate::assembly::Sparse;
use faer::{Mat, MatRef, c64};

/// Vectors that a matrix is read for together.
pub(super) const TOGETHER: usize = 4;

/// Y += a A X of a block of complex vectors, or with Aᵀ.
pub(super) fn add_product(
    matrix: &Sparse,
    side: MatrixSide,
    factor: c64,
    x: MatRef<'_, c64>,
    y: &mut Mat<c64>,
) {
    in_groups(x.ncols(), &mut |first, together| match together {
        TOGETHER => add_group::<TOGETHER>(matrix, side, factor, x, first, y),
        _ => add_group::<1>(matrix, side, factor, x, first, y),
    });
}

/// Calls for the first of every group of vectors, with how many they are: as many as go together, or one.
pub(super) fn in_groups(vectors: usize, call: &mut dyn FnMut(usize, usize)) {
    let whole = vectors - vectors % TOGETHER;
    (0..whole).step_by(TOGETHER).for_each(|first| call(first, TOGETHER));
    (whole..vectors).for_each(|first| call(first, 1));
}

/// The same of N vectors from a number on.
fn add_group<const N: usize>(
    matrix: &Sparse,
    side: MatrixSide,
    factor: c64,
    x: MatRef<'_, c64>,
    first: usize,
    y: &mut Mat<c64>,
) {
    let (from, mut to) = (packed::<N>(x, first), packed::<N>(y.as_ref(), first));
    add_products(matrix, side, factor, &from, &mut to);
    for (row, to) in to.iter().enumerate() {
        to.iter().enumerate().for_each(|(k, to)| y[(row, first + k)] = *to);
    }
}

/// The entries of N vectors from a number on, row by row.
pub(super) fn packed<const N: usize>(x: MatRef<'_, c64>, first: usize) -> Vec<[c64; N]> {
    (0..x.nrows()).map(|row| std::array::from_fn(|k| x[(row, first + k)])).collect()
}

/// Y += a A X, or with Aᵀ, of N vectors that lie row by row; of each its sums are those of a single one.
pub(super) fn add_products<const N: usize>(
    matrix: &Sparse,
    side: MatrixSide,
    factor: c64,
    from: &[[c64; N]],
    to: &mut [[c64; N]],
) {
    for column in 0..matrix.ncols() {
        let entries = matrix.row_idx_of_col_raw(column).iter().zip(matrix.val_of_col(column));
        match side {
            MatrixSide::Right => {
                let shares = from[column].map(|from| from * factor);
                for (row, value) in entries {
                    to[*row].iter_mut().zip(&shares).for_each(|(to, share)| *to += share * *value);
                }
            }
            MatrixSide::Left => {
                let mut sums = [c64::new(0.0, 0.0); N];
                for (row, value) in entries {
                    sums.iter_mut().zip(&from[*row]).for_each(|(sum, from)| *sum += from * *value);
                }
                to[column].iter_mut().zip(sums).for_each(|(to, sum)| *to += factor * sum);
            }
        }
    }
}
