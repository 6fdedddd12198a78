//! The product of two dense matrices.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par, c64};
use rayon::prelude::*;

/// Columns that are worked together: pieces do not depend on the number of threads, so neither does the result.
const TILE: usize = 64;

/// A B, some columns at a time, side by side.
#[must_use]
pub fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut image = Mat::zeros(a.nrows(), b.ncols());
    product_into(image.as_mut(), a, b);
    image
}

/// The same into a matrix that there is.
pub fn product_into(image: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    if image.nrows() == 0 || image.ncols() == 0 {
        return;
    }
    if image.ncols() <= TILE {
        matmul(image, Accum::Replace, a, b, 1.0, Par::Seq);
        return;
    }
    image.par_col_chunks_mut(TILE).enumerate().for_each(|(k, tile)| {
        let own = b.subcols(k * TILE, tile.ncols());
        matmul(tile, Accum::Replace, a, own, 1.0, Par::Seq);
    });
}

/// Aᴴ B of complex matrices.
#[must_use]
pub fn adjoint_product(a: MatRef<'_, c64>, b: MatRef<'_, c64>) -> Mat<c64> {
    let mut image = Mat::zeros(a.ncols(), b.ncols());
    matmul(image.as_mut(), Accum::Replace, a.adjoint(), b, c64::new(1.0, 0.0), Par::Seq);
    image
}
