//! What can be wrong with a structure case, beyond types, units and ranges.

use std::path::PathBuf;

use thiserror::Error;

use judder_keys::file_reference::PathFault;
use judder_keys::nearest::did_you_mean;
use judder_keys::problem::Problem;
use judder_memory::BeyondMemory;
use judder_structure::element::ElementKind;

/// What is wrong, with what a caller needs in order to act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StructureProblem {
    /// Matrices of elements, or what is made of them, that would take more memory than there is.
    #[error("this structure: {source}")]
    Memory {
        /// How much, and how much there is.
        source: BeyondMemory,
    },
    /// A case without a structure.
    #[error("a structure case needs `[structure]` or `[matrices]`")]
    NoStructure,
    /// None or several of the ways to describe a body.
    #[error("{section} has {}, but takes one of `beam`, `block`, `disc`, `mesh`", listed(found))]
    OneGeometry {
        /// The section as an error names it.
        section: String,
        /// The keys that are there.
        found: Vec<&'static str>,
    },
    /// A disc of elements that make none.
    #[error("a disc is made of eight-node or twenty-node bricks, not of {kind}s")]
    DiscElement {
        /// The shape.
        kind: ElementKind,
    },
    /// A band of a disc that is not within it.
    #[error("the band is not within the disc, whose radii are {inner} and {outer} m")]
    BeyondDisc {
        /// Of the disc, m.
        inner: f64,
        /// Of the disc, m.
        outer: f64,
    },
    /// A sector of a turn or more.
    #[error("the sector is a turn or more, which leaves nothing of the disc beside it")]
    WholeTurn,
    /// An axis of turning without a direction.
    #[error("`{key}` is an axis without a direction")]
    NoAxis {
        /// The key.
        key: String,
    },
    /// An axis of turning that leads a body of the plane out of it.
    #[error("`{key}` would turn a block of the plane out of its plane")]
    OutOfPlane {
        /// The key.
        key: String,
    },
    /// A key that a generated body needs.
    #[error("{what} needs `{key}`")]
    Needs {
        /// What needs it.
        what: &'static str,
        /// The key.
        key: &'static str,
        /// What its value would be.
        example: &'static str,
    },
    /// A mesh file of a format that is not read.
    #[error("`{key}` names `{}`, which is of no format that is read", path.display())]
    Format {
        /// The key.
        key: String,
        /// The file.
        path: PathBuf,
        /// The endings that are known.
        known: String,
    },
    /// A support that holds nothing.
    #[error("the support of set `{set}` neither fixes nor ties a direction")]
    EmptySupport {
        /// The set of nodes.
        set: String,
    },
    /// A folder that is not there.
    #[error("`{key}` names `{}`, which {fault}", path.display())]
    Folder {
        /// The key.
        key: String,
        /// Where the folder was looked for.
        path: PathBuf,
        /// Why not.
        fault: PathFault,
    },
    /// A factor of a matrix that gives NaN or an infinity.
    #[error("the factor of `{file}` is {value}{}{point}", if point.is_empty() { "" } else { ", at " })]
    Factor {
        /// The file of the matrix.
        file: String,
        /// What the expression gave.
        value: f64,
        /// The parameters that the factor depends on, as in `speed = 0`; empty where there are none.
        point: String,
    },
    /// A sweep of a structure that has no parameters.
    #[error("there is nothing to sweep: only factors and entries of `[matrices]` depend on parameters")]
    NothingToSweep,
    /// A swept parameter that no factor and no entry contains.
    #[error("no factor and no entry of a matrix contains the parameter `{name}`")]
    IdleParameter {
        /// The parameter.
        name: String,
    },
    /// Values of a sweep that go to and fro.
    #[error("the values of `sweep.values` must ascend or descend")]
    UnsortedValues,
    /// A set that the mesh does not have.
    #[error("there is no set of nodes named `{name}`")]
    UnknownSet {
        /// The name as written.
        name: String,
        /// The sets that there are.
        known: Vec<String>,
    },
    /// A material under a name that the mesh does not have.
    #[error("the mesh has no group and no material named `{name}`")]
    UnknownGroup {
        /// The name as written.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// Elements of which neither case nor mesh say what they are made of.
    #[error("the elements of `{name}` have no material")]
    NoMaterial {
        /// The name of their group.
        name: String,
    },
    /// A node that the table of freedoms does not have.
    #[error("the table of freedoms has no node {node}")]
    UnknownNode {
        /// The number as written.
        node: usize,
    },
    /// Freedoms that are kept twice, or none that are free.
    #[error("`reduction.kept` names {what}")]
    KeptFreedoms {
        /// What is wrong with them.
        what: &'static str,
    },
    /// A file that cannot be used.
    #[error("{reason}")]
    File {
        /// Which file, what is wrong with it, and where.
        reason: String,
    },
    /// Elements, materials or supports that cannot be together.
    #[error("{reason}")]
    Unbuilt {
        /// What is wrong.
        reason: String,
    },
    /// A kept set where there are no sets, or nodes where there is no table of freedoms.
    #[error("{}", kept(problem, key))]
    Kept {
        /// The key.
        key: String,
        /// What is wrong with it.
        problem: KeptProblem,
    },
    /// Fewer or more damping ratios than the two that fix α and β.
    #[error("the damping ratios {first} at {} Hz and {second} at {} Hz need a negative coefficient", hertz(*first_frequency), hertz(*second_frequency))]
    NegativeDamping {
        /// ζ at the lower frequency.
        first: f64,
        /// The lower frequency, rad/s.
        first_frequency: f64,
        /// ζ at the higher frequency.
        second: f64,
        /// The higher frequency, rad/s.
        second_frequency: f64,
    },
}

