//! Sweeps of any number of a sliding case: each value is a case of its own.

use super::SlidingCase;
use super::problem::SlidingProblem;
use crate::document::{Node, STEPS_LIMIT};
use crate::error::Fault;
use crate::key_sweep::{read_ends, read_values};
use crate::section::{Section, text};
use crate::structure::problem::StructureProblem;
use crate::sweep::{Scale, spaced};

pub use crate::key_sweep::KeySweep;

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
