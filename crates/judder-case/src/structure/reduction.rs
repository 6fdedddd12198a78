//! `[reduction]`: which freedoms are kept, and how many modes with them held.

use super::StructureSource;
use super::lists::whole_numbers;
use super::problem::{KeptProblem, StructureProblem};
use crate::cause::Cause;
use crate::declared::{Number, Setting, Settings, Whole, conflict};
use crate::dimension::Dimension;
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, list, text};
use judder_keys_derive::Settings;

/// What a Craig–Bampton reduction keeps.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// The freedoms that are kept.
    pub kept: Vec<Kept>,
    /// The fixed-interface modes that are kept.
    pub modes: FixedModes,
}

/// Freedoms that are kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Whose freedoms they are.
    pub nodes: KeptNodes,
    /// Which of them along x, y, z; all that are free where the case does not say.
    pub directions: [bool; 3],
}

/// Nodes whose freedoms are kept.
#[derive(Debug, Clone, PartialEq)]
pub enum KeptNodes {
    /// A set of the body.
    Set(String),
    /// Nodes of the table of freedoms, by their numbers in it.
    Numbers(Vec<usize>),
    /// The node nearest to a place x, y of the undeformed structure, m.
    Near([f64; 2]),
}

/// How many fixed-interface modes are kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FixedModes {
    /// So many, from the lowest on.
    Count(usize),
    /// All up to a frequency, rad/s.
    CutOff(f64),
}

/// How many fixed-interface modes are kept, as a case says it.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = FixedModeKeys::one)]
pub(crate) struct FixedModeKeys {
    /// So many fixed-interface modes are kept, from the lowest on, where no cut-off is given.
    #[key(rule = Whole { from: 1, to: FIXED_MODES_LIMIT }, usual = FIXED_MODES, omitted)]
    count: Option<usize>,
    /// Fixed-interface modes up to this frequency are kept.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω_c", omitted)]
    cut_off: Option<f64>,
}

impl FixedModeKeys {
    /// Refuses both keys.
    fn one(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        conflict(section, "count", "cut_off")
    }

    fn modes(&self) -> FixedModes {
        match self.cut_off {
            Some(limit) => FixedModes::CutOff(limit),
            None => FixedModes::Count(self.count.unwrap_or(FIXED_MODES)),
        }
    }
}

/// The number of fixed-interface modes where the case does not say: that of the beams paper.
pub const FIXED_MODES: usize = 20;

/// The most fixed-interface modes.
pub const FIXED_MODES_LIMIT: usize = 2000;

/// The keys of a reduction.
pub(crate) const KEYS: [&str; 3] = ["kept", "count", "cut_off"];

/// Reads the reduction that `section` describes, of a structure from `source`; without `kept` it keeps no freedoms.
pub(crate) fn read_reduction(section: &Section<'_>, source: &StructureSource) -> Result<Reduction, Fault> {
    let kept = section.get("kept").map(|node| read_list(section, node, source)).transpose()?;
    let kept = kept.unwrap_or_default();
    let modes = FixedModeKeys::read_table(section)?.modes();
    Ok(Reduction { kept, modes })
}

fn read_list(section: &Section<'_>, node: &Node, source: &StructureSource) -> Result<Vec<Kept>, Fault> {
    let path = section.path("kept");
    let nodes = list(&path, node)?;
    if nodes.is_empty() {
        return Err(Cause::EmptyList { key: path }.at(node.place));
    }
    let keys = ["set", "nodes", "directions"];
    let read = |node: &Node| {
        let section = Section::open(node, &path, &format!("an entry of `{path}`"), &keys)?;
        let directions =
            section.get("directions").map(|node| Setting::read(&section, "directions", node, &()));
        let directions = directions.transpose()?.unwrap_or([true; 3]);
        Ok(Kept { nodes: read_nodes(&section, source)?, directions })
    };
    nodes.iter().map(read).collect()
}

/// The nodes that `section` names, by a `set` of a body or by `nodes` of a table of freedoms.
pub(crate) fn read_nodes(section: &Section<'_>, source: &StructureSource) -> Result<KeptNodes, Fault> {
    conflict(section, "set", "nodes")?;
    let key = section.own_path().to_owned();
    let refuse =
        |problem: KeptProblem, node: &Node| Err(StructureProblem::Kept { key, problem }.at(node.place));
    Ok(match (source, section.get("set"), section.get("nodes")) {
        (StructureSource::Body(_), _, Some(node)) => return refuse(KeptProblem::NoNodes, node),
        (StructureSource::Body(_), _, None) => {
            let node = section.required("set", "set = \"…\", a set of nodes")?;
            KeptNodes::Set(text(&section.path("set"), node)?.to_owned())
        }
        (StructureSource::Matrices(_), Some(node), _) => return refuse(KeptProblem::NoSets, node),
        (StructureSource::Matrices(sums), None, _) => {
            let node = section.required("nodes", "nodes = [1, 17], numbers of the table of freedoms")?;
            if sums.freedoms.is_none() {
                return refuse(KeptProblem::NoTable, node);
            }
            KeptNodes::Numbers(whole_numbers(section, "nodes", node, (0, usize::MAX >> 1))?)
        }
    })
}
