//! What can be wrong with a sliding case, beyond types, units and ranges.

use judder_numerics::words::plain;
use thiserror::Error;

use judder_keys::problem::Problem;

/// What is wrong, with what a caller needs in order to act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SlidingProblem {
    /// Another number of structures than two.
    #[error("a sliding case has two structures, this one has {found}")]
    StructureCount {
        /// How many there are.
        found: usize,
    },
    /// A name that a dotted path could not hold.
    #[error("`{name}` cannot name a {what}")]
    Name {
        /// What it should name.
        what: &'static str,
        /// The name as written.
        name: String,
    },
    /// Two things of one name.
    #[error("there are two {what}s named `{name}`")]
    NameTwice {
        /// What they are.
        what: &'static str,
        /// Their name.
        name: String,
    },
    /// Matrices that stand in the case, whose nodes have no edge to slide on.
    #[error("the matrices of `{name}` are arrays, but those of a sliding case are files")]
    Arrays {
        /// The structure.
        name: String,
    },
    /// A structure that would slide on itself.
    #[error("`{name}` is both the slider and the track")]
    SameStructure {
        /// Its name.
        name: String,
    },
    /// Nodes where one node is meant.
    #[error("`{key}` names {found} nodes, but must name one")]
    NotOneNode {
        /// The key.
        key: String,
        /// How many nodes it names.
        found: usize,
    },
    /// A place where a structure has no node.
    #[error(
        "`{key}` is ({}, {}) m, but the nearest node of the structure lies at ({}, {}) m",
        plain(place[0]), plain(place[1]), plain(nearest[0]), plain(nearest[1])
    )]
    NoNodeThere {
        /// The key.
        key: String,
        /// The place that was given, m.
        place: [f64; 2],
        /// Where the nearest node is, m.
        nearest: [f64; 2],
    },
    /// More points than a march can watch.
    #[error("{found} points of `{structure}` are observed, but a march watches {limit} of it at most")]
    TooManyPoints {
        /// The structure.
        structure: String,
        /// How many points of it are observed.
        found: usize,
        /// How many can be.
        limit: usize,
    },
    /// A list of nodes that is not an edge along which something could slide.
    #[error("the track `{name}` {reason}")]
    Track {
        /// The set, or the nodes, as the case has it.
        name: String,
        /// Why not.
        reason: String,
    },
    /// A contact point that the track does not reach.
    #[error("`{key}` is {position} m, but the track goes from 0 to {length} m")]
    OffTrack {
        /// The key.
        key: String,
        /// s, m.
        position: f64,
        /// The length of the track, m.
        length: f64,
    },
    /// A velocity that does not lead from the start to the end.
    #[error("a velocity of {velocity} m/s does not lead from {start} m to {end} m")]
    NoCourse {
        /// s_0, m.
        start: f64,
        /// s_1, m.
        end: f64,
        /// v_x, m/s.
        velocity: f64,
    },
    /// A position that the motion does not pass.
    #[error("`{key}` is {position} m, but the motion goes from {start} m to {end} m")]
    OutsidePath {
        /// The key.
        key: String,
        /// s, m.
        position: f64,
        /// s_0, m.
        start: f64,
        /// s_1, m.
        end: f64,
    },
    /// A name of an analysis above, where there is none of the kind.
    #[error("there is no {what} above that could be `{name}`")]
    NothingAbove {
        /// The kind.
        what: &'static str,
        /// The name as written.
        name: String,
    },
    /// A signal that a march does not keep.
    #[error("the march `{march}` does not keep the signal `{signal}`")]
    NotKept {
        /// The name of the march.
        march: String,
        /// The name of the signal.
        signal: String,
        /// What of the motion of a point it is.
        quantity: &'static str,
    },
    /// Samples too few for the band that they shall carry, or more than there are steps.
    #[error("samples at {sample_rate:.0} Hz {reason}")]
    SampleRate {
        /// f_s, Hz.
        sample_rate: f64,
        /// Why not.
        reason: String,
    },
    /// A march that would take too long.
    #[error("this march takes {steps:.2e} steps, and {limit:.0e} are allowed")]
    TooManySteps {
        /// How many it takes.
        steps: f64,
        /// How many are allowed.
        limit: f64,
    },
    /// A step beyond the limit of stability.
    #[error("the step {} s is above the limit of stability, {} s", plain(*step), plain(*limit))]
    StepLimit {
        /// h, s.
        step: f64,
        /// The limit, s.
        limit: f64,
    },
    /// Structures, contact or motion that do not go together.
    #[error("{reason}")]
    Unbuilt {
        /// What is wrong.
        reason: String,
        /// What would be right.
        advice: &'static str,
    },
}

