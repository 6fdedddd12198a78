//! `[reduction]`: which freedoms are kept, and how many modes with them held.

use super::StructureSource;
use super::lists::{directions, quantity, whole_numbers};
use super::problem::{KeptProblem, StructureProblem};
use crate::cause::Cause;
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, list, text};
use crate::structure_keys::StructureKey;

/// What a Craig–Bampton reduction keeps.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// The freedoms that are kept.
    pub kept: Vec<Kept>,
    /// The fixed-interface modes that are kept.
    pub modes: FixedModes,
}

/// Freedoms that are kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Kept {
    /// Whose freedoms they are.
    pub nodes: KeptNodes,
    /// Which of them along x, y, z; all that are free where the case does not say.
    pub directions: [bool; 3],
}

/// Nodes whose freedoms are kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum KeptNodes {
    /// A set of the body.
    Set(String),
    /// Nodes of the table of freedoms, by their numbers in it.
    Numbers(Vec<usize>),
}

/// How many fixed-interface modes are kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FixedModes {
    /// So many, from the lowest on.
    Count(usize),
    /// All up to a frequency, rad/s.
    CutOff(f64),
}

/// The number of fixed-interface modes where the case does not say: that of the beams paper.
pub const FIXED_MODES: usize = 20;

/// The most fixed-interface modes.
pub const FIXED_MODES_LIMIT: usize = 2000;

/// Reads `[reduction]` of a structure from `source`.
pub(super) fn read_reduction(node: &Node, source: &StructureSource) -> Result<Reduction, Fault> {
    let section = Section::open(node, "reduction", "[reduction]", &["kept", "count", "cut_off"])?;
    let node = section.required("kept", "kept = [{ set = \"end\" }], the freedoms that are kept")?;
    let nodes = list("reduction.kept", node)?;
    if nodes.is_empty() {
        return Err(Cause::EmptyList { key: "reduction.kept".to_owned() }.at(node.place));
    }
    let kept = nodes.iter().map(|node| read_kept(node, source)).collect::<Result<_, _>>()?;
    let count = section.whole("count", 1, FIXED_MODES_LIMIT)?;
    let modes = match (count, section.get("cut_off")) {
        (Some(_), Some(node)) => {
            let (first, second) = (section.path("count"), section.path("cut_off"));
            return Err(Cause::Conflict { first, second }.at(node.place));
        }
        (None, Some(_)) => FixedModes::CutOff(quantity(&section, StructureKey::CutOff)?),
        (count, None) => FixedModes::Count(count.unwrap_or(FIXED_MODES)),
    };
    Ok(Reduction { kept, modes })
}

fn read_kept(node: &Node, source: &StructureSource) -> Result<Kept, Fault> {
    let path = "reduction.kept";
    let section =
        Section::open(node, path, &format!("an entry of `{path}`"), &["set", "nodes", "directions"])?;
    let directions = directions(&section, "directions")?.unwrap_or([true; 3]);
    if let (Some(_), Some(node)) = (section.get("set"), section.get("nodes")) {
        let (first, second) = (section.path("set"), section.path("nodes"));
        return Err(Cause::Conflict { first, second }.at(node.place));
    }
    let refuse = |problem: KeptProblem, node: &Node| Err(StructureProblem::Kept(problem).at(node.place));
    let nodes = match (source, section.get("set"), section.get("nodes")) {
        (StructureSource::Body(_), _, Some(node)) => return refuse(KeptProblem::NoNodes, node),
        (StructureSource::Body(_), _, None) => {
            let node = section.required("set", "set = \"…\", a set of nodes")?;
            KeptNodes::Set(text("reduction.kept.set", node)?.to_owned())
        }
        (StructureSource::Matrices(_), Some(node), _) => return refuse(KeptProblem::NoSets, node),
        (StructureSource::Matrices(sums), None, _) => {
            let node = section.required("nodes", "nodes = [1, 17], numbers of the table of freedoms")?;
            if sums.freedoms.is_none() {
                return refuse(KeptProblem::NoTable, node);
            }
            KeptNodes::Numbers(whole_numbers(&section, "nodes", node, (0, usize::MAX >> 1))?)
        }
    };
    Ok(Kept { nodes, directions })
}
