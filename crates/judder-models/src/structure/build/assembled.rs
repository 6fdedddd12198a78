//! Elements with materials and supports, assembled.

use super::{Elements, Structure, StructureLayout, Unbuilt};
use crate::structure::case::body::{BodySettings, PlaneSection};
use crate::structure::case::damping::Damping;
use crate::structure::case::problem::StructureProblem;
use judder_structure::StructureError;
use judder_structure::affine::{AffineFamily, Factors, Term};
use judder_structure::assembly::{Assembled, assemble};
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use std::collections::BTreeMap;

/// The width of a body of the plane where the case gives none, m.
const WIDTH: f64 = 1.0;

/// Elements with what they are made of and what holds them.
pub(super) fn assembled(
    mesh: Mesh,
    materials: BTreeMap<String, (Elastic, ElementSection)>,
    supports: &Supports,
    damping: &Damping,
) -> Result<Structure, Unbuilt> {
    let dimension = dimension_of(&mesh);
    let numbering = Numbering::new(&mesh, dimension, supports)
        .map_err(|error| Unbuilt::because("structure.supports", &error))?;
    let Assembled { stiffness, mass } =
        assemble(&mesh, &materials, &numbering).map_err(|error| Unbuilt::because("structure", &error))?;
    let term = |name: &str, matrix: &_| Term { name: name.to_owned(), matrix: Clone::clone(matrix) };
    let refused = |error: StructureError| Unbuilt::because("structure", &error);
    let damping = match damping {
        Damping::Ratios { .. } | Damping::Ratio { .. } => {
            let modal = damping.modal().map_err(refused)?;
            let matrix = modal.map(|own| own.matrix(&stiffness, &mass)).transpose().map_err(refused)?;
            matrix.iter().map(|matrix| term("damping of modes", matrix)).collect()
        }
        Damping::Rayleigh(_) => {
            vec![term("mass-proportional damping", &mass), term("stiffness-proportional damping", &stiffness)]
        }
        Damping::Structural(_) => vec![term("structural damping", &stiffness)],
        Damping::None => Vec::new(),
    };
    let family = AffineFamily::new(vec![term("mass", &mass)], damping, vec![term("stiffness", &stiffness)])
        .map_err(|error| Unbuilt::because("structure", &error))?;
    let layout = StructureLayout::of_mesh(&mesh, &numbering);
    let elements = Some(Elements { mesh, materials, numbering });
    Ok(Structure { family, layout: Some(layout), elements, kept: Vec::new(), warnings: Vec::new() })
}

/// The factors of the terms of a body: α and β, or η/ω_r; one of a matrix that has its ratios in it.
pub(super) fn factors(damping: &Damping) -> Factors {
    let damping = match damping {
        Damping::Rayleigh(own) => vec![own.alpha, own.beta],
        Damping::Structural(own) => vec![own.loss_factor / own.reference_frequency],
        Damping::Ratios { .. } | Damping::Ratio { .. } => vec![1.0],
        Damping::None => Vec::new(),
    };
    Factors { mass: vec![1.0], damping, stiffness: vec![1.0] }
}

/// 3 where an element is of space.
pub(super) fn dimension_of(mesh: &Mesh) -> usize {
    mesh.blocks.iter().map(|block| block.kind.dimension()).max().unwrap_or(2)
}

/// How the elements of a body are meant.
pub(super) fn section(body: &BodySettings, dimension: usize) -> ElementSection {
    let thickness = body.width.unwrap_or(WIDTH);
    match (dimension, body.section) {
        (3, _) => ElementSection::Solid,
        (_, Some(PlaneSection::PlaneStrain)) => ElementSection::PlaneStrain { thickness },
        (_, Some(PlaneSection::PlaneStress) | None) => ElementSection::PlaneStress { thickness },
    }
}

/// Adds the supports that a case names by sets.
pub(super) fn add_supports(body: &BodySettings, mesh: &Mesh, supports: &mut Supports) -> Result<(), Unbuilt> {
    for (index, support) in body.supports.iter().enumerate() {
        let nodes = nodes_of(&mesh.node_sets, &support.set, &format!("structure.supports.{index}.set"))?;
        hold(nodes, support.fixed, support.tied, supports);
    }
    Ok(())
}

/// The nodes of a set that the case names at `path`.
pub(super) fn nodes_of<'a>(
    sets: &'a BTreeMap<String, Vec<usize>>,
    set: &str,
    path: &str,
) -> Result<&'a [usize], Unbuilt> {
    sets.get(set).map(Vec::as_slice).ok_or_else(|| {
        let known = sets.keys().cloned().collect();
        Unbuilt::new(path, StructureProblem::UnknownSet { name: set.to_owned(), known })
    })
}

/// Fixes and ties nodes along the axes.
pub(super) fn hold(nodes: &[usize], fixed: [bool; 3], tied: [bool; 3], supports: &mut Supports) {
    for (axis, direction) in Direction::ALL.into_iter().enumerate() {
        if fixed[axis] {
            supports.fixed.extend(nodes.iter().map(|node| (*node, direction)));
        }
        if tied[axis] {
            supports.tied.push((nodes.to_vec(), direction));
        }
    }
}
