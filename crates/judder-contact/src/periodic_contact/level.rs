//! The periodic problem on one grid, and what is measured on its solution.

use super::dissipation::shear_from_dissipation;
use super::interpolation::interpolated;
use super::{PeriodicContactError, PeriodicLoading, PeriodicQuestion};
use crate::kernel::sliding::SlidingOperator;
use crate::steady::contact_area::periodic_contact_area;
use crate::steady::refinement::LevelSummary;
use crate::surface::grid::SurfaceGrid;
use crate::surface::operator::SurfaceOperator;
use crate::surface::stoppable::Stoppable;
use crate::unilateral::active_set::{self, UnilateralStart};
use crate::unilateral::{Loading, UnilateralLimits, UnilateralProblem, UnilateralSolution, symmetric};
use judder_numerics::stopping::Interrupted;

/// Cells a side below which no coarser grid gives a start.
const COARSEST: usize = 32;
/// The tolerance of the grids that only give a start.
const START: f64 = 1e-2;

/// The solution on one grid.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicLevel {
    /// The cells; their centres are points of the surface's lattice and, on finer grids, points between.
    pub grid: SurfaceGrid,
    /// How far before the centres the surfaces are compared, along x.
    pub collocation_shift: f64,
    /// Height of the surface above its lowest lattice point, where it is compared with the substrate.
    pub heights: Vec<f64>,
    /// Pressure, gap and depth.
    pub solution: UnilateralSolution,
    /// p̄/E0*.
    pub mean_pressure: f64,
    /// The part of the surface in contact, A/A₀, with its perimeter placed inside the cells.
    pub contact_fraction: f64,
    /// Mean of the gap: the distance of the mean planes of surface and substrate.
    pub mean_gap: f64,
    /// μ, from the pressure times the slope of the surface.
    pub friction: f64,
    /// μ, from the energy dissipated in the bulk.
    pub friction_from_dissipation: f64,
}

impl PeriodicLevel {
    /// Solves the question on a grid `factor` times as fine as its surface's lattice.
    pub(super) fn solve(
        question: &PeriodicQuestion<'_>,
        factor: usize,
        start: UnilateralStart<'_>,
        interrupted: Interrupted<'_>,
    ) -> Result<Self, PeriodicContactError> {
        let grid = refined(&question.surface.grid(), factor);
        let mut operator = SlidingOperator::periodic(grid, question.substrate, question.memory)?;
        let collocation_shift = operator.collocation_shift();
        let heights = interpolated(question.surface, factor, collocation_shift / grid.cell);
        let solution = solve_on(question, &mut operator, &heights, start, question.limits, interrupted)?;
        Ok(measured(question, factor, grid, collocation_shift, heights, solution))
    }

    /// The row of the grid in a table of refinement.
    pub(super) fn summary(&self) -> LevelSummary {
        let period = self.grid.len() as f64 * self.grid.cell_area();
        LevelSummary {
            cells: self.grid.columns,
            cell: self.grid.cell,
            force: self.mean_pressure * period,
            area: self.contact_fraction * period,
            friction: self.friction,
            indentation: self.solution.indentation,
            peak_pressure: self.solution.pressure.iter().copied().fold(0.0, f64::max),
            iterations: self.solution.iterations,
            products: self.solution.products,
            residual: self.solution.errors.worst(),
            converged: self.solution.converged,
        }
    }

    /// The pressure at the cells of the grid with half the cell.
    pub(super) fn doubled(&self) -> Vec<f64> {
        doubled(&self.grid, &self.solution.pressure)
    }
}

/// The grid `factor` times as fine, whose first point stays where it is.
fn refined(lattice: &SurfaceGrid, factor: usize) -> SurfaceGrid {
    let cell = lattice.cell / factor as f64;
    let aside = 0.5 * (lattice.cell - cell);
    SurfaceGrid {
        columns: factor * lattice.columns,
        rows: factor * lattice.rows,
        cell,
        origin: [lattice.origin[0] + aside, lattice.origin[1] + aside],
    }
}

