//! The contact interfaces of a case: points found, laws as the physics has them.

use super::body::TouchingNodes;
use super::size::width;
use super::turning::sliding_warning;
use super::{BuiltBody, Unassembled};
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::{
    ContactForceSettings, ContactInterface, PlaneSettings, SurfaceOf, TrackMotion, TrackOf, TrackSettings,
};
use crate::assembly::case::joint::SpringEnd;
use crate::assembly::case::normal_law::NormalLaw;
use crate::assembly::case::problem::{AssemblyProblem, PlacedSet};
use crate::assembly::case::rotation::BodyRotation;
use crate::structure::build::{Structure, points_of};
use judder_assembly::AssemblyError;
use judder_assembly::friction::Friction;
use judder_assembly::interface::{Interface, InterfaceLaw};
use judder_assembly::row::Row;
use judder_assembly::search::{
    FoundPoints, KeptOfFaces, Sliding, TouchingBody, Track, contact_points, least_distance, usual_reach,
};
use judder_assembly::surface::Surface;
use judder_contact::friction::FrictionError;
use judder_sliding::locus::Configuration;
use judder_structure::freedom::Direction;
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

/// The nodes of all contacts, and of what else joins bodies.
pub(super) struct Touching {
    contacts: Vec<Sides>,
    /// Structures, and nodes of springs and ties.
    joined: Vec<(usize, Vec<usize>)>,
}

impl Touching {
    /// The track's nodes of a contact, where that is a body.
    pub(super) fn track(&self, contact: usize) -> Option<&[usize]> {
        Some(&self.contacts.get(contact)?.track.as_ref()?.points)
    }

    /// All nodes of a body that are in some contact, spring or tie.
    pub(super) fn of_body(&self, index: usize) -> TouchingNodes {
        let sides =
            self.contacts.iter().flat_map(|sides| [Some(&sides.slider), sides.track.as_ref()]).flatten();
        let own = sides.filter(|side| side.structure == index);
        let joined = self.joined.iter().filter(|(structure, _)| *structure == index);
        TouchingNodes {
            in_contact: own.flat_map(|side| side.points.iter().copied()).collect(),
            joined: joined.flat_map(|(_, points)| points.iter().copied()).collect(),
        }
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
            // nodes without faces have no edge that two surfaces would share
            let with_faces = points.iter().filter(|_| structures[structure].elements.is_some());
            for point in with_faces {
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
        if matches!(contact.forces, ContactForceSettings::Asperity(_)) && slider.points.len() != 1 {
            let (contact, set) = (contact.name.to_string(), contact.slider.words());
            let path = format!("contact.{contact}.slider");
            let problem = AssemblyProblem::SeveralPoints { contact, set, nodes: slider.points.len() };
            return Err(Unassembled::new(path, problem));
        }
        let track = match &contact.track {
            TrackSettings::Plane(_) => None,
            TrackSettings::Surface(track) => Some(side(&track.surface, "track")?),
        };
        contacts.push(Sides { slider, track });
    }
    Ok(Touching { contacts, joined: joined(case, structures)? })
}

/// The nodes of all springs and ties: structure and points.
fn joined(case: &AssemblyCase, structures: &[Structure]) -> Result<Vec<(usize, Vec<usize>)>, Unassembled> {
    let of_springs = case.springs.iter().flat_map(|own| {
        let to = match &own.to {
            SpringEnd::Ground => None,
            SpringEnd::Nodes(nodes) => Some((nodes, format!("spring.{}.to", own.name))),
        };
        [Some((&own.from, format!("spring.{}.from", own.name))), to].into_iter().flatten()
    });
    let of_ties = case.ties.iter().flat_map(|own| {
        [(&own.from, format!("tie.{}.from", own.name)), (&own.to, format!("tie.{}.to", own.name))]
    });
    let points = |(nodes, path): (&SurfaceOf, String)| {
        Ok((*nodes.structure, points_of(&nodes.nodes, &structures[*nodes.structure], &path)?))
    };
    of_springs.chain(of_ties).map(points).collect()
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
        let found = found(case, contact, bodies, sides, None)?;
        let (alone, all) = (found.without_partner.len(), sides.slider.points.len());
        if alone > 0 {
            warnings.push(format!(
                "{alone} of {all} nodes of the slider of `{}` have no partner on the track: they carry no contact",
                contact.name,
            ));
        }
        let rotation = |side: &Side| case.structures[side.structure].rotation.as_ref();
        let turning = [rotation(&sides.slider), sides.track.as_ref().and_then(rotation)];
        warnings.extend(sliding_warning(&contact.name, turning, &found.points));
        made.push(Interface {
            name: contact.name.to_string(),
            points: found.points,
            law: law(&contact.forces).map_err(|error| {
                Unassembled::because(format!("contact.{}.friction_coefficient", contact.name), &error)
            })?,
            all_closed: matches!(contact.forces, ContactForceSettings::Coulomb { all_closed: true, .. }),
        });
        nodes.push(found.nodes);
    }
    Ok((made, nodes))
}

