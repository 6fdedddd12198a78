//! Complex vectors.

use faer::{ColRef, MatRef, c64};

/// A vector as a block of one.
pub(crate) fn column(vector: &[c64]) -> MatRef<'_, c64> {
    MatRef::from_column_major_slice(vector, vector.len(), 1)
}

/// aᵀ b, nothing conjugate.
pub(crate) fn bilinear(a: &[c64], b: ColRef<'_, c64>) -> c64 {
    a.iter().enumerate().map(|(row, a)| a * b[row]).sum()
}

/// |aᴴ b|² of vectors of length one: the modal assurance criterion.
pub(crate) fn assurance(a: &[c64], b: &[c64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.conj() * b).sum::<c64>().norm_sqr()
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