/// A pressure and a depth to start from, by coarser and coarser grids with the means of four heights.
pub(super) fn start_from_coarser(
    question: &PeriodicQuestion<'_>,
    interrupted: Interrupted<'_>,
) -> Result<(Vec<f64>, f64), PeriodicContactError> {
    let (grid, heights) = (question.surface.grid(), question.surface.heights());
    let mut coarser: Vec<(SurfaceGrid, Vec<f64>)> = Vec::new();
    loop {
        let (fine, values) = coarser.last().map_or((&grid, heights), |(grid, heights)| (grid, heights));
        if !can_be_halved(fine) {
            break;
        }
        let level = halved(fine, values);
        coarser.push(level);
    }
    let limits = UnilateralLimits { tolerance: START.max(question.limits.tolerance), ..question.limits };
    let cells = coarser.last().map_or(&grid, |(grid, _)| grid).len();
    let (mut pressure, mut indentation) = match question.loading {
        PeriodicLoading::MeanPressure(mean) => (vec![mean; cells], 0.0),
        PeriodicLoading::Indentation(depth) => (vec![0.0; cells], depth),
    };
    for (grid, heights) in coarser.iter().rev() {
        let mut operator = SlidingOperator::periodic(*grid, question.substrate, question.memory)?;
        let start = UnilateralStart { pressure: &pressure, indentation };
        let solution = solve_on(question, &mut operator, heights, start, limits, interrupted)?;
        (pressure, indentation) = (doubled(grid, &solution.pressure), solution.indentation);
    }
    Ok((pressure, indentation))
}

fn can_be_halved(grid: &SurfaceGrid) -> bool {
    grid.columns.min(grid.rows) > COARSEST && grid.columns.is_multiple_of(2) && grid.rows.is_multiple_of(2)
}

/// The grid of twice the cell, with the means of four heights.
fn halved(fine: &SurfaceGrid, heights: &[f64]) -> (SurfaceGrid, Vec<f64>) {
    let coarse =
        SurfaceGrid { columns: fine.columns / 2, rows: fine.rows / 2, cell: 2.0 * fine.cell, ..*fine };
    let mut means = Vec::with_capacity(coarse.len());
    for rows in heights.chunks_exact(2 * fine.columns) {
        let (upper, lower) = rows.split_at(fine.columns);
        let pairs = upper.chunks_exact(2).zip(lower.chunks_exact(2));
        means.extend(pairs.map(|(above, below)| 0.25 * (above[0] + above[1] + below[0] + below[1])));
    }
    (coarse, means)
}

/// The pressure of a coarse grid at the cells of the next finer one.
fn doubled(coarse: &SurfaceGrid, pressure: &[f64]) -> Vec<f64> {
    let rows = pressure.chunks_exact(coarse.columns);
    let wide = rows.map(|row| row.iter().flat_map(|value| [*value, *value]).collect::<Vec<f64>>());
    wide.flat_map(|row| [row.clone(), row]).flatten().collect()
}

/// An elastic substrate takes conjugate gradients, one with a wake the active set.
fn solve_on(
    question: &PeriodicQuestion<'_>,
    operator: &mut SlidingOperator,
    heights: &[f64],
    start: UnilateralStart<'_>,
    limits: UnilateralLimits,
    interrupted: Interrupted<'_>,
) -> Result<UnilateralSolution, PeriodicContactError> {
    let grid = operator.grid();
    let loading = match question.loading {
        PeriodicLoading::MeanPressure(mean) => Loading::Load(mean * grid.len() as f64 * grid.cell_area()),
        PeriodicLoading::Indentation(depth) => Loading::Indentation(depth),
    };
    let problem = UnilateralProblem { heights, loading };
    let mut operator = Stoppable::new(operator, interrupted);
    let solved = if operator.is_symmetric() {
        symmetric::solve(&mut operator, &problem, start, limits)
    } else {
        active_set::solve(&mut operator, &problem, start, limits)
    };
    if operator.is_stopped() { Err(PeriodicContactError::Interrupted) } else { Ok(solved?) }
}

fn measured(
    question: &PeriodicQuestion<'_>,
    factor: usize,
    grid: SurfaceGrid,
    collocation_shift: f64,
    heights: Vec<f64>,
    solution: UnilateralSolution,
) -> PeriodicLevel {
    let cells = grid.len() as f64;
    let pressure = &solution.pressure;
    let (behind, ahead) =
        (interpolated(question.surface, factor, 0.5), interpolated(question.surface, factor, -0.5));
    let rises = ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / grid.cell);
    let resistance: f64 = pressure.iter().zip(rises).map(|(pressure, slope)| pressure * slope).sum();
    let mean_pressure = pressure.iter().sum::<f64>() / cells;
    PeriodicLevel {
        mean_pressure,
        contact_fraction: periodic_contact_area(&grid, pressure, question.substrate)
            / (cells * grid.cell_area()),
        mean_gap: solution.gap.iter().sum::<f64>() / cells,
        friction: resistance / (cells * mean_pressure),
        friction_from_dissipation: shear_from_dissipation(&grid, pressure, question.substrate)
            / mean_pressure,
        grid,
        collocation_shift,
        heights,
        solution,
    }
}
