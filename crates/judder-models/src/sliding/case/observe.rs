//! `[observe]`: points whose motion a march keeps, and the signals that it leaves.

use super::contact::check_one_node;
use super::motion::PlaneAxis;
use super::plain_name::{PlainName, find_structure};
use super::problem::SlidingProblem;
use super::structure::SlidingStructure;
use crate::structure::case::reduction::KeptNodes;
use judder_keys::cause::Cause;
use judder_keys::declared::{Named, Number, NumberPair, Several, all, conflict};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list, text};
use judder_keys::{Choice, Settings};

/// Points whose motion is kept.
#[derive(Debug, Clone, PartialEq, Settings)]
pub(crate) struct ObservedPoints {
    /// Points whose motion along x and y a march keeps.
    #[key(rule = POINTS, example = "[{ name = \"T\", structure = \"…\", set = \"end-upper\" }]")]
    pub(crate) points: Vec<ObservedPoint>,
}

/// A point whose motion is kept.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an observed point")]
pub struct ObservedPoint {
    /// By which signals call this point.
    #[key(rule = "point", example = "\"…\", by which keys call this point")]
    pub name: PlainName,
    /// The name of a structure.
    #[key(later)]
    pub structure: Named<usize>,
    /// Where on it.
    #[key(flatten)]
    pub node: PointNode,
}

/// Which node a point is.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = PointNode::one)]
pub enum PointNode {
    /// The only one of a set, or the one of a number.
    #[key(flatten)]
    Kept(KeptNodes),
    /// In place of set or nodes: where it lies in the undeformed structure; the nearest node is taken.
    #[key(rule = PLACE, symbol = "x, y")]
    At([f64; 2]),
}

const POINTS: Several<()> = Several { of: (), length: [0, usize::MAX] };
const PLACE: NumberPair =
    NumberPair { of: Number::any(Dimension::LENGTH), what: "two lengths, x and y", is_ascending: false };

/// A signal of a march.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Signal {
    /// The motion of an observed point.
    Point {
        /// The index of the point.
        point: usize,
        /// Along x or y.
        axis: PlaneAxis,
        /// What of its motion.
        quantity: PointQuantity,
    },
    /// N, N.
    #[default]
    NormalForce,
    /// T, N.
    TangentialForce,
    /// Of C along the track, m/s.
    SlidingVelocity,
}

/// What of a motion is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "quantity")]
#[allow(missing_docs)]
pub enum PointQuantity {
    Acceleration,
    Velocity,
    Displacement,
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
    pub(crate) fn quantity(self) -> &'static str {
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
        let point = points.iter().position(|point| *point.name == own)?;
        let direction = parts.next()?;
        let (_, axis) = *PlaneAxis::ALL.iter().find(|(known, _)| *known == direction)?;
        let quantity = match parts.next() {
            None => PointQuantity::Acceleration,
            Some(word) => PointQuantity::ALL.iter().find(|(known, _)| *known == word)?.1,
        };
        parts.next().is_none().then_some(Self::Point { point, axis, quantity })
    }
}

impl ObservedPoints {
    /// Finds the structures of the points, and refuses nodes that they cannot have and two points of one name.
    pub(crate) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[SlidingStructure; 2],
    ) -> Result<(), Fault> {
        let Some(node) = section.get("points") else { return Ok(()) };
        let nodes = list("observe.points", node)?;
        all(self.points.iter_mut().zip(nodes).map(|(point, node)| point.admit(node, structures)))?;
        for (index, (point, node)) in self.points.iter().zip(nodes).enumerate() {
            if self.points[..index].iter().any(|other| other.name == point.name) {
                let name = point.name.to_string();
                return Err(SlidingProblem::NameTwice { what: "point", name }.at(node.place));
            }
        }
        Ok(())
    }
}

impl ObservedPoint {
    fn admit(&mut self, node: &Node, structures: &[SlidingStructure; 2]) -> Result<(), Fault> {
        let section = Section::of_table(node, "observe.points", "an observed point")?;
        find_structure(&mut self.structure, structures.iter().map(|own| &own.name), &section)?;
        let PointNode::Kept(nodes) = &self.node else { return Ok(()) };
        KeptNodes::admit(&section, &structures[*self.structure].source)?;
        check_one_node(&section.path("nodes"), nodes).map_err(|problem| problem.at(node.place))
    }
}

impl PointNode {
    /// Refuses a place beside nodes.
    fn one(section: &Section<'_>) -> Result<(), Fault> {
        conflict(section, "at", "set")?;
        conflict(section, "at", "nodes")
    }
}

impl Signal {
    /// The signal under `key`; without the key the first point's acceleration along y, or the normal force where no point is observed.
    pub(crate) fn named(
        section: &Section<'_>,
        key: &str,
        points: &[ObservedPoint],
    ) -> Result<Named<Self>, Fault> {
        let first = Self::Point { point: 0, axis: PlaneAxis::Y, quantity: PointQuantity::Acceleration };
        let found = match section.get(key) {
            Some(node) => Self::read(key, node, points)?,
            None if points.is_empty() => Self::NormalForce,
            None => first,
        };
        Ok(Named { name: found.name(points), found })
    }

    /// The signal that a value under `key` names.
    pub(crate) fn read(key: &str, node: &Node, points: &[ObservedPoint]) -> Result<Self, Fault> {
        let name = text(key, node)?;
        Self::find(name, points).ok_or_else(|| {
            let of_point =
                |point: &ObservedPoint| PlaneAxis::ALL.map(|(axis, _)| format!("{}.{axis}", *point.name));
            let own = points.iter().flat_map(of_point);
            let known = own.chain(CONTACT_SIGNALS.iter().map(|(name, _)| (*name).to_owned())).collect();
            Cause::UnknownName { what: "signal", name: name.to_owned(), known }.at(node.place)
        })
    }
}
