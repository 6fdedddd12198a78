//! What a contact takes in memory, all grids that lead to it and what is kept of it counted.

use judder_contact::kernel::sliding::SlidingOperator;
use judder_keys::memory::Memory;
use judder_memory::MemoryBudget;
use judder_numerics::parallel;
use judder_study::model::{NeededMemory, PROGRAM_BYTES, Refusal};

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
    operator_within(limit.bytes)
}

fn operator_within(bytes: u64) -> u64 {
    bytes / WHOLE * OPERATOR
}

/// The same of each of so many that are solved at once: no more than what the process may take has for it.
pub(crate) fn operator_at_once(limit: u64, at_once: usize) -> u64 {
    limit.min(operator_within(left_of_process() / parts(at_once)))
}

/// How many contacts on so many columns and rows are solved at once: one a thread, or as many as the process may take.
pub(crate) fn contacts_at_once(lattice: [usize; 2]) -> usize {
    let fit = left_of_process() / contact_bytes(lattice).max(1);
    parallel::threads().min(usize::try_from(fit).unwrap_or(usize::MAX)).max(1)
}

/// What the process may take beside the program.
fn left_of_process() -> u64 {
    MemoryBudget::of_whole_process().most().saturating_sub(PROGRAM_BYTES as u64)
}

/// Into how many parts that is divided for so many contacts: those that share the process share its threads, too.
fn parts(at_once: usize) -> u64 {
    (at_once as u64).div_ceil(MemoryBudget::of_whole_process().shared_by()).max(1)
}

/// The refusal of a grid for which the process may not take enough: `allowed` was left.
pub(super) fn beyond_process(lattice: [usize; 2], needed: u64, allowed: u64) -> Option<Refusal> {
    let left = MemoryBudget::of_whole_process().of_which(allowed.saturating_add(PROGRAM_BYTES as u64));
    memory_on(lattice, needed).held_against(left).err()
}

/// What a contact on so many columns and rows needs, given or likely.
pub(super) fn memory_of_contact(lattice: [usize; 2]) -> NeededMemory {
    memory_on(lattice, contact_bytes(lattice))
}

/// The same of a law, which is of many: those that are solved at once.
pub(super) fn memory_of_contacts(lattice: [usize; 2]) -> NeededMemory {
    let at_once = contacts_at_once(lattice);
    let one = memory_of_contact(lattice);
    let beside = one.beside.saturating_mul(at_once as u128);
    let what = if at_once > 1 { format!("{at_once} times {}", one.what).into() } else { one.what };
    NeededMemory { beside, what, ..one }
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
