//! A block of quadrilaterals that is pushed on a moving plane.

use crate::common::assembly;
use judder_assembly::assembly::Assembly;
use judder_assembly::interface::InterfaceLaw;
use judder_assembly::row::Row;
use judder_assembly::search::{KeptOfFaces, Sliding, TouchingBody, Track, contact_points};
use judder_structure::assembly::{assemble, displacement_load};
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};

const WIDTH: f64 = 0.01;

/// 40 × 20 mm in 8 × 4 cells, nine nodes on the plane; its top is held along x and pressed.
pub(crate) fn block(law: InterfaceLaw, speed: f64, damping: [f64; 2]) -> Assembly {
    made(law, speed, damping, false, [8, 4])
}

/// The same with its top held and pushed down by 20 µm.
pub(crate) fn block_held(law: InterfaceLaw, speed: f64, damping: [f64; 2]) -> Assembly {
    made(law, speed, damping, true, [8, 4])
}

/// The same in other cells.
#[allow(dead_code, reason = "benchmarks of other crates take it")]
pub(crate) fn block_of_cells(
    law: InterfaceLaw,
    speed: f64,
    damping: [f64; 2],
    cells: [usize; 2],
) -> Assembly {
    made(law, speed, damping, true, cells)
}

fn made(
    law: InterfaceLaw,
    speed: f64,
    damping: [f64; 2],
    is_held: bool,
    [along, up]: [usize; 2],
) -> Assembly {
    let grid = Grid { kind: ElementKind::Quad4, size: [0.04, 0.02, 0.0], cells: [along, up, 0] };
    let mesh = grid.mesh("block", |place| place).unwrap();
    let top = mesh.node_sets["y-max"].clone();
    let supports = Supports {
        fixed: top
            .iter()
            .flat_map(|node| [(*node, Direction::X), (*node, Direction::Y)])
            .filter(|(_, direction)| is_held || *direction == Direction::X)
            .collect(),
        ..Supports::default()
    };
    let numbering = Numbering::new(&mesh, 2, &supports).unwrap();
    let material = Elastic::new(2e9, 0.35, 1200.0).unwrap();
    let section = ElementSection::PlaneStrain { thickness: WIDTH };
    let materials = [("block".to_owned(), (material, section))].into();
    let assembled = assemble(&mesh, &materials, &numbering).unwrap();
    let mut load = vec![0.0; numbering.freedoms().len()];
    if is_held {
        let imposed = top.iter().map(|node| ((*node, Direction::Y), -20e-6)).collect();
        load = displacement_load(&mesh, &materials, &numbering, &imposed).unwrap();
    } else {
        for node in &top {
            load[numbering.number(*node, Direction::Y).unwrap()] = -1e3 / top.len() as f64;
        }
    }
    let slider = TouchingBody {
        mesh: &mesh,
        width: WIDTH,
        displacement: &|node, direction| {
            numbering.number(node, direction).map_or_else(Row::default, Row::of_freedom)
        },
        displaced: &|_| [0.0; 3],
        kept: KeptOfFaces::default(),
    };
    let found = contact_points(
        &slider,
        &mesh.node_sets["y-min"],
        &Track::Plane([0.0, 1.0, 0.0]),
        Sliding::Translation([speed, 0.0, 0.0]),
        1e-3,
    )
    .unwrap();
    assert_eq!(found.points.len(), along + 1);
    let entries = |matrix: &judder_structure::assembly::Sparse, factor: f64| {
        judder_assembly::assembly::triplets(matrix)
            .map(move |mut entry| {
                entry.val *= factor;
                entry
            })
            .collect::<Vec<_>>()
    };
    let all = [entries(&assembled.mass, damping[0]), entries(&assembled.stiffness, damping[1])].concat();
    let damping = judder_assembly::assembly::from_triplets(load.len(), load.len(), &all).unwrap();
    assembly([assembled.mass, damping, assembled.stiffness], load, found.points, law)
}
