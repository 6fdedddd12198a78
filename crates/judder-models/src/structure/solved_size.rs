//! What solving one structure needs of memory.

use super::build::Structure;
use judder_memory::{HeldMemory, MemoryBudget};
use judder_structure::assembly::Sparse;
use judder_structure::complex_modes::{ComplexModeSettings, likely_bytes_of_shift};
use judder_structure::factor::likely_entries;
use judder_study::model::{MemoryBound, NeededMemory, PROGRAM_BYTES};

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
    let of_factors = fullest(structure).map_or(0.0, |matrix| FACTOR_BYTES * likely_entries(matrix));
    NeededMemory { beside: (bytes_of_matrices(structure) + of_factors) as u128, ..needed(structure, what) }
}

/// Of stiffness and mass, and of damping where there is any.
fn bytes_of_matrices(structure: &Structure) -> f64 {
    let terms = structure.family.damping().len();
    let of_damping = if terms == 0 { 0.0 } else { TERM_BYTES * (terms + 1) as f64 };
    fullest(structure).map_or(0.0, |matrix| (ENTRY_BYTES + of_damping) * matrix.val().len() as f64)
}

/// Nothing yet, of some work on a structure.
fn needed(structure: &Structure, what: &str) -> NeededMemory {
    NeededMemory {
        beside: 0,
        bound: MemoryBound::AtLeast,
        what: format!("{what} of {} freedoms", structure.family.size()).into(),
        keys: &["count"],
        advice: "mesh coarser",
    }
}

/// Discs that a search of complex modes begins with; it asks again before it factors more.
const DISCS: f64 = 2.0;
/// Vectors of a disc at least, from either side, with their velocities.
const VECTORS: f64 = 64.0;

/// Of complex modes: of plates of 10 000 and 40 000 freedoms and a cube of 12 000, whose regions two discs cover, 0.9 to 1 of what one thread takes is told.
pub(super) fn complex_modes(structure: &Structure) -> NeededMemory {
    let vectors = 2.0 * VECTORS * 16.0 * structure.family.size() as f64;
    damped(structure, "complex modes", DISCS, vectors)
}

/// Of receptances: each thread holds the factors of a frequency, one at least.
pub(super) fn receptances(structure: &Structure) -> NeededMemory {
    damped(structure, "receptances", 1.0, 0.0)
}

/// Of so many factors of λ²M + λC + K at a time, each with vectors of so many bytes.
fn damped(structure: &Structure, what: &str, factors: f64, vectors: f64) -> NeededMemory {
    let of_matrices = bytes_of_matrices(structure);
    let of_factor = fullest(structure).map_or(0.0, likely_bytes_of_shift);
    let bytes = of_matrices + factors * (of_factor + vectors);
    NeededMemory { beside: bytes as u128, keys: &[], ..needed(structure, what) }
}

/// What searches of complex modes may take together, beside the program and matrices with so many entries in the stiffness.
pub(crate) fn complex_mode_settings(entries: usize) -> ComplexModeSettings {
    ComplexModeSettings { memory: beside_matrices(entries), ..ComplexModeSettings::default() }
}

/// What may be held beside the program and such matrices.
pub(super) fn beside_matrices(entries: usize) -> HeldMemory {
    HeldMemory::of(MemoryBudget::of_process_beside(PROGRAM_BYTES + (ENTRY_BYTES * entries as f64) as u128))
}

/// Entries of the stiffness or the mass of a structure, whichever has more.
pub(super) fn entries(structure: &Structure) -> usize {
    fullest(structure).map_or(0, |matrix| matrix.val().len())
}

/// The same of a reduction: measured of bars of bricks with 1800 and 19 900 freedoms 230 and 305 bytes an entry of the stiffness.
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
