//! Growth with the contact held: the amplitude in the march over the growth of the eigenvalue.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_report::figure::ShadedRegion;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_study::pictures::{StoredArrays, complexes, reals};
use num_complex::Complex64;
use serde_json::Value;
use std::f64::consts::TAU;

/// Room below and above the amplitudes, the upper one for the legend.
const ROOM: (f64, f64) = (0.8, 4.0);
/// Periods of the march that are marked, at most.
const MARKS: usize = 25;

/// Amplitudes of the normal force over time, the eigenvalue's growth, the stretch of the measurement; `None` where no history was kept.
pub(crate) fn growth(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let number = |name: &str| dataset.attributes().get(name).and_then(Value::as_f64);
    let method = dataset.attributes().get("method").and_then(Value::as_str).unwrap_or_default();
    let title = format!("{method}, held at {:.3} mm", 1e3 * number("position_m")?);
    growth_of(dataset, "Amplitude of $N$ (N)", number("start_amplitude_n")?, title)
}

/// The same of any amplitude that starts from a value.
pub(crate) fn growth_of(
    dataset: &StoredArrays<'_>,
    label: &str,
    start: f64,
    title: String,
) -> Option<Vec<Panel>> {
    dataset.over("amplitude", &["time"])?;
    for name in ["measured", "predicted"] {
        dataset.over(name, &[])?;
    }
    let (time, amplitude) = (reals(dataset, "time")?, reals(dataset, "amplitude")?);
    let rate = |name: &str| complexes(dataset, name)?.first().copied();
    let (measured, predicted) = (rate("measured")?, rate("predicted")?);
    let number = |name: &str| dataset.attributes().get(name).and_then(Value::as_f64);
    let until = number("measured_until_s")?;
    let milliseconds: Vec<f64> = time.iter().map(|time| 1e3 * time).collect();
    let promised = time.iter().map(|time| start * libm::exp(predicted.re * time)).collect();
    let interval = ShadedRegion {
        label: "measured interval".to_owned(),
        x: Some((0.0, 1e3 * until)),
        y: None,
        role: Role::Stable,
    };
    let layers = vec![
        Layer::Region(interval),
        Layer::line(told("eigenvalue", predicted), milliseconds.clone(), promised, Role::Series(1).solid()),
        Layer::points(told("march", measured), few(&milliseconds), few(amplitude), Role::Series(0)),
    ];
    let (low, high) =
        amplitude.iter().fold((start, start), |(low, high), own| (low.min(*own), high.max(*own)));
    let up = Axis::log(label).over(ROOM.0 * low, ROOM.1 * high);
    let across = Axis::linear("Time $t$ (ms)").over(0.0, 1e3 * time.last()?);
    Some(vec![Panel::new(across, up, layers).with_title(title).with_legend(Legend::Inside)])
}

/// At most so many values, evenly apart, that the line shows between their marks.
fn few(values: &[f64]) -> Vec<f64> {
    values.iter().step_by(values.len().div_ceil(MARKS).max(1)).copied().collect()
}

/// A growth rate with its frequency.
fn told(of: &str, rate: Complex64) -> String {
    format!("{of}: {:.3} s^{{−1}}, {:.2} Hz", rate.re, rate.im / TAU)
}
