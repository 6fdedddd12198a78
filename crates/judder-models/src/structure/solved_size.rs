//! What solving one structure needs of memory.

use super::build::Structure;
use judder_structure::assembly::Sparse;
use judder_structure::factor::likely_entries;
use judder_study::model::{MemoryBound, NeededMemory};

/// Bytes an entry of the stiffness: stiffness and mass, those of the shift, and what is left of making them.
const ENTRY_BYTES: f64 = 135.0;
/// The same of a term of the damping, with where its entries lie among those of all terms; and of their sum.
const TERM_BYTES: f64 = 24.0;
/// Bytes a number of the factors: themselves, what waits to be added to blocks while they are made, and the blocks of the factors that count.
const FACTOR_BYTES: f64 = 22.0;

/// Of whatever factors stiffness and mass, without what is found.
///
/// Measured of twelve modes of plates of linear and quadratic quadrilaterals, long and short, and of a bar, a slab and cubes of both kinds of bricks, of 23 000 to 45 000
/// freedoms, whose factors hold 2 to 11 numbers an entry of the stiffness, with Rayleigh damping, and of a plate without.
pub(crate) fn undamped(structure: &Structure, what: &str) -> NeededMemory {
    let freedoms = structure.family.size();
    let terms = structure.family.damping().len();
    let of_damping = if terms == 0 { 0.0 } else { TERM_BYTES * (terms + 1) as f64 };
    let of_entry = ENTRY_BYTES + of_damping;
    let bytes = fullest(structure)
        .map_or(0.0, |matrix| of_entry * matrix.val().len() as f64 + FACTOR_BYTES * likely_entries(matrix));
    NeededMemory {
        beside: bytes as u128,
        bound: MemoryBound::AtLeast,
        what: format!("{what} of {freedoms} freedoms").into(),
        keys: &["count"],
        advice: "mesh coarser",
    }
}

/// The same of complex modes and of receptances: measured of modes of bars of bricks with 1800 and 19 900 freedoms 620 and 480 bytes an entry of the stiffness.
pub(super) fn damped(structure: &Structure, what: &str) -> NeededMemory {
    NeededMemory { keys: &[], ..scaled(undamped(structure, what), 2.1) }
}

/// The same of a reduction: measured of these bars 230 and 305.
pub(super) fn reduced(structure: &Structure) -> NeededMemory {
    scaled(undamped(structure, "a reduction"), 1.4)
}

fn scaled(needed: NeededMemory, times: f64) -> NeededMemory {
    NeededMemory { beside: (needed.beside as f64 * times) as u128, ..needed }
}

/// The matrix with most entries.
fn fullest(structure: &Structure) -> Option<&Sparse> {
    let terms = structure.family.stiffness().iter().chain(structure.family.mass());
    terms.map(|term| &term.matrix).max_by_key(|matrix| matrix.val().len())
}
