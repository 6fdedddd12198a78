//! `march`: the motion along the path.

mod blocks;
mod expected;
pub mod figure;
mod loudness;
mod run;
mod sampling;
pub mod settings;
mod signals;
mod size;
pub(crate) mod sound;
mod summary;
pub(crate) mod tables;

pub(super) use signals::variable_name;
pub(super) use size::MarchSize;

use super::pair_size::with_pair;
use super::system::step;
use super::{SlidingSubject, blame, cost};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost::FIGURE};
use crate::sliding::case::SlidingCase;
use crate::sliding::case::observe::ObservedPoint;
use judder_keys::declared::Settings;
use judder_sliding::motion::Motion;
use judder_sliding::pair::Pair;
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use settings::MarchAnalysis;
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<Option<SlidingCase>, Arc<dyn Analysis<SlidingCase>>> = Kind {
    name: "march",
    doc: "the motion along the path by explicit time integration: signals, bursts, contact forces",
    declared: MarchAnalysis::declarations,
    read: |case, section| {
        let own = MarchAnalysis::read_table(section)?;
        Ok(Arc::new(match case {
            Some(case) => own.admit(case, section)?,
            None => own,
        }))
    },
    picture: Some(Picture {
        draw: figure::march,
        caption: "Each line fills the space between the smallest and the largest sample of a column; samples are low-passed before they are thinned. Below the normal force, the share of each state of the contact in the samples of a column. Above \
        the frame, where the contact is. Extremes of every step stand in the table.",
    }),
};

/// What marches, and how it is asked to.
pub(crate) struct Marched<'a> {
    /// The name of the analysis.
    pub(crate) name: &'a str,
    /// What the case asks for.
    pub(crate) march: &'a MarchAnalysis,
    /// The slider and its track.
    pub(crate) pair: &'a Pair,
    /// The points whose motion is kept.
    pub(crate) points: &'a [ObservedPoint],
    /// What is prescribed, from the start of the march to its end.
    pub(crate) motion: Motion,
}

impl Analysis<SlidingCase> for MarchAnalysis {
    fn memory(&self, of: &SlidingSubject<'_>) -> Result<NeededMemory, ModelError> {
        // a step that is refused is said by the analysis
        let of_samples = MarchSize::of(of.system, self).map_or(NeededMemory::LITTLE, MarchSize::memory);
        Ok(with_pair(of_samples, of.system))
    }

    fn admit(&self, of: &SlidingSubject<'_>) -> Result<(), ModelError> {
        step(&of.system.pair, self.method(), self.step, of.system.along(self))?;
        Ok(())
    }

    fn summary_keys(&self) -> Vec<Declared> {
        summary::summary_keys(self)
    }

    fn run(&self, of: &SlidingSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        let (pair, points) = (&of.system.pair, of.case.points.as_slice());
        let marched = Marched { name: of.name, march: self, pair, points, motion: of.system.along(self) };
        run::run(&marched, task.own, task.progress)
    }

    fn blame(&self, error: &ModelError) -> Option<Refusal> {
        blame::off_track(error, "to", None)
    }

    /// A march holds the samples between two checkpoints; bursts, sound and report look at all of them when it is over.
    fn estimate(&self, of: &SlidingSubject<'_>) -> Result<Estimate, ModelError> {
        let motion = of.system.along(self);
        let step = cost::step(of.system, self.method(), self.step, motion);
        let steps = motion.duration() / step;
        let seconds = steps * of.system.pair.modes() as f64 * cost::STEP_AND_MODE + FIGURE;
        Ok(Estimate { name: of.name.to_owned(), points: steps as usize, seconds, seconds_at_most: None })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
