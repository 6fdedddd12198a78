//! Any number of a case that varies: how its values are read, and how one is put back into the case.

use crate::case::scale::Spacing;
use crate::case::study_sweep::problem::SweepProblem;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Number, Setting, Several, Whole, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::problem::Placed;
use judder_keys::quantity::Quantity;
use judder_keys::section::{Section, finite_number, list, wrong_type};
use serde_json::Value as Json;

/// A value with its unit.
pub fn shown(value: f64, dimension: Dimension) -> String {
    if dimension.is_number() { value.to_string() } else { format!("{value} {}", dimension.unit()) }
}

/// A value as a case file would have it.
pub fn written(value: f64, dimension: Dimension) -> Data {
    if !dimension.is_number() {
        return Data::Text(format!("{value:?} {}", dimension.unit()));
    }
    // a count stays one
    let whole = (value.fract() == 0.0 && value.abs() < 1e15).then_some(value as i64);
    Data::Number { value, whole }
}

/// A number of the case that varies: over a range of so many points at most, or with these values.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct VariedKey<const MOST: usize> {
    /// Dotted path of any number of the case; an item of a list goes by its name.
    #[key(later)]
    pub key: String,
    /// First value.
    #[key(omitted)]
    pub from: Option<AnyNumber>,
    /// Last value.
    #[key(omitted)]
    pub to: Option<AnyNumber>,
    /// How many values, both ends included.
    #[key(rule = Whole { from: 2, to: MOST }, omitted)]
    pub points: Option<usize>,
    /// Spacing of the values.
    #[key(usual = Spacing::Linear, omitted)]
    pub scale: Option<Spacing>,
    /// In place of a range.
    #[key(rule = Several { of: (), length: [1, usize::MAX] }, omitted)]
    pub values: Option<Vec<AnyNumber>>,
}

/// A plain number, or a quantity in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnyNumber {
    /// The number.
    pub value: f64,
    /// Its dimension.
    pub dimension: Dimension,
}

impl Setting for AnyNumber {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Quantity
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let key = section.path(key);
        match &node.data {
            Data::Number { .. } => {
                let (value, dimension) = (finite_number(&key, node)?, Dimension::NUMBER);
                Ok(Self { value, dimension })
            }
            Data::Text(text) => match Quantity::parse(text) {
                Ok(Quantity { number: value, dimension }) => Ok(Self { value, dimension }),
                Err((problem, range)) => Err(SweepProblem::NotQuantity { key, problem }.at(node.part(range))),
            },
            _ => Err(wrong_type(&key, "a plain number or a quantity in quotes", node)),
        }
    }

    fn write(&self, (): &()) -> Json {
        self.value.write(&Number::any(self.dimension))
    }
}

/// The ends of a range that differ, in one dimension.
pub struct Ends {
    /// The first value and the last.
    pub values: [f64; 2],
    /// Their dimension.
    pub dimension: Dimension,
    /// How the values between are spaced.
    pub scale: Spacing,
}

impl<const MOST: usize> VariedKey<MOST> {
    /// The ends of its range.
    pub fn ends(&self, table: &Section<'_>) -> Result<Ends, Fault> {
        let end = |key: &str, given: Option<AnyNumber>| {
            given.ok_or_else(|| table.missing(key, &format!("{key} = …, the value at this end")))
        };
        let (from, to) = both(end("from", self.from), end("to", self.to))?;
        if from.dimension != to.dimension {
            let [first, second] = ["from", "to"].map(|key| table.path(key));
            let (of_first, of_second) = (from.dimension, to.dimension);
            return Err(
                Cause::MixedDimensions { first, of_first, second, of_second }.at(table.place_of(&["to"]))
            );
        }
        let (scale, [from, to], dimension) =
            (self.scale.unwrap_or(Spacing::Linear), [from.value, to.value], from.dimension);
        if from == to {
            return Err(Cause::EmptyRange { from: table.written("from", from) }.at(table.place));
        }
        if scale == Spacing::Log && (from == 0.0 || to == 0.0 || (from < 0.0) != (to < 0.0)) {
            let (from, to) = (table.written("from", from), table.written("to", to));
            return Err(Cause::LogThroughZero { from, to }.at(table.place));
        }
        Ok(Ends { values: [from, to], dimension, scale })
    }
}

/// A list of values in one dimension, `least` at least, each with its place; `node` is where they stand.
pub fn of_one_dimension(
    key: &str,
    node: &Node,
    given: &[AnyNumber],
    least: usize,
) -> Result<(Vec<f64>, Vec<Place>, Dimension), Fault> {
    let nodes = list(key, node)?;
    let Some(first) = given.first().filter(|_| given.len() >= least) else {
        return Err(match given.len() {
            0 if least == 1 => Cause::EmptyList { key: key.to_owned() },
            points => Cause::TooFewPoints { points: points as i64 },
        }
        .at(node.place));
    };
    all(given.iter().zip(nodes).map(|(own, node)| same_dimension(key, *first, *own, node.place)))?;
    let values = given.iter().map(|own| own.value).collect();
    Ok((values, nodes.iter().map(|node| node.place).collect(), first.dimension))
}

fn same_dimension(key: &str, one: AnyNumber, other: AnyNumber, place: Place) -> Result<(), Fault> {
    if one.dimension == other.dimension {
        return Ok(());
    }
    let (key, expected, found) = (key.to_owned(), one.dimension, other.dimension);
    Err(Cause::WrongDimension { key, expected, found, group: None }.at(place))
}
