//! The contact interfaces of a case: points found, laws as the physics has them.

use super::size::width;
use super::{BuiltBody, Unassembled};
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::{ContactInterface, NormalLaw, SlidingMotion, SurfaceOf, TrackSettings};
use crate::assembly::case::problem::AssemblyProblem;
use crate::structure::build::{Structure, points_of};
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::search::{FoundPoints, Sliding, TouchingBody, Track, contact_points, usual_reach};
use judder_assembly::surface::Surface;
use judder_structure::mesh::Mesh;
use std::collections::BTreeMap;

/// The nodes of one side of a contact.
struct Side {
    structure: usize,
    points: Vec<usize>,
}

/// The nodes of a contact: of the slider, and of the track where that is a body.
struct Sides {
    slider: Side,
    track: Option<Side>,
}

/// The nodes of all contacts.
pub(super) struct Touching {
    contacts: Vec<Sides>,
}

impl Touching {
    /// All nodes of a body that are in some contact.
    pub(super) fn of_body(&self, index: usize) -> Vec<usize> {
        let sides =
            self.contacts.iter().flat_map(|sides| [Some(&sides.slider), sides.track.as_ref()]).flatten();
        sides.filter(|side| side.structure == index).flat_map(|side| side.points.iter().copied()).collect()
    }
}

/// Finds the nodes of all contacts, which must not share any.
pub(super) fn touching(case: &AssemblyCase, structures: &[Structure]) -> Result<Touching, Unassembled> {
    let mut taken: BTreeMap<(usize, usize), &ContactInterface> = BTreeMap::new();
    let mut contacts = Vec::new();
    for contact in &case.contacts {
        let mut side = |surface: &SurfaceOf, key: &str| -> Result<Side, Unassembled> {
            let (structure, path) = (*surface.structure, format!("contact.{}.{key}", contact.name));
            let points = points_of(&surface.nodes, &structures[structure], &path)?;
            for point in &points {
                if let Some(other) = taken.insert((structure, *point), contact) {
                    let problem = AssemblyProblem::SharedNode {
                        first: other.name.to_string(),
                        second: contact.name.to_string(),
                        structure: surface.structure.name.clone(),
                        node: *point,
                    };
                    return Err(Unassembled::new(path, problem));
                }
            }
            Ok(Side { structure, points })
        };
        let slider = side(&contact.slider, "slider")?;
        let track = match &contact.track {
            TrackSettings::Plane(_) => None,
            TrackSettings::Surface(surface) => Some(side(surface, "track")?),
        };
        contacts.push(Sides { slider, track });
    }
    Ok(Touching { contacts })
}

/// The interfaces with their points, and the slider's node of each point.
pub(super) fn interfaces(
    case: &AssemblyCase,
    bodies: &[BuiltBody],
    touching: &Touching,
    warnings: &mut Vec<String>,
) -> Result<(Vec<Interface>, Vec<Vec<usize>>), Unassembled> {
    let (mut made, mut nodes) = (Vec::new(), Vec::new());
    for (contact, sides) in case.contacts.iter().zip(&touching.contacts) {
        let found = found(contact, bodies, sides)?;
        let (alone, all) = (found.without_partner.len(), sides.slider.points.len());
        if alone > 0 {
            warnings.push(format!(
                "{alone} of {all} nodes of the slider of `{}` have no partner on the track: they carry no contact",
                contact.name,
            ));
        }
        if let (SlidingMotion::Rotation(_), Some(_)) = (&contact.sliding, &sides.track) {
            warnings.push(format!(
                "the track of `{}` turns: gyroscopic, convective and centrifugal terms of its body are left out",
                contact.name,
            ));
        }
        made.push(Interface {
            name: contact.name.to_string(),
            points: found.points,
            law: law(contact),
            all_closed: contact.all_closed,
        });
        nodes.push(found.nodes);
    }
    Ok((made, nodes))
}

/// The contact points of a contact.
fn found(
    contact: &ContactInterface,
    bodies: &[BuiltBody],
    sides: &Sides,
) -> Result<FoundPoints, Unassembled> {
    let path = |key: &str| format!("contact.{}.{key}", contact.name);
    let meshes: Vec<Mesh> = bodies.iter().map(|body| mesh_of(&body.structure)).collect();
    let freedoms: Vec<_> =
        bodies.iter().map(|body| |node, direction| body.coordinate(node, direction)).collect();
    let displaced: Vec<_> = bodies.iter().map(|body| |node| body.displaced(node)).collect();
    let body = |index: usize| TouchingBody {
        mesh: &meshes[index],
        width: width(&bodies[index].structure),
        freedom: &freedoms[index],
        displaced: &displaced[index],
    };
    let reach = |side: &Side| {
        let mesh = &meshes[side.structure];
        Surface::of_nodes(mesh, &side.points).map_or(0.0, |surface| usual_reach(mesh, &surface))
    };
    let slider = &sides.slider;
    let (track, reach) = match (&contact.track, &sides.track) {
        (_, Some(track)) => {
            (Track::Body(body(track.structure), &track.points), reach(slider).max(reach(track)))
        }
        (TrackSettings::Plane(plane), None) => (Track::Plane(in_space(&plane.normal)), 0.0),
        (TrackSettings::Surface(_), None) => (Track::Plane([0.0; 3]), 0.0),
    };
    let motion = sliding(&contact.sliding);
    let found = contact_points(&body(slider.structure), &slider.points, &track, motion, reach)
        .map_err(|error| Unassembled::because(path("slider"), &error))?;
    match (&contact.track, found.points.is_empty()) {
        (TrackSettings::Surface(track), true) => {
            let (slider, track) = (contact.slider.words(), track.words());
            Err(Unassembled::new(path("track"), AssemblyProblem::Apart { slider, track, reach }))
        }
        _ => Ok(found),
    }
}

/// The mesh of a body; of matrices its places alone.
fn mesh_of(structure: &Structure) -> Mesh {
    match (structure.mesh(), &structure.layout) {
        (Some(mesh), _) => mesh.clone(),
        (None, Some(layout)) => Mesh { nodes: layout.points.clone(), ..Mesh::default() },
        (None, None) => Mesh::default(),
    }
}

/// A vector of two or three numbers in space.
fn in_space(vector: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| vector.get(k).copied().unwrap_or(0.0))
}

/// A vector of this length and direction.
fn directed(size: f64, direction: &[f64]) -> [f64; 3] {
    let length = direction.iter().map(|part| part * part).sum::<f64>().sqrt();
    in_space(direction).map(|part| size * part / length)
}

fn sliding(own: &SlidingMotion) -> Sliding {
    match own {
        SlidingMotion::Translation(own) => Sliding::Translation(directed(own.velocity, &own.direction)),
        SlidingMotion::Rotation(own) => Sliding::Rotation {
            angular_velocity: directed(own.speed, &own.axis),
            centre: in_space(&own.centre),
        },
    }
}

fn law(contact: &ContactInterface) -> InterfaceLaw {
    let friction = contact.friction.clone();
    match &contact.normal {
        NormalLaw::Rigid => InterfaceLaw::Rigid(friction),
        NormalLaw::Compliant(pressure) => InterfaceLaw::Compliant(pressure.clone(), friction),
    }
}
