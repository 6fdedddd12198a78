//! `modes`: undamped modes of one of the structures, as it is held, without contact.

use super::pair_size::with_pair;
use super::system::alone;
use super::{SlidingSubject, cost};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost::FIGURE};
use crate::sliding::case::SlidingCase;
use crate::sliding::case::plain_name::find_structure;
use crate::structure::modes::{self, ModesAnalysis, PICTURE, ToldModes};
use judder_keys::Settings;
use judder_keys::declared::{Named, Settings};
use judder_store::{Declared, Results};
use judder_study::case::analysis::Kind;
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// Undamped modes of one of the structures.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct PartModes {
    /// The name of a structure.
    #[key(later)]
    pub structure: Named<usize>,
    /// Which.
    #[key(flatten)]
    pub modes: ModesAnalysis,
}

/// The kind.
pub(crate) const KIND: Kind<Option<SlidingCase>, Arc<dyn Analysis<SlidingCase>>> = Kind {
    name: "modes",
    doc: "undamped modes of one of the two structures, as it is held, without contact",
    declared: PartModes::declarations,
    read: |case, section| {
        let mut own = PartModes::read_table(section)?;
        if let Some(case) = case {
            find_structure(&mut own.structure, case.structures.iter().map(|own| &own.name), section)?;
        }
        Ok(Arc::new(own))
    },
    picture: Some(PICTURE),
};

impl Analysis<SlidingCase> for PartModes {
    fn run(&self, of: &SlidingSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        let part = &of.system.parts[*self.structure];
        let own = alone(of.case, *self.structure);
        let reduced = Some(&part.reduced.body.eigenvalues[..]);
        let outcome = modes::run(&own, &part.structure, of.name, self.modes, reduced)?;
        task.progress.advance();
        Ok(outcome)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldModes::declared()
    }

    fn memory(&self, of: &SlidingSubject<'_>) -> Result<NeededMemory, ModelError> {
        let modes = self.modes.memory_of(&of.system.parts[*self.structure].structure);
        let pair = with_pair(NeededMemory::LITTLE, of.system).beside;
        // the pair is made, and let go of but for its matrices, before there are modes
        Ok(NeededMemory { beside: modes.beside.max(pair), ..modes })
    }

    fn estimate(&self, of: &SlidingSubject<'_>) -> Result<Estimate, ModelError> {
        let seconds = cost::FREEDOM * cost::freedoms(of.system, *self.structure) + FIGURE;
        Ok(Estimate { name: of.name.to_owned(), points: 1, seconds, seconds_at_most: None })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