/// A body as the search for contact points wants it.
struct Sought<'a> {
    mesh: Mesh,
    width: f64,
    displacement: Box<dyn Fn(usize, Direction) -> Row + 'a>,
    displaced: Box<dyn Fn(usize) -> [f64; 3] + 'a>,
    kept: KeptOfFaces,
}

impl<'a> Sought<'a> {
    fn new(body: &'a BuiltBody) -> Self {
        Self {
            mesh: mesh_of(&body.structure),
            width: width(&body.structure),
            displacement: Box::new(|node, direction| body.displacement(node, direction)),
            displaced: Box::new(|node| body.displaced(node)),
            kept: KeptOfFaces::default(),
        }
    }

    /// The same where its nodes are displaced by so much, in m, what loads impose among it.
    fn moved_by(mut self, displaced: &[[f64; 3]]) -> Self {
        for (place, by) in self.mesh.nodes.iter_mut().zip(displaced) {
            *place = std::array::from_fn(|k| place[k] + by[k]);
        }
        self.displaced = Box::new(|_| [0.0; 3]);
        self
    }

    fn touching(&self) -> TouchingBody<'_> {
        let Self { mesh, width, displacement, displaced, kept } = self;
        TouchingBody { mesh, width: *width, displacement, displaced, kept: *kept }
    }

    /// How far a partner of these nodes is sought.
    fn reach(&self, points: &[usize]) -> f64 {
        Surface::of_nodes(&self.mesh, points).map_or(0.0, |surface| usual_reach(&self.mesh, &surface))
    }
}

/// What was found between two surfaces, and how far it was sought.
pub(super) struct FoundBeside {
    pub(super) found: FoundPoints,
    pub(super) reach: f64,
}

/// The points of one body beside the faces of another, which does not move.
pub(super) fn points_beside(
    [first, second]: [usize; 2],
    [points, opposite]: [&[usize]; 2],
    bodies: &[BuiltBody],
) -> Result<FoundBeside, AssemblyError> {
    let (own, other) = (Sought::new(&bodies[first]), Sought::new(&bodies[second]));
    let reach = own.reach(points).max(other.reach(opposite));
    let track = Track::Body(other.touching(), opposite);
    let found = contact_points(&own.touching(), points, &track, Sliding::Translation([0.0; 3]), reach)?;
    Ok(FoundBeside { found, reach })
}

/// A set of nodes by its words, and where its nodes lie.
pub(super) type SetOfPlaces = (String, Vec<[f64; 3]>);

/// The places of points of a body.
pub(super) fn places(body: &BuiltBody, points: &[usize]) -> Vec<[f64; 3]> {
    let mesh = mesh_of(&body.structure);
    points.iter().filter_map(|point| mesh.nodes.get(*point).copied()).collect()
}

/// Sets that do not face each other, named at a key.
pub(super) fn apart(path: String, sets: [SetOfPlaces; 2], reach: f64) -> Unassembled {
    let nearest = least_distance(&sets[0].1, &sets[1].1);
    let [slider, track] = sets.map(|(words, places)| {
        let corner = |from: f64, of: fn(f64, f64) -> f64| {
            std::array::from_fn(|k| places.iter().map(|place| place[k]).fold(from, of))
        };
        PlacedSet { words, bounds: [corner(f64::INFINITY, f64::min), corner(f64::NEG_INFINITY, f64::max)] }
    });
    Unassembled::new(path, AssemblyProblem::Apart { slider, track, reach, nearest })
}

/// The contact points of contacts that see the deformed track, where nodes are displaced by so much, in m; by contact.
pub(super) fn displaced_points(
    case: &AssemblyCase,
    bodies: &[BuiltBody],
    touching: &Touching,
    displaced: &[Vec<[f64; 3]>],
) -> Result<Vec<Option<FoundPoints>>, Unassembled> {
    let of_contact = |(contact, sides): (&ContactInterface, &Sides)| match contact.configuration {
        Configuration::Undeformed => Ok(None),
        Configuration::Deformed => found(case, contact, bodies, sides, Some(displaced)).map(Some),
    };
    case.contacts.iter().zip(&touching.contacts).map(of_contact).collect()
}

