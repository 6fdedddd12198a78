//! Motion with stick, slip and lift-off, of the oscillator and of a mass on a belt.
//!
//! - `model`: the two of them.
//! - `becomes`: what motions settle to. `amplitude_spectrum`: how they swing.
//! - `pictures`: their figures.
//! - `check`: what they would take.
//! - A folder each: `history` (kind `motion`), `limit_cycle`, `bifurcation`, `basin`.

mod amplitude_spectrum;
mod basin;
pub mod becomes;
mod bifurcation;
pub(crate) mod check;
mod history;
pub(crate) mod limit_cycle;
pub(crate) mod model;
pub mod pictures;
pub mod settings;

use crate::error::ModelError;
use crate::motion::settings::{Bifurcation, MotionAnalysis};
use judder_store::Declared;
use judder_study::Progress;
use judder_study::kept::Kept;
use judder_study::model::{MotionBlock, Task};
use judder_study::outcome::Outcome;
use model::Moving;

/// How many steps an analysis announces.
pub(crate) fn steps<K>(kind: &MotionAnalysis<K>) -> usize {
    match kind {
        MotionAnalysis::History(_) | MotionAnalysis::LimitCycle(_) => 1,
        MotionAnalysis::Bifurcation(asked) => asked.sweep.points * asked.diagram.direction.sweeps().len(),
        MotionAnalysis::Basin(asked) => asked.samples,
    }
}

/// The keys of the summary of an analysis.
pub(crate) fn summary_keys<K>(kind: &MotionAnalysis<K>) -> Vec<Declared> {
    match kind {
        MotionAnalysis::History(_) => history::summary_keys(),
        MotionAnalysis::LimitCycle(_) => limit_cycle::summary_keys(),
        MotionAnalysis::Bifurcation(asked) => bifurcation::summary_keys(asked.diagram.branches),
        MotionAnalysis::Basin(_) => basin::summary_keys(),
    }
}

fn run<M: Moving<N>, const N: usize>(
    model: &M,
    kind: &MotionAnalysis<M::Key>,
    kept: Kept<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    match kind {
        MotionAnalysis::History(asked) => history::run(model, asked, progress, None),
        MotionAnalysis::LimitCycle(asked) => {
            limit_cycle::run(model, &asked.start, &asked.following(), progress)
        }
        MotionAnalysis::Bifurcation(Bifurcation { sweep, diagram }) => {
            let settings = bifurcation::Settings {
                sweep,
                start: &diagram.start,
                following: &diagram.following(),
                transient: diagram.transient,
                branches: diagram.branches,
            };
            bifurcation::run(model, &settings, diagram.direction, kept, progress)
        }
        MotionAnalysis::Basin(asked) => {
            let within = asked.within.state::<N>();
            let draw = basin::Draw { within: &within, samples: asked.samples, seed: asked.seed as u64 };
            basin::run(model, &draw, &asked.following(), kept, progress)
        }
    }
}

/// As [`run`], of nothing that is known before; a history hands its samples to `watch` while it is computed.
fn run_watched<M: Moving<N>, const N: usize>(
    model: &M,
    kind: &MotionAnalysis<M::Key>,
    progress: &dyn Progress,
    watch: &mut dyn FnMut(MotionBlock),
) -> Result<Outcome, ModelError> {
    match kind {
        MotionAnalysis::History(asked) => history::run(model, asked, progress, Some(watch)),
        kind => run(model, kind, Kept::NOTHING, progress),
    }
}

/// Runs an analysis of a model as its task asks.
pub(crate) fn run_task<M: Moving<N>, const N: usize>(
    model: &M,
    kind: &MotionAnalysis<M::Key>,
    task: Task<'_>,
) -> Result<Outcome, ModelError> {
    match task.watch {
        Some(watch) => run_watched(model, kind, task.progress, watch),
        None => run(model, kind, task.own, task.progress),
    }
}
