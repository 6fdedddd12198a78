//! `fit`: the three functions of the oscillator paper through a computed law.

mod run;

use super::check::ContactEstimate;
use super::law::figure;
use super::{ContactSubject, Exciting};
use crate::computed_law::KnownPoints;
use crate::contact::case::ContactCase;
use crate::contact::settings::{ContactScope, FitReading, FitSettings, LawSettings};
use crate::error::ModelError;
use judder_contact::law::sweep::SolvedLawPoint;
use judder_keys::declared::{Settings, both};
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use run::ToldFit;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<Option<ContactScope>, Arc<dyn Exciting>> = Kind {
    name: "fit",
    doc: "the three functions of the oscillator paper, fitted to a computed law",
    declared: FitSettings::declarations,
    read: |scope, section| {
        let settings = both(LawSettings::of("fit", scope.as_ref(), section), FitReading::read_table(section));
        settings.map(|(law, reading)| Arc::new(FitSettings { law, reading }) as Arc<dyn Exciting>)
    },
    picture: Some(Picture {
        draw: figure::fit,
        caption: "Computed values (points) and the fitted functions (34), (36), (38) (curves); right, their difference over the largest value at \
        each indentation.",
    }),
};

/// The law that the functions are fitted to is refused, takes and excites what it does alone.
impl Analysis<ContactCase> for FitSettings {
    fn steps(&self) -> usize {
        self.law.steps()
    }

    fn fits(&self, of: &ContactSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        self.law.fits(of)
    }

    fn memory(&self, of: &ContactSubject<'_>) -> Result<NeededMemory, ModelError> {
        self.law.memory(of)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldFit::declared()
    }

    fn run(&self, of: &ContactSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        let known: Vec<SolvedLawPoint> = task.own.known();
        let keep = |point: &SolvedLawPoint| task.own.add(point);
        run::run(
            of.case,
            &self.law,
            self.reading.velocity_scale,
            KnownPoints { known: &known, kept: &keep },
            task.progress,
        )
    }

    fn estimate(&self, of: &ContactSubject<'_>) -> Result<ContactEstimate, ModelError> {
        self.law.estimate(of)
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.law.write_table(json);
        self.reading.write_table(json);
    }
}

impl Exciting for FitSettings {
    fn excited(&self, of: &ContactSubject<'_>) -> Result<Vec<f64>, ModelError> {
        self.law.excited(of)
    }
}
