//! Matrices that stand in the case itself: arrays of numbers and expressions, each freedom named by its node and direction.

use crate::entries::{Entries, EntryMatrix, Order, Scope};
use crate::sliding::case::plain_name::PlainName;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, Setting, Several, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Entry, Node};
use judder_keys::error::Fault;
use judder_keys::problem::{Placed, Problem};
use judder_keys::section::{Section, list, wrong_type};
use judder_structure::freedom::Direction;
use serde_json::{Map, Value as Json, json};
use std::collections::BTreeMap;
use thiserror::Error;

/// M, C and K as arrays of numbers and expressions.
#[derive(Debug, Clone)]
pub struct MatrixArrays {
    /// The canonical form.
    written: Json,
    /// The node and the direction of each freedom, in the order of the rows.
    freedoms: Vec<(String, Direction)>,
    /// Places of nodes by their names, in m.
    places: Vec<(String, Vec<f64>)>,
    entries: ArrayEntries,
}

/// The entries of M, C and K.
#[derive(Debug, Clone)]
enum ArrayEntries {
    /// As they stand in the case.
    Given([Option<Entries>; 3]),
    /// When the parameters are known.
    Compiled(Vec<EntryMatrix>),
}

/// M, C and K, in messages and sections.
const NAMES: [&str; 3] = ["mass", "damping", "stiffness"];

/// M, C and K as arrays of numbers and expressions.
#[derive(Debug, Clone, Settings)]
pub(crate) struct ArrayKeys {
    /// M, as many rows as freedoms, of numbers or expressions of the parameters, in place of files.
    #[key(rule = Order::Any, example = "[[1, 0], [0, 1]], a row for each freedom")]
    mass: Entries,
    /// C; zero by default.
    #[key(rule = Order::Any)]
    damping: Option<Entries>,
    /// K; zero by default.
    #[key(rule = Order::Any)]
    stiffness: Option<Entries>,
    /// The node and the direction of each freedom; each node is a set of its name.
    #[key(example = "[[\"mass\", \"x\"], [\"mass\", \"y\"]], node and direction of each row")]
    freedoms: NamedFreedoms,
    /// Where nodes lie; at the origin where not given.
    #[key(default = NodePlaces(Vec::new()))]
    places: NodePlaces,
}

/// The freedoms of arrays, in the order of their rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct NamedFreedoms(Vec<(String, Direction)>);

/// Places of nodes by their names, in m.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct NodePlaces(Vec<(String, Vec<f64>)>);

/// What can be wrong with arrays that are matrices one by one.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ArrayProblem {
    /// A matrix of another size than the mass.
    #[error("`{key}` has {found} row{}, but the mass has {expected}", plural(*.found))]
    OtherSize {
        /// The key.
        key: String,
        /// Its rows.
        found: usize,
        /// Those of the mass.
        expected: usize,
    },
    /// More freedoms than rows, or fewer.
    #[error("`{key}` names {found} freedom{}, but the mass has {expected} row{}", plural(*.found), plural(*.expected))]
    FreedomCount {
        /// The key.
        key: String,
        /// How many there are.
        found: usize,
        /// Rows of the mass.
        expected: usize,
    },
    /// A freedom that is named twice.
    #[error("`{key}` names node `{node}` along {direction} twice")]
    FreedomTwice {
        /// The key.
        key: String,
        /// The node.
        node: String,
        /// The direction.
        direction: Direction,
    },
    /// A freedom that is no pair.
    #[error("an entry of `{key}` must be a node and a direction, and has {found} part{}", plural(*.found))]
    NoPair {
        /// The key.
        key: String,
        /// How many parts it has.
        found: usize,
    },
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

impl Problem for ArrayProblem {
    fn kind(&self) -> &'static str {
        "Matrix"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::OtherSize { .. } | Self::FreedomCount { .. } => "another size",
            Self::FreedomTwice { .. } => "given twice",
            Self::NoPair { .. } => "no freedom",
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::OtherSize { expected, .. } => format!("give {expected} rows of {expected} entries"),
            Self::FreedomCount { expected, .. } => {
                format!(
                    "name {expected}: one for each row, in their order, as in [[\"mass\", \"x\"], [\"mass\", \"y\"]]"
                )
            }
            Self::FreedomTwice { .. } => {
                "a node has one freedom along each of x, y, z; call another node by another name".to_owned()
            }
            Self::NoPair { .. } => "as in [\"mass\", \"x\"]".to_owned(),
        })
    }
}

impl Setting for NamedFreedoms {
    type Rule = ();

    fn form((): &()) -> Allowed {
        let pair = Allowed::List { of: Box::new(Allowed::Text), length: [2, 2] };
        Allowed::List { of: Box::new(pair), length: [1, usize::MAX] }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        let nodes = list(&path, node)?;
        let pair = |node: &Node| {
            let [name, direction] = list(&path, node)? else {
                let found = list(&path, node)?.len();
                return Err(ArrayProblem::NoPair { key: path.clone(), found }.at(node.place));
            };
            let name = PlainName::read(section, key, name, &"node");
            let (name, direction) = both(name, Direction::read(section, key, direction, &()))?;
            Ok((name.to_string(), direction))
        };
        let freedoms = all(nodes.iter().map(pair))?;
        let is_twice = |k: &usize| freedoms[..*k].contains(&freedoms[*k]);
        match (1..freedoms.len()).find(is_twice) {
            None => Ok(Self(freedoms)),
            Some(k) => {
                let (node, direction) = freedoms[k].clone();
                Err(ArrayProblem::FreedomTwice { key: path, node, direction }.at(nodes[k].place))
            }
        }
    }