/// Share of the limit of a step that is recommended; two digits of it stay below the limit.
const SHARE: f64 = 0.9;

impl Problem for SlidingProblem {
    fn kind(&self) -> &'static str {
        "Sliding"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::StructureCount { .. } => "not two",
            Self::Name { .. } => "this name",
            Self::NameTwice { .. } => "given twice",
            Self::Arrays { .. } => "not in a sliding case",
            Self::SameStructure { .. } => "the same structure",
            Self::NotOneNode { .. } => "not one node",
            Self::NoNodeThere { .. } => "outside the structure",
            Self::TooManyPoints { .. } => "too many",
            Self::Track { .. } => "no edge",
            Self::OffTrack { .. } => "off the track",
            Self::NoCourse { .. } => "leads elsewhere",
            Self::OutsidePath { .. } => "not on the path",
            Self::NothingAbove { .. } => "unknown name",
            Self::NotKept { .. } => "not kept",
            Self::SampleRate { .. } => "this rate",
            Self::TooManySteps { .. } => "too long",
            Self::StepLimit { .. } => "too large",
            Self::Unbuilt { .. } => "here",
        }
    }

    fn help(&self) -> Option<String> {
        Some(self.advice())
    }
}

impl SlidingProblem {
    /// What would be right.
    fn advice(&self) -> String {
        let help = match self {
            Self::StructureCount { .. } => {
                "give two tables [[structure]]: what slides, and on what it slides"
            }
            Self::Name { .. } => {
                "use 1 to 100 of A-Z a-z 0-9 _ -: keys such as structure.NAME.width contain it"
            }
            Self::Arrays { .. } => {
                "write them to files, or take `model = \"assembly\"`, whose bodies may be arrays"
            }
            Self::NameTwice { what, .. } => return format!("give each {what} a `name` of its own"),
            Self::SameStructure { .. } => "let one structure slide on the other",
            Self::NotOneNode { .. } => {
                "of a beam, `end-lower` or another corner is a set of one node; an observed point can be given by its place: at = [\"50 mm\", \"1 mm\"]"
            }
            Self::NoNodeThere { .. } => "give a place on the undeformed structure, as it is drawn",
            Self::TooManyPoints { .. } => "observe fewer points in one case, others in another",
            Self::Track { .. } => {
                "name the nodes of one edge in their order, as `upper-corners` of a beam has them"
            }
            Self::OffTrack { .. } => "let C stay between the first and the last node of the track",
            Self::NoCourse { .. } => {
                "the velocity is positive where `end` lies beyond `start`, negative where it lies before it"
            }
            Self::OutsidePath { .. } => "a march is a part of the motion, in its direction",
            Self::NothingAbove { what, .. } => return format!("let the {what} stand before what shows it"),
            Self::NotKept { march, quantity, .. } => {
                return format!(
                    "let the march `{march}` keep it: signals = {{ quantities = [\"{quantity}\"] }}"
                );
            }
            Self::SampleRate { .. } => {
                "1/step ≥ sample_rate > 2 pass_band; at 3e-7 s, 400 kHz carry 50 kHz with room for the filter"
            }
            Self::TooManySteps { .. } => "take a shorter path, a larger step or a higher velocity",
            Self::StepLimit { limit, .. } => {
                return format!(
                    "take a step below the limit, such as \"{:.1e} s\", or leave `step` out: the march then chooses one",
                    SHARE * limit
                );
            }
            Self::Unbuilt { advice, .. } => advice,
        };
        help.to_owned()
    }
}
