//! The problem on one grid, and what is measured on its solution.

use super::SteadyQuestion;
use super::contact_area::{contact_area, contact_length};
use super::error::SteadyError;
use super::line;
use super::posed::Posed;
use super::profile::{OUT_OF_REACH, Profile};
use super::start::LevelStart;
use crate::kernel::sliding::SlidingOperator;
use crate::surface::grid::SurfaceGrid;
use crate::surface::operator::SurfaceOperator;
use crate::surface::stoppable::Stoppable;
use crate::unilateral::active_set::{self, UnilateralStart};
use crate::unilateral::symmetric;
use crate::unilateral::{UnilateralProblem, UnilateralSolution};
use judder_numerics::stopping::Interrupted;

/// The solution on one grid; lengths in R, forces in E0* R². Of a line contact forces and areas are per length.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The cells.
    pub grid: SurfaceGrid,
    /// Pressure, gap, depth, errors and work.
    pub solution: UnilateralSolution,
    /// How far upstream of the cells' centres the gap was taken, in R.
    pub collocation_shift: f64,
    /// F/(E0* R²); of a line contact F/(E0* R).
    pub force: f64,
    /// A/R²; of a line contact its width over R.
    pub area: f64,
    /// μ, from the pressure times the slope of the indenter.
    pub friction: f64,
}

impl From<&Level> for LevelStart {
    fn from(level: &Level) -> Self {
        Self {
            grid: Some(level.grid),
            pressure: level.solution.pressure.clone(),
            indentation: level.solution.indentation,
        }
    }
}

impl Level {
    /// Solves the question on one grid.
    ///
    /// # Errors
    /// [`SteadyError::Kernel`], [`SteadyError::Unilateral`], [`SteadyError::BeyondIndenter`].
    pub fn solve(
        question: &SteadyQuestion<'_>,
        grid: &SurfaceGrid,
        start: &LevelStart,
    ) -> Result<Self, SteadyError> {
        Self::solve_until(question, grid, start, &|| false)
    }

    /// As [`solve`](Self::solve), unless `interrupted` says to stop.
    pub(super) fn solve_until(
        question: &SteadyQuestion<'_>,
        grid: &SurfaceGrid,
        start: &LevelStart,
        interrupted: Interrupted<'_>,
    ) -> Result<Self, SteadyError> {
        let is_line = question.profile.is_line();
        let posed = if is_line {
            line::pose(question, grid, start)?
        } else {
            let operator = SlidingOperator::new(*grid, question.substrate, question.memory)?;
            Posed { operator, loading: question.loading, indentation: start.indentation, datum: 0.0 }
        };
        let Posed { mut operator, loading, indentation, datum } = posed;
        let shift = operator.collocation_shift();
        let heights = heights(question.profile, grid, shift);
        let problem = UnilateralProblem { heights: &heights, loading };
        let pressure = start.on(grid);
        let start = UnilateralStart { pressure: &pressure, indentation };
        let mut operator = Stoppable::new(&mut operator, interrupted);
        let solved = if operator.is_symmetric() {
            symmetric::solve(&mut operator, &problem, start, question.limits)
        } else {
            active_set::solve(&mut operator, &problem, start, question.limits)
        };
        if operator.is_stopped() {
            return Err(SteadyError::Interrupted);
        }
        let mut solution = solved?;
        solution.indentation -= datum;
        if let Some(cell) = beside_the_edge(grid, &heights, &solution.pressure) {
            return Err(SteadyError::BeyondIndenter {
                x: grid.x(cell % grid.columns),
                y: grid.y(cell / grid.columns),
            });
        }
        let pressures = solution.pressure.iter().sum::<f64>();
        let resistance = resistance(question.profile, grid, &solution.pressure);
        let (force, area) = if is_line {
            (pressures * grid.cell, contact_length(grid, &solution.pressure, question.substrate))
        } else {
            (pressures * grid.cell_area(), contact_area(grid, &solution.pressure, question.substrate))
        };
        let friction = resistance / (pressures * grid.cell_area());
        Ok(Self { grid: *grid, collocation_shift: shift, force, area, friction, solution })
    }

    /// The sides of the box around the cells in contact: left, right, top, bottom, in R.
    #[must_use]
    pub fn bounds(&self) -> Option<[f64; 4]> {
        let grid = &self.grid;
        let loaded =
            self.solution.pressure.iter().enumerate().filter(|(_, p)| **p > 0.0).map(|(cell, _)| cell);
        let cells = loaded.fold(None, |bounds: Option<[usize; 4]>, cell| {
            let (row, column) = (cell / grid.columns, cell % grid.columns);
            let [left, right, top, bottom] = bounds.unwrap_or([column, column, row, row]);
            Some([left.min(column), right.max(column), top.min(row), bottom.max(row)])
        })?;
        let half = 0.5 * grid.cell;
        Some([
            grid.x(cells[0]) - half,
            grid.x(cells[1]) + half,
            grid.y(cells[2]) - half,
            grid.y(cells[3]) + half,
        ])
    }

    /// Whether a cell at the edge of the grid is in contact; the one row of a line contact has two ends and no sides.
    #[must_use]
    pub fn touches_edge(&self) -> bool {
        let (columns, rows) = (self.grid.columns, self.grid.rows);
        let at_end = |index: usize, count: usize| index == 0 || index + 1 == count;
        self.solution.pressure.iter().enumerate().any(|(cell, pressure)| {
            let (row, column) = (cell / columns, cell % columns);
            *pressure > 0.0 && (at_end(column, columns) || (rows > 1 && at_end(row, rows)))
        })
    }
}

/// A cell in contact with a neighbour where there is no indenter.
fn beside_the_edge(grid: &SurfaceGrid, heights: &[f64], pressure: &[f64]) -> Option<usize> {
    let beyond = |cell: usize| heights[cell] >= OUT_OF_REACH;
    (0..grid.len()).filter(|cell| pressure[*cell] > 0.0).find(|cell| {
        let (row, column) = (cell / grid.columns, cell % grid.columns);
        (column > 0 && beyond(cell - 1))
            || (column + 1 < grid.columns && beyond(cell + 1))
            || (row > 0 && beyond(cell - grid.columns))
            || (row + 1 < grid.rows && beyond(cell + grid.columns))
    })
}

/// Heights at the collocation points.
pub(crate) fn heights(profile: &dyn Profile, grid: &SurfaceGrid, shift: f64) -> Vec<f64> {
    (0..grid.len())
        .map(|cell| profile.height(grid.x(cell % grid.columns) - shift, grid.y(cell / grid.columns)))
        .collect()
}

/// F_x = ∫ p ∂h/∂x: the pressure of a cell times the mean slope of the indenter over it.
pub(crate) fn resistance(profile: &dyn Profile, grid: &SurfaceGrid, pressure: &[f64]) -> f64 {
    let half = 0.5 * grid.cell;
    let mut sum = 0.0;
    for (cell, p) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
        let (x, y) = (grid.x(cell % grid.columns), grid.y(cell / grid.columns));
        sum += p * (profile.height(x + half, y) - profile.height(x - half, y));
    }
    sum * grid.cell
}