/// How nodes that a case names do not fit the structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum KeptProblem {
    /// A set of matrices.
    NoSets,
    /// Numbers of nodes of a body.
    NoNodes,
    /// Numbers of nodes of arrays, which have names.
    NoNumbers,
    /// Numbers of nodes without `matrices.freedoms`.
    NoTable,
}

fn kept(problem: &KeptProblem, key: &str) -> String {
    match problem {
        KeptProblem::NoSets => {
            format!("matrices have no sets: `{key}` names nodes of the table `matrices.freedoms`")
        }
        KeptProblem::NoNodes => format!("`{key}` of a body names sets, not nodes"),
        KeptProblem::NoNumbers => {
            format!("`{key}` of arrays names a node of `matrices.freedoms`, not a number")
        }
        KeptProblem::NoTable => {
            format!("`{key}` names nodes, but `matrices.freedoms` does not say which freedoms they have")
        }
    }
}

fn listed(found: &[&str]) -> String {
    match found {
        [] => "none".to_owned(),
        _ => found.iter().map(|key| format!("`{key}`")).collect::<Vec<_>>().join(" and "),
    }
}

fn hertz(angular: f64) -> f64 {
    angular / std::f64::consts::TAU
}

impl Problem for StructureProblem {
    fn kind(&self) -> &'static str {
        "Structure"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::Memory { .. } => "too many",
            Self::NoStructure | Self::Needs { .. } => "in this section",
            Self::OneGeometry { .. } => "one of four",
            Self::DiscElement { .. } => "no bricks",
            Self::BeyondDisc { .. } => "beyond the disc",
            Self::WholeTurn => "too wide",
            Self::NoAxis { .. } => "no direction",
            Self::OutOfPlane { .. } => "out of the plane",
            Self::Format { .. } => "unknown format",
            Self::EmptySupport { .. } => "without effect",
            Self::Folder { fault, .. } => fault.label("no such folder"),
            Self::Factor { .. } => "not finite",
            Self::NothingToSweep | Self::IdleParameter { .. } => "without effect",
            Self::UnsortedValues => "not in order",
            Self::UnknownSet { .. } => "unknown set",
            Self::UnknownGroup { .. } => "unknown name",
            Self::NoMaterial { .. } => "in this section",
            Self::UnknownNode { .. } => "unknown node",
            Self::KeptFreedoms { .. } => "these freedoms",
            Self::File { .. } => "this file",
            Self::Unbuilt { .. } => "here",
            Self::Kept { .. } => "not here",
            Self::NegativeDamping { .. } => "these ratios",
        }
    }

    fn help(&self) -> Option<String> {
        self.advice()
    }
}

impl StructureProblem {
    /// What would be right.
    fn advice(&self) -> Option<String> {
        Some(match self {
            Self::Memory { source } => source.remedy(),
            Self::NoStructure => {
                "give [structure] with beam = { … }, block = { … }, disc = { … } or mesh = \"file.msh\", or [matrices] with mass = [{ file = \"…\" }]"
                    .to_owned()
            }
            Self::OneGeometry { .. } => {
                "as in beam = { length = \"100 mm\", thickness = \"2 mm\", elements = [100, 2] }".to_owned()
            }
            Self::DiscElement { .. } => "give element = \"hexahedron8\" or \"hexahedron20\"".to_owned(),
            Self::BeyondDisc { .. } => "give radii between those of the disc".to_owned(),
            Self::WholeTurn => "for even cells all around leave the sector out: `cells` has how many".to_owned(),
            Self::NoAxis { .. } => "give a number other than zero, as in axis = [0, 1, 0]".to_owned(),
            Self::OutOfPlane { .. } => "leave axis out: in the plane it is [0, 0, 1]".to_owned(),
            Self::Needs { example, .. } => format!("give {example}"),
            Self::Format { known, .. } => format!("known endings: {known}"),
            Self::EmptySupport { .. } => "give fixed = [\"x\", \"y\"] or tied = [\"y\"]".to_owned(),
            Self::Folder { fault, .. } => fault
                .help("a folder in a case is relative to the case file, one in `--set` to where the program runs")
                .to_owned(),
            Self::Factor { .. } => "a factor must be finite: mind division by zero".to_owned(),
            Self::NothingToSweep => {
                "take matrices with factors such as \"1/speed - 1\", or run the case once a value with `--set`"
                    .to_owned()
            }
            Self::IdleParameter { .. } => "sweep a parameter that a factor or an entry contains".to_owned(),
            Self::UnsortedValues => "branches are followed from one value to the next: sort them".to_owned(),
            Self::UnknownSet { name, known } => did_you_mean(name, known, "sets here"),
            Self::UnknownGroup { name, known } => did_you_mean(name, known, "names here"),
            Self::NoMaterial { name } => format!("give material = {{ … }} or materials = {{ {name} = {{ … }} }}"),
            Self::UnknownNode { .. } => "name nodes that the table has".to_owned(),
            Self::KeptFreedoms { .. } => "name free freedoms, each once".to_owned(),
            Self::File { .. } => "mend the file, or name another; it is read as its ending says".to_owned(),
            // its reason says it
            Self::Unbuilt { .. } => return None,
            Self::Kept { problem: KeptProblem::NoSets, .. } => "as in nodes = [1, 17]".to_owned(),
            Self::Kept { problem: KeptProblem::NoNodes, .. } => "as in set = \"end\"".to_owned(),
            Self::Kept { problem: KeptProblem::NoNumbers, .. } => "as in set = \"mass\"".to_owned(),
            Self::Kept { problem: KeptProblem::NoTable, .. } => {
                "give freedoms = \"table.csv\" with the matrices".to_owned()
            }
            Self::NegativeDamping { .. } => "move the ratios closer to one another".to_owned(),
        })
    }
}
