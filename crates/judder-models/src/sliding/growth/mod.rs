//! `growth`: the growth of a mode in a march with the contact held, against the eigenvalue there.

pub(crate) mod figure;
mod history;
mod run;
pub mod settings;

use super::pair_size::with_pair;
use super::system::step;
use super::{SlidingSubject, blame, cost};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost::FIGURE};
use crate::sliding::case::SlidingCase;
use crate::sliding::march::settings::MarchWord;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use run::ToldGrowth;
use serde_json::{Map, Value as Json, json};
use settings::GrowthAnalysis;
use std::f64::consts::TAU;
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<Option<SlidingCase>, Arc<dyn Analysis<SlidingCase>>> = Kind {
    name: "growth",
    doc: "the growth of one mode in a march with the contact held, against the eigenvalue there",
    declared: GrowthAnalysis::declarations,
    read: |_, section| Ok(Arc::new(GrowthAnalysis::read_table(section)?)),
    picture: Some(Picture {
        draw: figure::growth,
        caption: "The contact held, the pair started in one mode of 10^{−5} of the normal force: the largest deviation of the normal force in each period, and \
        how the eigenvalue says that it grows, from the same start. Nothing is fitted to the line; the shaded interval is where the march's own rate is \
        measured.",
    }),
};

impl Analysis<SlidingCase> for GrowthAnalysis {
    fn admit(&self, of: &SlidingSubject<'_>) -> Result<(), ModelError> {
        let (pair, motion) = (&of.system.pair, of.system.motion.held(self.position));
        pair.edge_point(self.position)?;
        step(pair, self.method(), self.step, motion)?;
        Ok(())
    }

    fn run(&self, of: &SlidingSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.system, self, task.progress)
    }

    fn blame(&self, error: &ModelError) -> Option<Refusal> {
        blame::off_track(error, "position", Some(self.position))
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldGrowth::declared()
    }

    fn memory(&self, of: &SlidingSubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(with_pair(NeededMemory::LITTLE, of.system))
    }

    fn estimate(&self, of: &SlidingSubject<'_>) -> Result<Estimate, ModelError> {
        let step = cost::step(of.system, self.method(), self.step, of.system.motion.held(self.position));
        let steps = cost::PERIODS * TAU / self.frequency / step;
        let seconds = steps * of.system.pair.modes() as f64 * cost::STEP_AND_MODE + FIGURE;
        Ok(Estimate { name: of.name.to_owned(), points: steps as usize, seconds, seconds_at_most: None })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
        // what a march by this method has besides
        if self.word == MarchWord::Subs {
            json.insert("slope".to_owned(), json!("none"));
        }
    }
}
