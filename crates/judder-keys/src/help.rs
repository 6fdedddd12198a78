//! What would be right: the help line of every cause, the words beside its caret, the key that is to blame.

use crate::cause::{Cause, gibibytes};
use crate::dimension::Dimension;
use crate::memory::Memory;
use crate::nearest::{did_you_mean, nearest};
use crate::quantity::{QuantityError, UNIT_LIST};

impl Cause {
    /// The key that an unknown one most likely means, and its section.
    pub(crate) fn misspelt_key(&self) -> Option<(String, String)> {
        match self {
            Self::UnknownKey { key, section, known } => {
                nearest(key, known).map(|meant| (meant.to_owned(), section.clone()))
            }
            _ => None,
        }
    }

    /// Whether it is that this key lacks in a section of this name.
    pub(crate) fn is_lack_of(&self, meant: &str, of_section: &str) -> bool {
        match self {
            Self::MissingKey { key, section, .. } => key == meant && section == of_section,
            _ => false,
        }
    }

    /// The dotted path of the key that is to blame, where there is one.
    pub fn key(&self) -> Option<&str> {
        match self {
            Self::UnknownKey { key, .. }
            | Self::MissingKey { key, .. }
            | Self::WrongType { key, .. }
            | Self::Quantity { key, .. }
            | Self::WrongDimension { key, .. }
            | Self::NeedsUnit { key, .. }
            | Self::NotFinite { key, .. }
            | Self::NotFiniteExpression { key, .. }
            | Self::OutOfRange { key, .. }
            | Self::NotNumeric { key, .. }
            | Self::KeyTwice { key, .. }
            | Self::EmptyList { key, .. }
            | Self::MatrixShape { key, .. } => Some(key),
            Self::Problem(problem) => problem.key(),
            _ => None,
        }
    }

