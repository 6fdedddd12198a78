//! What a contact takes in memory, all grids that lead to it and what is kept of it counted.

use judder_contact::kernel::sliding::SlidingOperator;
use judder_keys::memory::Memory;
use judder_study::model::NeededMemory;

/// A contact takes so much where its operator takes [`OPERATOR`]: measured of spheres on 512 × 512 and 1024 × 1024 cells, whose coarser grids, fields
/// and figures are counted.
const WHOLE: u64 = 23;
const OPERATOR: u64 = 10;

/// Bytes of a contact on so many columns and rows.
pub(super) fn contact_bytes([columns, rows]: [usize; 2]) -> u64 {
    bytes_with_operator(SlidingOperator::memory_bytes(columns, rows))
}

/// Bytes of a contact whose operator takes these.
pub(super) fn bytes_with_operator(operator: u64) -> u64 {
    operator.saturating_mul(WHOLE) / OPERATOR
}

/// What is left for the operator of a contact that may take so much.
pub(super) fn operator_limit(limit: Memory) -> u64 {
    limit.bytes / WHOLE * OPERATOR
}

/// What a contact on so many columns and rows needs, given or likely.
pub(super) fn memory_of_contact(lattice: [usize; 2]) -> NeededMemory {
    memory_on(lattice, contact_bytes(lattice))
}

/// The same where the bytes are known.
pub(super) fn memory_on([columns, rows]: [usize; 2], bytes: u64) -> NeededMemory {
    NeededMemory {
        beside: u128::from(bytes),
        what: format!("a contact on {columns} × {rows} cells").into(),
        keys: &["cells", "accuracy"],
        advice: "take fewer `cells`, or ask for less `accuracy`",
        ..NeededMemory::LITTLE
    }
}