    fn write(&self, (): &()) -> Json {
        self.0.iter().map(|(node, direction)| json!([node, direction.to_string()])).collect()
    }
}

const PLACE: Several<Number> = Several { of: Number::any(Dimension::LENGTH), length: [2, 3] };

impl Setting for NodePlaces {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Named(Box::new(Vec::<f64>::form(&PLACE)))
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        let Data::Table(table) = &node.data else { return Err(wrong_type(&path, "a table", node)) };
        let inner = Section::of_table(node, &path, &format!("`{path}`"))?;
        let place = |entry: &Entry| {
            let place = Vec::<f64>::read(&inner, &entry.key, &entry.node, &PLACE)?;
            if (2..=3).contains(&place.len()) {
                return Ok((entry.key.clone(), place));
            }
            let (key, found) = (inner.path(&entry.key), place.len());
            Err(Cause::Length { key, expected: "two or three lengths", found }.at(entry.node.place))
        };
        all(table.entries.iter().map(place)).map(Self)
    }

    fn write(&self, (): &()) -> Json {
        self.0.iter().map(|(name, place)| (name.clone(), json!(place))).collect::<Map<_, _>>().into()
    }
}

impl MatrixArrays {
    pub(super) fn form() -> Allowed {
        ArrayKeys::form(&())
    }

    pub(super) fn read(section: &Section<'_>, key: &str, node: &Node) -> Result<Self, Fault> {
        let keys = ArrayKeys::read(section, key, node, &())?;
        let written = Setting::write(&keys, &());
        let ArrayKeys { mass, damping, stiffness, freedoms, places } = keys;
        let entries = ArrayEntries::Given([Some(mass), damping, stiffness]);
        Ok(Self { written, freedoms: freedoms.0, places: places.0, entries })
    }

    /// The canonical form.
    pub(super) fn written(&self) -> Json {
        self.written.clone()
    }

    /// Compiles the entries, whose matrices and names must fit together.
    pub(super) fn found(mut self, section: &Section<'_>, scope: &Scope<'_>) -> Result<Self, Fault> {
        let ArrayEntries::Given(given) = &self.entries else { return Ok(self) };
        let order = given[0].as_ref().map_or(0, Entries::order);
        let compiled = |(name, given): (&'static str, &Option<Entries>)| match given {
            None => Ok(EntryMatrix::diagonal(name, order, 0.0)),
            Some(given) if name == NAMES[0] => given.mass(scope),
            Some(given) if given.order() == order => given.matrix(name, scope),
            Some(given) => {
                let (key, found) = (section.path(name), given.order());
                let problem = ArrayProblem::OtherSize { key, found, expected: order };
                Err(problem.at(section.place_of(&[name])))
            }
        };
        let matrices = all(NAMES.into_iter().zip(given).map(compiled));
        let count = match self.freedoms.len() == order {
            true => Ok(()),
            false => {
                let (key, found) = (section.path("freedoms"), self.freedoms.len());
                let problem = ArrayProblem::FreedomCount { key, found, expected: order };
                Err(problem.at(section.place_of(&["freedoms"])))
            }
        };
        let (matrices, _) = both(matrices, both(count, self.check_places(section)))?;
        self.entries = ArrayEntries::Compiled(matrices);
        Ok(self)
    }

    /// Refuses places of nodes that there are not.
    fn check_places(&self, section: &Section<'_>) -> Result<(), Fault> {
        let known = self.nodes();
        let stranger = self.places.iter().find(|(name, _)| !known.contains(name));
        match (stranger, section.inner("places")?) {
            (Some((name, _)), Some(places)) => {
                let (name, place) = (name.clone(), places.place_of(&[name]));
                Err(Cause::UnknownName { what: "node", name, known }.at(place))
            }
            _ => Ok(()),
        }
    }

    /// M, C and K; none before they are compiled.
    pub(crate) fn matrices(&self) -> &[EntryMatrix] {
        match &self.entries {
            ArrayEntries::Given(_) => &[],
            ArrayEntries::Compiled(matrices) => matrices,
        }
    }

    /// The node and the direction of each freedom.
    pub(crate) fn freedoms(&self) -> &[(String, Direction)] {
        &self.freedoms
    }

    /// The names of the nodes, in the order of their first freedoms.
    pub(crate) fn nodes(&self) -> Vec<String> {
        let mut nodes: Vec<String> = Vec::new();
        for (node, _) in self.freedoms() {
            if !nodes.contains(node) {
                nodes.push(node.clone());
            }
        }
        nodes
    }

    /// Where the nodes lie, by name, in m; at the origin where not given.
    pub(crate) fn places(&self) -> BTreeMap<&str, [f64; 3]> {
        let place = |place: &Vec<f64>| std::array::from_fn(|axis| place.get(axis).copied().unwrap_or(0.0));
        let given = self.places.iter().map(|(name, own)| (name.as_str(), place(own)));
        let origin = self.freedoms().iter().map(|(name, _)| (name.as_str(), [0.0; 3]));
        origin.chain(given).collect()
    }
}
