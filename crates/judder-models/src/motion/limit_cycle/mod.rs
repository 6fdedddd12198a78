//! `limit-cycle`: the cycle that a motion settles to, made exact.

mod run;

pub(crate) use run::shooting;

use super::counted::ProbedMotions;
use super::model::Moving;
use super::settings::{
    CYCLE_TOLERANCE, DURATION, MOTION_STEPS, MotionKinds, MotionModel, MotionStart, SETTLING_DURATION, STEPS,
    TOLERANCE, declared, followed, read,
};
use super::{MotionEnd, MotionOf, MotionSize, pictures};
use crate::error::ModelError;
use judder_keys::Settings;
use judder_keys::declared::Settings;
use judder_keys::numeric_key::Value;
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::Task;
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};

/// The cycle that a motion settles to.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct LimitCycle {
    /// Where the motion starts.
    #[key(default = MotionStart::USUAL)]
    pub start: MotionStart,
    /// Time within which the motion settles.
    #[key(rule = DURATION, symbol = "t", default = SETTLING_DURATION)]
    pub duration: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = CYCLE_TOLERANCE)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
}

followed!(LimitCycle);

impl<S: MotionModel> MotionKinds<S> {
    /// The kind.
    pub(crate) const LIMIT_CYCLE: Kind<S, S::Analysis> = Kind {
        name: "limit-cycle",
        doc: "the cycle that a motion settles to, with its Floquet multipliers",
        declared: declared::<S, LimitCycle>,
        read: |keys, section| read::<S, LimitCycle>(keys, section).map(S::of_motion),
        picture: Some(Picture {
            draw: pictures::limit_cycle,
            caption: "One period with the contact state shaded (white: slip), the phase portrait with the changes of the contact state, and the Floquet \
                multipliers: the cycle is stable where all but the one at 1 lie within the unit circle.",
        }),
    };
}

impl<S: MotionModel> MotionOf<S> for LimitCycle {
    fn summary_keys(&self) -> Vec<Declared> {
        run::summary_keys()
    }

    fn run<M: Moving<N, Key = S::Key>, const N: usize>(
        &self,
        model: &M,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError> {
        run::run(model, &self.start, &self.following(), task.progress)
    }

    fn size(&self) -> MotionSize {
        MotionSize { points: 1, motions: 1, ends: MotionEnd::Settled, branches: false }
    }

    fn probed(&self) -> ProbedMotions<'_, S::Key> {
        ProbedMotions { start: self.start, following: self.following(), sweep: None }
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
