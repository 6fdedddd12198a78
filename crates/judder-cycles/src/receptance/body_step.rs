//! A step of the bodies, for small motions about a periodic one.

use super::{HarmonicBodies, HarmonicMatrices, carried};
use crate::CyclesError;
use faer::Mat;
use judder_dense::general::solve;
use judder_dense::product::product;

/// A step of the bodies, v⁺ = A⁻¹ ((M − h C/2 − h² K/4) v − h K x + h Pᵀ λ), x⁺ = x + h (v + v⁺)/2, with A = M + h C/2 + h² K/4.
#[derive(Debug, Clone)]
pub(crate) struct BodyStep {
    kind: StepMatrices,
    /// A⁻¹ h Pᵀ, coordinates × components.
    pub(crate) pushes: Mat<f64>,
    /// P.
    pub(crate) rows: Mat<f64>,
    /// c of the components that have one.
    pub(crate) convected: Vec<(usize, Vec<f64>)>,
}

#[derive(Debug, Clone)]
enum StepMatrices {
    /// Factors of v and of x of each mode.
    Modes(Vec<[f64; 2]>),
    /// The same as matrices.
    Whole([Mat<f64>; 2]),
}

impl BodyStep {
    /// c x of a component that has one.
    pub(crate) fn carries(&self, component: usize, x: &[f64]) -> f64 {
        carried(&self.convected, component, x)
    }

    /// v⁺ without contact, of columns x and v.
    pub(crate) fn free(&self, x: &Mat<f64>, v: &Mat<f64>) -> Mat<f64> {
        match &self.kind {
            StepMatrices::Modes(factors) => Mat::from_fn(v.nrows(), v.ncols(), |k, j| {
                factors[k][0] * v[(k, j)] + factors[k][1] * x[(k, j)]
            }),
            StepMatrices::Whole([of_v, of_x]) => {
                product(of_v.as_ref(), v.as_ref()) + product(of_x.as_ref(), x.as_ref())
            }
        }
    }
}

impl HarmonicBodies {
    /// Coordinates.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        self.rows.ncols()
    }

    /// A step of so many seconds.
    pub(crate) fn step(&self, step: f64) -> Result<BodyStep, CyclesError> {
        let (size, coordinates) = (self.rows.nrows(), self.rows.ncols());
        let mut pushes = Mat::from_fn(coordinates, size, |k, j| step * self.rows[(j, k)]);
        let kind = match self.kind.as_ref() {
            HarmonicMatrices::Modes(modes) => {
                let ahead =
                    |k: usize| 0.5 * step * modes.damping[k] + 0.25 * step * step * modes.eigenvalues[k];
                for column in 0..size {
                    (0..coordinates).for_each(|k| pushes[(k, column)] /= 1.0 + ahead(k));
                }
                let factors = |k: usize| {
                    [(1.0 - ahead(k)) / (1.0 + ahead(k)), -step * modes.eigenvalues[k] / (1.0 + ahead(k))]
                };
                StepMatrices::Modes((0..coordinates).map(factors).collect())
            }
            HarmonicMatrices::Whole(matrices) => {
                let [mass, damping, stiffness] = matrices.as_ref();
                let ahead = |i: usize, j: usize| {
                    0.5 * step * damping[(i, j)] + 0.25 * step * step * stiffness[(i, j)]
                };
                let matrix = Mat::from_fn(coordinates, coordinates, |i, j| mass[(i, j)] + ahead(i, j));
                let mut right = Mat::from_fn(coordinates, 2 * coordinates + size, |i, j| {
                    match (j / coordinates, j % coordinates) {
                        (0, j) => mass[(i, j)] - ahead(i, j),
                        (1, j) => -step * stiffness[(i, j)],
                        _ => pushes[(i, j - 2 * coordinates)],
                    }
                });
                solve(matrix, &mut right).ok_or(CyclesError::Singular)?;
                pushes = right.subcols(2 * coordinates, size).to_owned();
                let part = |which: usize| right.subcols(which * coordinates, coordinates).to_owned();
                StepMatrices::Whole([part(0), part(1)])
            }
        };
        Ok(BodyStep { kind, pushes, rows: self.rows.clone(), convected: self.convected.clone() })
    }
}
