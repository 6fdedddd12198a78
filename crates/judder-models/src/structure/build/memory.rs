//! What matrices of elements take in memory, known before a mesh is made.

use super::Unbuilt;
use crate::structure::case::problem::StructureProblem;
use judder_memory::MemoryBudget;
use judder_structure::element::ElementKind;

/// Bytes of each place of the common pattern of mass and stiffness while a structure is assembled and kept: 114 to 122 measured of plates of 15 000 and
/// 242 000 freedoms and bricks of 15 000 and 106 000.
const PLACE_BYTES: f64 = 118.0;

/// Refuses cells whose matrices are beyond the memory that there is.
pub(super) fn admit_cells(path: &str, kind: ElementKind, cells: &[usize]) -> Result<(), Unbuilt> {
    admit(path, matrices_bytes(kind, cells))
}

/// Refuses elements whose matrices are.
pub(super) fn admit_elements(path: &str, kind: ElementKind, elements: usize) -> Result<(), Unbuilt> {
    admit(path, elements as f64 / elements_of_a_cell(kind) * places_of_a_cell(kind) * PLACE_BYTES)
}

fn admit(path: &str, bytes: f64) -> Result<(), Unbuilt> {
    MemoryBudget::of_process()
        .ask(bytes as u128)
        .map_err(|source| Unbuilt::new(path, StructureProblem::Memory { source }))
}

/// Bytes that mass and stiffness of a box of cells take.
fn matrices_bytes(kind: ElementKind, cells: &[usize]) -> f64 {
    let within = &cells[..cells.len().min(kind.dimension())];
    // a row of c cells has c + 1 corners with two neighbours or one: 3 c + 1 pairs in place of 3 c
    let shares = within.iter().map(|count| *count as f64 + 1.0 / 3.0);
    shares.product::<f64>() * places_of_a_cell(kind) * PLACE_BYTES
}

/// How many elements make a cell.
fn elements_of_a_cell(kind: ElementKind) -> f64 {
    match kind {
        ElementKind::Quad4 | ElementKind::Quad8 | ElementKind::Hexahedron8 | ElementKind::Hexahedron20 => 1.0,
        ElementKind::Triangle6 => 2.0,
        ElementKind::Tetrahedron10 => 6.0,
    }
}

/// Places of the pattern a cell of a large grid: for each of its nodes the nodes that share an element with it, times the directions of both.
fn places_of_a_cell(kind: ElementKind) -> f64 {
    let nodes = match kind {
        ElementKind::Quad4 => 9.0,
        // a corner has 21 nodes around, each of two middles 13
        ElementKind::Quad8 => 21.0 + 2.0 * 13.0,
        // each of three middles 9
        ElementKind::Triangle6 => 19.0 + 3.0 * 9.0,
        ElementKind::Hexahedron8 => 27.0,
        // each of three middles 51
        ElementKind::Hexahedron20 => 81.0 + 3.0 * 51.0,
        // middles of edges 27, of diagonals of faces 19, of the body 27
        ElementKind::Tetrahedron10 => 65.0 + 3.0 * 27.0 + 3.0 * 19.0 + 27.0,
    };
    nodes * (kind.dimension() * kind.dimension()) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_structure::assembly::assemble;
    use judder_structure::freedom::{Numbering, Supports};
    use judder_structure::grid::Grid;
    use judder_structure::material::{Elastic, ElementSection};

    /// The pattern of a free body against the one that is assembled.
    #[test]
    fn places_are_those_that_are_assembled() {
        for kind in [
            ElementKind::Quad4,
            ElementKind::Quad8,
            ElementKind::Triangle6,
            ElementKind::Hexahedron8,
            ElementKind::Hexahedron20,
            ElementKind::Tetrahedron10,
        ] {
            let cells = if kind.dimension() == 2 { [30, 20, 1] } else { [8, 6, 5] };
            let mesh = Grid { kind, size: [3.0, 2.0, 1.0], cells }.mesh("steel", |place| place).unwrap();
            let dimension = kind.dimension();
            let section = if dimension == 2 {
                ElementSection::PlaneStress { thickness: 1.0 }
            } else {
                ElementSection::Solid
            };
            let steel = (String::from("steel"), (Elastic::new(1.0, 0.3, 1.0).unwrap(), section));
            let numbering = Numbering::new(&mesh, dimension, &Supports::default()).unwrap();
            let found = assemble(&mesh, &[steel].into(), &numbering).unwrap().mass.val().len() as f64;
            let told = matrices_bytes(kind, &cells) / PLACE_BYTES;
            assert!((told / found - 1.0).abs() < 0.1, "{kind}: {told} places, {found} are assembled");
        }
    }

    #[test]
    fn cells_that_no_memory_has_are_refused_with_the_number() {
        let refused =
            admit_cells("structure.block.cells", ElementKind::Hexahedron8, &[100_000; 3]).unwrap_err();
        assert_eq!(refused.path, "structure.block.cells");
        assert!(refused.problem.to_string().contains("28.7 EB"), "{}", refused.problem);
        admit_cells("structure.block.cells", ElementKind::Hexahedron8, &[10; 3]).unwrap();
        admit_elements("structure.mesh", ElementKind::Tetrahedron10, usize::MAX).unwrap_err();
    }
}