/// The contact points of a contact, of bodies as they are meshed or displaced.
fn found(
    case: &AssemblyCase,
    contact: &ContactInterface,
    bodies: &[BuiltBody],
    sides: &Sides,
    displaced: Option<&[Vec<[f64; 3]>]>,
) -> Result<FoundPoints, Unassembled> {
    let path = |key: &str| format!("contact.{}.{key}", contact.name);
    let sought = |side: &Side| {
        let own = Sought::new(&bodies[side.structure]);
        match displaced {
            Some(displaced) => own.moved_by(&displaced[side.structure]),
            None => own,
        }
    };
    let slider = sought(&sides.slider);
    let other = sides.track.as_ref().map(|side| {
        let mut track = sought(side);
        track.kept = KeptOfFaces {
            turns: contact.configuration == Configuration::Deformed,
            passes: case.structures[side.structure].rotation.as_ref().is_some_and(BodyRotation::passes),
        };
        (side, track)
    });
    let (track, reach) = match (&contact.track, &other) {
        (TrackSettings::Surface(TrackOf { normal: Some(normal), surface }), Some((side, body))) => {
            let [node] = side.points[..] else {
                let (set, found) = (surface.words(), side.points.len());
                return Err(Unassembled::new(
                    path("track.normal"),
                    AssemblyProblem::CarriedBySet { set, found },
                ));
            };
            (Track::Carried(body.touching(), node, in_space(normal)), 0.0)
        }
        (TrackSettings::Surface(own), Some((side, body))) => {
            if bodies[side.structure].structure.elements.is_none() {
                let node = own.surface.words();
                return Err(Unassembled::new(path("track"), AssemblyProblem::NoFaces { node }));
            }
            let reach = slider.reach(&sides.slider.points).max(body.reach(&side.points));
            (Track::Body(body.touching(), &side.points), reach)
        }
        (TrackSettings::Plane(plane), _) => (Track::Plane(in_space(&plane.normal)), 0.0),
        (TrackSettings::Surface(_), None) => (Track::Plane([0.0; 3]), 0.0),
    };
    let motion = sliding(contact);
    let mut found = contact_points(&slider.touching(), &sides.slider.points, &track, motion, reach)
        .map_err(|error| Unassembled::because(path("slider"), &error))?;
    if let TrackSettings::Plane(PlaneSettings { gap: Some(gap), .. }) = &contact.track {
        found.points.iter_mut().for_each(|point| point.gap += gap);
    }
    match (&contact.track, found.points.is_empty()) {
        (TrackSettings::Surface(track), true) => {
            let of = |side: &Side| places(&bodies[side.structure], &side.points);
            let own = (contact.slider.words(), of(&sides.slider));
            let other = (track.surface.words(), sides.track.as_ref().map(of).unwrap_or_default());
            Err(apart(path("track"), [own, other], reach))
        }
        _ => Ok(found),
    }
}

/// The mesh of a body; of matrices its places alone.
pub(super) fn mesh_of(structure: &Structure) -> Mesh {
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
pub(super) fn directed(size: f64, direction: &[f64]) -> [f64; 3] {
    let length = direction.iter().map(|part| part * part).sum::<f64>().sqrt();
    in_space(direction).map(|part| size * part / length)
}

/// How the track of a contact moves. One that rests needs neither a law of its own speed nor a way to go.
fn sliding(contact: &ContactInterface) -> Sliding {
    let may_rest = contact.travel.is_none() && matches!(contact.forces, ContactForceSettings::Coulomb { .. });
    match &contact.sliding {
        TrackMotion::Translation(own) if own.velocity == 0.0 && may_rest => {
            Sliding::Rest(directed(1.0, &own.direction))
        }
        TrackMotion::Translation(own) => Sliding::Translation(directed(own.velocity, &own.direction)),
        TrackMotion::Rotation(own) => Sliding::Rotation {
            angular_velocity: directed(own.speed, &own.axis),
            centre: in_space(&own.centre),
        },
    }
}

/// The law of an interface; of a sphere, until its load is known, that of a rigid point without friction.
fn law(forces: &ContactForceSettings) -> Result<InterfaceLaw, FrictionError> {
    Ok(match forces {
        ContactForceSettings::Coulomb { normal: NormalLaw::Rigid, friction, .. } => {
            InterfaceLaw::Rigid(friction.friction()?)
        }
        ContactForceSettings::Coulomb { normal: NormalLaw::Compliant(pressure), friction, .. } => {
            InterfaceLaw::Compliant(pressure.clone(), friction.friction()?)
        }
        ContactForceSettings::Coulomb { normal: NormalLaw::File(own), friction, .. } => {
            InterfaceLaw::Compliant(own.pressure(), friction.friction()?)
        }
        ContactForceSettings::Asperity(_) => InterfaceLaw::Rigid(Friction::Constant(0.0)),
    })
}
