//! The case at a point of a sweep: read anew, with the swept keys set.

use super::problem::SweepProblem;
use super::{StudySweep, SweptKey, SweptValues};
use crate::case::key_sweep::written;
use crate::case::tree::CaseTree;
use crate::model::Case;
use judder_keys::cause::Cause;
use judder_keys::document::Node;
use judder_keys::error::{Fault, Place};

/// A point at which there is no such case.
pub(crate) struct RefusedPoint {
    pub(crate) problem: SweepProblem,
    /// The key to blame, by its position, where one alone is.
    pub(crate) axis: Option<usize>,
}

impl RefusedPoint {
    /// Whether the key is to blame rather than its value.
    pub(crate) fn is_of_key(&self) -> bool {
        matches!(self.problem, SweepProblem::Key { .. })
    }
}

/// The tree of the case with these values set, and the case that it gives.
pub(crate) fn at(
    tree: &CaseTree,
    axes: &[SweptKey],
    values: &[f64],
) -> Result<(CaseTree, Case), RefusedPoint> {
    let mut tree = tree.clone();
    let read = axes.iter().zip(values).enumerate().try_for_each(|(k, (axis, value))| {
        let leaf = Node { place: marker(k, VALUE), data: written(*value, axis.dimension) };
        tree.root.vary(&axis.path, marker(k, KEY), leaf)
    });
    match read.and_then(|()| tree.read()) {
        Ok(case) => Ok((tree, case)),
        Err(fault) => Err(refusal(axes, values, fault)),
    }
}

/// What a marker stands for.
const KEY: usize = 0;
const VALUE: usize = 1;

/// The place of what was set: no text is there, but it tells which key a fault concerns.
fn marker(axis: usize, part: usize) -> Place {
    Place { source: usize::MAX - axis, start: part, end: part }
}

fn refusal(axes: &[SweptKey], values: &[f64], fault: Fault) -> RefusedPoint {
    let place = fault.place();
    let cause = fault.into_cause();
    let axis = usize::MAX - place.source;
    let axis = (axis < axes.len()).then_some(axis);
    let (reason, help) = (cause.to_string(), cause.help());
    let is_of_key = place.start == KEY
        && matches!(cause, Cause::UnknownKey { .. } | Cause::UnknownName { .. } | Cause::WrongType { .. });
    let problem = match axis {
        Some(k) if is_of_key => SweepProblem::Key {
            key: axes[k].path.clone(),
            reason,
            advice: help.unwrap_or_else(|| "sweep a number of the case".to_owned()),
        },
        _ => {
            let blamed =
                axes.iter().zip(values).enumerate().filter(|(k, _)| axis.is_none_or(|axis| axis == *k));
            let settings = blamed.map(|(_, (key, value))| format!("`{}` = {}", key.path, key.text(*value)));
            SweepProblem::Value {
                settings: settings.collect::<Vec<_>>().join(", "),
                reason,
                advice: help.unwrap_or_else(|| "sweep values that the key can take".to_owned()),
            }
        }
    };
    RefusedPoint { problem, axis }
}

/// Tries the case at the first values of all keys, and at other values of each key in turn.
pub(super) fn try_values(tree: &CaseTree, axes: &[SweptKey]) -> Result<Vec<Case>, RefusedPoint> {
    let first: Vec<f64> = axes.iter().map(|axis| tried(axis)[0]).collect();
    let mut cases = vec![at(tree, axes, &first)?.1];
    for (k, axis) in axes.iter().enumerate() {
        for value in &tried(axis)[1..] {
            let mut values = first.clone();
            values[k] = *value;
            cases.push(
                at(tree, axes, &values)
                    .map_err(|refusal| RefusedPoint { axis: refusal.axis.or(Some(k)), ..refusal })?
                    .1,
            );
        }
    }
    Ok(cases)
}

impl StudySweep {
    /// The steps to what a refusal concerns in the tree of the case file: an axis, its key, or all axes.
    pub(crate) fn steps_to(&self, refusal: &RefusedPoint) -> Vec<String> {
        let mut steps = vec!["sweep".to_owned(), self.name.clone(), "over".to_owned()];
        steps.extend(refusal.axis.map(|axis| axis.to_string()));
        steps.extend((refusal.axis.is_some() && refusal.is_of_key()).then(|| "key".to_owned()));
        steps
    }
}

/// A coordinate at which a count between two others is not whole.
const BETWEEN: f64 = 0.381_966;

/// The values that are tried, never none: the ends, and one between, which a key of whole numbers refuses.
fn tried(axis: &SweptKey) -> Vec<f64> {
    let [low, high] = axis.range();
    match &axis.values {
        SweptValues::Listed(_) if low == high => vec![low],
        SweptValues::Listed(_) => vec![low, high],
        SweptValues::Spaced { from, to, points: 2 } => vec![*from, *to],
        SweptValues::Spaced { from, to, .. } => vec![*from, *to, axis.value(1)],
        SweptValues::Between { from, to } => vec![*from, *to, axis.value_at(BETWEEN)],
    }
}
