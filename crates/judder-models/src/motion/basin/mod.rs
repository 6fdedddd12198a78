//! `basin`: the share of starts from which steady sliding is reached.

mod run;

use super::counted::ProbedMotions;
use super::model::Moving;
use super::settings::{
    COORDINATE_VELOCITY, DISPLACEMENT, DURATION, MOTION_STEPS, MotionKinds, MotionModel, MotionStart,
    SETTLING_DURATION, STEPS, TOLERANCE, declared, followed, in_order, read,
};
use super::{MotionEnd, MotionOf, MotionSize, pictures};
use crate::error::ModelError;
use judder_keys::Settings;
use judder_keys::declared::{ScaledPair, Settings, Whole};
use judder_keys::error::Fault;
use judder_keys::numeric_key::Value;
use judder_keys::section::Section;
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::case::study_sweep::SEEDS;
use judder_study::model::Task;
use judder_study::outcome::Outcome;
use run::Draw;
use serde_json::{Map, Value as Json};

/// The share of starts from which steady sliding is reached.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct BasinAnalysis {
    /// The ranges from which starts are drawn, evenly and independently.
    #[key(example = "{ x = [from, to], velocity_x = [from, to] }, the ranges of the starts")]
    pub within: StartRanges,
    /// Number of starts.
    #[key(rule = Whole { from: 1, to: 10_000_000 }, default = 1000)]
    pub samples: usize,
    /// Which starts are drawn; the n-th depends on the seed and on n alone.
    #[key(rule = SEEDS, default = 1)]
    pub seed: usize,
    /// Time within which each motion settles.
    #[key(rule = DURATION, symbol = "t", default = SETTLING_DURATION)]
    pub duration: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    #[key(rule = TOLERANCE, symbol = "ε", default = 1e-6)]
    pub tolerance: f64,
    /// The most steps of one motion.
    #[key(rule = STEPS, default = MOTION_STEPS)]
    pub steps: usize,
}

followed!(BasinAnalysis);

/// The range of each coordinate of a start; what is left out stands as in steady sliding.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
#[settings(check = StartRanges::says_one)]
pub struct StartRanges {
    /// Of the displacement.
    #[key(rule = DISPLACEMENTS, omitted)]
    pub x: Option<[Value; 2]>,
    /// Of the normal displacement.
    #[key(rule = DISPLACEMENTS, omitted)]
    pub y: Option<[Value; 2]>,
    /// Of the velocity along x.
    #[key(rule = VELOCITIES, omitted)]
    pub velocity_x: Option<[Value; 2]>,
    /// Of the velocity along y.
    #[key(rule = VELOCITIES, omitted)]
    pub velocity_y: Option<[Value; 2]>,
}

const ENDS: &str = "two numbers, [from, to]";
const DISPLACEMENTS: ScaledPair = ScaledPair { of: DISPLACEMENT, what: ENDS };
const VELOCITIES: ScaledPair = ScaledPair { of: COORDINATE_VELOCITY, what: ENDS };

impl StartRanges {
    /// The ranges in the order of a state: displacements, then their velocities.
    pub fn state<const N: usize>(&self) -> [Option<[Value; 2]>; N] {
        in_order([self.x, self.y], [self.velocity_x, self.velocity_y])
    }

    fn says_one(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if !section.is_empty() {
            return Ok(());
        }
        Err(section.missing("x", "x = [from, to], the range of a coordinate"))
    }
}

impl<S: MotionModel> MotionKinds<S> {
    /// The kind.
    pub(crate) const BASIN: Kind<S, S::Analysis> = Kind {
        name: "basin",
        doc: "the share of starts, drawn evenly, from which steady sliding is reached",
        declared: declared::<S, BasinAnalysis>,
        read: |keys, section| read::<S, BasinAnalysis>(keys, section).map(S::of_motion),
        picture: Some(Picture {
            draw: pictures::basin,
            caption: "Starts, drawn evenly, and what becomes of them.",
        }),
    };
}

impl<S: MotionModel> MotionOf<S> for BasinAnalysis {
    fn announced(&self) -> usize {
        self.samples
    }

    fn summary_keys(&self) -> Vec<Declared> {
        run::summary_keys()
    }

    fn run<M: Moving<N, Key = S::Key>, const N: usize>(
        &self,
        model: &M,
        task: Task<'_>,
    ) -> Result<Outcome, ModelError> {
        let operating = model.operating(None)?;
        let ranges = self.within.state::<N>();
        let within: [_; N] =
            std::array::from_fn(|k| ranges[k].map(|ends| ends.map(|end| operating.coordinate::<N>(k, end))));
        let draw = Draw { within: &within, samples: self.samples, seed: self.seed as u64 };
        run::run(model, &draw, &self.following(), task.own, task.progress)
    }

    fn size(&self) -> MotionSize {
        let samples = self.samples;
        MotionSize { points: samples, motions: samples, ends: MotionEnd::Confirmed, branches: false }
    }

    fn probed(&self) -> ProbedMotions<'_, S::Key> {
        ProbedMotions { start: MotionStart::USUAL, following: self.following(), sweep: None }
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
