//! How large a body is.

use crate::structure::build::Structure;
use crate::structure::case::StructureSource;
use crate::structure::case::body::BodyGeometry;
use judder_structure::mesh::Mesh;
use judder_study::text::short;

/// The width of a body of the plane across it; one of a body of space, and of matrices.
pub(super) fn width(structure: &Structure) -> f64 {
    let section = structure.elements.as_ref().and_then(|elements| elements.materials.values().next());
    section.map_or(1.0, |(_, section)| section.thickness())
}

/// A body so large or small that its mesh may be meant in another unit of length.
pub(super) fn size_warning(name: &str, source: &StructureSource, structure: &Structure) -> Option<String> {
    /// Sizes of what brakes, seals and wipers are made of, m.
    const USUAL: [f64; 2] = [1e-4, 10.0];
    let size = extent(structure.mesh()?);
    let is_usual = (USUAL[0]..=USUAL[1]).contains(&size);
    let remedy = match source {
        StructureSource::Body(body) => match body.geometry {
            BodyGeometry::Mesh(_) => "is its mesh in another unit of length? unit = \"mm\" says so",
            BodyGeometry::Beam(_) | BodyGeometry::Block(_) | BodyGeometry::Disc(_) => {
                "are its lengths meant in this unit? \"40 mm\" is 0.04 m"
            }
        },
        StructureSource::Matrices(_) => "are the places of its nodes in metres?",
    };
    (!is_usual).then(|| format!("`{name}` is {size} m long: {remedy}", size = short(size)))
}

/// The longest side of the box around a mesh, m.
pub(crate) fn extent(mesh: &Mesh) -> f64 {
    let along = |axis: usize| {
        let places = mesh.nodes.iter().map(|node| node[axis]);
        places.clone().fold(f64::NEG_INFINITY, f64::max) - places.fold(f64::INFINITY, f64::min)
    };
    (0..3).map(along).fold(0.0, f64::max)
}
