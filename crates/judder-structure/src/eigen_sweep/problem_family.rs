//! Problems over parameters, as a sweep sees them.

use crate::StructureError;
use crate::affine::{AffineFamily, Factors, Term};
use crate::assembly::Sparse;
use crate::quadratic::Quadratic;
use crate::statics;
use faer::{Mat, MatRef};
use judder_dense::product::product;
use judder_numerics::parallel;
use std::array;

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

    /// Prepares problems on the basis V of these columns, of which one is that of a sample.
    fn on_basis(&self, basis: MatRef<'_, f64>, sample: &Quadratic) -> Self::OnBasis;

    /// VᵀMV, VᵀCV and VᵀKV of the problem at a point.
    fn projected(
        &self,
        prepared: &Self::OnBasis,
        basis: MatRef<'_, f64>,
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

    fn on_basis(&self, basis: MatRef<'_, f64>, _: &Quadratic) -> ProjectedTerms {
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
        basis: MatRef<'_, f64>,
        factors: &Factors,
        _: &Quadratic,
    ) -> [Mat<f64>; 3] {
        [
            sum(&terms.mass, &factors.mass, basis.ncols()),
            sum(&terms.damping, &factors.damping, basis.ncols()),
            sum(&terms.stiffness, &factors.stiffness, basis.ncols()),
        ]
    }
}

/// A problem on a basis, for others that differ from it in few entries.
pub struct ProjectedProblem {
    own: [Sparse; 3],
    projected: [Mat<f64>; 3],
}

impl ProjectedProblem {
    /// A problem on the basis V of these columns.
    #[must_use]
    pub fn new(problem: &Quadratic, basis: MatRef<'_, f64>) -> Self {
        let own = [problem.mass(), problem.damping(), problem.stiffness()];
        Self { own: own.map(Clone::clone), projected: own.map(|matrix| projected(matrix, basis)) }
    }

    /// VᵀMV, VᵀCV and VᵀKV of another problem.
    #[must_use]
    pub fn other(&self, problem: &Quadratic, basis: MatRef<'_, f64>) -> [Mat<f64>; 3] {
        let others = [problem.mass(), problem.damping(), problem.stiffness()];
        array::from_fn(|k| match difference(&self.own[k], others[k]) {
            Some(entries) if entries.is_empty() => self.projected[k].clone(),
            Some(entries) => &self.projected[k] + projected_entries(&entries, basis),
            None => projected(others[k], basis),
        })
    }
}

/// Row, column and value of an entry.
type PlacedEntry = (usize, usize, f64);

/// What a matrix has beyond another; `None` where they differ in more than a few of their entries.
fn difference(from: &Sparse, to: &Sparse) -> Option<Vec<PlacedEntry>> {
    /// One of so many entries.
    const FEW: usize = 4;
    if (from.nrows(), from.ncols()) != (to.nrows(), to.ncols()) {
        return None;
    }
    let most = from.val().len().max(to.val().len()) / FEW;
    let mut entries = Vec::new();
    for column in 0..to.ncols() {
        let mut before = from.row_idx_of_col(column).zip(from.val_of_col(column)).peekable();
        let mut after = to.row_idx_of_col(column).zip(to.val_of_col(column)).peekable();
        // rows ascend
        while let Some(row) = [before.peek(), after.peek()].into_iter().flatten().map(|(row, _)| *row).min() {
            let old = before.next_if(|(other, _)| *other == row).map_or(0.0, |(_, value)| *value);
            let new = after.next_if(|(other, _)| *other == row).map_or(0.0, |(_, value)| *value);
            if old != new {
                entries.push((row, column, new - old));
            }
        }
        if entries.len() > most {
            return None;
        }
    }
    Some(entries)
}

/// Vᵀ A V of a matrix with few entries.
fn projected_entries(entries: &[PlacedEntry], basis: MatRef<'_, f64>) -> Mat<f64> {
    let sorted = |pick: fn(&PlacedEntry) -> usize| {
        let mut all: Vec<usize> = entries.iter().map(pick).collect();
        all.sort_unstable();
        all.dedup();
        all
    };
    let (rows, columns) = (sorted(|entry| entry.0), sorted(|entry| entry.1));
    let places: Vec<PlacedEntry> = entries
        .iter()
        .map(|(row, column, value)| {
            (rows.partition_point(|own| own < row), columns.partition_point(|own| own < column), *value)
        })
        .collect();
    let mut image = Mat::zeros(rows.len(), basis.ncols());
    for k in 0..basis.ncols() {
        let of_columns: Vec<f64> = columns.iter().map(|column| basis[(*column, k)]).collect();
        let mut sums = vec![0.0; rows.len()];
        for (row, column, value) in &places {
            sums[*row] += value * of_columns[*column];
        }
        sums.iter().enumerate().for_each(|(row, sum)| image[(row, k)] = *sum);
    }
    let of_rows = Mat::from_fn(rows.len(), basis.ncols(), |row, k| basis[(rows[row], k)]);
    product(of_rows.transpose(), image.as_ref())
}

/// Vᵀ A V.
#[must_use]
fn projected(matrix: &Sparse, basis: MatRef<'_, f64>) -> Mat<f64> {
    let vector = |k: usize| (0..basis.nrows()).map(|row| basis[(row, k)]).collect::<Vec<f64>>();
    let columns = parallel::each_place(basis.ncols(), |k| statics::product(matrix, &vector(k)));
    let image = Mat::from_fn(basis.nrows(), basis.ncols(), |row, k| columns[k][row]);
    product(basis.transpose(), image.as_ref())
}

/// Σ fᵢ Aᵢ.
fn sum(matrices: &[Mat<f64>], factors: &[f64], size: usize) -> Mat<f64> {
    Mat::from_fn(size, size, |i, j| matrices.iter().zip(factors).map(|(matrix, f)| f * matrix[(i, j)]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::Triplet;
    use judder_numerics::counter::uniform;

    #[test]
    fn a_problem_beside_another_is_projected_by_what_differs() {
        let sparse = |changed: f64| {
            let entry = |i: usize, j: usize| uniform(3, (20 * i + j) as u64) + 0.1;
            let mut all: Vec<_> = (0..20).flat_map(|i| (0..20).map(move |j| (i, j, entry(i, j)))).collect();
            all[45].2 = changed;
            let kept = all.into_iter().filter(|(.., value)| *value != 0.0);
            let all: Vec<_> = kept.map(|(i, j, value)| Triplet::new(i, j, value)).collect();
            Sparse::try_new_from_triplets(20, 20, &all).unwrap()
        };
        let problem = |changed: f64| Quadratic::new(sparse(1.0), sparse(changed), sparse(0.5)).unwrap();
        let basis = Mat::from_fn(20, 4, |i, k| uniform(4, (20 * k + i) as u64) - 0.5);
        let own = ProjectedProblem::new(&problem(2.0), basis.as_ref());
        for changed in [2.0, -3.0, 0.0] {
            let beside = own.other(&problem(changed), basis.as_ref());
            let alone = ProjectedProblem::new(&problem(changed), basis.as_ref()).projected;
            for (a, b) in beside.iter().zip(&alone) {
                assert!((a - b).norm_max() < 1e-13);
            }
        }
    }
}
