//! `modes`: undamped modes.

pub(super) mod figure;
mod run;
pub(crate) mod tables;

pub(crate) use run::{ToldModes, run};

use super::undamped::Undamped;
use super::{StructureSubject, solved_size};
use crate::error::ModelError;
use crate::structure::build::Structure;
use crate::structure::case::StructureCase;
use crate::structure::case::scope::StructureScope;
use judder_keys::Settings;
use judder_keys::declared::{Number, NumberPair, Settings, Whole, both};
use judder_keys::dimension::Dimension;
use judder_store::{Declared, Results};
use judder_structure::modes::WantedModes;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, MemoryBound, NeededMemory, Task};
use judder_study::outcome::Outcome;
use judder_study::text::short;
use serde_json::{Map, Value as Json};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Which undamped modes are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum ModesAnalysis {
    /// So many modes, from the lowest on, where no band is given.
    #[key(rule = Whole { from: 1, to: MODES_LIMIT }, default = MODES)]
    Count(usize),
    /// All modes between two frequencies, in place of count.
    #[key(rule = BAND, symbol = "ω")]
    Band([f64; 2]),
}

/// Two frequencies.
pub(super) const BAND: NumberPair = NumberPair {
    of: Number::non_negative(Dimension::ANGULAR_FREQUENCY),
    what: "two frequencies, from and to",
    is_ascending: true,
};

/// The number of modes where the case does not say.
pub const MODES: usize = 20;

/// The most modes of an analysis.
pub const MODES_LIMIT: usize = 2000;

/// The kind.
pub(crate) const KIND: Kind<StructureScope, Arc<dyn Analysis<StructureCase>>> = Kind {
    name: "modes",
    doc: "undamped modes: frequencies, shapes, residuals, and a count that shows whether one is missing",
    declared: ModesAnalysis::declarations,
    read: |scope, section| {
        let ((), own) = both(scope.check_factors(section), ModesAnalysis::read_table(section))?;
        Ok(Arc::new(own))
    },
    picture: Some(PICTURE),
};

/// The figure, of either model that has such modes.
pub(crate) const PICTURE: Picture = Picture {
    draw: figure::modes,
    caption: "Shapes over the body at rest (grey), displacements enlarged alike; on the page they swing. Last, how alike any two shapes are: the \
    modal assurance criterion, $|φ_{i}^{T}φ_{j}|^{2}$ over both lengths squared.",
};

impl ModesAnalysis {
    fn wanted(self) -> WantedModes {
        match self {
            Self::Count(count) => WantedModes::Lowest(count),
            Self::Band([from, to]) => WantedModes::Band(from / TAU, to / TAU),
        }
    }

    /// What it needs of one structure.
    pub(crate) fn memory_of(self, structure: &Structure) -> NeededMemory {
        let of_factor = solved_size::undamped(structure, "undamped modes");
        let of_factor = NeededMemory { beside: of_factor.beside + FIGURE_BYTES, ..of_factor };
        let Self::Count(count) = self else { return of_factor };
        let freedoms = structure.family.size();
        let shapes = SHAPE_BYTES * freedoms as u128 * count.min(freedoms) as u128;
        let advice = "ask for fewer modes, or mesh coarser";
        NeededMemory { bound: MemoryBound::About, beside: of_factor.beside + shapes, advice, ..of_factor }
    }
}

/// Bytes of the panels of their shapes: measured of 12 modes of 1800 freedoms.
const FIGURE_BYTES: u128 = 30_000_000;
/// Bytes a freedom and mode: measured of 40 in place of 3.
const SHAPE_BYTES: u128 = 94;

impl Analysis<StructureCase> for ModesAnalysis {
    fn admit(&self, of: &StructureSubject<'_>) -> Result<(), ModelError> {
        Undamped::admit(of.case, of.structure, self.wanted())
    }

    fn run(&self, of: &StructureSubject<'_>, _: Task<'_>) -> Result<Outcome, ModelError> {
        run(of.case, of.structure, of.name, *self, None)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldModes::declared()
    }

    fn memory(&self, of: &StructureSubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(self.memory_of(of.structure))
    }

    fn estimate(&self, _: &StructureSubject<'_>) -> Result<String, ModelError> {
        Ok(match self {
            ModesAnalysis::Count(count) => format!("the lowest {count} modes"),
            ModesAnalysis::Band([from, to]) => {
                let [from, to] = [from, to].map(|angular| short(angular / TAU));
                format!("the modes from {from} to {to} Hz")
            }
        })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
