//! Any number of a case that varies: how its values are read, and how one is put back into the case.

use crate::case::scale::Scale;
use crate::case::study_sweep::problem::SweepProblem;
use judder_keys::cause::Cause;
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::{Fault, Place};
use judder_keys::problem::Placed;
use judder_keys::quantity::Quantity;
use judder_keys::section::{Section, finite_number, list, wrong_type};

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

/// The ends of a range that differ, in one dimension.
pub struct Ends {
    /// The first value and the last.
    pub values: [f64; 2],
    /// Their dimension.
    pub dimension: Dimension,
    /// How the values between are spaced.
    pub scale: Scale,
}

/// Reads `from`, `to` and `scale` of a table.
pub fn read_ends(table: &Section<'_>) -> Result<Ends, Fault> {
    let end = |key: &str| {
        let node = table.required(key, &format!("{key} = …, the value at this end"))?;
        Ok::<_, Fault>((read_number(&table.path(key), node)?, node.place))
    };
    let (((from, dimension), _), ((to, other), place)) = (end("from")?, end("to")?);
    same_dimension(&table.path("to"), dimension, other, place)?;
    if from == to {
        return Err(Cause::EmptyRange { from }.at(table.place));
    }
    let scale = table.choice("scale", "scale", &Scale::ALL)?.unwrap_or(Scale::Linear);
    if scale == Scale::Log && (from == 0.0 || to == 0.0 || (from < 0.0) != (to < 0.0)) {
        return Err(Cause::LogThroughZero { from, to }.at(table.place));
    }
    Ok(Ends { values: [from, to], dimension, scale })
}

/// Reads a list of values in one dimension, `least` at least, each with its place.
pub fn read_values(key: &str, node: &Node, least: usize) -> Result<(Vec<f64>, Vec<Place>, Dimension), Fault> {
    let nodes = list(key, node)?;
    let (mut values, mut dimension) = (Vec::with_capacity(nodes.len()), None);
    for node in nodes {
        let (value, own) = read_number(key, node)?;
        same_dimension(key, *dimension.get_or_insert(own), own, node.place)?;
        values.push(value);
    }
    match dimension {
        Some(dimension) if values.len() >= least => {
            Ok((values, nodes.iter().map(|node| node.place).collect(), dimension))
        }
        None if least == 1 => Err(Cause::EmptyList { key: key.to_owned() }.at(node.place)),
        _ => Err(Cause::TooFewPoints { points: values.len() as i64 }.at(node.place)),
    }
}

/// A plain number, or a quantity in quotes.
fn read_number(key: &str, node: &Node) -> Result<(f64, Dimension), Fault> {
    match &node.data {
        Data::Number { .. } => Ok((finite_number(key, node)?, Dimension::NUMBER)),
        Data::Text(text) => match Quantity::parse(text) {
            Ok(quantity) => Ok((quantity.number, quantity.dimension)),
            Err((problem, range)) => {
                Err(SweepProblem::NotQuantity { key: key.to_owned(), problem }.at(node.part(range)))
            }
        },
        _ => Err(wrong_type(key, "a plain number or a quantity in quotes", node)),
    }
}

fn same_dimension(key: &str, expected: Dimension, found: Dimension, place: Place) -> Result<(), Fault> {
    if expected == found {
        return Ok(());
    }
    Err(Cause::WrongDimension { key: key.to_owned(), expected, found, group: None }.at(place))
}
