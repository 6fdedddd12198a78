//! Steady sliding of a rigid indenter on a viscoelastic half-space: grids chosen, refined, and their errors shown.
//!
//! - [`profile`]: the indenter's surface as a height over every point.
//! - [`domain`]: the square in which contact is sought, fitted to the contact.
//! - [`level`]: the problem on one grid and what is measured on its solution.
//! - [`contact_area`]: the area with its perimeter placed inside the cells.
//! - [`bulk_dissipation`]: friction once more, from the energy dissipated.
//! - [`refinement`]: the errors estimated from a sequence of grids.
//! - `line`: what is different for a long cylinder; `posed`: the problem as a solver takes it.
//! - [`start`]: what the solve on a grid starts from.

pub mod bulk_dissipation;
pub mod contact_area;
pub mod domain;
pub mod error;
pub mod level;
mod line;
mod posed;
pub mod profile;
pub mod refinement;
pub mod start;

use crate::kernel::substrate::SlidingSubstrate;
use crate::surface::grid::SurfaceGrid;
use crate::unilateral::{Loading, UnilateralLimits};
use domain::Domain;
pub use error::SteadyError;
use judder_numerics::stopping::Interrupted;
use level::Level;
use profile::Profile;
use refinement::{LevelSummary, Refinement};
use start::LevelStart;

/// Cells a side of the grid on which the extent of the contact is found.
const SCOUT: usize = 32;
/// Cells a side of the finest grid that is chosen without being asked for.
const FINEST: usize = 1024;
/// Strips of the finest row that is chosen without being asked for: a line contact costs a row, not a square.
const FINEST_STRIPS: usize = 16384;
/// Cells a side of the coarsest grid of a sequence.
const COARSEST: usize = 32;
/// How often the domain may be fitted to the contact.
const FITS: usize = 4;
/// Bytes that a kernel may take unless said otherwise: the finest grid chosen unasked takes a tenth.
pub const MEMORY: u64 = 4 << 30;

/// The grid on which a contact is computed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum GridChoice {
    /// Domain fitted to the contact, cells halved until the accuracy is met.
    #[default]
    Automatic,
    /// Domain fitted to the contact, this many cells a side.
    Cells(usize),
    /// A square domain as given.
    Fixed {
        /// Cells a side.
        cells: usize,
        /// Half the side of the domain, in R.
        half_width: f64,
        /// Its centre, in R; a line contact has x alone.
        centre: [f64; 2],
    },
}

/// A steady-sliding problem: lengths in R, pressures in E0*, forces in E0* R².
///
/// The contact of a [line](Profile::is_line) takes a force per length in E0* R, and answers with a width in place of an area.
#[derive(Clone, Copy)]
pub struct SteadyQuestion<'a> {
    /// The substrate with its wake lengths ℓ_k = v τ_k, in R.
    pub substrate: &'a SlidingSubstrate,
    /// The indenter's surface.
    pub profile: &'a dyn Profile,
    /// Imposed depth y/R or force F/(E0* R²).
    pub loading: Loading,
    /// Relative error allowed to the force; area and friction may be five times as far off.
    pub accuracy: f64,
    /// Cells and extent.
    pub grid: GridChoice,
    /// How exactly each grid's problem is solved.
    pub limits: UnilateralLimits,
    /// Bytes of memory that a grid's kernel may take.
    pub memory: u64,
}

impl SteadyQuestion<'_> {
    /// A domain in squares, or in strips for a line contact.
    fn cells(&self, domain: &Domain, side: usize) -> SurfaceGrid {
        if self.profile.is_line() { domain.strips(side) } else { domain.grid(side) }
    }

    fn refinement(&self, levels: &[LevelSummary]) -> Refinement {
        if self.profile.is_line() {
            return Refinement::of_line(levels);
        }
        let unresolved = levels.last().is_some_and(|finest| self.substrate.has_wake_of(finest.cell));
        Refinement::of(levels, unresolved)
    }

    fn finest(&self) -> usize {
        if self.profile.is_line() { FINEST_STRIPS } else { FINEST }
    }
}

/// The answer: what the indenter feels, how exact that is, and the fields on the finest grid.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyContact {
    /// Force, area, friction and depth with their estimated errors, and the grids they come from; the error of the friction is no
    /// smaller than the difference from that in the bulk.
    pub refinement: Refinement,
    /// Friction coefficient from the energy dissipated in the bulk, on the finest grid.
    pub friction_from_dissipation: f64,
    /// The finest grid's solution.
    pub finest: Level,
    /// Changes of the contact set over all grids.
    pub iterations: usize,
    /// Products with the kernel over all grids.
    pub products: usize,
    /// Whether every grid's problem was solved and the accuracy is met.
    pub converged: bool,
}

impl SteadyContact {
    /// Relative difference of the two frictions, from the surface and from the bulk.
    #[must_use]
    pub fn friction_difference(&self) -> f64 {
        relative_difference(self.finest.friction, self.friction_from_dissipation)
    }
}

/// Solves a steady-sliding problem on a sequence of grids until its accuracy is met.
///
/// # Errors
/// [`SteadyError`] where the question is ill posed, the given domain is too small or a product overflows. An answer
/// that misses its accuracy is no error: `converged` is false and the errors say by how much.
pub fn solve(question: &SteadyQuestion<'_>) -> Result<SteadyContact, SteadyError> {
    solve_until(question, &|| false)
}

