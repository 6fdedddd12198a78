//! `growth`: the growth of a mode in a march that is started in it, against its eigenvalue.

mod run;

use super::AssemblySubject;
use super::linear_size::of_modes;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::march::settings::SchemeWord;
use crate::assembly::meant_mode::mode_near;
use crate::error::ModelError;
use crate::sliding::growth::figure::growth_of;
use judder_keys::Settings;
use judder_keys::declared::{Number, Settings};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_report::Panel;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use judder_study::pictures::StoredArrays;
use run::ToldMarchGrowth;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// A march that is started in a mode, against the eigenvalue.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = AssemblyGrowth::check)]
pub struct AssemblyGrowth {
    /// Frequency near which the mode lies that is meant.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω")]
    pub frequency: f64,
    /// How the motion is integrated.
    #[key(default = SchemeWord::Moreau)]
    pub method: SchemeWord,
    /// The time step.
    #[key(rule = Number::positive(Dimension::TIME), symbol = "h")]
    pub step: f64,
}

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "growth",
    doc: "the growth of one mode in a march that is started in it, against its eigenvalue",
    declared: AssemblyGrowth::declarations,
    read: |_, section| Ok(Arc::new(AssemblyGrowth::read_table(section)?)),
    picture: Some(Picture {
        draw: growth,
        caption: "A march from steady sliding disturbed by one mode: how much of the mode the motion has, by its left vector, and how the eigenvalue says that it grows, from \
        the same start. Nothing is fitted to the line; the march's own rate is measured over the shaded interval.",
    }),
};

fn growth(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let method = dataset.attributes().get("method").and_then(Json::as_str).unwrap_or_default();
    growth_of(dataset, "Amplitude of the mode, of its start (1)", 1.0, method.to_owned())
}

impl AssemblyGrowth {
    /// A contact of springs and dampers is at rest elsewhere than in steady sliding.
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if self.method != SchemeWord::Smoothed {
            return Ok(());
        }
        let reason = "a smoothed contact is at rest elsewhere than in steady sliding, about which modes grow: give \"moreau\" or \"film\"";
        Err(AssemblyProblem::Refused { reason: reason.to_owned() }.at(section.place_of(&["method"])))
    }
}

impl Analysis<AssemblyCase> for AssemblyGrowth {
    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        Ok(of.touches().and_then(|()| of.slides()))
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(NeededMemory { keys: &[], ..of_modes(of, None) })
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, task.progress)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldMarchGrowth::declared()
    }

    fn estimate(&self, _: &AssemblySubject<'_>) -> Result<String, ModelError> {
        Ok(format!("a march in the {}", mode_near(self.frequency)))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
