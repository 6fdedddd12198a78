//! Steady sliding of a long cylinder across its axis: the line contact.

use super::contact_area::contact_length;
use super::error::SteadyError;
use crate::kernel::sliding::SlidingOperator;
use crate::kernel::substrate::SlidingSubstrate;
use crate::surface::grid::SurfaceGrid;
use crate::surface::operator::SurfaceOperator;
use crate::unilateral::active_set::{self, Start};
use crate::unilateral::{Loading, UnilateralLimits, UnilateralProblem, UnilateralSolution};
use std::f64::consts::PI;

/// Half the domain over the half width of the rubbery contact, which is the widest.
const DOMAIN: f64 = 1.25;
/// Cells of the coarsest grid.
const COARSEST: usize = 32;

/// A cylinder of unit radius under a load per length; lengths in R, pressures in E0*.
#[derive(Clone, Copy)]
pub struct LineQuestion<'a> {
    /// The substrate with its wake lengths ℓ_k = v τ_k, in R.
    pub substrate: &'a SlidingSubstrate,
    /// F/(E0* R), force per length of the cylinder.
    pub load: f64,
    /// Cells across the domain, which is 1.25 times as wide as the rubbery contact.
    pub cells: usize,
    /// How exactly the problem is solved.
    pub limits: UnilateralLimits,
    /// Bytes of memory that the kernel may take.
    pub memory: u64,
}

/// The line contact on its finest grid.
#[derive(Debug, Clone, PartialEq)]
pub struct LineContact {
    /// The strips, one row.
    pub grid: SurfaceGrid,
    /// Pressure, gap, errors and work; the depth has no meaning of its own in a line contact.
    pub solution: UnilateralSolution,
    /// Largest pressure over E0*.
    pub peak_pressure: f64,
    /// Length in contact over R.
    pub width: f64,
    /// μ, from the pressure times the slope of the cylinder.
    pub friction: f64,
}

/// Solves the line contact of a cylinder h = x²/2 under a load, on nested grids.
///
/// # Errors
/// [`SteadyError`] for too few cells, a load that is not positive, a substrate that cannot be served.
pub fn solve(question: &LineQuestion<'_>) -> Result<LineContact, SteadyError> {
    if question.cells < COARSEST {
        return Err(SteadyError::TooFewCells { cells: question.cells });
    }
    // Hertz's half width a = √(4 F R/(π E0*)) and depth scale a²/2.
    let half_contact = (4.0 * question.load / PI).sqrt();
    let mut start = (vec![0.0], 0.5 * half_contact * half_contact);
    let mut finest = None;
    for cells in super::nested(question.cells) {
        let half_width = DOMAIN * half_contact;
        let grid = SurfaceGrid {
            rows: 1,
            origin: [-half_width, 0.0],
            ..SurfaceGrid::square(cells, [0.0; 2], half_width)
        };
        let solution = on_grid(question, grid, &start)?;
        start = (solution.pressure.clone(), solution.indentation);
        finest = Some(measured(grid, solution, question.substrate));
    }
    finest.ok_or(SteadyError::NoCells)
}

fn on_grid(
    question: &LineQuestion<'_>,
    grid: SurfaceGrid,
    (pressure, indentation): &(Vec<f64>, f64),
) -> Result<UnilateralSolution, SteadyError> {
    // Any reference far beyond the contact does: under a load it moves the depth alone.
    let reference = 1e3 * grid.cell * grid.columns as f64;
    let mut operator = SlidingOperator::line(grid, question.substrate, reference, question.memory)?;
    let shift = operator.collocation_shift();
    let heights: Vec<f64> = (0..grid.columns).map(|column| 0.5 * (grid.x(column) - shift).powi(2)).collect();
    // A strip's force per length is p h, a square cell's force p h².
    let problem = UnilateralProblem { heights: &heights, loading: Loading::Load(question.load * grid.cell) };
    let start: Vec<f64> =
        (0..grid.columns).map(|column| pressure[column * pressure.len() / grid.columns]).collect();
    let start = Start { pressure: &start, indentation: *indentation };
    Ok(active_set::solve(&mut operator, &problem, start, question.limits)?)
}

fn measured(grid: SurfaceGrid, solution: UnilateralSolution, substrate: &SlidingSubstrate) -> LineContact {
    let pressure = &solution.pressure;
    let force: f64 = pressure.iter().sum();
    let moment: f64 = pressure.iter().enumerate().map(|(column, p)| p * grid.x(column)).sum();
    let width = contact_length(&grid, pressure, substrate);
    let peak_pressure = pressure.iter().copied().fold(0.0, f64::max);
    LineContact { grid, peak_pressure, width, friction: moment / force, solution }
}
