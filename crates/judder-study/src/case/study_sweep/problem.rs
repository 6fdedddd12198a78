//! What can be wrong with a sweep of whole studies, beyond types, units and ranges.

use thiserror::Error;

use judder_keys::nearest::did_you_mean;
use judder_keys::problem::Problem;
use judder_keys::quantity::QuantityError;

/// What is wrong, with what a caller needs in order to act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SweepProblem {
    /// A name that cannot be a folder of results.
    #[error("`{name}` cannot name a sweep")]
    Name {
        /// The name as written.
        name: String,
    },
    /// A name that an analysis or another sweep has.
    #[error("`{name}` names both this sweep and {other}")]
    NameTwice {
        /// The name; names that differ only in case count as one.
        name: String,
        /// `an analysis` or `another sweep`.
        other: &'static str,
    },
    /// A text that should be a value of a swept key.
    #[error("`{key}` is not a quantity: {problem}")]
    NotQuantity {
        /// The key.
        key: String,
        /// Why it is none.
        problem: QuantityError,
    },
    /// A path that no number of a case can have.
    #[error("`{key}` cannot be swept")]
    NotSwept {
        /// The key as written.
        key: String,
    },
    /// Something else than a key of the case that a sweep should vary.
    #[error("`{key}` cannot be swept: {reason}")]
    Key {
        /// The key as written.
        key: String,
        /// What is wrong with it.
        reason: String,
        /// What would be right.
        advice: String,
    },
    /// Values of swept keys with which the case cannot be.
    #[error("with {settings}: {reason}")]
    Value {
        /// The keys to blame with their values, as in `` `contact.shear_strength` = -1 ``.
        settings: String,
        /// What is wrong then.
        reason: String,
        /// What would be right.
        advice: String,
    },
    /// One number of the case that is swept twice.
    #[error("`{second}` is swept twice{}", if first == second { String::new() } else { format!(": `{first}` says the same") })]
    KeyTwice {
        /// The first key.
        first: String,
        /// The second key.
        second: String,
    },
    /// One value that stands twice along an axis of a grid.
    #[error("`{key}` is {value} twice")]
    ValueTwice {
        /// The key.
        key: String,
        /// The value with its unit.
        value: String,
    },
    /// A total number of points beside a grid.
    #[error("`points` has no meaning with method = \"grid\"")]
    PointsOfGrid,
    /// Lists that should go together and do not.
    #[error("`{first}` has {values} values, but `{second}` has {found}")]
    Lengths {
        /// The first key.
        first: String,
        /// How many values it has.
        values: usize,
        /// The key of another length.
        second: String,
        /// How many values that has.
        found: usize,
    },
    /// More keys than there are dimensions of points.
    #[error("{found} keys are swept, but this method takes {limit} at most")]
    TooManyKeys {
        /// How many are swept.
        found: usize,
        /// How many can be.
        limit: usize,
    },
    /// More points than can be told apart.
    #[error("{shape} points are more than {limit:e}")]
    TooManyPoints {
        /// The number, with its factors where there are several: `40000 × 25000 = 1000000000`.
        shape: String,
        /// The number of points.
        points: u128,
        /// How many there can be.
        limit: f64,
    },
    /// Sensitivity of a design that is not drawn at random.
    #[error("`sensitivity` has no meaning with method = \"{method}\"")]
    SensitivityOf {
        /// `grid` or `list`.
        method: &'static str,
    },
    /// A probability over points that are not drawn at random.
    #[error("`probabilities` have no meaning with method = \"{method}\"")]
    ProbabilityOf {
        /// `grid` or `list`.
        method: &'static str,
    },
    /// A condition that no quantity of the sweep can be asked.
    #[error("no probability of `{quantity}`: {reason}")]
    Condition {
        /// The quantity as written.
        quantity: String,
        /// What is wrong with it.
        reason: String,
        /// The quantities of the sweep.
        known: Vec<String>,
    },
    /// A condition on nothing.
    #[error("an entry of `probabilities` names no `quantity`")]
    NoQuantity {
        /// The quantities of the sweep.
        known: Vec<String>,
    },
    /// A text that does not lead to a number.
    #[error("`{path}` is not the path of a quantity: {reason}")]
    QuantityPath {
        /// The path as written.
        path: String,
        /// Why not.
        reason: &'static str,
    },
    /// One quantity that is asked for twice.
    #[error("the quantity `{path}` stands twice")]
    QuantityTwice {
        /// The path.
        path: String,
    },
    /// A quantity of an analysis that the case does not have.
    #[error("`{path}`: there is no analysis `{name}`")]
    UnknownAnalysis {
        /// The path as written.
        path: String,
        /// What stands before its first dot.
        name: String,
        /// The analyses that there are.
        known: Vec<String>,
    },
    /// A name that no quantity of an operating point of this model has.
    #[error("no operating point of this model has a quantity `{name}`")]
    UnknownQuantity {
        /// The name as written.
        name: String,
        /// The quantities that there are.
        known: Vec<String>,
    },
    /// A name that the results of an analysis do not have.
    #[error("`{path}`: there is no result `{name}`")]
    UnknownResult {
        /// The path as written.
        path: String,
        /// The step that leads nowhere.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// A path through results that does not end at a number.
    #[error("`{path}` is not the path of a number: {reason}")]
    NoNumber {
        /// The path as written.
        path: String,
        /// Why not.
        reason: &'static str,
        /// What would be right.
        advice: String,
    },
    /// Values that are not one a swept key.
    #[error("a point of the sweep `{name}` has {expected} values, but {found} are given")]
    ValueCount {
        /// The name of the sweep.
        name: String,
        /// How many keys are swept.
        expected: usize,
        /// How many values are given.
        found: usize,
    },
}

