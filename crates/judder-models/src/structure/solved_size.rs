//! What solving one structure needs of memory.

use super::build::Structure;
use judder_numerics::elementary::{exp, ln};
use judder_structure::element::ElementKind;
use judder_structure::mesh::Mesh;
use judder_study::model::{MemoryBound, NeededMemory};

/// Of whatever factors stiffness and mass, without what is found.
///
/// Measured of three modes and of twelve, bytes an entry of the stiffness, the matrices themselves included: plates of 15 000 to 242 000 freedoms 221 to 237; bricks of
/// twenty nodes with 1800, 19 900 and 100 800 freedoms 231, 218 and 248; bricks of eight nodes with 15 000 to 73 000, whose factor fills as the cube root of their
/// number, 262 to 358.
pub(crate) fn undamped(structure: &Structure, what: &str) -> NeededMemory {
    let freedoms = structure.family.size();
    let of_entry = match structure.mesh().is_some_and(is_of_linear_bricks) {
        true => 212.0 + 80.0 * exp(ln(freedoms.max(1) as f64 / 14_700.0) / 3.0),
        false => 232.0,
    };
    NeededMemory {
        beside: (entries(structure) * of_entry) as u128,
        bound: MemoryBound::AtLeast,
        what: format!("{what} of {freedoms} freedoms").into(),
        keys: &["count"],
        advice: "mesh coarser",
    }
}

/// The same of complex modes and of receptances, over what a real factor of the same matrices takes: measured of modes of bars of bricks with 1800 and 19 900
/// freedoms 2.7 and 2.2.
pub(super) fn damped(structure: &Structure, what: &str) -> NeededMemory {
    NeededMemory { keys: &[], ..scaled(undamped(structure, what), 2.45) }
}

/// The same of a reduction: measured of these bars 1.0 and 1.4.
pub(super) fn reduced(structure: &Structure) -> NeededMemory {
    scaled(undamped(structure, "a reduction"), 1.35)
}

fn scaled(needed: NeededMemory, times: f64) -> NeededMemory {
    NeededMemory { beside: (needed.beside as f64 * times) as u128, ..needed }
}

/// Those of the fullest matrix.
fn entries(structure: &Structure) -> f64 {
    let terms = structure.family.stiffness().iter().chain(structure.family.mass());
    terms.map(|term| term.matrix.val().len()).max().unwrap_or(0) as f64
}

fn is_of_linear_bricks(mesh: &Mesh) -> bool {
    mesh.blocks.iter().any(|block| block.kind == ElementKind::Hexahedron8)
}
