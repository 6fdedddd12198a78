//! Mesh files of other programs, with the materials and supports of the case.

use super::assembled::{add_supports, assembled, section};
use super::memory::admit_elements;
use super::{Structure, Unbuilt};
use crate::structure::case::body::BodySettings;
use crate::structure::case::damping::Damping;
use crate::structure::case::problem::StructureProblem;
use judder_exchange::mesh_file::{FileSection, MeshFile, Units, read_mesh};
use judder_keys::file_reference::FileReference;
use judder_structure::freedom::Supports;
use judder_structure::material::{Elastic, ElementSection};
use judder_study::text::short;
use std::collections::BTreeMap;

/// The longest side, in m, of a mesh without a unit of whose metres nothing is said.
const LONGEST_UNREMARKED: f64 = 10.0;

/// Reads a mesh and assembles it.
pub(super) fn structure(
    body: &BodySettings,
    file: &FileReference,
    damping: &Damping,
) -> Result<Structure, Unbuilt> {
    let mut read = read_mesh(&file.path).map_err(|error| {
        Unbuilt::new("structure.mesh", StructureProblem::File { reason: error.to_string() })
    })?;
    if let Some(unit) = body.unit {
        // lengths, newtons and seconds: of materials and sections in the file too
        let length = unit.metres();
        read = read.in_si(Units { length, mass: 1.0 / length, time: 1.0 });
    }
    let of_unit = body.unit.is_none().then(|| unit_warning(&read.mesh.nodes)).flatten();
    name_nodes(&mut read);
    refuse_strangers(body, &read)?;
    for block in &read.mesh.blocks {
        admit_elements("structure.mesh", block.kind, block.connectivity.len() / block.kind.nodes())?;
    }
    let materials = materials(body, &read)?;
    let mut supports = Supports::default();
    add_supports(body, &read.mesh, &mut supports)?;
    let mut structure = assembled(read.mesh, materials, &supports, damping)?;
    if let Some(layout) = &mut structure.layout {
        layout.names = read.node_labels;
    }
    let of_file = read.warnings.iter().map(ToString::to_string);
    let told = |warning| format!("{}: {warning}", file.given);
    structure.warnings.extend(of_unit.into_iter().chain(of_file).map(told));
    Ok(structure)
}

/// That places without a unit are read as metres, where they are then farther apart than in most structures that vibrate by friction.
fn unit_warning(nodes: &[[f64; 3]]) -> Option<String> {
    let sides = (0..3).map(|axis| {
        let along = || nodes.iter().filter_map(|node| node.get(axis));
        along().copied().fold(f64::NEG_INFINITY, f64::max) - along().copied().fold(f64::INFINITY, f64::min)
    });
    let longest = sides.fold(0.0, f64::max);
    (longest > LONGEST_UNREMARKED).then(|| {
        format!(
            "its lengths are read as metres, as no `unit` is given, and it is {} m long; `unit = \"mm\"` reads them as millimetres, `unit = \"m\"` says that it is so",
            short(longest)
        )
    })
}

/// Lets sets of sides and elements be named where nodes are wanted.
fn name_nodes(read: &mut MeshFile) {
    let names: Vec<String> =
        read.mesh.side_sets.keys().chain(read.mesh.element_sets.keys()).cloned().collect();
    for name in names {
        if let Some(nodes) = read.nodes_of(&name) {
            read.mesh.node_sets.entry(name).or_insert(nodes);
        }
    }
}

/// Refuses materials of the case under names that the mesh does not have.
fn refuse_strangers(body: &BodySettings, read: &MeshFile) -> Result<(), Unbuilt> {
    let of_file = read.sections.values().filter_map(|section| section.material.clone());
    let mut known: Vec<String> =
        read.mesh.blocks.iter().map(|block| block.material.clone()).chain(of_file).collect();
    known.sort_unstable();
    known.dedup();
    match body.materials.0.iter().find(|(name, _)| !known.contains(name)) {
        None => Ok(()),
        Some((name, _)) => {
            let problem = StructureProblem::UnknownGroup { name: name.clone(), known };
            Err(Unbuilt::new(format!("structure.materials.{name}"), problem))
        }
    }
}

/// Material and section of each block: what the case says under the name of the block or of its material, what the file says of it, the
/// material of the whole case.
fn materials(
    body: &BodySettings,
    read: &MeshFile,
) -> Result<BTreeMap<String, (Elastic, ElementSection)>, Unbuilt> {
    let mut materials = BTreeMap::new();
    for block in &read.mesh.blocks {
        let name = &block.material;
        let own = read.sections.get(name);
        let of_file = own.and_then(|section| section.material.as_ref());
        let named = body.materials.0.iter().find(|(given, _)| given == name || Some(given) == of_file);
        let elastic = match named {
            Some((_, material)) => *material,
            None => match (told(read, of_file)?, &body.material) {
                (Some(elastic), _) => elastic,
                (None, Some(material)) => *material,
                (None, None) => {
                    let problem = StructureProblem::NoMaterial { name: name.clone() };
                    return Err(Unbuilt::new("structure", problem));
                }
            },
        };
        materials.insert(name.clone(), (elastic, section_of(body, own, block.kind.dimension())));
    }
    Ok(materials)
}

/// What the file says of a material, where it says all.
fn told(read: &MeshFile, name: Option<&String>) -> Result<Option<Elastic>, Unbuilt> {
    let Some(material) = name.and_then(|name| read.materials.get(name)) else { return Ok(None) };
    let (Some([youngs_modulus, poisson_ratio]), Some(density)) = (material.elastic, material.density) else {
        return Ok(None);
    };
    Elastic::new(youngs_modulus, poisson_ratio, density)
        .map(Some)
        .map_err(|error| Unbuilt::because("structure.mesh", &error))
}

/// The section that the case gives, else that of the file.
fn section_of(body: &BodySettings, own: Option<&FileSection>, dimension: usize) -> ElementSection {
    match own {
        Some(own) if body.section.is_none() && body.width.is_none() => own.section,
        _ => section(body, dimension),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_of_millimetres_without_a_unit_is_remarked_on() {
        let of = |length: f64| unit_warning(&[[-0.1 * length, 0.0, 0.0], [0.9 * length, 0.02 * length, 0.0]]);
        let told = of(120.0).unwrap();
        assert!(told.contains("read as metres") && told.contains("it is 120 m long"), "{told}");
        assert_eq!((of(0.12), of(10.0), unit_warning(&[])), (None, None, None));
    }
}
