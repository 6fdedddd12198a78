//! `[reduction]`: which freedoms are kept, and how many modes with them held.

use super::problem::{KeptProblem, StructureProblem};
use super::{Matrices, StructureSource};
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, Several, UNLIMITED, Whole, all};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list, text};

/// What a Craig–Bampton reduction keeps.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct ReductionSettings {
    /// Freedoms that are kept.
    #[key(rule = KEPT, filled)]
    pub kept: Vec<KeptFreedoms>,
    /// The fixed-interface modes that are kept.
    #[key(flatten)]
    pub modes: FixedModes,
}

/// Freedoms that are kept.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct KeptFreedoms {
    /// Whose freedoms they are.
    #[key(flatten)]
    pub nodes: KeptNodes,
    /// Directions in which they are kept; all that are free where left out.
    #[key(default = [true; 3])]
    pub directions: [bool; 3],
}

/// Nodes that a case names.
#[derive(Debug, Clone, PartialEq, Settings)]
pub enum KeptNodes {
    /// A set of nodes of a body, or a node of arrays by its name.
    #[key(later)]
    Set(String),
    /// Of matrices, in place of set: nodes of the table of freedoms, by their numbers in it.
    #[key(name = "nodes", rule = NUMBERS)]
    Numbers(Vec<usize>),
}

/// How many fixed-interface modes are kept.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum FixedModes {
    /// So many fixed-interface modes are kept, from the lowest on, where no cut-off is given.
    #[key(rule = Whole { from: 1, to: FIXED_MODES_LIMIT }, default = FIXED_MODES)]
    Count(usize),
    /// Fixed-interface modes up to this frequency are kept.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω_c")]
    CutOff(f64),
}

pub(crate) const KEPT: Several<()> = Several { of: (), length: [1, usize::MAX] };
const NUMBERS: Several<Whole> = Several { of: Whole { from: 0, to: UNLIMITED }, length: [0, usize::MAX] };

/// The number of fixed-interface modes where the case does not say: that of the beams paper.
pub const FIXED_MODES: usize = 20;

/// The most fixed-interface modes.
pub const FIXED_MODES_LIMIT: usize = 2000;

impl ReductionSettings {
    /// Refuses kept freedoms that a structure from `source` cannot have.
    pub(crate) fn admit(&self, section: &Section<'_>, source: &StructureSource) -> Result<(), Fault> {
        let Some(node) = section.get("kept") else { return Ok(()) };
        let path = section.path("kept");
        let nodes = list(&path, node)?;
        if nodes.is_empty() {
            return Err(Cause::EmptyList { key: path }.at(node.place));
        }
        let title = format!("an entry of `{path}`");
        let admitted =
            nodes.iter().map(|node| KeptNodes::admit(&Section::of_table(node, &path, &title)?, source));
        all(admitted).map(drop)
    }
}

impl KeptNodes {
    /// The nodes in words.
    pub(crate) fn words(&self) -> String {
        match self {
            Self::Set(set) => set.clone(),
            Self::Numbers(nodes) => nodes.iter().map(usize::to_string).collect::<Vec<_>>().join(", "),
        }
    }

    /// Refuses a `section` that names nodes otherwise than those of `source` are: by a set of a body, by numbers of a table of freedoms, by
    /// a name that arrays have.
    pub(crate) fn admit(section: &Section<'_>, source: &StructureSource) -> Result<(), Fault> {
        let (problem, node) = match (source, section.get("set"), section.get("nodes")) {
            (StructureSource::Body(_), _, Some(node)) => (KeptProblem::NoNodes, node),
            (StructureSource::Body(_), ..) => {
                return section.required("set", "set = \"…\", a set of nodes").map(drop);
            }
            (StructureSource::Matrices(Matrices::Arrays(_)), _, Some(node)) => (KeptProblem::NoNumbers, node),
            (StructureSource::Matrices(Matrices::Arrays(arrays)), ..) => {
                let known = arrays.nodes();
                let expected = format!("set = \"…\", one of {}", known.join(", "));
                let node = section.required("set", &expected)?;
                let name = text(&section.path("set"), node)?;
                return match known.iter().any(|own| own == name) {
                    true => Ok(()),
                    false => {
                        Err(Cause::UnknownName { what: "node", name: name.to_owned(), known }.at(node.place))
                    }
                };
            }
            (StructureSource::Matrices(Matrices::Files(_)), Some(node), _) => (KeptProblem::NoSets, node),
            (StructureSource::Matrices(Matrices::Files(sums)), ..) => {
                let node = section.required("nodes", "nodes = [1, 17], numbers of the table of freedoms")?;
                if sums.freedoms.is_some() {
                    return Ok(());
                }
                (KeptProblem::NoTable, node)
            }
        };
        let key = section.own_path().to_owned();
        Err(StructureProblem::Kept { key, problem }.at(node.place))
    }
}
