//! Reduced against full: errors, and the limit that the reduction tells of itself.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::super::undamped::words_of;
use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, reals};

/// Relative errors of reduced frequencies, and the limit that the reduction tells of itself.
pub(super) fn reduction(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.shaped("full", &[None])?;
    dataset.alike(&["full", "error", "bound"])?;
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
    let of = words_of(dataset.attributes().get("reduction_of").and_then(serde_json::Value::as_str));
    let across = Axis::linear(format!("Frequency of the full structure{of} (Hz)"));
    Some(vec![Panel::new(across, vertical, layers)])
}
