//! Motion with stick, slip and lift-off, of the oscillator and of a mass on a belt.
//!
//! - `model`: the two of them.
//! - `becomes`: what motions settle to. `amplitude_spectrum`: how they swing.
//! - `pictures`: their figures.
//! - `check`: what they would take.
//! - A folder each: `history` (kind `motion`), `limit_cycle`, `bifurcation`, `basin`.

mod amplitude_spectrum;
mod basin;
pub(crate) mod becomes;
mod bifurcation;
pub(crate) mod check;
mod history;
pub(crate) mod limit_cycle;
pub(crate) mod model;
pub(crate) mod pictures;

pub use history::MotionBlock;

use crate::error::StudyError;
use crate::kept::Kept;
use crate::model::{Pictured, Task};
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_case::MotionAnalysis;
use model::Moving;

/// The kinds of analyses that have a figure.
pub(super) const PICTURED: [Pictured; 4] =
    [history::PICTURED, limit_cycle::PICTURED, bifurcation::PICTURED, basin::PICTURED];

/// How many steps an analysis announces.
pub(crate) fn steps<K>(kind: &MotionAnalysis<K>) -> usize {
    match kind {
        MotionAnalysis::History { .. } | MotionAnalysis::LimitCycle { .. } => 1,
        MotionAnalysis::Bifurcation { sweep, direction, .. } => sweep.points * direction.sweeps().len(),
        MotionAnalysis::Basin { samples, .. } => *samples,
    }
}

fn run<M: Moving<N>, const N: usize>(
    model: &M,
    kind: &MotionAnalysis<M::Key>,
    kept: Kept<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    match kind {
        MotionAnalysis::History { start, following, transient, points } => {
            history::run(model, start, following, (*transient, *points), (progress, None))
        }
        MotionAnalysis::LimitCycle { start, following } => {
            limit_cycle::run(model, start, following, progress)
        }
        MotionAnalysis::Bifurcation { sweep, direction, start, following, transient, branches } => {
            let (transient, branches) = (*transient, *branches);
            let settings = bifurcation::Settings { sweep, start, following, transient, branches };
            bifurcation::run(model, &settings, *direction, kept, progress)
        }
        MotionAnalysis::Basin { within, samples, seed, following } => {
            let draw = basin::Draw { within, samples: *samples, seed: *seed };
            basin::run(model, &draw, following, kept, progress)
        }
    }
}

/// As [`run`], of nothing that is known before; a history hands its samples to `watch` while it is computed.
fn run_watched<M: Moving<N>, const N: usize>(
    model: &M,
    kind: &MotionAnalysis<M::Key>,
    progress: &dyn Progress,
    watch: &mut dyn FnMut(MotionBlock),
) -> Result<Outcome, StudyError> {
    match kind {
        MotionAnalysis::History { start, following, transient, points } => {
            history::run(model, start, following, (*transient, *points), (progress, Some(watch)))
        }
        kind => run(model, kind, Kept::NOTHING, progress),
    }
}

/// Runs an analysis of a model as its task asks.
pub(crate) fn run_task<M: Moving<N>, const N: usize>(
    model: &M,
    kind: &MotionAnalysis<M::Key>,
    task: Task<'_>,
) -> Result<Outcome, StudyError> {
    match task.watch {
        Some(watch) => run_watched(model, kind, task.progress, watch),
        None => run(model, kind, task.own, task.progress),
    }
}
