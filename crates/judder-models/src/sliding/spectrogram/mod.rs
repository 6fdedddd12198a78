//! `spectrogram`: a signal of a march over time and frequency, from what the march has stored.

mod run;
pub mod settings;

use super::SlidingSubject;
use super::march::MarchSize;
use super::pair_size::with_pair;
use crate::error::ModelError;
use crate::estimate::{Estimate, cost::FIGURE};
use crate::sliding::case::SlidingCase;
use crate::sliding::case::problem::SlidingProblem;
use crate::sliding::march::settings::MarchAnalysis;
use crate::spectrogram::figure;
use crate::spectrogram::levels::ToldSpectrogram;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use settings::SpectrogramAnalysis;
use std::sync::Arc;

const SHORTER: &str = "give a shorter length, or none";
const LONGER: &str = "give a longer length, or none";

/// The kind.
pub(crate) const KIND: Kind<Option<SlidingCase>, Arc<dyn Analysis<SlidingCase>>> = Kind {
    name: "spectrogram",
    doc: "a signal of a march over time, position and frequency, with the unstable zones of a locus",
    declared: SpectrogramAnalysis::declarations,
    read: |case, section| {
        let own = SpectrogramAnalysis::read_table(section)?;
        Ok(Arc::new(match case {
            Some(case) => own.admit(case, section)?,
            None => own,
        }))
    },
    picture: Some(Picture {
        draw: figure::spectrogram,
        caption: "First, the highest level in each cell of the drawing, with the unstable zones of a locus as frames from start to end. Then the highest level in \
        each of successive stretches: every spectrum stands on its position and hides what is behind it; bars are the zones. Frequencies \
        beyond one and a half times the highest of a zone are stored, not drawn.",
    }),
};

/// The march whose signal it shows.
fn march<'a>(asked: &SpectrogramAnalysis, case: &'a SlidingCase) -> Option<&'a MarchAnalysis> {
    case.analyses.iter().find(|own| own.name == asked.levels.of)?.settings()
}

impl Analysis<SlidingCase> for SpectrogramAnalysis {
    fn fits(&self, of: &SlidingSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        let Some(march) = march(self, of.case) else { return Ok(Ok(())) };
        let (pieces, name) = (&self.levels.pieces, &self.levels.of);
        let (length, duration) = (pieces.length, of.system.along(march).duration());
        let refused =
            |reason, advice| Ok(Err(Refusal::key("length", SlidingProblem::Unbuilt { reason, advice })));
        if length > duration {
            let reason = format!("a window is {length} s long, but the march `{name}` takes {duration:.6} s");
            return refused(reason, SHORTER);
        }
        let stored = MarchSize::of(of.system, march).map(|size| size.samples / duration);
        match stored.and_then(|rate| pieces.too_short(name, rate)) {
            Some(reason) => refused(reason, LONGER),
            None => Ok(Ok(())),
        }
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldSpectrogram::declared()
    }

    fn run(&self, of: &SlidingSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        let outcome = run::run(of.name, self, &of.case.points, task.own.place)?;
        task.progress.advance();
        Ok(outcome)
    }

    fn memory(&self, of: &SlidingSubject<'_>) -> Result<NeededMemory, ModelError> {
        let read = march(self, of.case).and_then(|march| MarchSize::of(of.system, march));
        let known = |size: MarchSize| self.levels.memory(size.samples, size.stored());
        Ok(with_pair(read.map_or(NeededMemory::LITTLE, known), of.system))
    }

    fn estimate(&self, of: &SlidingSubject<'_>) -> Result<Estimate, ModelError> {
        Ok(Estimate { name: of.name.to_owned(), points: 1, seconds: 1.0 + FIGURE, seconds_at_most: None })
    }

    fn takes_up(&self) -> Vec<&str> {
        [Some(self.levels.of.as_str()), self.locus.as_deref()].into_iter().flatten().collect()
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
