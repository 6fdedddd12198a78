//! `reduction`: the reduced structure against the full one.

mod figure;
mod files;
mod run;
pub(super) mod tables;

use super::undamped::Undamped;
use super::{StructureSubject, solved_size};
use crate::error::ModelError;
use crate::structure::case::StructureCase;
use crate::structure::case::scope::StructureScope;
use crate::structure::modes::MODES_LIMIT;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Settings, Whole, both};
use judder_store::{Declared, Results};
use judder_structure::modes::WantedModes;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use run::ToldReduction;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The reduced structure against the full one.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct ReductionAnalysis {
    /// How many frequencies are compared.
    #[key(rule = Whole { from: 1, to: MODES_LIMIT }, default = COMPARED)]
    pub count: usize,
}

/// The number of frequencies that `reduction` compares where the case does not say.
pub const COMPARED: usize = 12;

/// The kind.
pub(crate) const KIND: Kind<StructureScope, Arc<dyn Analysis<StructureCase>>> = Kind {
    name: "reduction",
    doc: "frequencies of the reduced structure against those of the full one, and the limit that the reduction tells of itself",
    declared: ReductionAnalysis::declarations,
    read: |scope, section| {
        if !scope.has_reduction {
            let (key, section_name) = ("reduction".to_owned(), "the case".to_owned());
            let expected = "[reduction] with kept = [{ set = \"…\" }]".to_owned();
            return Err(Cause::MissingKey { key, section: section_name, expected }.at(section.place));
        }
        let ((), own) = both(scope.check_factors(section), ReductionAnalysis::read_table(section))?;
        Ok(Arc::new(own))
    },
    picture: Some(Picture {
        draw: figure::reduction,
        caption: "How far the frequencies of the reduced structure lie above those of the full one, and what the reduction alone says that this is at most. Below \
        its limit it says that every frequency is within 10^{−4}, the dotted level.",
    }),
};

impl Analysis<StructureCase> for ReductionAnalysis {
    fn admit(&self, of: &StructureSubject<'_>) -> Result<(), ModelError> {
        Undamped::admit(of.case, of.structure, WantedModes::Lowest(self.count))
    }

    fn run(&self, of: &StructureSubject<'_>, _: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.structure, of.name, self.count)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldReduction::declared()
    }

    fn memory(&self, of: &StructureSubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(solved_size::reduced(of.structure))
    }

    fn estimate(&self, _: &StructureSubject<'_>) -> Result<String, ModelError> {
        Ok(format!("{} frequencies, reduced against full", self.count))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
