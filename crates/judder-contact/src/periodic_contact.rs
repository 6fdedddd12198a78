//! A rough surface that repeats itself, pressed on the substrate or sliding over it.
//!
//! - [`level`]: the problem on one grid, and what is measured on its solution.
//! - `interpolation`: the surface on finer grids than its own.
//! - `dissipation`: friction once more, from the energy dissipated.

mod dissipation;
mod interpolation;
pub mod level;

use crate::indenter::HeightMap;
use crate::kernel::check::KernelError;
use crate::kernel::sliding::SlidingOperator;
use crate::kernel::substrate::SlidingSubstrate;
use crate::steady::refinement::{ErrorEstimate, LevelSummary, Refinement};
use crate::unilateral::active_set::UnilateralStart;
use crate::unilateral::{UnilateralError, UnilateralLimits};
use judder_numerics::stopping::Interrupted;
use level::{PeriodicLevel, start_from_coarser};
use thiserror::Error;

/// Cells of the finest grid that a surface is refined to; the heights themselves may have more.
pub const FINEST: usize = 2048 * 2048;

/// What is imposed on a surface that repeats itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PeriodicLoading {
    /// p̄/E0*, mean pressure over the period.
    MeanPressure(f64),
    /// δ, depth of the surface's lowest lattice point below the mean plane of the deformed substrate.
    ///
    /// The mean gap is the mean height less δ, so this imposes the distance of the mean planes. On a half-space a mean pressure has
    /// no finite mean displacement, and no other depth means anything. At the mean height all is in contact, and no
    /// greater depth exists.
    Indentation(f64),
}

/// A periodic contact; lengths in one unit, pressures in E0*.
#[derive(Debug, Clone, Copy)]
pub struct PeriodicQuestion<'a> {
    /// The substrate with its wake lengths.
    pub substrate: &'a SlidingSubstrate,
    /// One period of the surface; its lattice is the coarsest grid that answers.
    pub surface: &'a HeightMap,
    /// Imposed mean pressure or depth.
    pub loading: PeriodicLoading,
    /// Relative error allowed to depth or load; area and friction may be five times as far off. `None` stays on the surface's own
    /// lattice, whose errors stay unknown.
    pub accuracy: Option<f64>,
    /// How exactly each grid's problem is solved.
    pub limits: UnilateralLimits,
    /// Bytes that a grid's kernel may take.
    pub memory: u64,
}

/// The answer: load, area, friction and depth with their errors, and the fields on the finest grid.
#[derive(Debug, Clone, PartialEq)]
pub struct PeriodicContact {
    /// Load F/(E0* L²) and area of one period, friction and depth, and the grids they come from.
    pub refinement: Refinement,
    /// The finest grid's solution.
    pub finest: PeriodicLevel,
    /// Whether every grid's problem was solved and the accuracy, where one is asked for, is met.
    pub converged: bool,
}

impl PeriodicContact {
    /// Relative difference of the two frictions, from the surface and from the bulk; 0 where nothing dissipates.
    #[must_use]
    pub fn friction_difference(&self) -> f64 {
        let (surface, bulk) = (self.finest.friction, self.finest.friction_from_dissipation);
        if bulk == 0.0 { 0.0 } else { (surface - bulk).abs() / surface.abs().max(bulk) }
    }
}

