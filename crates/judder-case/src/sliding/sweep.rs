//! Sweeps of any number of a sliding case: each value is a case of its own.

use super::SlidingCase;
use super::problem::SlidingProblem;
use crate::cause::Cause;
use crate::dimension::Dimension;
use crate::document::{Data, Node, STEPS_LIMIT};
use crate::error::{Fault, Place};
use crate::keys::Form;
use crate::quantity::Quantity;
use crate::section::{Section, finite_number, list, text, wrong_type};
use crate::structure::problem::StructureProblem;
use crate::sweep::{Scale, Sweep};

/// Any number of a case with the values that it takes one after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct KeySweep {
    /// Its dotted path, such as `structure.oblique.beam.angle`.
    pub path: String,
    /// The values, two at least, ascending or descending, in SI units.
    pub values: Vec<f64>,
    /// Their dimension.
    pub dimension: Dimension,
    /// How they are spaced, for the axis of figures.
    pub scale: Scale,
}

impl KeySweep {
    /// A value with its unit.
    pub fn text(&self, value: f64) -> String {
        if self.dimension.is_number() {
            value.to_string()
        } else {
            format!("{value} {}", self.dimension.unit())
        }
    }

    /// A value as a case file would have it.
    pub(super) fn data(&self, value: f64) -> Data {
        if !self.dimension.is_number() {
            return Data::Text(format!("{value:?} {}", self.dimension.unit()));
        }
        // a count stays one
        let whole = (value.fract() == 0.0 && value.abs() < 1e15).then_some(value as i64);
        Data::Number { value, whole }
    }
}

/// What can be swept: the sections whose numbers describe structures, contact and motion.
const SWEPT: [&str; 4] = ["parameters", "structure", "contact", "motion"];

/// The most points of a sweep: each is a case of its own.
pub const SWEEP_LIMIT: usize = 100_000;

/// Reads `{ key, from, to, points, scale }` or `{ key, values }`, and tries both ends on the case.
pub(super) fn read_key_sweep(case: &SlidingCase, node: &Node) -> Result<KeySweep, Fault> {
    let table = Section::open(node, "sweep", "`sweep`", &["key", "from", "to", "points", "scale", "values"])?;
    let key = table
        .required("key", "the dotted path of a number of the case, key = \"contact.friction_coefficient\"")?;
    let path = text("sweep.key", key)?.to_owned();
    let mut steps = path.split('.');
    if !steps.next().is_some_and(|first| SWEPT.contains(&first)) || steps.count() > STEPS_LIMIT {
        return Err(SlidingProblem::NotSwept { key: path }.at(key.place));
    }
    let sweep = match table.get("values") {
        Some(values) => {
            Section::open(node, "sweep", "`sweep` with `values`", &["key", "values"])?;
            read_list(path, values)?
        }
        None => read_range(path, &table)?,
    };
    for value in sweep.values.first().into_iter().chain(sweep.values.last()) {
        case.at(&sweep, *value).map_err(|problem| {
            let is_of_key = matches!(problem, SlidingProblem::SweptKey { .. });
            problem.at(if is_of_key { key.place } else { node.place })
        })?;
    }
    Ok(sweep)
}

fn read_list(path: String, node: &Node) -> Result<KeySweep, Fault> {
    let nodes = list("sweep.values", node)?;
    let (mut values, mut dimension) = (Vec::with_capacity(nodes.len()), None);
    for node in nodes {
        let (value, own) = read_end("sweep.values", node)?;
        same_dimension("sweep.values", *dimension.get_or_insert(own), own, node.place)?;
        values.push(value);
    }
    let (Some(dimension), 2..) = (dimension, values.len()) else {
        return Err(Cause::TooFewPoints { points: values.len() as i64 }.at(node.place));
    };
    if !values.is_sorted_by(|a, b| a < b) && !values.is_sorted_by(|a, b| a > b) {
        return Err(StructureProblem::UnsortedValues.at(node.place));
    }
    Ok(KeySweep { path, values, dimension, scale: Scale::Linear })
}

fn read_range(path: String, table: &Section<'_>) -> Result<KeySweep, Fault> {
    let end = |key: &str| {
        let node = table.required(key, &format!("{key} = …, the value at this end"))?;
        Ok::<_, Fault>((read_end(&table.path(key), node)?, node.place))
    };
    let (((from, dimension), _), ((to, other), place)) = (end("from")?, end("to")?);
    same_dimension("sweep.to", dimension, other, place)?;
    if from == to {
        return Err(Cause::EmptyRange { from }.at(table.place));
    }
    let scale = table.choice("scale", "scale", &Scale::ALL)?.unwrap_or(Scale::Linear);
    if scale == Scale::Log && (from == 0.0 || to == 0.0 || (from < 0.0) != (to < 0.0)) {
        return Err(Cause::LogThroughZero { from, to }.at(table.place));
    }
    table.required("points", "points = 101, the number of points, both ends included")?;
    let points = table.whole("points", 2, SWEEP_LIMIT)?.unwrap_or(2);
    let values = Sweep { key: (), path: String::new(), from, to, points, scale, form: Form::Si }.values();
    Ok(KeySweep { path, values, dimension, scale })
}

/// A plain number, or a quantity in quotes.
fn read_end(key: &str, node: &Node) -> Result<(f64, Dimension), Fault> {
    match &node.data {
        Data::Number { .. } => Ok((finite_number(key, node)?, Dimension::NUMBER)),
        Data::Text(text) => match Quantity::parse(text) {
            Ok(quantity) => Ok((quantity.number, quantity.dimension)),
            Err((problem, range)) => {
                Err(SlidingProblem::NotQuantity { key: key.to_owned(), problem }.at(node.part(range)))
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
