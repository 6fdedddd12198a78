//! `fit`: the three functions of the oscillator paper through a computed law.

mod run;

use super::check::ContactEstimate;
use super::law::figure;
use super::{Exciting, Subject};
use crate::case::analysis::{Kind, Picture};
use crate::error::StudyError;
use crate::model::{Analysis, Refusal, Task};
use crate::models::contact::case::ContactCase;
use crate::models::contact::settings::{ContactScope, FitReading, FitSettings, LawSettings};
use crate::outcome::Outcome;
use judder_contact::law::sweep::SolvedPoint;
use judder_keys::declared::{Settings, both};
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<ContactScope, Arc<dyn Exciting>> = Kind {
    name: "fit",
    doc: "the three functions of the oscillator paper, fitted to a computed law",
    declared: FitSettings::declarations,
    read: |scope, section| {
        let settings = both(LawSettings::of("fit", scope, section), FitReading::read_table(section));
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

    fn fits(&self, of: &Subject<'_>) -> Result<Result<(), Refusal>, StudyError> {
        self.law.fits(of)
    }

    fn run(&self, of: &Subject<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        let known: Vec<SolvedPoint> = task.own.known();
        let keep = |point: &SolvedPoint| task.own.add(point);
        run::run(of.case, (&self.law, self.reading.velocity_scale), (&known, &keep), task.progress)
    }

    fn estimate(&self, of: &Subject<'_>) -> Result<ContactEstimate, StudyError> {
        self.law.estimate(of)
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.law.write_table(json);
        self.reading.write_table(json);
    }
}

impl Exciting for FitSettings {
    fn excited(&self, of: &Subject<'_>) -> Result<Vec<f64>, StudyError> {
        self.law.excited(of)
    }
}