impl Problem for SweepProblem {
    fn kind(&self) -> &'static str {
        "StudySweep"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::Name { .. } => "this name",
            Self::NameTwice { .. }
            | Self::KeyTwice { .. }
            | Self::ValueTwice { .. }
            | Self::QuantityTwice { .. } => "given twice",
            Self::NotQuantity { .. } => "no quantity",
            Self::NotSwept { .. } | Self::Key { .. } => "not to be swept",
            Self::Value { .. } => "a value of this sweep",
            Self::PointsOfGrid | Self::SensitivityOf { .. } | Self::ProbabilityOf { .. } => "without meaning",
            Self::Lengths { .. } => "of another length",
            Self::TooManyKeys { .. } | Self::TooManyPoints { .. } => "too many",
            Self::Condition { .. } | Self::NoQuantity { .. } => "this condition",
            Self::QuantityPath { .. } => "no path",
            Self::NoNumber { .. } => "no number",
            Self::UnknownAnalysis { .. } | Self::UnknownQuantity { .. } | Self::UnknownResult { .. } => {
                "unknown name"
            }
            Self::ValueCount { .. } => "this sweep",
        }
    }

    fn help(&self) -> Option<String> {
        Some(self.advice())
    }
}

impl SweepProblem {
    /// Whether a path is well written, and there is no such number.
    pub(super) fn is_of_results(&self) -> bool {
        matches!(self, Self::UnknownQuantity { .. } | Self::UnknownResult { .. } | Self::NoNumber { .. })
    }

    /// What would be right.
    fn advice(&self) -> String {
        let help = match self {
            Self::Name { .. } => {
                "use 1 to 100 of A-Z a-z 0-9 . _ - and no dot at either end: the name becomes a folder"
            }
            Self::NameTwice { .. } => "give each analysis and each sweep a `name` of its own",
            Self::NotQuantity { .. } => "write a plain number, or a number with a unit in quotes: \"10 mm\"",
            Self::NotSwept { .. } => {
                "give the dotted path of a number of the case: operation.velocity, structure.NAME.width, analysis.NAME.tolerance"
            }
            Self::Key { advice, .. } | Self::Value { advice, .. } | Self::NoNumber { advice, .. } => advice,
            Self::KeyTwice { .. } => "sweep each number once",
            Self::ValueTwice { .. } => "give each value of an axis once",
            Self::PointsOfGrid => {
                "give each key its own: over = [{ key = …, from = …, to = …, points = 21 }, …]; or use method = \"sobol\""
            }
            Self::Lengths { .. } => {
                "a list takes one value of each key a point; for all combinations, use method = \"grid\""
            }
            Self::TooManyKeys { .. } => {
                "sweep fewer keys; with `sensitivity` a point takes two coordinates a key"
            }
            Self::TooManyPoints { .. } => "take fewer points",
            Self::SensitivityOf { .. } | Self::ProbabilityOf { .. } => {
                "leave it out, or use method = \"sobol\" or \"latin-hypercube\", whose points fill the ranges evenly"
            }
            Self::QuantityPath { .. } => {
                "write a name such as growth_rate, or ANALYSIS.PATH: cycle.rms, thresholds.full.0.min, modes.frequencies_hz.0"
            }
            Self::Condition { known, .. } | Self::NoQuantity { known } => return condition(known),
            Self::QuantityTwice { .. } => "ask for each quantity once",
            Self::UnknownQuantity { name, known } if !known.is_empty() => {
                return did_you_mean(name, known, "quantities");
            }
            Self::UnknownQuantity { .. } => {
                "this model has results of analyses alone: ANALYSIS.PATH, such as modes.frequencies_hz.0"
            }
            Self::UnknownResult { name, known, .. } => return did_you_mean(name, known, "results here"),
            Self::UnknownAnalysis { name, known, .. } if !known.is_empty() => {
                return did_you_mean(name, known, "analyses");
            }
            Self::UnknownAnalysis { .. } => {
                "the case has no analysis: give one in [[analysis]], or a quantity of the point, without a dot"
            }
            Self::ValueCount { .. } => "give one value a swept key, in the order of `over`",
        };
        help.to_owned()
    }
}

/// How a condition on one of these quantities is written.
fn condition(known: &[String]) -> String {
    let first = known.first().map_or("ANALYSIS.PATH", String::as_str);
    let list = known.join(", ");
    format!(
        "name one of the `quantities` of this sweep, {list}, with a bound, {{ quantity = \"{first}\", above = 0 }}, or of a class which it is"
    )
}
