//! Structures: modes, reduced against full, complex modes.

mod eigen;
mod shapes;
mod sweep;

pub(super) use eigen::{eigen, frequency_axis};
pub(super) use sweep::eigen_sweep;

use super::{codes, complexes, contact::FRAME, reals};
use crate::report_tables::modes_of;
use judder_report::figure::ValueMap;
use judder_report::palette::ColourMap;
use judder_report::{Axis, Layer, Panel, Role};
use judder_store::Dataset;

/// Shapes that a figure shows.
const SHOWN: usize = 6;
/// Below this share of the largest frequency a mode is a rigid motion, which is no picture.
const RIGID: f64 = 1e-4;

/// Shapes, and their comparison with each other.
pub(super) fn modes(dataset: &Dataset) -> Option<Vec<Panel>> {
    let frequencies = reals(dataset, "frequency")?;
    let largest = frequencies.last().copied().unwrap_or(0.0);
    let elastic = (0..frequencies.len()).filter(|k| frequencies[*k] > RIGID * largest);
    let of = modes_of(dataset.attributes().get("modes_of").and_then(serde_json::Value::as_str));
    let title = |k: usize| format!("mode {}{of}: {} Hz", k + 1, significant(frequencies[k]));
    let mut panels = shapes::panels(dataset, elastic.take(SHOWN), &title);
    panels.extend(mac(dataset));
    Some(panels)
}

/// How alike shapes are.
fn mac(dataset: &Dataset) -> Option<Panel> {
    let values = reals(dataset, "mac")?;
    let count = *dataset.variable("mac")?.shape.first()?;
    // one shape is like itself
    if count < 2 || values.len() != count * count {
        return None;
    }
    let numbers: Vec<f64> = (1..=count).map(|k| k as f64).collect();
    let bar = Axis::linear("MAC (−)").with_range(0.0, 1.0);
    let map =
        ValueMap { x: numbers.clone(), y: numbers, z: values.to_vec(), bar, colours: ColourMap::Sequential };
    let axis = || Axis::linear("Mode").over(0.5, count as f64 + 0.5);
    Some(Panel::new(axis(), axis(), vec![Layer::Values(map)]).with_title("shapes against each other"))
}

/// Relative errors of reduced frequencies, and the limit that the reduction tells of itself.
pub(super) fn reduction(dataset: &Dataset) -> Option<Vec<Panel>> {
    let (full, errors) = (reals(dataset, "full")?, reals(dataset, "error")?);
    // errors of rounding have no place on a logarithmic axis
    let shown: Vec<f64> = errors.iter().map(|error| if *error > 1e-12 { *error } else { f64::NAN }).collect();
    let mut layers = vec![
        Layer::line("", full.to_vec(), shown.clone(), Role::Series(0).solid()),
        Layer::points("reduced against full", full.to_vec(), shown, Role::Series(0)),
    ];
    if let Some(bounds) = reals(dataset, "bound") {
        let shown = bounds.iter().map(|bound| if *bound > 1e-12 { *bound } else { f64::NAN }).collect();
        layers.push(Layer::line(
            "bound told by the reduction",
            full.to_vec(),
            shown,
            Role::Series(1).dashed(),
        ));
    }
    if let Some(limit) = dataset.attributes().get("limit_hz").and_then(serde_json::Value::as_f64) {
        layers.push(Layer::vertical_rule(limit, "limit told by the reduction"));
        layers.push(Layer::horizontal_rule(1e-4, ""));
    }
    let vertical = Axis::log("Relative error (−)");
    let of = modes_of(dataset.attributes().get("reduction_of").and_then(serde_json::Value::as_str));
    let across = Axis::linear(format!("Frequency of the full structure{of} (Hz)"));
    Some(vec![Panel::new(across, vertical, layers)])
}

/// A number to four digits.
pub(super) fn significant(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = (3 - value.abs().log10().floor().clamp(-20.0, 3.0) as i32).max(0) as usize;
    format!("{value:.digits$}").replace('-', "−")
}
