//! `motion`: the history of one motion.

pub(super) mod run;
mod sound;
mod watched;

use super::counted::ProbedMotions;
use super::model::Moving;
use super::settings::{
    DURATION, MOTION_STEPS, MotionKinds, MotionModel, MotionStart, STEPS, TOLERANCE, TRANSIENT, declared,
    followed, leave_some, read,
};
use super::{MotionEnd, MotionOf, MotionSize, pictures};
use crate::error::ModelError;
use judder_keys::Settings;
use judder_keys::declared::{Settings, Whole};
use judder_keys::error::Fault;
use judder_keys::numeric_key::Value;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::Task;
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use sound::SoundInGroups;

/// The history of one motion.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = HistoryAnalysis::complete)]
pub struct HistoryAnalysis {
    /// Where the motion starts.
    #[key(default = MotionStart::USUAL)]
    pub start: MotionStart,
    /// Time that the motion is followed.
    #[key(rule = DURATION, symbol = "t", default = Value::group(2000.0))]
    pub duration: Value,
    /// First part of the duration, which averages leave out; half of it by default.
    #[key(rule = TRANSIENT, symbol = "t", filled)]
    pub transient: Value,
    /// Points of the uniform grid of time that is kept.
    #[key(rule = Whole { from: 16, to: 1 << 22 }, default = 4096)]
    pub points: usize,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = 1e-8)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
    /// Whether the velocity along x becomes a sound; of a case with seconds: an oscillator whose speed or load is given in SI, a belt with mass and stiffness.
    #[key(omitted)]
    pub sound: Option<bool>,
}

followed!(HistoryAnalysis);

impl HistoryAnalysis {
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        leave_some(&mut self.transient, self.duration, section)
    }
}

impl<S: MotionModel> MotionKinds<S> {
    /// The kind.
    pub(crate) const HISTORY: Kind<S, S::Analysis> = Kind {
        name: "motion",
        doc: "the history of one motion: stick, slip, lift-off, its averages, its energy",
        declared: declared::<S, HistoryAnalysis>,
        read: |keys, section| {
            let own = read::<S, HistoryAnalysis>(keys, section)?;
            if own.sound == Some(true) && !keys.has_seconds() {
                return Err(SoundInGroups { seconds: S::SECONDS }.at(section.place_of(&["sound"])));
            }
            Ok(S::of_motion(own))
        },
        picture: Some(Picture {
            draw: |dataset| pictures::motion(dataset, S::FREQUENCY),
            caption: "The whole motion; its end with the contact state shaded (white: slip); the phase portrait of that end with the changes of the contact \
                state; the spectrum and the Poincaré section (where $x$ is largest) after the transient.",
        }),
    };
}

impl<S: MotionModel> MotionOf<S> for HistoryAnalysis {
    fn summary_keys(&self) -> Vec<Declared> {
        run::summary_keys(self.sound == Some(true))
    }

    fn run<M: Moving<N, Key = S::Key>, const N: usize>(
        &self,
        model: &M,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError> {
        run::run(model, self, task.progress, task.watch)
    }

    fn is_heard(&self) -> bool {
        self.sound == Some(true)
    }

    fn size(&self) -> MotionSize {
        MotionSize { points: self.points, motions: 1, ends: MotionEnd::Duration, branches: false }
    }

    fn probed(&self) -> ProbedMotions<'_, S::Key> {
        ProbedMotions { start: self.start, following: self.following(), sweep: None }
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
