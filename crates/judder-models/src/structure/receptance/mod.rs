//! `receptance`: the displacement of one point by a unit force at another, over frequency.

mod figure;
mod run;
pub mod settings;

use super::{StructureSubject, solved_size};
use crate::error::ModelError;
use crate::structure::case::StructureCase;
use crate::structure::case::scope::StructureScope;
use crate::told_quantities::ToldQuantity;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use judder_study::text::short;
use run::{ToldReceptance, freedom};
use serde_json::{Map, Value as Json};
use settings::ReceptanceAnalysis;
use std::f64::consts::TAU;
use std::sync::Arc;

/// What its table tells.
pub(crate) const TOLD: &[ToldQuantity] = &[
    ("peak_frequency_hz", "frequency of the largest receptance", "Hz"),
    ("peak_m_per_n", "the largest receptance", "m/N"),
    ("points", "frequencies", ""),
];

/// The kind.
pub(crate) const KIND: Kind<StructureScope, Arc<dyn Analysis<StructureCase>>> = Kind {
    name: "receptance",
    doc: "the displacement of one point by a unit force at another, over frequency",
    declared: ReceptanceAnalysis::declarations,
    read: |scope, section| Ok(Arc::new(ReceptanceAnalysis::read(scope, section)?)),
    picture: Some(Picture {
        draw: figure::receptance,
        caption: "The displacement of the observed point by a unit force at the excited one: magnitude and phase of $α(ω) = \
            e_{o}^{T}(K + iωC − ω^{2}M)^{−1}e_{e}$. A phase of −180° is a motion against the force.",
    }),
};

impl Analysis<StructureCase> for ReceptanceAnalysis {
    fn fits(&self, of: &StructureSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        let named = |key, place| {
            freedom(key, place, of.structure).map(drop).map_err(|cause| Refusal::key(key, cause))
        };
        Ok(named("excited", &self.excited).and_then(|()| named("observed", &self.observed)))
    }

    fn steps(&self) -> usize {
        run::steps(self.points)
    }

    fn run(&self, of: &StructureSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.structure, of.name, self, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldReceptance::declared()
    }

    fn memory(&self, of: &StructureSubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(solved_size::receptances(of.structure))
    }

    fn estimate(&self, _: &StructureSubject<'_>) -> Result<String, ModelError> {
        let [from, to] = self.band.map(|end| short(end / TAU));
        Ok(format!("the receptance at {} frequencies from {from} to {to} Hz", self.points))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
