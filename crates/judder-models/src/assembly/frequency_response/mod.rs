//! `frequency-response`: periodic motions under forces that swing, over their frequency and through its folds.
//!
//! - [`settings`]: the keys. `run`: the response, and what is to be said of it. `followed`: an observed coordinate along it.
//! - `told`, `arrays`: what is told and stored. `figure`, `tables`: how it is shown.

mod arrays;
mod figure;
mod followed;
mod run;
pub mod settings;
pub(super) mod tables;
mod told;

use super::AssemblySubject;
use crate::assembly::case::AssemblyCase;
use crate::assembly::limit_cycle::stability::multipliers_estimated;
use crate::assembly::periodic::PeriodicSize;
use crate::error::ModelError;
use judder_cycles::receptance::MOST_FREEDOMS;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use judder_study::text::short;
use serde_json::{Map, Value as Json};
use settings::FrequencyResponse;
use std::f64::consts::TAU;
use std::sync::Arc;
use told::ToldResponse;

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "frequency-response",
    doc: "periodic motions through stick, slip and lift-off under forces that swing, over their frequency and through its folds",
    declared: FrequencyResponse::declarations,
    read: |case, section| Ok(Arc::new(FrequencyResponse::of(case.as_ref(), section)?)),
    picture: Some(Picture {
        draw: figure::frequency_response,
        caption: "Observed points under forces that swing, over the frequency: the amplitude of the first harmonic, the root mean square with the mean, the largest value. The \
        line joins periodic motions in their order along the branch, back and forth between its folds; where stability is asked for stable motions are solid, unstable ones dashed, those of unknown stability pale, and marked is how that changes.",
    }),
};

impl Analysis<AssemblyCase> for FrequencyResponse {
    fn most_freedoms(&self) -> Option<usize> {
        Some(MOST_FREEDOMS)
    }

    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        self.admitted(of)
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        let size = PeriodicSize {
            harmonics: Some(self.harmonics),
            samples: self.samples,
            stability: self.stability,
            folds: false,
        };
        size.memory(of)
    }

    fn admit(&self, of: &AssemblySubject<'_>) -> Result<(), ModelError> {
        of.admit_steady()
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldResponse::declared()
    }

    fn estimate(&self, of: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let points: usize = of.built.nodes.iter().map(Vec::len).sum();
        let [from, to] = self.frequency.map(|own| short(own / TAU));
        let multipliers = match multipliers_estimated(of, self.stability, Some(run::ROWS)) {
            words if words.is_empty() => words,
            words => format!("{words} for each of up to {} motions", self.points),
        };
        Ok(format!(
            "motions from {from} to {to} Hz, {} harmonics of {points} contact points{multipliers}",
            self.harmonics
        ))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
