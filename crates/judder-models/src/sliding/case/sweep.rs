//! Sweeps of any number of a sliding case: each value is a case of its own.

use super::SlidingCase;
use super::problem::SlidingProblem;
use crate::structure::case::problem::StructureProblem;
use judder_keys::declared::{Allowed, Number, Setting, both, read_settings};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node, STEPS_LIMIT};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_study::case::key_sweep::{AnyNumber, VariedKey, of_one_dimension, shown, written};
use judder_study::case::scale::{Scale, spaced};
use serde_json::{Value as Json, json};

/// What can be swept: the sections whose numbers describe structures, contact and motion.
const SWEPT: [&str; 4] = ["parameters", "structure", "contact", "motion"];

/// The most points of a sweep: each is a case of its own.
pub const SWEEP_LIMIT: usize = 100_000;

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
        shown(value, self.dimension)
    }

    /// A value as a case file would have it.
    pub fn data(&self, value: f64) -> Data {
        written(value, self.dimension)
    }
}

/// `{ key, from, to, points, scale }` or `{ key, values }`.
impl Setting for KeySweep {
    type Rule = ();

    fn form((): &()) -> Allowed {
        VariedKey::<SWEEP_LIMIT>::form(&())
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let (path, title) = (section.path(key), section.title(key));
        let varied: VariedKey<SWEEP_LIMIT> = read_settings(node, &path, &title)?;
        let table = Section::of_table(node, &path, &title)?;
        let expected = "the dotted path of a number of the case, key = \"contact.friction_coefficient\"";
        let node_of_key = table.required("key", expected)?;
        let mut steps = varied.key.split('.');
        if !steps.next().is_some_and(|first| SWEPT.contains(&first)) || steps.count() > STEPS_LIMIT {
            return Err(SlidingProblem::NotSwept { key: varied.key }.at(node_of_key.place));
        }
        match (table.get("values"), &varied.values) {
            (Some(node_of_values), Some(values)) => {
                Section::open(node, "sweep", "`sweep` with `values`", &["key", "values"])?;
                of_list(&varied.key, node_of_values, values)
            }
            _ => of_range(&varied, &table),
        }
    }

    fn write(&self, (): &()) -> Json {
        let rule = Number::any(self.dimension);
        let values: Json = self.values.iter().map(|value| value.write(&rule)).collect();
        json!({ "key": self.path, "values": values, "scale": self.scale.name() })
    }
}

impl KeySweep {
    /// Tries both ends on the case, which has the sweep at `node`.
    pub(crate) fn admit(&self, case: &SlidingCase, node: &Node) -> Result<(), Fault> {
        for value in self.values.first().into_iter().chain(self.values.last()) {
            case.at(self, *value).map_err(|problem| {
                let key = node.entry("key").filter(|_| matches!(problem, SlidingProblem::SweptKey { .. }));
                problem.at(key.unwrap_or(node).place)
            })?;
        }
        Ok(())
    }
}

fn of_list(path: &str, node: &Node, values: &[AnyNumber]) -> Result<KeySweep, Fault> {
    let (values, _, dimension) = of_one_dimension("sweep.values", node, values, 2)?;
    if !values.is_sorted_by(|a, b| a < b) && !values.is_sorted_by(|a, b| a > b) {
        return Err(StructureProblem::UnsortedValues.at(node.place));
    }
    Ok(KeySweep { path: path.to_owned(), values, dimension, scale: Scale::Linear })
}

fn of_range(varied: &VariedKey<SWEEP_LIMIT>, table: &Section<'_>) -> Result<KeySweep, Fault> {
    let points = varied
        .points
        .ok_or_else(|| table.missing("points", "points = 101, the number of points, both ends included"));
    let (ends, points) = both(varied.ends(table), points)?;
    let points = points as u64;
    let values = (0..points).map(|index| spaced(ends.values, points, ends.scale, index)).collect();
    Ok(KeySweep { path: varied.key.clone(), values, dimension: ends.dimension, scale: ends.scale })
}
