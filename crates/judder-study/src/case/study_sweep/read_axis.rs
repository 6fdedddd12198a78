//! Reading of the swept keys of a `[[sweep]]`.

use judder_numerics::order::sort_by_number;
use judder_numerics::sampling::sobol::DIMENSIONS_LIMIT;

use super::design::POINTS_LIMIT;
use super::problem::SweepProblem;
use super::{Design, SweptKey, SweptValues};
use crate::case::key_sweep::{Ends, VariedKey, of_one_dimension};
use crate::case::root::{MODEL, SWEEP, TITLE};
use crate::case::scale::Spacing;
use crate::case::tree::CaseTree;
use crate::model::Case;
use judder_keys::cause::Cause;
use judder_keys::declared::{all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Node, STEPS_LIMIT};
use judder_keys::error::{Fault, Place};
use judder_keys::problem::Placed;
use judder_keys::section::{Section, list};

/// An entry of `over`.
pub(super) type SweepEntry = VariedKey<{ POINTS_LIMIT as usize }>;

/// A swept key with the places that later checks point at.
pub(super) struct PlacedKey {
    pub(super) key: SweptKey,
    pub(super) key_place: Place,
    pub(super) place: Place,
}

/// The swept keys that stand at `over`.
pub(super) fn read_axes(axes: &[SweepEntry], over: &Node, method: Design) -> Result<Vec<PlacedKey>, Fault> {
    let nodes = list("over", over)?;
    if nodes.is_empty() {
        return Err(Cause::EmptyList { key: "over".to_owned() }.at(over.place));
    }
    if nodes.len() > DIMENSIONS_LIMIT {
        let problem = SweepProblem::TooManyKeys { found: nodes.len(), limit: DIMENSIONS_LIMIT };
        return Err(problem.at(over.place));
    }
    let axes = all(axes.iter().zip(nodes).map(|(axis, node)| read_axis(axis, node, method)))?;
    if method == Design::List {
        same_lengths(&axes)?;
    }
    Ok(axes)
}

fn read_axis(axis: &SweepEntry, node: &Node, method: Design) -> Result<PlacedKey, Fault> {
    let table = Section::of_table(node, "over", "an entry of `over`")?;
    let key =
        table.required("key", "the dotted path of a number of the case, key = \"operation.velocity\"")?;
    let path = axis.key.clone();
    let key_place = key.part(0..path.len());
    let steps: Vec<&str> = path.split('.').collect();
    let is_path = steps.len() <= STEPS_LIMIT && steps.iter().all(|step| !step.trim().is_empty());
    if !is_path || [TITLE, MODEL, SWEEP].contains(&steps[0]) {
        return Err(SweepProblem::NotSwept { key: path }.at(key_place));
    }
    let (values, dimension, scale) = match method {
        Design::Grid | Design::List => read_counted(axis, &table, method)?,
        Design::LatinHypercube { .. } | Design::Sobol { .. } => {
            let with = format!("method = \"{}\"", method.name());
            all(["points", "values"].map(|key| refuse(&table, key, &with)))?;
            let Ends { values: [from, to], dimension, scale } = axis.ends(&table)?;
            (SweptValues::Between { from, to }, dimension, scale)
        }
    };
    Ok(PlacedKey { key: SweptKey { path, dimension, scale, values }, key_place, place: node.place })
}

/// The values of a key that takes a number of them.
fn read_counted(
    axis: &SweepEntry,
    table: &Section<'_>,
    method: Design,
) -> Result<(SweptValues, Dimension, Spacing), Fault> {
    if let (Some(node), Some(values)) = (table.get("values"), &axis.values) {
        all(["from", "to", "points", "scale"].map(|key| refuse(table, key, "`values`")))?;
        let (values, places, dimension) = of_one_dimension("over.values", node, values, 1)?;
        if method == Design::Grid {
            refuse_repeated_values(&axis.key, &values, &places, dimension)?;
        }
        return Ok((SweptValues::Listed(values), dimension, Spacing::Linear));
    }
    if method == Design::List {
        return Err(table.missing("values", "values = [ … ], one a point"));
    }
    let expected = "points = 21, the number of values; or values = [ … ] in place of the range";
    let points = axis.points.ok_or_else(|| table.missing("points", expected));
    let (Ends { values: [from, to], dimension, scale }, points) = both(axis.ends(table), points)?;
    Ok((SweptValues::Spaced { from, to, points: points as u64 }, dimension, scale))
}

/// Refuses a key that has no meaning beside something else.
pub(super) fn refuse(section: &Section<'_>, key: &'static str, with: &str) -> Result<(), Fault> {
    let Some(node) = section.get(key) else { return Ok(()) };
    let problem = Cause::Meaningless { key, with: with.to_owned() };
    Err(problem.at(node.place))
}

/// Coordinates of a grid are told apart by their values.
fn refuse_repeated_values(
    path: &str,
    values: &[f64],
    places: &[Place],
    dimension: Dimension,
) -> Result<(), Fault> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    sort_by_number(&mut order, |own| values[*own]);
    match order.windows(2).find(|pair| values[pair[0]] == values[pair[1]]) {
        None => Ok(()),
        Some(pair) => {
            let value = crate::case::key_sweep::shown(values[pair[1]], dimension);
            Err(SweepProblem::ValueTwice { key: path.to_owned(), value }.at(places[pair[1]]))
        }
    }
}

fn same_lengths(axes: &[PlacedKey]) -> Result<(), Fault> {
    let count = |axis: &PlacedKey| axis.key.count().unwrap_or_default() as usize;
    let Some((first, others)) = axes.split_first() else { return Ok(()) };
    match others.iter().find(|axis| count(axis) != count(first)) {
        None => Ok(()),
        Some(other) => {
            let (key, second) = (first.key.path.clone(), other.key.path.clone());
            let (values, found) = (count(first), count(other));
            Err(SweepProblem::Lengths { first: key, values, second, found }.at(other.place))
        }
    }
}

/// Refuses two paths that lead to one number.
pub(super) fn refuse_repeated_keys(tree: &CaseTree, case: &Case, axes: &[PlacedKey]) -> Result<(), Fault> {
    let positions: Vec<_> = axes.iter().map(|axis| tree.root.by_position(&axis.key.path)).collect();
    let path = |k: usize| axes[k].key.path.as_str();
    for k in 0..axes.len() {
        let is_same =
            |other: &usize| positions[*other] == positions[k] || case.is_one_quantity(path(*other), path(k));
        if let Some(first) = (0..k).find(is_same) {
            let (first, second) = (path(first).to_owned(), path(k).to_owned());
            return Err(SweepProblem::KeyTwice { first, second }.at(axes[k].key_place));
        }
    }
    Ok(())
}
