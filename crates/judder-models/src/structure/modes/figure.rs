//! Shapes of undamped modes, and their comparison with each other.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::super::shape_panels::{mac, panels, significant};
use super::super::undamped::words_of;
use judder_report::Panel;
use judder_study::pictures::{StoredArrays, at, reals};

/// Shapes that a figure shows.
const SHOWN: usize = 6;
/// Below this share of the largest frequency a mode is a rigid motion, which is no picture.
const RIGID: f64 = 1e-4;

/// Shapes, and their comparison with each other.
pub(super) fn modes(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    dataset.over("frequency", &["mode"])?;
    let frequencies = reals(dataset, "frequency")?;
    let largest = frequencies.last().copied().unwrap_or(0.0);
    let elastic = frequencies.iter().enumerate().filter(|(_, own)| **own > RIGID * largest).map(|(k, _)| k);
    let of = words_of(dataset.attributes().get("modes_of").and_then(serde_json::Value::as_str));
    let title = |k: usize| format!("mode {}{of}: {} Hz", k + 1, significant(at(frequencies, k)));
    let mut drawn = panels(dataset, elastic.take(SHOWN), &title);
    drawn.extend(mac(dataset));
    Some(drawn)
}