    /// What stands beside the caret: a few words.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "here",
            Self::UnknownKey { .. } => "unknown key",
            Self::MissingKey { .. } => "in this section",
            Self::WrongType { .. } | Self::MatrixShape { .. } => "wrong type",
            Self::UnknownName { .. } | Self::UnknownTemplate { .. } => "unknown name",
            Self::OtherModel { .. } => "not available here",
            Self::WrongDimension { .. } => "wrong unit",
            Self::MixedDimensions { .. } => "another dimension",
            Self::NeedsUnit { .. } => "no unit",
            Self::NotFinite { .. } | Self::NotFiniteEntry { .. } | Self::NotFiniteExpression { .. } => {
                "not finite"
            }
            Self::OutOfRange { .. } => "out of range",
            Self::Conflict { .. } | Self::KeyTwice { .. } | Self::DuplicateName { .. } => "given twice",
            Self::NotNumeric { .. } => "not a number",
            Self::EmptyRange { .. } | Self::Backwards { .. } | Self::LogThroughZero { .. } => "this range",
            Self::NothingMeasured { .. } => "too long",
            Self::TooFewPoints { .. } => "too few",
            Self::TooLarge { .. } => "too many",
            Self::MixedForms { .. } => "of the other kind",
            Self::File { fault, .. } => fault.label("no such file"),
            Self::OneOfTwo { .. } => "one too many",
            Self::Count { .. } => "out of range",
            Self::Difference { .. } => "not a difference",
            Self::Meaningless { .. } => "without meaning",
            Self::NotMemory { .. } => "not an amount",
            Self::Length { .. } => "wrong length",
            Self::Problem(problem) => problem.label(),
            _ => "here",
        }
    }

    /// What would be right.
    pub fn help(&self) -> Option<String> {
        Some(match self {
            Self::Missing { .. }
            | Self::Folder { .. }
            | Self::NotAFile { .. }
            | Self::TooLong { .. }
            | Self::Empty { .. }
            | Self::Binary { .. } => "`judder new` prints a case file to start from".to_owned(),
            Self::Unreadable { .. } => return None,
            Self::Syntax { message } if !message.contains("quoted") => return None,
            Self::Syntax { .. } => "text and quantities stand in quotes: velocity = \"30 mm/s\"".to_owned(),
            Self::OverrideForm { .. } => {
                "write the dotted key, `=`, the value: --set \"operation.velocity=30 mm/s\"".to_owned()
            }
            Self::UnknownKey { key, known, .. } => did_you_mean(key, known, "keys here"),
            Self::MissingKey { expected, .. } => format!("give {expected}"),
            Self::WrongType { .. } => return None,
            Self::UnknownName { name, known, .. } | Self::UnknownTemplate { name, known } => {
                did_you_mean(name, known, "known")
            }
            Self::OtherModel { known, .. } | Self::NotNumeric { known, .. } => {
                format!("available: {}", known.join(", "))
            }
            Self::Quantity { dimension, problem, .. } => help_for_quantity(*dimension, problem),
            Self::WrongDimension { expected, found, group, .. } => {
                help_for_dimension(*expected, *found, *group)
            }
            Self::NeedsUnit { dimension, .. } => format!("write {}", with_example(*dimension)),
            _ => return self.help_for_values(),
        })
    }

    /// The help of causes that lie in values and ranges rather than in names and units.
    fn help_for_values(&self) -> Option<String> {
        let help = match self {
            Self::Conflict { first, second } | Self::OneOfTwo { first, second } => {
                format!("keep `{first}` or `{second}`")
            }
            Self::OutOfRange { key, .. } if key.ends_with("confidence") => {
                "give a share of one: 0.95 for 95 %".to_owned()
            }
            Self::EmptyRange { .. } => "let `from` and `to` differ".to_owned(),
            Self::Backwards { .. } => "exchange its two ends".to_owned(),
            Self::NothingMeasured { .. } => "let `transient` be shorter than `duration`".to_owned(),
            Self::TooFewPoints { .. } => "count both ends".to_owned(),
            Self::KeyTwice { .. } => "take two different quantities".to_owned(),
            Self::NotFinite { .. } => "nan, inf and numbers beyond 1e308 are not values of a case".to_owned(),
            Self::EmptyList { .. } => "give at least one value, or leave the table out".to_owned(),
            Self::LogThroughZero { .. } => {
                "let both ends have one sign, or use scale = \"linear\"".to_owned()
            }
            Self::MixedDimensions { .. } => "give both in units of the key that varies".to_owned(),
            Self::MixedForms { .. } => "use plain numbers throughout, or units throughout".to_owned(),
            Self::TooLarge { limit, most, .. } => {
                format!("the limit is {}: at most {most} points in all", gibibytes(*limit))
            }
            Self::BadName { .. } => {
                "use 1 to 100 of A-Z a-z 0-9 . _ - and no leading dot: the name becomes a file name"
                    .to_owned()
            }
            Self::DuplicateName { .. } => "give each analysis a `name` of its own".to_owned(),
            Self::ParameterName { .. } => {
                "a letter, then letters, digits or _; functions and pi are taken".to_owned()
            }
            Self::MatrixShape { .. } => "as in [[\"2\", \"1 - mu\"], [1, 2]]".to_owned(),
            Self::Expression { problem, parameters } => problem.help(parameters),
            Self::NotFiniteExpression { .. } => {
                "a number must be finite: mind division by zero, roots and logarithms of negative numbers"
                    .to_owned()
            }
            Self::ExpressionWithoutUnit { text, dimension, group, .. } => {
                let with_unit =
                    format!("{{ expression = \"{text}\", unit = \"{}\" }}", unit_of(&dimension.example()));
                match group {
                    Some(group) => format!("write {with_unit}, or {{ expression = \"{text}\" }} for {group}"),
                    None => format!("write {with_unit}"),
                }
            }
            Self::UnusedParameter { path } => {
                let name = path.rsplit('.').next().unwrap_or(path);
                format!("write it into what shall follow it, as in friction_coefficient = \"0.4*{name}\"")
            }
            Self::NotFiniteEntry { .. } => {
                "an entry must be finite: mind division by zero, roots and logarithms of negative numbers"
                    .to_owned()
            }
            Self::File { fault, .. } => {
                fault.help("a path in a case is relative to the folder of the case file").to_owned()
            }
            Self::Count { from, to, .. } => format!("give a number from {from} to {to}"),
            Self::Difference { example, .. } => format!("write a difference: \"{example}\""),
            Self::Meaningless { key, .. } => format!("leave `{key}` out"),
            Self::Length { expected, .. } => format!("give {expected}"),
            Self::NotMemory { .. } => format!("write {}", Memory::form()),
            Self::Problem(problem) => return problem.help(),
            _ => return None,
        };
        Some(help)
    }
}

fn with_example(dimension: Dimension) -> String {
    format!("{dimension}, such as \"{}\"", dimension.example())
}

/// The unit of an example, which is `10 mm`, or several such quantities with words between.
fn unit_of(example: &str) -> &str {
    let first = example.split('"').next().unwrap_or(example);
    first.split_once(' ').map_or("", |(_, unit)| unit)
}

fn help_for_quantity(dimension: Dimension, problem: &QuantityError) -> String {
    match problem {
        QuantityError::UnknownUnit { .. } => {
            format!("write {}; known units: {UNIT_LIST}", with_example(dimension))
        }
        QuantityError::FactorAfterQuotient => "write one `/` before each divisor: J/kg/s".to_owned(),
        _ => format!("write {}", with_example(dimension)),
    }
}

fn help_for_dimension(expected: Dimension, found: Dimension, group: Option<&str>) -> String {
    match group {
        Some(group) if found.is_number() => {
            format!("without quotes it is {group}; with a unit, {}", with_example(expected))
        }
        Some(group) => format!("write {}, or a plain number: {group}", with_example(expected)),
        None => format!("write {}", with_example(expected)),
    }
}
