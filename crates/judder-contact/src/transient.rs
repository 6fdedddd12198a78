//! A rigid indenter on any path over a viscoelastic half-space: the contact as a function of time.
//!
//! - [`path`]: where the indenter goes, and how deep or with what force.
//! - [`substrate`]: creep with retardation times.
//! - `window`: the cells that move with the indenter, the strip of material that is remembered.
//! - `weights`, `memory`: the past as one retarded pressure for each retardation time.
//! - `step`: a step, which is an elastic contact over the surface that the past has left.
//! - `control`: the length of the steps.
//! - `march`: step after step; `quadrature`: work from samples.
//! - [`history`]: what comes out.
//!
//! Lengths are in R, pressures in E0*, forces in E0* R²; times in any unit, the same for path and substrate.

mod control;
pub mod error;
pub mod history;
mod march;
mod memory;
pub mod path;
mod quadrature;
mod step;
pub mod substrate;
mod weights;
mod window;

use crate::steady::profile::Profile;
use crate::unilateral::UnilateralLimits;
pub use error::TransientError;
pub use history::{TransientEnergy, TransientFields, TransientHistory, TransientSample};
pub use path::{IndenterPath, NormalCourse, PathCourse};
use std::ops::ControlFlow;
pub use substrate::{CreepingSubstrate, CreepingTerm};

/// What the substrate has gone through before the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Before {
    /// Nothing: it answers the first touch like glass.
    #[default]
    Untouched,
    /// The indenter has rested for ever as it stands at time 0: all has crept.
    Settled,
}

/// Length of the steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepControl {
    /// Error allowed to a step: displacement over the contact, over the largest depth of the path.
    pub tolerance: f64,
    /// Cells by which the indenter may move in a step.
    pub cells_a_step: f64,
    /// Steps after which the run ends, completed or not, those that were rejected included.
    pub most: usize,
}

impl Default for StepControl {
    fn default() -> Self {
        Self { tolerance: 1e-4, cells_a_step: 1.0, most: 100_000 }
    }
}

/// The cells of a transient contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransientGrid {
    /// Cells a side of the window that moves with the indenter.
    pub cells: usize,
    /// Half the side of the window, in R; `None` for the square that the undeformed indenter cuts from the surface.
    pub half_width: Option<f64>,
    /// Bytes that may be taken.
    pub memory_limit: u64,
}

impl Default for TransientGrid {
    fn default() -> Self {
        Self { cells: 64, half_width: None, memory_limit: 2 << 30 }
    }
}

/// A transient contact problem.
#[derive(Clone, Copy)]
pub struct TransientQuestion<'a> {
    /// The substrate.
    pub substrate: &'a CreepingSubstrate,
    /// The indenter's surface.
    pub profile: &'a dyn Profile,
    /// Where the indenter goes.
    pub path: &'a IndenterPath,
    /// End of the path, in time units.
    pub duration: f64,
    /// What was before.
    pub before: Before,
    /// The cells.
    pub grid: TransientGrid,
    /// Length of the steps.
    pub steps: StepControl,
    /// Times at which fields are kept.
    pub fields_at: &'a [f64],
    /// Whether stored and dissipated energy are computed: one product with the strip more for each retardation time.
    pub energy: bool,
    /// How exactly the contact of each step is solved.
    pub limits: UnilateralLimits,
}

impl<'a> TransientQuestion<'a> {
    /// A question with the default cells, steps and limits, about an untouched substrate.
    #[must_use]
    pub fn new(
        substrate: &'a CreepingSubstrate,
        profile: &'a dyn Profile,
        path: &'a IndenterPath,
        duration: f64,
    ) -> Self {
        Self {
            substrate,
            profile,
            path,
            duration,
            before: Before::default(),
            grid: TransientGrid::default(),
            steps: StepControl::default(),
            fields_at: &[],
            energy: false,
            limits: UnilateralLimits::default(),
        }
    }

    /// Columns and rows of the strip of material that will be remembered, and the bytes that this takes: ask before running.
    ///
    /// # Errors
    /// What makes the question ill posed, but not [`TransientError::Memory`].
    pub fn needs(&self) -> Result<([usize; 2], u64), TransientError> {
        window::ContactWindow::needs(self)
    }

    /// Refuses a path whose motion over the cells or whose frequencies need more steps than are allowed.
    fn refuse_too_many_steps(&self, cell: f64) -> Result<(), TransientError> {
        let StepControl { cells_a_step, most, .. } = self.steps;
        let by_motion = self.path.position.largest_rate() / (cells_a_step * cell);
        let needed = self.duration * by_motion.max(1.0 / self.path.longest_step());
        let allowed = most;
        if needed <= allowed as f64 { Ok(()) } else { Err(TransientError::TooManySteps { needed, allowed }) }
    }
}

/// Follows an indenter on its path.
///
/// `progress` is told the end of every step and may stop the run, whose history is then not `completed`.
///
/// # Errors
/// [`TransientError`] where the question is ill posed, takes too much memory, or the contact outgrows its window. Steps
/// whose contact was not solved are no error: `converged` is false and the samples' residuals say by how much.
pub fn run(
    question: &TransientQuestion<'_>,
    progress: &mut dyn FnMut(&TransientSample) -> ControlFlow<()>,
) -> Result<TransientHistory, TransientError> {
    check(question)?;
    march::TransientMarch::new(question)?.run(progress)
}

fn check(question: &TransientQuestion<'_>) -> Result<(), TransientError> {
    question.substrate.check()?;
    question.path.position.check()?;
    question.path.normal_course().check()?;
    substrate::positive("duration", question.duration)?;
    substrate::positive("tolerance of a step", question.steps.tolerance)?;
    substrate::positive("tolerance of the contact", question.limits.tolerance)?;
    substrate::positive("motion in a step, in cells,", question.steps.cells_a_step)?;
    let outside = |time: &&f64| !(0.0..=question.duration).contains(*time);
    match question.fields_at.iter().find(outside) {
        Some(time) => Err(TransientError::FieldTime { time: *time, duration: question.duration }),
        None => Ok(()),
    }
}
