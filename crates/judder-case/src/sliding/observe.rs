//! `[observe]`: points whose motion a march keeps, and the signals that it leaves.

use super::contact::{NodesOf, check_one_node};
use super::motion::Axis;
use super::problem::SlidingProblem;
use super::structure::{SlidingStructure, find_structure, read_name};
use crate::cause::Cause;
use crate::dimension::Dimension;
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, list, text};
use crate::sliding_keys::SlidingKey;
use crate::structure::lists::{length, quantities};
use crate::structure::reduction::{KeptNodes, read_nodes};

/// A point whose motion is kept.
#[derive(Debug, Clone, PartialEq)]
pub struct ObservedPoint {
    /// Its name, of letters, digits, `_` and `-`.
    pub name: String,
    /// Its node, one of a structure.
    pub node: NodesOf,
}

/// A signal of a march.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Signal {
    /// The motion of an observed point.
    Point {
        /// The index of the point.
        point: usize,
        /// Along x or y.
        axis: Axis,
        /// What of its motion.
        quantity: PointQuantity,
    },
    /// N, N.
    NormalForce,
    /// T, N.
    TangentialForce,
    /// Of C along the track, m/s.
    SlidingVelocity,
}

/// What of a motion is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum PointQuantity {
    Acceleration,
    Velocity,
    Displacement,
}

impl PointQuantity {
    /// The quantities with their names in a case file.
    pub const ALL: [(&'static str, Self); 3] = [
        ("acceleration", Self::Acceleration),
        ("velocity", Self::Velocity),
        ("displacement", Self::Displacement),
    ];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// The signals of the contact with their names in a case file.
pub const CONTACT_SIGNALS: [(&str, Signal); 3] = [
    ("normal-force", Signal::NormalForce),
    ("tangential-force", Signal::TangentialForce),
    ("sliding-velocity", Signal::SlidingVelocity),
];

impl Signal {
    /// The name in a case file: `T.y` is the acceleration of the point T along y, `T.y.velocity` its velocity.
    pub fn name(self, points: &[ObservedPoint]) -> String {
        match self {
            Self::Point { point, axis, quantity } => {
                let name = points.get(point).map_or("", |point| point.name.as_str());
                match quantity {
                    PointQuantity::Acceleration => format!("{name}.{}", axis.name()),
                    _ => format!("{name}.{}.{}", axis.name(), quantity.name()),
                }
            }
            Self::NormalForce => "normal-force".to_owned(),
            Self::TangentialForce => "tangential-force".to_owned(),
            Self::SlidingVelocity => "sliding-velocity".to_owned(),
        }
    }

    /// What of the motion of a point it is; empty for a signal of the contact.
    pub(super) fn quantity(self) -> &'static str {
        match self {
            Self::Point { quantity, .. } => quantity.name(),
            _ => "",
        }
    }

    /// Its dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Point { quantity: PointQuantity::Acceleration, .. } => Dimension::ACCELERATION,
            Self::Point { quantity: PointQuantity::Velocity, .. } | Self::SlidingVelocity => Dimension::SPEED,
            Self::Point { quantity: PointQuantity::Displacement, .. } => Dimension::LENGTH,
            Self::NormalForce | Self::TangentialForce => Dimension::FORCE,
        }
    }

    /// The signal that a case calls by `name`.
    fn find(name: &str, points: &[ObservedPoint]) -> Option<Self> {
        if let Some((_, signal)) = CONTACT_SIGNALS.iter().find(|(known, _)| *known == name) {
            return Some(*signal);
        }
        let mut parts = name.split('.');
        let own = parts.next()?;
        let point = points.iter().position(|point| point.name == own)?;
        let direction = parts.next()?;
        let (_, axis) = *Axis::ALL.iter().find(|(known, _)| *known == direction)?;
        let quantity = match parts.next() {
            None => PointQuantity::Acceleration,
            Some(word) => PointQuantity::ALL.iter().find(|(known, _)| *known == word)?.1,
        };
        parts.next().is_none().then_some(Self::Point { point, axis, quantity })
    }
}

/// Reads `[observe]`; without it no points are kept.
pub(super) fn read_points(
    root: &Section<'_>,
    structures: &[SlidingStructure; 2],
) -> Result<Vec<ObservedPoint>, Fault> {
    let Some(node) = root.get("observe") else { return Ok(Vec::new()) };
    let section = root.table("observe", node, &["points"])?;
    let node =
        section.required("points", "points = [{ name = \"T\", structure = \"…\", set = \"end-upper\" }]")?;
    let mut points: Vec<ObservedPoint> = Vec::new();
    for node in list("observe.points", node)? {
        let point = read_point(node, structures)?;
        if points.iter().any(|other| other.name == point.name) {
            return Err(SlidingProblem::NameTwice { what: "point", name: point.name }.at(node.place));
        }
        points.push(point);
    }
    Ok(points)
}

fn read_point(node: &Node, structures: &[SlidingStructure; 2]) -> Result<ObservedPoint, Fault> {
    let keys = ["name", "structure", "set", "nodes", "at"];
    let section = Section::open(node, "observe.points", "an observed point", &keys)?;
    let name = read_name(&section, "point")?;
    let structure = find_structure(structures, &section, "structure")?;
    let nodes = match section.get("at") {
        Some(node) => read_place(&section, node)?,
        None => read_nodes(&section, &structures[structure].source)?,
    };
    check_one_node(&section, "nodes", node, &nodes)?;
    Ok(ObservedPoint { name, node: NodesOf { structure, nodes } })
}

/// The place x, y of a point, in place of the name of its node.
fn read_place(section: &Section<'_>, node: &Node) -> Result<KeptNodes, Fault> {
    for other in ["set", "nodes"] {
        if let Some(node) = section.get(other) {
            let (first, second) = (section.path("at"), section.path(other));
            return Err(Cause::Conflict { first, second }.at(node.place));
        }
    }
    match quantities(section, SlidingKey::PointAt.entry(), node)?[..] {
        [x, y] => Ok(KeptNodes::Near([x, y])),
        _ => Err(length(section, "at", "two lengths, x and y", node)),
    }
}

/// The signal that `key` of an analysis names; without the key the first point's acceleration along y, or the normal force where no
/// point is observed.
pub(super) fn read_signal(
    section: &Section<'_>,
    key: &str,
    points: &[ObservedPoint],
) -> Result<Signal, Fault> {
    let Some(node) = section.get(key) else {
        let first = Signal::Point { point: 0, axis: Axis::Y, quantity: PointQuantity::Acceleration };
        return Ok(if points.is_empty() { Signal::NormalForce } else { first });
    };
    find_signal(&section.path(key), node, points)
}

/// The signal that an entry of the key `key` names.
pub(super) fn find_signal(key: &str, node: &Node, points: &[ObservedPoint]) -> Result<Signal, Fault> {
    let name = text(key, node)?;
    Signal::find(name, points).ok_or_else(|| {
        let of_point = |point: &ObservedPoint| Axis::ALL.map(|(axis, _)| format!("{}.{axis}", point.name));
        let own = points.iter().flat_map(of_point);
        let known = own.chain(CONTACT_SIGNALS.iter().map(|(name, _)| (*name).to_owned())).collect();
        Cause::UnknownName { what: "signal", name: name.to_owned(), known }.at(node.place)
    })
}
