//! What steady sliding and small motions about it need of memory.

use super::AssemblySubject;
use judder_numerics::parallel;
use judder_study::model::{MemoryBound, NeededMemory};

/// Bytes an entry of the stiffness.
mod entry_bytes {
    /// Of steady sliding. Measured of a plate of 26 000 and 103 000 freedoms 390 to 420, of bricks of 12 000 and 27 000 430 to 460.
    pub(super) const STEADY: f64 = 430.0;
    /// Of the factors about a shift. Measured of 12 modes of plates of 6500 and 26 000 freedoms 1840 and 1800, of a full matrix of 400 2000.
    pub(super) const MODES: f64 = 1800.0;
    /// The same of bricks of 3700 and 12 000 freedoms: 1250 and 1070.
    pub(super) const MODES_OF_BRICKS: f64 = 1130.0;
    /// Of a family of problems, and of what each thread solves, as shares of that. Measured of seven values on one thread and on two.
    pub(super) const FAMILY: f64 = 0.36;
    pub(super) const THREAD: f64 = 0.5;
}
/// Bytes a freedom and mode of a count that is asked for, where that is more. Measured of 3 to 100 modes of a plate of 6500 freedoms.
const MODE_BYTES: u128 = 600;
/// Bytes of what is known of a value of a sweep, told and drawn. Measured of 2000 values of 72 freedoms and of 200 of 820.
const VALUE_BYTES: u128 = 97_000;

/// Steady sliding.
pub(super) fn of_steady_sliding(of: &AssemblySubject<'_>) -> NeededMemory {
    needed(of, "steady sliding", (entries(of) * entry_bytes::STEADY) as u128)
}

/// So many modes about steady sliding; without a count those about one shift.
pub(super) fn of_modes(of: &AssemblySubject<'_>, count: Option<usize>) -> NeededMemory {
    let size = of.built.assembly.size();
    let shapes = size as u128 * count.unwrap_or(0).min(2 * size) as u128 * MODE_BYTES;
    let factors = (entries(of) * factor_bytes(of)) as u128;
    let bound = if count.is_some() { MemoryBound::About } else { MemoryBound::AtLeast };
    let needed = needed(of, "complex modes", factors.max(shapes));
    NeededMemory { bound, keys: &["count"], ..needed }
}

/// A motion from steady sliding: the factors that it starts from, or what it holds of itself, and its figures. Measured of marches of plates of 400 and of 6500 freedoms
/// and of bricks of 3700, and of a cycle and a response of the smaller plate.
pub(super) fn of_motion(of: &AssemblySubject<'_>, own: NeededMemory) -> NeededMemory {
    const FIGURES: u128 = 20_000_000;
    let factors = needed(of, "motions", (entries(of) * factor_bytes(of)) as u128);
    let larger = if factors.beside > own.beside { factors } else { own };
    NeededMemory { beside: larger.beside.saturating_add(FIGURES), ..larger }
}

/// Modes at so many values of a key or two.
pub(super) fn of_sweep(
    of: &AssemblySubject<'_>,
    values: usize,
    keys: &'static [&'static str],
) -> NeededMemory {
    let threads = parallel::threads().min(values) as f64;
    let each = factor_bytes(of) * (entry_bytes::FAMILY + entry_bytes::THREAD * threads);
    let what = format!("complex modes at {values} values");
    let needed = needed(of, &what, (entries(of) * each) as u128 + values as u128 * VALUE_BYTES);
    NeededMemory { keys, advice: "take fewer points, or coarser bodies", ..needed }
}

fn needed(of: &AssemblySubject<'_>, what: &str, beside: u128) -> NeededMemory {
    let what = format!("{what} of {} freedoms", of.built.assembly.size()).into();
    NeededMemory { beside, what, advice: "mesh the bodies coarser, or reduce them", ..NeededMemory::LITTLE }
}

fn entries(of: &AssemblySubject<'_>) -> f64 {
    of.built.assembly.stiffness.val().len() as f64
}

/// Bytes an entry of the factors: what extends in space has more neighbours, and fewer of them at one node.
fn factor_bytes(of: &AssemblySubject<'_>) -> f64 {
    let meshes = of.built.bodies.iter().filter_map(|body| body.structure.mesh());
    let mut blocks = meshes.flat_map(|mesh| &mesh.blocks);
    let is_in_space = blocks.any(|block| block.kind.dimension() == 3);
    if is_in_space { entry_bytes::MODES_OF_BRICKS } else { entry_bytes::MODES }
}
