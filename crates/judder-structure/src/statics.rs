//! Displacements under loads that rest.

use crate::StructureError;
use crate::assembly::Sparse;
use faer::linalg::cholesky::llt::factor::LltError as Pivot;
use faer::linalg::solvers::Solve;
use faer::sparse::linalg::solvers::{Llt, Lu};
use faer::sparse::linalg::{LltError, LuError};
use faer::sparse::ops::binary_op;
use faer::{ColMut, Side};
use rayon::prelude::*;

/// A stiffness that was factored once for many loads.
#[derive(Debug, Clone)]
pub struct Statics {
    factor: Llt<usize, f64>,
}

impl Statics {
    /// The Cholesky factor of a symmetric, positive definite stiffness; its lower triangle is read.
    ///
    /// # Errors
    /// [`StructureError::NotHeld`] where a pivot is not positive, [`StructureError::OutOfMemory`].
    pub fn new(stiffness: &Sparse) -> Result<Self, StructureError> {
        match stiffness.sp_cholesky(Side::Lower) {
            Ok(factor) => Ok(Self { factor }),
            Err(LltError::Numeric(Pivot::NonPositivePivot { index })) => {
                Err(StructureError::NotHeld { row: index })
            }
            Err(LltError::Generic(_)) => Err(StructureError::OutOfMemory { rows: stiffness.nrows() }),
        }
    }

    /// u with K u = f, in place of f.
    pub fn solve(&self, load: &mut [f64]) {
        self.factor.solve_in_place(ColMut::from_slice_mut(load));
    }
}

/// A stiffness that need not be symmetric, factored once for many loads.
#[derive(Debug, Clone)]
pub struct GeneralStatics {
    factor: Lu<usize, f64>,
}

impl GeneralStatics {
    /// The factors P K Q = L U.
    ///
    /// # Errors
    /// [`StructureError::Singular`] to rounding, [`StructureError::OutOfMemory`].
    pub fn new(stiffness: &Sparse) -> Result<Self, StructureError> {
        let rows = stiffness.nrows();
        let factor = match stiffness.sp_lu() {
            Ok(factor) => Self { factor },
            Err(LuError::SymbolicSingular { .. }) => return Err(StructureError::Singular { rows }),
            Err(LuError::Generic(_)) => return Err(StructureError::OutOfMemory { rows }),
        };
        // a zero pivot shows as what is not finite
        let mut probe = vec![1.0; rows];
        factor.solve(&mut probe);
        match probe.iter().all(|u| u.is_finite()) {
            true => Ok(factor),
            false => Err(StructureError::Singular { rows }),
        }
    }

    /// u with K u = f, in place of f.
    pub fn solve(&self, load: &mut [f64]) {
        self.factor.solve_in_place(ColMut::from_slice_mut(load));
    }
}

/// A x of a sparse matrix.
#[must_use]
pub fn product(matrix: &Sparse, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; matrix.nrows()];
    for (column, factor) in x.iter().enumerate() {
        let values = matrix.val_of_col(column);
        for (row, value) in matrix.row_idx_of_col(column).zip(values) {
            y[row] += value * factor;
        }
    }
    y
}

/// A x of a symmetric matrix with both triangles.
pub(crate) fn symmetric_product(matrix: &Sparse, x: &[f64]) -> Vec<f64> {
    /// Rows that are worked together.
    const CHUNK: usize = 4096;
    let row = |row: usize| (matrix.row_idx_of_col_raw(row), matrix.val_of_col(row));
    let mut y = vec![0.0; matrix.nrows()];
    y.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, y)| {
        let first = chunk * CHUNK;
        let (pairs, last) = y.as_chunks_mut::<2>();
        for (k, pair) in pairs.iter_mut().enumerate() {
            *pair = two_sums([row(first + 2 * k), row(first + 2 * k + 1)], x);
        }
        if let [y] = last {
            let places_and_values = row(first + 2 * pairs.len());
            [*y, _] = two_sums([places_and_values, (&[], &[])], x);
        }
    });
    y
}

/// Σ aₖ x at place k of two rows, side by side: neither sum waits for the other.
fn two_sums(
    [(places, values), (other_places, other_values)]: [(&[usize], &[f64]); 2],
    x: &[f64],
) -> [f64; 2] {
    let common = places.len().min(other_places.len());
    let ((first, rest), (other_first, other_rest)) = (places.split_at(common), other_places.split_at(common));
    let ((a, a_rest), (b, b_rest)) = (values.split_at(common), other_values.split_at(common));
    let mut sums = [-0.0; 2];
    for ((i, a), (j, b)) in first.iter().zip(a).zip(other_first.iter().zip(b)) {
        sums[0] += a * x[*i];
        sums[1] += b * x[*j];
    }
    for (sum, (places, values)) in sums.iter_mut().zip([(rest, a_rest), (other_rest, b_rest)]) {
        for (place, value) in places.iter().zip(values) {
            *sum += value * x[*place];
        }
    }
    sums
}

/// a A + b B of two square matrices of one size, on the union of their patterns.
pub(crate) fn sum(a: f64, first: &Sparse, b: f64, second: &Sparse) -> Result<Sparse, StructureError> {
    let size = |matrix: &Sparse| [matrix.nrows(), matrix.ncols()];
    if size(first) != size(second) || first.nrows() != first.ncols() {
        return Err(StructureError::DifferentSizes { first: size(first), second: size(second) });
    }
    let entry =
        |x: Option<&f64>, y: Option<&f64>| a * x.copied().unwrap_or(0.0) + b * y.copied().unwrap_or(0.0);
    binary_op(first.as_ref(), second.as_ref(), entry)
        .map_err(|_| StructureError::OutOfMemory { rows: first.nrows() })
}

/// aᵀ b.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
