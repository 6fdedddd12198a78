//! The bodies that a case describes: their meshes, and what holds them.

use super::assembled::{add_supports, assembled, dimension_of, hold, section};
use super::memory::admit_cells;
use super::{Structure, Unbuilt};
use crate::structure::case::body::{BeamSettings, Block, BodyGeometry, BodySettings, EndCondition};
use crate::structure::case::damping::Damping;
use crate::structure::case::disc::DiscSettings;
use judder_structure::beam;
use judder_structure::element::ElementKind;
use judder_structure::freedom::Supports;
use judder_structure::grid::Grid;
use judder_structure::mesh::Mesh;

/// The material of a generated body.
const OWN: &str = "structure.material";
/// Assembles a body with its damping.
pub(super) fn structure(body: &BodySettings, damping: &Damping) -> Result<Structure, Unbuilt> {
    let (mesh, mut supports) = match &body.geometry {
        BodyGeometry::Beam(beam) => beam_mesh(beam)?,
        BodyGeometry::Block(block) => (block_mesh(block)?, Supports::default()),
        BodyGeometry::Disc(disc) => (disc_mesh(disc)?, Supports::default()),
        BodyGeometry::Mesh(file) => return super::mesh_file::structure(body, file, damping),
    };
    add_supports(body, &mesh, &mut supports)?;
    let material = body.material;
    let dimension = dimension_of(&mesh);
    let section = section(body, dimension);
    let materials = material.map(|material| (OWN.to_owned(), (material, section))).into_iter().collect();
    assembled(mesh, materials, &supports, damping)
}

/// The mesh of a beam and what holds its ends.
fn beam_mesh(beam: &BeamSettings) -> Result<(Mesh, Supports), Unbuilt> {
    let BeamSettings { length, thickness, elements, origin, angle, start, end } = *beam;
    admit_cells("structure.beam.elements", ElementKind::Quad8, &elements)?;
    let mesh = beam::Beam { length, thickness, elements, origin, angle }
        .mesh(OWN)
        .map_err(|error| Unbuilt::because("structure.beam", &error))?;
    let mut supports = Supports::default();
    for (set, condition) in [("start", start), ("end", end)] {
        let nodes = mesh.node_sets.get(set).cloned().unwrap_or_default();
        let (fixed, tied) = match condition {
            EndCondition::Free => ([false; 3], [false; 3]),
            EndCondition::Clamped => ([true, true, false], [false; 3]),
            EndCondition::Guided => ([true, false, false], [false, true, false]),
        };
        hold(&nodes, fixed, tied, &mut supports);
    }
    Ok((mesh, supports))
}

fn block_mesh(block: &Block) -> Result<Mesh, Unbuilt> {
    let size = std::array::from_fn(|axis| block.size.get(axis).copied().unwrap_or(0.0));
    let cells = std::array::from_fn(|axis| block.cells.get(axis).copied().unwrap_or(0));
    let origin = block.origin.as_deref().unwrap_or_default();
    let moved = |axis: usize, along: f64| origin.get(axis).map_or(along, |from| from + along);
    let turned = |place| block.orientation.as_ref().map_or(place, |own| own.turned(place));
    let grid = Grid { kind: block.element(), size, cells };
    admit_cells("structure.block.cells", grid.kind, &cells)?;
    let place = |place| {
        let turned = turned(place);
        std::array::from_fn(|axis| moved(axis, turned[axis]))
    };
    let mesh = match &block.chamfer {
        Some(chamfer) => grid.chamfered_mesh(&chamfer.chamfered(), OWN, place),
        None => grid.mesh(OWN, place),
    };
    mesh.map_err(|error| Unbuilt::because("structure.block", &error))
}

fn disc_mesh(disc: &DiscSettings) -> Result<Mesh, Unbuilt> {
    let origin = disc.origin.as_deref().unwrap_or_default();
    let moved = |axis: usize, along: f64| origin.get(axis).map_or(along, |from| from + along);
    let ring = disc.ring();
    let cells = [ring.radii.len().saturating_sub(1), ring.angles.len(), ring.layers];
    admit_cells("structure.disc.cells", ring.kind, &cells)?;
    ring.mesh(OWN, |place| std::array::from_fn(|axis| moved(axis, place[axis])))
        .map_err(|error| Unbuilt::because("structure.disc", &error))
}
