//! Edges along which contact points travel.

use super::interface::{Touching, directed};
use super::{BuiltAssembly, BuiltBody, Unassembled};
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::{ContactInterface, TrackMotion, TrackSettings};
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::row::Row;
use judder_nonsmooth::travel::{EdgeNode, TravellingContact};
use judder_numerics::order::sort_by_number;
use judder_sliding::plane::{PlaneVector, along_chord, dot, length};
use judder_structure::freedom::Direction;

/// The contacts of a case whose points travel; `nodes` are the slider's of each contact.
pub(super) fn travelling(
    case: &AssemblyCase,
    bodies: &[BuiltBody],
    touching: &Touching,
    nodes: &[Vec<usize>],
) -> Result<Vec<TravellingContact>, Unassembled> {
    let mut all = Vec::new();
    for (number, contact) in case.contacts.iter().enumerate() {
        let (Some(interpolation), TrackSettings::Surface(track), Some(points)) =
            (contact.travel, &contact.track, touching.track(number))
        else {
            continue;
        };
        let path = format!("contact.{}.travel", contact.name);
        let (slider, track) = (&bodies[*contact.slider.structure], &bodies[*track.surface.structure]);
        if moves_in_space(slider, &nodes[number]) || moves_in_space(track, points) {
            let reason = "contact points travel along an edge in the plane: these bodies move in space, where they do not travel yet";
            return Err(Unassembled::because(path, &reason));
        }
        let edge = edge(contact, track, points);
        let places: Vec<PlaneVector> = edge.iter().map(|node| node.place).collect();
        along_chord(&places).map_err(|error| Unassembled::because(path, &error))?;
        all.push(TravellingContact {
            interface: number,
            points: nodes[number].iter().map(|node| rows(slider, *node)).collect(),
            interpolation,
            nodes: edge,
        });
    }
    Ok(all)
}

/// A contact whose points would leave the edge.
pub(crate) struct TrackEnd {
    /// Its number in the case.
    pub(crate) contact: usize,
    /// How far it may travel back and ahead, in m.
    pub(crate) ways: [f64; 2],
    /// Its speed, in m/s.
    pub(crate) speed: f64,
}

impl BuiltAssembly {
    /// How far each contact that travels may go.
    pub(crate) fn track_ends(&self) -> impl Iterator<Item = TrackEnd> {
        self.travelling.iter().map(|own| {
            let points = &self.assembly.interfaces[own.interface].points;
            let mut end = TrackEnd { contact: own.interface, ways: [f64::INFINITY; 2], speed: 0.0 };
            for ContactPoint { velocity: [x, y, _], place: [from, over, _], .. } in points {
                end.speed = length([*x, *y]);
                let ahead = |place: PlaneVector| -dot(place, [*x, *y]) / end.speed;
                let here = ahead([*from, *over]);
                let nodes = || own.nodes.iter().map(|node| ahead(node.place));
                let [first, last] =
                    [nodes().fold(f64::INFINITY, f64::min), nodes().fold(f64::NEG_INFINITY, f64::max)];
                end.ways = [end.ways[0].min(here - first), end.ways[1].min(last - here)];
            }
            end
        })
    }
}

/// All forms of a contact that travels.
pub(super) fn rows_of(contact: &mut TravellingContact) -> impl Iterator<Item = &mut Row> {
    let of_nodes = contact.nodes.iter_mut().flat_map(|node| &mut node.rows);
    contact.points.iter_mut().flatten().chain(of_nodes)
}

/// The nodes of an edge in the order in which the track moves by.
fn edge(contact: &ContactInterface, track: &BuiltBody, points: &[usize]) -> Vec<EdgeNode> {
    let towards = match &contact.sliding {
        TrackMotion::Translation(own) => directed(1.0, &own.direction),
        TrackMotion::Rotation(_) => [1.0, 0.0, 0.0],
    };
    let node = |point: &usize| EdgeNode { place: place(track, *point), rows: rows(track, *point) };
    let mut nodes: Vec<EdgeNode> = points.iter().map(node).collect();
    let along = |node: &EdgeNode| dot(node.place, [towards[0], towards[1]]);
    sort_by_number(&mut nodes, along);
    nodes
}

fn place(body: &BuiltBody, point: usize) -> PlaneVector {
    let layout = body.structure.layout.as_ref();
    let [x, y, _] = layout.map_or([0.0; 3], |layout| layout.points[point]);
    [x, y]
}

fn rows(body: &BuiltBody, point: usize) -> [Row; 2] {
    [Direction::X, Direction::Y].map(|direction| body.displacement(point, direction))
}

fn moves_in_space(body: &BuiltBody, points: &[usize]) -> bool {
    points.iter().any(|point| !body.displacement(*point, Direction::Z).is_empty())
}
