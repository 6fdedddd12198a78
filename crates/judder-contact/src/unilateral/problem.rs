//! What is asked of a unilateral solver and what it answers.

use thiserror::Error;

/// What is imposed on the indenter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loading {
    /// δ, the depth of the indenter's lowest point below the undeformed surface.
    Indentation(f64),
    /// F, the normal force, in E0* times the square of the length unit.
    Load(f64),
}

/// Pressure p ≥ 0, gap g = K p + h − δ ≥ 0, p g = 0 on every cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnilateralProblem<'a> {
    /// h, height of the indenter above its lowest point at every collocation point, row-major like the grid.
    pub heights: &'a [f64],
    /// Imposed depth or force.
    pub loading: Loading,
}

/// How exact a solution must be, and how long it may take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnilateralLimits {
    /// Largest residual of complementarity and of contact, relative to the depth.
    pub tolerance: f64,
    /// Largest number of changes of the contact set.
    pub iterations: usize,
    /// Largest number of products with the operator, over all iterations.
    pub products: usize,
}

impl Default for UnilateralLimits {
    fn default() -> Self {
        Self { tolerance: 1e-5, iterations: 200, products: 4000 }
    }
}

/// How far a pressure is from solving its problem, computed anew from the pressure at the end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnilateralErrors {
    /// max over cells of min(p/p_max, |g|/δ).
    pub complementarity: f64,
    /// Smallest pressure over largest pressure; 0 where nothing pulls.
    pub smallest_pressure: f64,
    /// Largest penetration −g over the depth δ.
    pub largest_penetration: f64,
    /// Deviation of the force from the imposed one, relative; 0 under imposed indentation.
    pub load: f64,
}

impl UnilateralErrors {
    /// The errors of a pressure with its displacement K p under an indenter at depth δ.
    #[must_use]
    pub fn of(pressure: &[f64], gap: &[f64], indentation: f64, load: f64) -> Self {
        let largest = pressure.iter().copied().fold(0.0, f64::max);
        let smallest = pressure.iter().copied().fold(0.0, f64::min);
        let per_pressure = if largest > 0.0 { 1.0 / largest } else { 0.0 };
        let per_depth = 1.0 / indentation.abs();
        let complementarity = pressure
            .iter()
            .zip(gap)
            .map(|(p, g)| (p.abs() * per_pressure).min(g.abs() * per_depth))
            .fold(0.0, f64::max);
        let largest_penetration = gap.iter().map(|g| -g * per_depth).fold(0.0, f64::max);
        Self { complementarity, smallest_pressure: smallest * per_pressure, largest_penetration, load }
    }

    /// The largest of them.
    #[must_use]
    pub fn worst(&self) -> f64 {
        let contact = self.complementarity.max(self.largest_penetration);
        contact.max(-self.smallest_pressure).max(self.load)
    }
}

/// A pressure, whether it solves its problem, and how much work it took.
#[derive(Debug, Clone, PartialEq)]
pub struct UnilateralSolution {
    /// p, pressure on every cell, in E0*.
    pub pressure: Vec<f64>,
    /// g, gap at every collocation point.
    pub gap: Vec<f64>,
    /// δ, imposed or found.
    pub indentation: f64,
    /// Errors recomputed from the pressure.
    pub errors: UnilateralErrors,
    /// Whether every error is within the tolerance and the contact set has come to rest.
    pub converged: bool,
    /// Contact sets tried.
    pub iterations: usize,
    /// Products with the operator.
    pub products: usize,
}

/// Why a unilateral problem cannot be posed or solved at all.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum UnilateralError {
    /// The heights do not fill the grid.
    #[error("{heights} heights were given for a grid of {cells} cells: one height a cell is needed")]
    HeightsDoNotFit {
        /// Number of heights.
        heights: usize,
        /// Number of cells.
        cells: usize,
    },
    /// A height is NaN or infinite.
    #[error("the indenter's height at row {row}, column {column} is {value}: heights must be finite")]
    HeightNotFinite {
        /// Row of the cell.
        row: usize,
        /// Column of the cell.
        column: usize,
        /// The height.
        value: f64,
    },
    /// The imposed depth or force is not a positive number.
    #[error("the imposed {what} is {value}; it must be a positive number")]
    LoadingNotPositive {
        /// `indentation` or `load`.
        what: &'static str,
        /// The number given.
        value: f64,
    },
    /// The symmetric solver was given an operator that is not symmetric.
    #[error(
        "conjugate gradients need a symmetric operator, that of an elastic substrate; this one is not symmetric"
    )]
    NotSymmetric,
    /// Products with the operator overflow.
    #[error(
        "the displacement of the surface is beyond what numbers hold (after {products} products with the kernel); give a smaller load \
         or indentation"
    )]
    NotFinite {
        /// Products made until then.
        products: usize,
    },
}

impl UnilateralProblem<'_> {
    /// Refuses heights and loadings that no solver could serve.
    ///
    /// # Errors
    /// [`UnilateralError::HeightsDoNotFit`], [`UnilateralError::HeightNotFinite`], [`UnilateralError::LoadingNotPositive`].
    pub fn check(&self, grid: &crate::surface::grid::SurfaceGrid) -> Result<(), UnilateralError> {
        if self.heights.len() != grid.len() {
            return Err(UnilateralError::HeightsDoNotFit { heights: self.heights.len(), cells: grid.len() });
        }
        if let Some(index) = self.heights.iter().position(|height| !height.is_finite()) {
            let (row, column) = (index / grid.columns, index % grid.columns);
            return Err(UnilateralError::HeightNotFinite { row, column, value: self.heights[index] });
        }
        let (what, value) = match self.loading {
            Loading::Indentation(value) => ("indentation", value),
            Loading::Load(value) => ("load", value),
        };
        if !(value > 0.0 && value.is_finite()) {
            return Err(UnilateralError::LoadingNotPositive { what, value });
        }
        Ok(())
    }
}
