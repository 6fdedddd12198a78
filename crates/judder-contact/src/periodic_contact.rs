//! A rough surface that repeats itself, pressed on the substrate or sliding over it.

use crate::indenter::HeightMap;
use crate::kernel::check::KernelError;
use crate::kernel::sliding::SlidingOperator;
use crate::kernel::substrate::SlidingSubstrate;
use crate::steady::contact_area::periodic_contact_area;
use crate::surface::grid::SurfaceGrid;
use crate::surface::operator::SurfaceOperator;
use crate::unilateral::active_set::{self, Start};
use crate::unilateral::{
    Loading, UnilateralError, UnilateralLimits, UnilateralProblem, UnilateralSolution, symmetric,
};
use thiserror::Error;

/// Cells a side below which no coarser grid gives a start.
const COARSEST: usize = 32;
/// The tolerance of the grids that only give a start.
const START: f64 = 1e-2;

/// A periodic contact under an imposed load; lengths in one unit, pressures in E0*.
#[derive(Debug, Clone, Copy)]
pub struct PeriodicQuestion<'a> {
    /// The substrate with its wake lengths.
    pub substrate: &'a SlidingSubstrate,
    /// One period of the surface; its lattice is the grid.
    pub surface: &'a HeightMap,
    /// p̄, mean pressure over the period.
    pub mean_pressure: f64,
    /// How exactly the problem is solved.
    pub limits: UnilateralLimits,
    /// Bytes that the computation may take.
    pub memory: u64,
}

/// The solution of a periodic contact.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicContact {
    /// The cells, with the lowest point of the surface at the origin.
    pub grid: SurfaceGrid,
    /// Pressure, gap and depth: that of the lowest point below the mean plane of the deformed substrate.
    pub solution: UnilateralSolution,
    /// The part of the surface in contact, A/A₀, with its perimeter placed inside the cells.
    pub contact_fraction: f64,
    /// Mean of the gap.
    pub mean_gap: f64,
    /// μ, from the pressure times the slope of the surface.
    pub friction: f64,
}

/// Why a periodic contact has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PeriodicContactError {
    /// The surface does not repeat itself.
    #[error(
        "the height map is not periodic: set `periodic = true` where the surface repeats itself at its edges"
    )]
    NotPeriodic,
    /// The kernel refuses the grid or the speed.
    #[error(transparent)]
    Kernel(#[from] KernelError),
    /// The problem is ill posed or overflows.
    #[error(transparent)]
    Unilateral(#[from] UnilateralError),
}

/// Solves a periodic contact on nested grids: each gives the start of the next, which has half the cell.
///
/// An elastic substrate takes conjugate gradients, one with a wake the active set.
///
/// # Errors
/// [`PeriodicContactError`]. A solution that did not converge is no error: it says so.
pub fn solve(question: &PeriodicQuestion<'_>) -> Result<PeriodicContact, PeriodicContactError> {
    if !question.surface.is_periodic() {
        return Err(PeriodicContactError::NotPeriodic);
    }
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
    let limits = question.limits;
    let rough = UnilateralLimits { tolerance: START.max(limits.tolerance), ..limits };
    let (mut pressure, mut indentation) =
        (vec![question.mean_pressure; coarsest_cells(&grid, &coarser)], 0.0);
    for (grid, heights) in coarser.iter().rev() {
        let start = Start { pressure: &pressure, indentation };
        let solution = solve_level(question, *grid, heights, start, rough)?;
        (pressure, indentation) = (doubled(grid, &solution.pressure), solution.indentation);
    }
    let start = Start { pressure: &pressure, indentation };
    let solution = solve_level(question, grid, heights, start, limits)?;
    Ok(measured(question, grid, solution))
}

fn coarsest_cells(grid: &SurfaceGrid, coarser: &[(SurfaceGrid, Vec<f64>)]) -> usize {
    coarser.last().map_or(grid, |(grid, _)| grid).len()
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

fn solve_level(
    question: &PeriodicQuestion<'_>,
    grid: SurfaceGrid,
    heights: &[f64],
    start: Start<'_>,
    limits: UnilateralLimits,
) -> Result<UnilateralSolution, PeriodicContactError> {
    let mut operator = SlidingOperator::periodic(grid, question.substrate, question.memory)?;
    let load = question.mean_pressure * grid.len() as f64 * grid.cell_area();
    let loading = Loading::Load(load);
    if operator.is_symmetric() {
        let problem = UnilateralProblem { heights, loading };
        return Ok(symmetric::solve(&mut operator, &problem, start, limits)?);
    }
    let shift = operator.collocation_shift();
    let upstream: Vec<f64> = (0..grid.len())
        .map(|cell| question.surface.height(grid.x(cell % grid.columns) - shift, grid.y(cell / grid.columns)))
        .collect();
    let problem = UnilateralProblem { heights: &upstream, loading };
    Ok(active_set::solve(&mut operator, &problem, start, limits)?)
}

fn measured(
    question: &PeriodicQuestion<'_>,
    grid: SurfaceGrid,
    solution: UnilateralSolution,
) -> PeriodicContact {
    let surface = question.surface;
    let cells = grid.len() as f64;
    let half = 0.5 * grid.cell;
    let (mut sum, mut resistance) = (0.0, 0.0);
    for (cell, pressure) in solution.pressure.iter().enumerate().filter(|(_, pressure)| **pressure > 0.0) {
        let (x, y) = (grid.x(cell % grid.columns), grid.y(cell / grid.columns));
        resistance += pressure * (surface.height(x + half, y) - surface.height(x - half, y)) / grid.cell;
        sum += pressure;
    }
    PeriodicContact {
        grid,
        contact_fraction: periodic_contact_area(&grid, &solution.pressure, question.substrate)
            / (cells * grid.cell_area()),
        mean_gap: solution.gap.iter().sum::<f64>() / cells,
        friction: resistance / sum,
        solution,
    }
}
