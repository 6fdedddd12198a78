//! Sweeps of any number of a sliding case: each value is a case of its own.

use super::SlidingCase;
use super::problem::SlidingProblem;
use crate::structure::case::problem::StructureProblem;
use judder_keys::declared::{Allowed, Number, Setting};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node, STEPS_LIMIT};
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, text};
use judder_study::case::key_sweep::{read_ends, read_values, shown, written};
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
        Allowed::Told {
            schema: crate::sliding::schema::key_sweep(),
            words: "`{ key, from, to, points, scale }`, or `{ key, values }`".to_owned(),
            keys: Vec::new(),
        }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let table = section.table(key, node, &["key", "from", "to", "points", "scale", "values"])?;
        let expected = "the dotted path of a number of the case, key = \"contact.friction_coefficient\"";
        let key = table.required("key", expected)?;
        let path = text("sweep.key", key)?.to_owned();
        let mut steps = path.split('.');
        if !steps.next().is_some_and(|first| SWEPT.contains(&first)) || steps.count() > STEPS_LIMIT {
            return Err(SlidingProblem::NotSwept { key: path }.at(key.place));
        }
        match table.get("values") {
            Some(values) => {
                Section::open(node, "sweep", "`sweep` with `values`", &["key", "values"])?;
                read_list(path, values)
            }
            None => read_range(path, &table),
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

fn read_list(path: String, node: &Node) -> Result<KeySweep, Fault> {
    let (values, _, dimension) = read_values("sweep.values", node, 2)?;
    if !values.is_sorted_by(|a, b| a < b) && !values.is_sorted_by(|a, b| a > b) {
        return Err(StructureProblem::UnsortedValues.at(node.place));
    }
    Ok(KeySweep { path, values, dimension, scale: Scale::Linear })
}

fn read_range(path: String, table: &Section<'_>) -> Result<KeySweep, Fault> {
    let ends = read_ends(table)?;
    table.required("points", "points = 101, the number of points, both ends included")?;
    let points = table.whole("points", 2, SWEEP_LIMIT)?.unwrap_or(2) as u64;
    let values = (0..points).map(|index| spaced(ends.values, points, ends.scale, index)).collect();
    Ok(KeySweep { path, values, dimension: ends.dimension, scale: ends.scale })
}
