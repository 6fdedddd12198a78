//! `transient`: a contact that is followed in time.

mod asked;
mod figure;
mod run;
pub mod settings;

use super::check::ContactEstimate;
use super::memory::memory_on;
use super::{ContactSubject, Exciting, blame};
use crate::contact::case::ContactCase;
use crate::contact::problem::ContactProblem;
use crate::contact::settings::ContactScope;
use crate::contact::transient::settings::TransientSettings;
use crate::error::ModelError;
use crate::told_quantities::{ToldQuantity, quantities};
use asked::AskedTransient;
use judder_contact::transient::TransientError;
use judder_keys::declared::Settings;
use judder_report::page::PageTable;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use run::ToldHistory;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// What its table tells.
const TOLD: &[ToldQuantity] = &[
    ("duration_second", "duration", "s"),
    ("force_newton", "normal force at the end", "N"),
    ("friction_force_newton", "friction force at the end", "N"),
    ("work_per_cycle_joule", "work of the last cycle", "J"),
    ("cycle_change", "its change from the cycle before (relative)", "1"),
    ("c_y_newton_second_per_metre", "damper of the oscillating depth c_y", "N s/m"),
    ("steady_friction", "friction coefficient of steady sliding", "1"),
    ("steps", "steps", ""),
];

/// A friction force below this share of the normal force is rounding.
const ROUNDING: f64 = 1e-12;

/// The table of a contact in time.
pub(super) fn tables(results: &Map<String, Json>) -> Vec<PageTable> {
    let mut told = results.clone();
    let number = |key: &str| results.get(key).and_then(Json::as_f64);
    if let (Some(friction), Some(force)) = (number("friction_force_newton"), number("force_newton"))
        && friction.abs() < ROUNDING * force.abs()
    {
        told.insert("friction_force_newton".to_owned(), "0 within rounding".into());
    }
    quantities("The contact in time", &told, TOLD)
}

/// The kind.
pub(crate) const KIND: Kind<Option<ContactScope>, Arc<dyn Exciting>> = Kind {
    name: "transient",
    doc: "a contact that is followed in time: histories of force, friction and area, work of a cycle",
    declared: TransientSettings::declarations,
    read: |scope, section| Ok(Arc::new(TransientSettings::of(scope.as_ref(), section)?)),
    picture: Some(Picture {
        draw: figure::transient,
        caption: "Normal force, friction force and area over time; where the path repeats itself, the loop whose area is the work of a cycle.",
    }),
};

impl Analysis<ContactCase> for TransientSettings {
    fn fits(&self, of: &ContactSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        let asked = AskedTransient::new(&of.case.shape, self, of.scales);
        if let Err(refusal) = of.is_not_too_deep(asked.largest_depth())? {
            return Ok(Err(refusal));
        }
        match asked.question(&of.scales.creeping(), of.profile()?, self).needs() {
            Err(TransientError::TooManySteps { needed, allowed }) => {
                Ok(Err(Refusal::keys(&["duration"], ContactProblem::TooManySteps { needed, allowed })))
            }
            needs => {
                let (strip, needed) = needs?;
                Ok(blame::large(strip, needed, self.memory))
            }
        }
    }

    fn memory(&self, of: &ContactSubject<'_>) -> Result<NeededMemory, ModelError> {
        let asked = AskedTransient::new(&of.case.shape, self, of.scales);
        let (lattice, bytes) = asked.question(&of.scales.creeping(), of.profile()?, self).needs()?;
        Ok(memory_on(lattice, bytes))
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldHistory::declared()
    }

    fn run(&self, of: &ContactSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, self, task.progress)
    }

    fn estimate(&self, of: &ContactSubject<'_>) -> Result<ContactEstimate, ModelError> {
        let asked = AskedTransient::new(&of.case.shape, self, of.scales);
        let contacts = asked.steps(self.cells);
        let (name, lattice) = (of.name.to_owned(), [self.cells; 2]);
        Ok(ContactEstimate { name, asked: asked.words(self), contacts, lattice })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Exciting for TransientSettings {
    fn excited(&self, of: &ContactSubject<'_>) -> Result<Vec<f64>, ModelError> {
        let asked = AskedTransient::new(&of.case.shape, self, of.scales);
        Ok(asked.frequencies(of.half_length(asked.loading())?))
    }
}
