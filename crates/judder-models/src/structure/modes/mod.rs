//! `modes`: undamped modes.

pub(super) mod figure;
mod run;
pub(crate) mod tables;

pub(crate) use run::{ToldModes, run};

use super::StructureSubject;
use crate::error::ModelError;
use crate::estimate::PROCESS_BYTES;
use crate::structure::build::Structure;
use crate::structure::case::StructureCase;
use crate::structure::case::problem::StructureProblem;
use crate::structure::case::scope::StructureScope;
use judder_keys::Settings;
use judder_keys::declared::{Number, NumberPair, Settings, Whole, both};
use judder_keys::dimension::Dimension;
use judder_keys::memory::Memory;
use judder_memory::MemoryBudget;
use judder_numerics::elementary::{exp, ln};
use judder_store::{Declared, Results};
use judder_structure::mesh::Mesh;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, Refusal, Task};
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
    /// Bytes that it takes, factor and shapes included; of a band those of no mode, as how many it has is not known.
    ///
    /// Measured of three modes, an entry of the stiffness, the matrices themselves included: plates of 15 000 to 242 000 freedoms 221 to 237 bytes; bricks of
    /// 15 000 to 73 000, whose factor fills as the cube root of their number, 262 to 358. Of 40 modes in place of 3: 94 bytes a freedom and mode.
    fn bytes(self, structure: &Structure) -> u128 {
        let freedoms = structure.family.size();
        let of_entry = match structure.mesh().is_some_and(extends_in_space) {
            true => 212.0 + 80.0 * exp(ln(freedoms.max(1) as f64 / 14_700.0) / 3.0),
            false => 228.0,
        };
        let terms = structure.family.stiffness().iter().chain(structure.family.mass());
        let entries = terms.map(|term| term.matrix.val().len()).max().unwrap_or(0);
        let count = match self {
            Self::Count(count) => count.min(freedoms),
            Self::Band(_) => 0,
        };
        PROCESS_BYTES + (entries as f64 * of_entry) as u128 + freedoms as u128 * count as u128 * 94
    }
}

fn extends_in_space(mesh: &Mesh) -> bool {
    mesh.blocks.iter().any(|block| block.kind.dimension() == 3)
}

impl Analysis<StructureCase> for ModesAnalysis {
    fn run(&self, of: &StructureSubject<'_>, _: Task<'_>) -> Result<Outcome, ModelError> {
        run(of.case, of.structure, of.name, *self, None)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        ToldModes::declared()
    }

    fn fits(&self, of: &StructureSubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        let beyond = |source| Refusal::keys(&["count"], StructureProblem::Memory { source });
        Ok(MemoryBudget::of_process().ask(self.bytes(of.structure)).map_err(beyond))
    }

    fn estimate(&self, of: &StructureSubject<'_>) -> Result<String, ModelError> {
        let memory = Memory { bytes: self.bytes(of.structure) as u64 };
        Ok(match self {
            ModesAnalysis::Count(count) => format!("the lowest {count} modes, about {memory} of memory"),
            ModesAnalysis::Band([from, to]) => {
                let [from, to] = [from, to].map(|angular| short(angular / TAU));
                format!("the modes from {from} to {to} Hz, {memory} of memory or more")
            }
        })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
