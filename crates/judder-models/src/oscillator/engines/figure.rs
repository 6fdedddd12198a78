//! One cycle by three engines.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_report::{Axis, Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, axis, reals};

/// Errors over the step of the time-stepping, and over the width of the smoothed sign.
pub(crate) fn engines(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let step = errors(dataset, "time_step", "time_stepping")?.with_title("Time-stepping");
    let mut width = errors(dataset, "width", "smoothed")?.with_title("Smoothed sign");
    if let Some(typical) = dataset.attributes().get("typical_width").and_then(serde_json::Value::as_f64) {
        width.layers.push(Layer::vertical_rule(typical, "usual"));
    }
    Some(vec![step, width])
}

fn errors(dataset: &StoredArrays<'_>, varied: &str, engine: &str) -> Option<Panel> {
    for quantity in ["rms", "period"] {
        dataset.over(&format!("{engine}_{quantity}_error"), &[varied])?;
    }
    let values = reals(dataset, varied)?;
    let mut layers = Vec::new();
    for (quantity, series) in [("rms", 0), ("period", 1)] {
        let errors = reals(dataset, &format!("{engine}_{quantity}_error"))?;
        let sizes: Vec<f64> = errors.iter().map(|error| error.abs()).collect();
        if quantity == "rms" {
            let first = values.iter().zip(&sizes).find(|(_, size)| size.is_finite());
            layers.extend(first.map(|(at, size)| {
                let rising = values.iter().map(|value| (size * value / at).min(1.0)).collect();
                Layer::line("first order", values.to_vec(), rising, Role::Reference)
            }));
        }
        layers.push(Layer::line("", values.to_vec(), sizes.clone(), Role::Series(series)));
        layers.push(Layer::points(quantity, values.to_vec(), sizes, Role::Series(series)));
    }
    let up = Axis::log("Relative error (−)");
    Some(Panel::new(dataset.variable(varied).map(axis)?, up, layers))
}
