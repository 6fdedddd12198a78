//! Complex vectors.

use faer::{ColRef, Mat, MatRef, c64};
use judder_dense::product::adjoint_product;

/// A vector as a block of one.
pub(crate) fn column(vector: &[c64]) -> MatRef<'_, c64> {
    MatRef::from_column_major_slice(vector, vector.len(), 1)
}

/// aᵀ b, nothing conjugate.
pub(crate) fn bilinear(a: &[c64], b: ColRef<'_, c64>) -> c64 {
    a.iter().enumerate().map(|(row, a)| a * b[row]).sum()
}

/// Vectors of one length as columns.
pub(crate) fn columns(vectors: &[&[c64]]) -> Mat<c64> {
    let rows = vectors.first().map_or(0, |vector| vector.len());
    Mat::from_fn(rows, vectors.len(), |row, k| vectors[k][row])
}

/// |aᴴ b|² of each of some vectors of length one with each of others: the modal assurance criterion.
pub(crate) fn assurances(a: &[&[c64]], b: &[&[c64]]) -> Mat<f64> {
    if a.is_empty() || b.is_empty() {
        return Mat::zeros(a.len(), b.len());
    }
    let products = adjoint_product(columns(a).as_ref(), columns(b).as_ref());
    Mat::from_fn(a.len(), b.len(), |i, k| products[(i, k)].norm_sqr())
}

/// √(vᴴ v).
pub(crate) fn length(vector: &[c64]) -> f64 {
    vector.iter().map(c64::norm_sqr).sum::<f64>().sqrt()
}

/// Makes a vector's length one.
pub(crate) fn normalise(vector: &mut [c64]) {
    let length = length(vector);
    for v in vector {
        *v /= length;
    }
}