/// Solves a steady-sliding problem as [`solve`] does, unless `interrupted` says to stop: it is asked before each product with the kernel.
///
/// # Errors
/// As of [`solve`]; [`SteadyError::Interrupted`].
pub fn solve_until(
    question: &SteadyQuestion<'_>,
    interrupted: Interrupted<'_>,
) -> Result<SteadyContact, SteadyError> {
    check(question)?;
    let (domain, sides, mut start) = match question.grid {
        GridChoice::Fixed { cells, half_width, centre } => {
            (Domain { centre, half_width }, nested(cells), LevelStart::none(question))
        }
        GridChoice::Cells(cells) => {
            let (domain, start) = fitted_domain(question, interrupted)?;
            (domain, nested(cells), start)
        }
        GridChoice::Automatic => {
            let (domain, start) = fitted_domain(question, interrupted)?;
            (domain, nested(question.finest()), start)
        }
    };
    let finest = sides.last().copied();
    let mut summaries: Vec<LevelSummary> = Vec::new();
    for side in sides {
        let level = Level::solve_until(question, &question.cells(&domain, side), &start, interrupted)?;
        if level.touches_edge() {
            return Err(too_small(question, &domain, interrupted));
        }
        summaries.push(LevelSummary::of(&level));
        start = LevelStart::from(&level);
        let may_end = question.grid == GridChoice::Automatic
            && question.refinement(&summaries).meets(question.accuracy);
        // The bulk is asked last: it costs as much as a coarse grid.
        if may_end || Some(side) == finest {
            let contact = answer(question, &summaries, level);
            if Some(side) == finest || contact.refinement.meets(question.accuracy) {
                return Ok(contact);
            }
        }
    }
    Err(SteadyError::NoCells)
}

/// The error that names the half width which would do, found where the domain is free.
fn too_small(question: &SteadyQuestion<'_>, domain: &Domain, interrupted: Interrupted<'_>) -> SteadyError {
    match fitted_domain(question, interrupted) {
        Ok((fitted, _)) => SteadyError::DomainTooSmall {
            half_width: domain.half_width,
            centre_x: domain.centre[0],
            needed: domain.half_width_around(&fitted),
        },
        Err(error) => error,
    }
}

fn answer(question: &SteadyQuestion<'_>, summaries: &[LevelSummary], finest: Level) -> SteadyContact {
    let dissipated = if question.profile.is_line() {
        bulk_dissipation::friction_of_a_line
    } else {
        bulk_dissipation::friction_from_dissipation
    }(&finest.grid, &finest.solution.pressure, question.substrate);
    let friction_from_dissipation = dissipated / finest.force;
    let difference = relative_difference(finest.friction, friction_from_dissipation);
    let refinement = question.refinement(summaries).with_friction_difference(difference);
    let solved = summaries.iter().all(|level| level.converged);
    SteadyContact {
        friction_from_dissipation,
        iterations: summaries.iter().map(|level| level.iterations).sum(),
        products: summaries.iter().map(|level| level.products).sum(),
        converged: solved && refinement.meets(question.accuracy),
        refinement,
        finest,
    }
}

/// The difference over the larger of the two; 0 where both are.
fn relative_difference(one: f64, other: f64) -> f64 {
    let scale = one.abs().max(other.abs());
    if scale == 0.0 { 0.0 } else { (one - other).abs() / scale }
}

/// Cells a side, each grid twice as fine as the one before, up to `finest`.
fn nested(finest: usize) -> Vec<usize> {
    let mut sides = vec![finest];
    while sides[sides.len() - 1].is_multiple_of(2) && sides[sides.len() - 1] / 2 >= COARSEST {
        sides.push(sides[sides.len() - 1] / 2);
    }
    sides.reverse();
    sides
}

/// The domain that the contact fills, found on a coarse grid, with a pressure to start from.
fn fitted_domain(
    question: &SteadyQuestion<'_>,
    interrupted: Interrupted<'_>,
) -> Result<(Domain, LevelStart), SteadyError> {
    let mut domain = Domain::overlap(question.profile, question.loading);
    let mut start = LevelStart::none(question);
    for _ in 0..FITS {
        let level = Level::solve_until(question, &question.cells(&domain, SCOUT), &start, interrupted)?;
        start = LevelStart::from(&level);
        match domain.fitted(&level) {
            Some(better) => domain = better,
            None => break,
        }
    }
    Ok((domain, start))
}

fn check(question: &SteadyQuestion<'_>) -> Result<(), SteadyError> {
    if !(question.accuracy > 0.0 && question.accuracy < 1.0) {
        return Err(SteadyError::Accuracy { accuracy: question.accuracy });
    }
    if let Loading::Indentation(depth) = question.loading
        && depth >= question.profile.deepest()
    {
        return Err(SteadyError::TooDeep { indentation: depth, limit: question.profile.deepest() });
    }
    match question.grid {
        GridChoice::Automatic => Ok(()),
        GridChoice::Cells(cells) if cells >= 8 => Ok(()),
        GridChoice::Fixed { cells, half_width, centre }
            if cells >= 8
                && half_width > 0.0
                && half_width.is_finite()
                && centre.iter().all(|c| c.is_finite()) =>
        {
            Ok(())
        }
        GridChoice::Cells(cells) => Err(SteadyError::TooFewCells { cells }),
        GridChoice::Fixed { cells, half_width, .. } if cells >= 8 => {
            Err(SteadyError::HalfWidth { half_width })
        }
        GridChoice::Fixed { cells, .. } => Err(SteadyError::TooFewCells { cells }),
    }
}
