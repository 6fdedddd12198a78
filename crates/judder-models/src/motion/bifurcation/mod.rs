//! `bifurcation`: what motions settle to along one key, up and down.

pub(super) mod branch_layers;
mod branches;
mod diagram;
mod point;
mod run;

use super::counted::ProbedMotions;
use super::model::Moving;
use super::settings::{
    DURATION, MOTION_STEPS, MotionKinds, MotionModel, MotionStart, STEPS, TOLERANCE, TRANSIENT, declared,
    followed, leave_some, read,
};
use super::{MotionEnd, MotionOf, MotionSize, pictures};
use crate::error::ModelError;
use crate::key_unit::{in_unit, unit_of};
use crate::read_sweep::SWEEP;
use crate::sweep::Sweep;
use judder_keys::declared::{Settings, both};
use judder_keys::error::Fault;
use judder_keys::numeric_key::Value;
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::Task;
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};

/// What the motion settles to along one key.
#[derive(Debug, Clone, PartialEq)]
pub struct Bifurcation<K> {
    /// The swept key.
    pub sweep: Sweep<K>,
    /// How it is followed.
    pub diagram: BifurcationAnalysis,
}

/// How a bifurcation diagram is followed: each motion starts where the one before has ended.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = BifurcationAnalysis::complete)]
pub struct BifurcationAnalysis {
    /// Which way the key is followed.
    #[key(default = SweepDirection::Both)]
    pub direction: SweepDirection,
    /// Where the motion at the first value starts.
    #[key(default = MotionStart::USUAL)]
    pub start: MotionStart,
    /// Time within which each motion settles.
    #[key(rule = DURATION, symbol = "t", default = Value::group(5000.0))]
    pub duration: Value,
    /// First part of the duration, which the averages of an irregular motion leave out; half of it by default.
    #[key(rule = TRANSIENT, symbol = "t", filled)]
    pub transient: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = 1e-6)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
    /// Follow the [branches of cycles](theory/motion.md#branches-through-a-diagram), stable and unstable, through the diagram: a cascade of cycles that stick and lift off takes minutes.
    #[key(default = false)]
    pub branches: bool,
}

followed!(BifurcationAnalysis);

/// Which way a bifurcation diagram is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "direction")]
pub enum SweepDirection {
    /// Both ways.
    Both,
    /// From the first value to the last.
    Forward,
    /// From the last value to the first.
    Backward,
}

impl SweepDirection {
    /// The single sweeps that it takes.
    pub fn sweeps(self) -> &'static [Self] {
        match self {
            Self::Both => &[Self::Forward, Self::Backward],
            Self::Forward => &[Self::Forward],
            Self::Backward => &[Self::Backward],
        }
    }
}

impl BifurcationAnalysis {
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        leave_some(&mut self.transient, self.duration, section)
    }
}

impl<S: MotionModel> MotionKinds<S> {
    /// The kind.
    pub(crate) const BIFURCATION: Kind<S, S::Analysis> = Kind {
        name: "bifurcation",
        doc: "what the motion settles to along one key, each motion from the end of the one before",
        declared: || [vec![SWEEP.declaration::<S>()], declared::<S, BifurcationAnalysis>()].concat(),
        read: |keys, section| {
            let (sweep, diagram) =
                both(SWEEP.read_alone(keys, section), read::<S, BifurcationAnalysis>(keys, section))?;
            Ok(S::of_motion(Bifurcation { sweep, diagram }))
        },
        picture: Some(Picture {
            draw: pictures::bifurcation,
            caption: "What motions settle to as the key goes up and down, each from the end of the one before: rms of $x$ about its mean, its largest values, the \
        shares of the time in stick and in lift-off. Irregular is a motion without a period from which nearby ones part; \
        unconfirmed is what has not settled within its time, or changes its kind with the tolerance. Points are simulated, and no line joins them: neighbours may have \
        settled to different motions. Where branches were followed, lines are cycles \
        and steady sliding, stable (solid) or not (dashed).",
        }),
    };
}

impl<S: MotionModel> MotionOf<S> for Bifurcation<S::Key> {
    fn announced(&self) -> usize {
        self.motions()
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let keys = run::summary_keys(self.diagram.branches);
        in_unit(keys, &unit_of::<S>(&self.sweep), &["value", "folds", "between"])
    }

    fn run<M: Moving<N, Key = S::Key>, const N: usize>(
        &self,
        model: &M,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError> {
        let diagram = &self.diagram;
        let settings = run::DiagramSettings {
            sweep: &self.sweep,
            start: &diagram.start,
            following: &diagram.following(),
            transient: diagram.transient,
            branches: diagram.branches,
        };
        run::run(model, &settings, diagram.direction, task.own, task.progress)
    }

    fn size(&self) -> MotionSize {
        let (motions, branches) = (self.motions(), self.diagram.branches);
        MotionSize { points: motions, motions, ends: MotionEnd::Confirmed, branches }
    }

    fn probed(&self) -> ProbedMotions<'_, S::Key> {
        let BifurcationAnalysis { start, .. } = self.diagram;
        ProbedMotions { start, following: self.diagram.following(), sweep: Some(&self.sweep) }
    }

    fn write(&self, json: &mut Map<String, Json>) {
        SWEEP.write::<S>(&self.sweep, json);
        self.diagram.write_table(json);
    }

    fn swept(&self) -> Option<&Sweep<S::Key>> {
        Some(&self.sweep)
    }
}

impl<K> Bifurcation<K> {
    /// How many motions are followed.
    fn motions(&self) -> usize {
        self.sweep.points * self.diagram.direction.sweeps().len()
    }
}
