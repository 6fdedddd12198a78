//! What two structures and their pair take of memory, whatever is asked of them.

use super::system::ReducedPair;
use crate::structure::solved_size::undamped;
use judder_study::model::NeededMemory;

/// Bytes beside the program: measured of pairs of 2800 and 9800 freedoms 457 an entry of both stiffnesses, twice those of one factor, and 20 MB.
const OF_ANY: u128 = 20_000_000;
const FACTORS: u128 = 2;

/// What an analysis needs beside the pair, and the pair.
pub(super) fn with_pair(needed: NeededMemory, system: &ReducedPair) -> NeededMemory {
    let of_structures: u128 = system.parts.iter().map(|part| undamped(&part.structure, "").beside).sum();
    let what = format!("{}, and the pair", needed.what).into();
    NeededMemory { beside: needed.beside.saturating_add(OF_ANY + FACTORS * of_structures), what, ..needed }
}
