//! Sweeps of whole studies, from what lies in their group: no case is asked.
//!
//! - `column`: a quantity with its label, its colours and its values.
//! - `grid`: lines over one key, maps over two.
//! - `samples`: points over every key.
//! - `sensitivity`: Sobol' indices with their confidence intervals.

mod column;
mod grid;
mod samples;
mod sensitivity;

use super::{StoredArrays, reals};
use crate::error::WrongArray;
use crate::registry::ModelKind;
use column::{KeyColumn, PointColumn};
use judder_report::{Figure, Panel};
use judder_store::Dataset;
use serde_json::{Map, Value};

/// Whether the arrays with these attributes are those of a sweep.
pub(crate) fn is_sweep(attributes: &Map<String, Value>) -> bool {
    attributes.get("kind").and_then(Value::as_str) == Some("sweep")
}

/// Points of a curve, and of a scatter plot, that are drawn at most.
const DRAWN_POINTS: usize = 4000;
/// Panels of a figure.
const PANELS: usize = 12;

/// Which points of a sweep are read to draw it, along each of its dimensions.
pub(crate) fn drawn_points(
    attributes: &Map<String, Value>,
    dimensions: &[(String, usize)],
) -> Vec<Vec<usize>> {
    let lengths: Vec<usize> = dimensions.iter().map(|(_, length)| *length).collect();
    match attributes.get("method").and_then(Value::as_str) {
        Some("grid") => grid::drawn_points(&lengths),
        Some("list") => lengths.iter().map(|length| evenly(*length, DRAWN_POINTS)).collect(),
        // the first of a sequence fill the ranges as all of them do
        _ => lengths.iter().map(|length| (0..(*length).min(DRAWN_POINTS)).collect()).collect(),
    }
}

/// As many positions as are drawn, from the first to the last.
fn evenly(length: usize, drawn: usize) -> Vec<usize> {
    let count = length.min(drawn);
    (0..count).map(|k| k * length.saturating_sub(1) / (count - 1).max(1)).collect()
}

/// The figures of a sweep over a case of this model that was read at its drawn points; `results` is what the summary says of it.
///
/// # Errors
/// [`WrongArray`].
pub(crate) fn figures(
    model: Option<&ModelKind>,
    name: &str,
    dataset: &Dataset,
    results: &Map<String, Value>,
) -> Result<Vec<Figure>, WrongArray> {
    let arrays = StoredArrays::of(dataset);
    let Some(sweep) = DrawnSweep::of(model, &arrays, results) else { return arrays.settled(Vec::new()) };
    let (panels, columns, caption) = match sweep.is_grid {
        true => grid::panels(&sweep),
        false => samples::panels(&sweep),
    };
    let mut figures = Vec::new();
    if !panels.is_empty() {
        let caption = format!("{caption}{}", sweep.told());
        figures.push(Figure::new(name, name, panels).with_columns(columns).with_caption(caption));
    }
    figures.extend(sensitivity::figure(name, &sweep));
    arrays.settled(figures)
}

/// Panels, how many stand in a row, and what stands under them.
type Drawn = (Vec<Panel>, usize, String);

/// A sweep at its drawn points.
struct DrawnSweep<'a> {
    dataset: StoredArrays<'a>,
    keys: Vec<KeyColumn>,
    /// The quantities that were asked for.
    columns: Vec<PointColumn>,
    is_grid: bool,
    /// Points along each dimension, of those that were read.
    lengths: Vec<usize>,
    /// All points that there are.
    points: Option<u64>,
    sensitivity: Option<&'a Map<String, Value>>,
}

impl<'a> DrawnSweep<'a> {
    fn of(
        model: Option<&ModelKind>,
        dataset: &StoredArrays<'a>,
        results: &'a Map<String, Value>,
    ) -> Option<Self> {
        if !is_sweep(dataset.attributes()) {
            return None;
        }
        let (values, stored) = (reals(dataset, "values")?, dataset.variable("values")?);
        let (_, lengths) = stored.shape.split_last()?;
        // the quantities of a point stand together
        let mut dimensions: Vec<&str> = stored.dimensions.iter().map(String::as_str).collect();
        if let Some(last) = dimensions.last_mut() {
            *last = "quantity";
        }
        dataset.over("values", &dimensions)?;
        let is_grid = dataset.attributes().get("method").and_then(Value::as_str) == Some("grid");
        let mut columns = column::columns(model, dataset, values)?;
        let mut keys = column::keys(dataset)?;
        if !is_grid {
            // the values of the keys stand before those of the quantities
            let asked = columns.split_off(keys.len().min(columns.len()));
            for (key, column) in keys.iter_mut().zip(columns) {
                key.values = column.values;
            }
            columns = asked;
        }
        Some(Self {
            dataset: dataset.clone(),
            keys,
            columns,
            is_grid,
            lengths: lengths.to_vec(),
            points: results.get("points").and_then(Value::as_u64),
            sensitivity: results.get("sensitivity").and_then(Value::as_object),
        })
    }

    /// How many of the points are drawn, where it is not all of them.
    fn told(&self) -> String {
        let drawn = self.lengths.iter().product::<usize>() as u64;
        match self.points {
            Some(points) if points > drawn => format!(" Drawn are {drawn} of {points} points."),
            _ => String::new(),
        }
    }
}

/// What stands in a document under these keys, one in the other; nothing where there is none.
fn part<'v>(document: &'v Value, keys: &[&str]) -> &'v Value {
    keys.iter().try_fold(document, |own, key| own.get(key)).unwrap_or(&Value::Null)
}

/// What a figure leaves out, in words.
fn left_out(shown: usize, all: usize, what: &str) -> String {
    if shown < all { format!(" The first {shown} of {all} {what}.") } else { String::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn drawn(method: &str, lengths: &[usize]) -> Vec<Vec<usize>> {
        let Value::Object(attributes) = json!({ "method": method }) else { unreachable!() };
        let dimensions: Vec<(String, usize)> =
            lengths.iter().map(|length| (String::new(), *length)).collect();
        drawn_points(&attributes, &dimensions)
    }

    #[test]
    fn what_is_drawn_of_a_huge_sweep_is_little() {
        let read = drawn("grid", &[100_000, 3, 100_000]);
        assert_eq!(read.iter().map(Vec::len).collect::<Vec<_>>(), [400, 1, 400]);
        assert_eq!(
            (read[0][0], read[0][399], read[1][0]),
            (0, 99_999, 1),
            "from end to end, at the middle of the other"
        );
        assert_eq!(drawn("grid", &[1_000_000_000])[0].len(), 4000);
        assert_eq!(drawn("sobol", &[1_000_000_000])[0], (0..4000).collect::<Vec<_>>());
        assert_eq!(drawn("list", &[8001])[0][..3], [0, 2, 4]);
        assert_eq!(drawn("list", &[1])[0], [0]);
    }

    #[test]
    fn what_is_no_sweep_has_no_figure() {
        let empty = Map::new();
        assert!(figures(None, "sweep", &Dataset::new(), &empty).unwrap().is_empty());
        assert!(!is_sweep(&empty));
    }
}
