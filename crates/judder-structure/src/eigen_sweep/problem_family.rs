//! Problems over parameters, as a sweep sees them.

use crate::StructureError;
use crate::affine::{AffineFamily, Factors, Term};
use crate::assembly::Sparse;
use crate::quadratic::Quadratic;
use crate::statics::{dot, product};
use faer::Mat;
use rayon::prelude::*;

/// Problems of one size over parameters.
pub trait ProblemFamily: Sync {
    /// The values of the parameters.
    type Point: Sync;
    /// What of the problems on a basis does not depend on the point.
    type OnBasis: Sync;
    /// Why there is no problem at a point.
    type Error: From<StructureError> + Send;

    /// The problem at a point.
    ///
    /// # Errors
    /// Where there is none.
    fn at(&self, point: &Self::Point) -> Result<Quadratic, Self::Error>;

    /// Numbers that differ little from those of another point where the problems do.
    fn coordinates(&self, point: &Self::Point) -> Vec<f64>;

    /// Prepares problems on the basis V of these columns.
    fn on_basis(&self, basis: &[Vec<f64>]) -> Self::OnBasis;

    /// VᵀMV, VᵀCV and VᵀKV of the problem at a point.
    fn projected(
        &self,
        prepared: &Self::OnBasis,
        basis: &[Vec<f64>],
        point: &Self::Point,
        problem: &Quadratic,
    ) -> [Mat<f64>; 3];
}

/// The terms Vᵀ A V of an affine family.
pub struct ProjectedTerms {
    mass: Vec<Mat<f64>>,
    damping: Vec<Mat<f64>>,
    stiffness: Vec<Mat<f64>>,
}

impl ProblemFamily for AffineFamily {
    type Point = Factors;
    type OnBasis = ProjectedTerms;
    type Error = StructureError;

    fn at(&self, factors: &Factors) -> Result<Quadratic, StructureError> {
        Self::at(self, factors)
    }

    fn coordinates(&self, factors: &Factors) -> Vec<f64> {
        factors.mass.iter().chain(&factors.damping).chain(&factors.stiffness).copied().collect()
    }

    fn on_basis(&self, basis: &[Vec<f64>]) -> ProjectedTerms {
        let each = |terms: &[Term]| terms.iter().map(|term| projected(&term.matrix, basis)).collect();
        ProjectedTerms {
            mass: each(self.mass()),
            damping: each(self.damping()),
            stiffness: each(self.stiffness()),
        }
    }

    fn projected(
        &self,
        terms: &ProjectedTerms,
        basis: &[Vec<f64>],
        factors: &Factors,
        _: &Quadratic,
    ) -> [Mat<f64>; 3] {
        [
            sum(&terms.mass, &factors.mass, basis.len()),
            sum(&terms.damping, &factors.damping, basis.len()),
            sum(&terms.stiffness, &factors.stiffness, basis.len()),
        ]
    }
}

/// Vᵀ A V.
#[must_use]
pub fn projected(matrix: &Sparse, basis: &[Vec<f64>]) -> Mat<f64> {
    let columns: Vec<Vec<f64>> = basis
        .par_iter()
        .map(|vector| {
            let image = product(matrix, vector);
            basis.iter().map(|left| dot(left, &image)).collect()
        })
        .collect();
    Mat::from_fn(basis.len(), basis.len(), |i, j| columns[j][i])
}

/// Σ fᵢ Aᵢ.
fn sum(matrices: &[Mat<f64>], factors: &[f64], size: usize) -> Mat<f64> {
    Mat::from_fn(size, size, |i, j| matrices.iter().zip(factors).map(|(matrix, f)| f * matrix[(i, j)]).sum())
}