/// Why a periodic contact has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PeriodicContactError {
    /// The surface does not repeat itself.
    #[error(
        "the height map is not periodic: set `periodic = true` where the surface repeats itself at its edges"
    )]
    NotPeriodic,
    /// The accuracy is not a small positive fraction.
    #[error("the accuracy is {accuracy}: it must lie between 0 and 1")]
    Accuracy {
        /// The accuracy asked for.
        accuracy: f64,
    },
    /// The surface would be below its own mean plane everywhere.
    #[error(
        "the indentation is {indentation}: at {limit}, the mean height above the lowest point, all is in contact, and no deeper \
         contact exists; impose a load"
    )]
    TooDeep {
        /// δ asked for.
        indentation: f64,
        /// The mean height.
        limit: f64,
    },
    /// It was told to stop.
    #[error("interrupted")]
    Interrupted,
    /// The kernel refuses the grid or the speed.
    #[error(transparent)]
    Kernel(#[from] KernelError),
    /// The problem is ill posed or overflows.
    #[error(transparent)]
    Unilateral(#[from] UnilateralError),
}

/// Solves a periodic contact on the surface's lattice and, until its accuracy is met, on grids of half the cell.
///
/// Between its lattice points the surface is their trigonometric interpolation, so finer grids hold the same surface and their answers
/// differ by the discretisation alone. Each grid gives the start of the next; coarser grids, with means of heights, give that of the
/// first.
///
/// # Errors
/// [`PeriodicContactError`]. A solution that did not converge, or an accuracy that the finest grid allowed does not meet, is no
/// error: `converged` is false.
pub fn solve(question: &PeriodicQuestion<'_>) -> Result<PeriodicContact, PeriodicContactError> {
    solve_until(question, &|| false)
}

/// Solves a periodic contact as [`solve`] does, unless `interrupted` says to stop: it is asked before each product with the kernel.
///
/// # Errors
/// As of [`solve`]; [`PeriodicContactError::Interrupted`].
pub fn solve_until(
    question: &PeriodicQuestion<'_>,
    interrupted: Interrupted<'_>,
) -> Result<PeriodicContact, PeriodicContactError> {
    check(question)?;
    let (mut pressure, mut indentation) = start_from_coarser(question, interrupted)?;
    let mut summaries: Vec<LevelSummary> = Vec::new();
    let mut factor = 1;
    loop {
        let start = UnilateralStart { pressure: &pressure, indentation };
        let level = PeriodicLevel::solve(question, factor, start, interrupted)?;
        summaries.push(level.summary());
        let refinement = refinement(question, &summaries);
        let met = question.accuracy.is_none_or(|accuracy| refinement.meets(accuracy));
        if met || !question.has_room_for(2 * factor) {
            let solved = summaries.iter().all(|level| level.converged);
            return Ok(PeriodicContact { refinement, finest: level, converged: solved && met });
        }
        (pressure, indentation) = (level.doubled(), level.solution.indentation);
        factor *= 2;
    }
}

impl PeriodicQuestion<'_> {
    /// Whether a grid so many times as fine is allowed.
    fn has_room_for(&self, factor: usize) -> bool {
        let lattice = self.surface.grid();
        let (columns, rows) = (factor * lattice.columns, factor * lattice.rows);
        columns * rows <= FINEST && SlidingOperator::memory_bytes(columns, rows) <= self.memory
    }
}

/// The estimates of a sequence of grids.
///
/// A rough contact has so many edges that where each falls in its cells does not matter: area and friction have an order, that of the
/// area about one, and are extrapolated as well. What does not dissipate has no friction, to the last digit.
fn refinement(question: &PeriodicQuestion<'_>, levels: &[LevelSummary]) -> Refinement {
    let estimate =
        |value: fn(&LevelSummary) -> f64| ErrorEstimate::of(&levels.iter().map(value).collect::<Vec<f64>>());
    let refinement = Refinement {
        area: estimate(|level| level.area),
        friction: estimate(|level| level.friction),
        ..Refinement::of(levels, false)
    };
    if question.substrate.terms.iter().all(|term| term.compliance * term.length == 0.0) {
        let friction = ErrorEstimate { value: 0.0, error: 0.0, order: None };
        return Refinement { friction, ..refinement };
    }
    refinement
}

fn check(question: &PeriodicQuestion<'_>) -> Result<(), PeriodicContactError> {
    if !question.surface.is_periodic() {
        return Err(PeriodicContactError::NotPeriodic);
    }
    if let Some(accuracy) = question.accuracy
        && !(accuracy > 0.0 && accuracy < 1.0)
    {
        return Err(PeriodicContactError::Accuracy { accuracy });
    }
    let heights = question.surface.heights();
    let limit = heights.iter().sum::<f64>() / heights.len() as f64;
    match question.loading {
        PeriodicLoading::Indentation(indentation) if indentation >= limit => {
            Err(PeriodicContactError::TooDeep { indentation, limit })
        }
        _ => Ok(()),
    }
}
