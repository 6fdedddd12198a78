//! The analyses of motion: stick, slip and lift-off of the oscillator, stick and slip of the mass on a belt.

mod amplitude_spectrum;
mod basin;
pub(crate) mod becomes;
mod bifurcation;
mod branches;
mod diagram;
pub(super) mod engines;
mod history;
mod limit_cycle;
mod model;
mod watched;

pub(crate) use model::belt;
pub(super) use model::{BeltModel, OscillatorModel};
pub use watched::MotionBlock;

use crate::error::StudyError;
use crate::kept::Kept;
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_case::MotionAnalysis;
use model::Model;

/// How many steps an analysis announces.
pub(super) fn steps<K>(kind: &MotionAnalysis<K>) -> usize {
    match kind {
        MotionAnalysis::History { .. } | MotionAnalysis::LimitCycle { .. } => 1,
        MotionAnalysis::Bifurcation { sweep, direction, .. } => sweep.points * direction.sweeps().len(),
        MotionAnalysis::Basin { samples, .. } => *samples,
    }
}

pub(super) fn run<M: Model<N>, const N: usize>(
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
pub(super) fn run_watched<M: Model<N>, const N: usize>(
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
