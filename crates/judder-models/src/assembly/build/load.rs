//! What acts on a body.

use super::Unassembled;
use super::size::width;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::load::{Load, LoadAmount};
use crate::assembly::case::problem::AssemblyProblem;
use crate::structure::build::{Structure, points_of};
use judder_assembly::surface::Surface;
use judder_structure::assembly::displacement_load;
use judder_structure::freedom::Direction;
use std::collections::BTreeMap;

/// Held displacements that are not zero, in m.
pub(super) type Imposed = BTreeMap<(usize, Direction), f64>;

/// f of a body, in N on its freedoms, and which of its held displacements are imposed.
pub(super) fn load(
    case: &AssemblyCase,
    index: usize,
    structure: &Structure,
) -> Result<(Vec<f64>, Imposed), Unassembled> {
    let (mut load, mut imposed) = (vec![0.0; structure.family.size()], Imposed::new());
    for (number, own) in case.loads.iter().enumerate().filter(|(_, load)| *load.structure == index) {
        let path = format!("load.{number}");
        let points = points_of(&own.nodes, structure, &path)?;
        let direction = own.direction.unwrap_or(Direction::X);
        let acting = match own.amount {
            LoadAmount::Force(force) => of_force(structure, &points, direction, force).ok_or_else(|| {
                Unassembled::because(format!("{path}.force"), &moves_nothing(&own.set(), direction))
            })?,
            LoadAmount::Pressure(pressure) => of_pressure(structure, &points, pressure, &path)?,
            LoadAmount::Displacement(displacement) => {
                let moved: Imposed = points.iter().map(|point| ((*point, direction), displacement)).collect();
                if moved.keys().any(|key| imposed.contains_key(key)) {
                    let reason = "another load displaces nodes of this set in this direction";
                    return Err(Unassembled::because(format!("{path}.displacement"), &reason));
                }
                imposed.extend(&moved);
                of_displacement(structure, own, &moved, &path)?
            }
        };
        load.iter_mut().zip(acting).for_each(|(load, own)| *load += own);
    }
    Ok((load, imposed))
}

/// Why a force on nodes that are all held is none.
pub(super) fn moves_nothing(set: &str, direction: Direction) -> String {
    format!("no node of `{set}` is free along {direction}: a force there moves nothing")
}

/// A force that all nodes share alike; `None` where all are held.
pub(super) fn of_force(
    structure: &Structure,
    points: &[usize],
    direction: Direction,
    force: f64,
) -> Option<Vec<f64>> {
    let layout = structure.layout.as_ref()?;
    let free: Vec<usize> =
        points.iter().filter_map(|point| layout.freedoms[*point][direction as usize]).collect();
    let mut load = vec![0.0; structure.family.size()];
    for freedom in &free {
        load[*freedom] += force / points.len() as f64;
    }
    (!free.is_empty()).then_some(load)
}

/// A pressure on the surface between nodes, against its outward normals.
fn of_pressure(
    structure: &Structure,
    points: &[usize],
    pressure: f64,
    path: &str,
) -> Result<Vec<f64>, Unassembled> {
    let path = format!("{path}.pressure");
    let (Some(elements), Some(layout)) = (&structure.elements, &structure.layout) else {
        return Err(Unassembled::because(path, &"a body of matrices has no surface: give it forces"));
    };
    let surface = match Surface::of_nodes(&elements.mesh, points) {
        Ok(surface) if !surface.faces.is_empty() => surface,
        Ok(_) => {
            let reason = "no side of an element lies between these nodes: a pressure needs a surface";
            return Err(Unassembled::because(path, &reason));
        }
        Err(error) => return Err(Unassembled::because(path, &error)),
    };
    let mut load = vec![0.0; structure.family.size()];
    for (node, area) in surface.nodal_areas(&elements.mesh) {
        for (axis, part) in area.into_iter().enumerate() {
            if let Some(freedom) = layout.freedoms[node][axis] {
                load[freedom] -= pressure * width(structure) * part;
            }
        }
    }
    Ok(load)
}

/// What displaced supports do to the free displacements.
fn of_displacement(
    structure: &Structure,
    own: &Load,
    imposed: &Imposed,
    path: &str,
) -> Result<Vec<f64>, Unassembled> {
    let path = format!("{path}.displacement");
    let Some(elements) = &structure.elements else {
        let reason = "a body of matrices has no displacements that are held: give it forces";
        return Err(Unassembled::because(path, &reason));
    };
    let is_free =
        |(point, direction): &&(usize, Direction)| elements.numbering.number(*point, *direction).is_some();
    if let Some((_, direction)) = imposed.keys().find(is_free) {
        let (structure, set, direction) = (own.structure.name.clone(), own.set(), direction.to_string());
        return Err(Unassembled::new(path, AssemblyProblem::NotFixed { structure, set, direction }));
    }
    displacement_load(&elements.mesh, &elements.materials, &elements.numbering, imposed)
        .map_err(|error| Unassembled::because(path, &error))
}
