//! `[contact]`: who slides on what, and the friction between them.

use super::problem::SlidingProblem;
use super::structure::{SlidingStructure, find_structure};
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::section::Section;
use crate::sliding_keys::SlidingKey;
use crate::structure::lists::{number, quantities};
use crate::structure::problem::StructureProblem;
use crate::structure::reduction::{KeptNodes, read_nodes};
use crate::swept_keys::read_value;

/// The contact of a slider on a track.
#[derive(Debug, Clone, PartialEq)]
pub struct SlidingContact {
    /// The slider and its contact point C, one node.
    pub slider: NodesOf,
    /// The track and its contact edge: nodes in their order, from which positions count.
    pub track: NodesOf,
    /// μ.
    pub friction: Friction,
    /// How the edge runs between its nodes.
    pub interpolation: Interpolation,
    /// g_0, m, closed over the ramp of the gap; below zero a penetration.
    pub initial_gap: f64,
}

/// Nodes of one of the two structures.
#[derive(Debug, Clone, PartialEq)]
pub struct NodesOf {
    /// The index of the structure, 0 or 1.
    pub structure: usize,
    /// The nodes: a set of a body, or numbers of the table of freedoms.
    pub nodes: KeptNodes,
}

/// The friction coefficient.
#[derive(Debug, Clone, PartialEq)]
pub enum Friction {
    /// μ, whatever the speed.
    Constant(f64),
    /// μ against the sliding speed, linear between the speeds and constant beyond them.
    Table {
        /// Sliding speeds, m/s, ascending, two at least.
        velocity: Vec<f64>,
        /// μ at each of them.
        coefficient: Vec<f64>,
    },
}

/// How the contact edge runs between its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Straight: the slope jumps at a node.
    Linear,
    /// Cubic, with continuous slope.
    Hermite,
}

impl Interpolation {
    /// The choices with their names in a case file.
    pub const ALL: [(&'static str, Self); 2] = [("linear", Self::Linear), ("hermite", Self::Hermite)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// The keys of `[contact]`.
const KEYS: [&str; 5] = ["slider", "track", "friction_coefficient", "interpolation", "initial_gap"];

/// Reads `[contact]`.
pub(super) fn read_contact(
    root: &Section<'_>,
    structures: &[SlidingStructure; 2],
) -> Result<SlidingContact, Fault> {
    let node = root.required("contact", "[contact] with slider = { … } and track = { … }")?;
    let section = root.table("contact", node, &KEYS)?;
    let node = section.required("slider", "slider = { structure = \"…\", set = \"end-lower\" }")?;
    let slider = read_nodes_of(&section, "slider", node, structures)?;
    check_one_node(&section, "slider", node, &slider.nodes)?;
    let node = section.required("track", "track = { structure = \"…\", set = \"upper-corners\" }")?;
    let track = read_nodes_of(&section, "track", node, structures)?;
    if slider.structure == track.structure {
        let name = structures[track.structure].name.clone();
        return Err(SlidingProblem::SameStructure { name }.at(node.place));
    }
    if let KeptNodes::Numbers(nodes) = &track.nodes
        && nodes.len() < 2
    {
        let (key, expected) = (section.path("track"), "two nodes at least");
        return Err(StructureProblem::Length { key, expected, found: nodes.len() }.at(node.place));
    }
    if let KeptNodes::Numbers(nodes) = &track.nodes
        && let Some(twice) =
            nodes.iter().enumerate().find_map(|(k, own)| nodes[..k].contains(own).then_some(own))
    {
        let name = nodes.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        let place = node.entry("nodes").map_or(node.place, |nodes| nodes.place);
        return Err(SlidingProblem::Track { name, reason: format!("names node {twice} twice") }.at(place));
    }
    let choice = section.choice("interpolation", "interpolation", &Interpolation::ALL)?;
    Ok(SlidingContact {
        slider,
        track,
        friction: read_friction(&section)?,
        interpolation: choice.unwrap_or(Interpolation::Linear),
        initial_gap: number(&section, SlidingKey::InitialGap.entry())?,
    })
}

fn read_nodes_of(
    section: &Section<'_>,
    key: &str,
    node: &Node,
    structures: &[SlidingStructure; 2],
) -> Result<NodesOf, Fault> {
    let table = section.table(key, node, &["structure", "set", "nodes"])?;
    let structure = find_structure(structures, &table, "structure")?;
    Ok(NodesOf { structure, nodes: read_nodes(&table, &structures[structure].source)? })
}

/// Refuses numbers of several nodes; a set is counted when there is a mesh.
pub(super) fn check_one_node(
    section: &Section<'_>,
    key: &str,
    node: &Node,
    nodes: &KeptNodes,
) -> Result<(), Fault> {
    match nodes {
        KeptNodes::Numbers(nodes) if nodes.len() != 1 => {
            let (key, found) = (section.path(key), nodes.len());
            Err(SlidingProblem::NotOneNode { key, found }.at(node.place))
        }
        _ => Ok(()),
    }
}

fn read_friction(section: &Section<'_>) -> Result<Friction, Fault> {
    let entry = SlidingKey::FrictionCoefficient.entry();
    let node = match section.get(entry.name()) {
        Some(node) if matches!(node.data, Data::Table(_)) => node,
        Some(node) => {
            return Ok(Friction::Constant(read_value(entry, &section.path(entry.name()), node)?.number));
        }
        None => return number(section, entry).map(Friction::Constant),
    };
    let table = section.table(entry.name(), node, &["velocity", "coefficient"])?;
    let column = |key: SlidingKey, example: &str| {
        let node = table.required(key.entry().name(), example)?;
        Ok((quantities(&table, key.entry(), node)?, node))
    };
    let (velocity, speeds) = column(SlidingKey::FrictionSpeed, "velocity = [\"0 mm/s\", \"10 mm/s\"]")?;
    let (coefficient, coefficients) = column(SlidingKey::FrictionAtSpeed, "coefficient = [0.4, 0.3]")?;
    if velocity.len() != coefficient.len() || velocity.len() < 2 {
        let problem =
            SlidingProblem::FrictionTable { speeds: velocity.len(), coefficients: coefficient.len() };
        return Err(problem.at(coefficients.place));
    }
    match velocity.windows(2).find(|pair| pair[0] >= pair[1]) {
        Some(pair) => {
            Err(SlidingProblem::UnsortedSpeeds { before: pair[0], speed: pair[1] }.at(speeds.place))
        }
        None => Ok(Friction::Table { velocity, coefficient }),
    }
}
