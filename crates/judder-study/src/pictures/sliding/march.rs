//! Marches: signals over time, with the position of the contact above.

use super::super::{axis, reals};
use judder_report::{Axis, Layer, Panel, Role, SecondAxis};
use judder_store::Dataset;

/// Columns of a history, each with its smallest and its largest value: a few a pixel of the drawing would not be told apart.
const COLUMNS: usize = 700;
/// Points of the second axis.
const PLACES: usize = 200;

/// The signal of the march, normal force, sliding velocity.
pub(in crate::pictures) fn march(dataset: &Dataset) -> Option<Vec<Panel>> {
    let signal = dataset.attributes().get("signal")?.as_str()?;
    let mut names = vec![signal];
    names.extend(["normal_force", "sliding_velocity"].into_iter().filter(|name| *name != signal));
    names.into_iter().map(|name| history(dataset, name, name == signal)).collect()
}

fn history(dataset: &Dataset, name: &str, has_bursts: bool) -> Option<Panel> {
    let (time, values) = (reals(dataset, "time")?, reals(dataset, name)?);
    let (x, y) = envelope(time, values);
    let mut layers = vec![Layer::line("", x, y, Role::Series(0).solid())];
    if has_bursts
        && let (Some(times), Some(peaks)) = (reals(dataset, "burst_time"), reals(dataset, "burst_peak"))
        && !times.is_empty()
    {
        layers.push(Layer::points("bursts", times.to_vec(), peaks.to_vec(), Role::Series(1)));
    }
    let settled = dataset.attributes().get("settled_s").and_then(serde_json::Value::as_f64);
    if let Some(settled) =
        settled.filter(|settled| *settled > 0.0 && time.last().is_some_and(|t| t > settled))
    {
        layers.push(Layer::vertical_rule(settled, "ramps end"));
    }
    let up = axis(dataset.variable(name)?);
    let panel = Panel::new(Axis::linear("Time $t$ (s)"), up, layers);
    Some(match positions(time, reals(dataset, "position")?) {
        Some(second) => panel.with_second_axis(second),
        None => panel,
    })
}

/// A line that fills the space between smallest and largest value of each column.
fn envelope(time: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let width = time.len().div_ceil(COLUMNS).max(1);
    if width <= 2 {
        return (time.to_vec(), values.to_vec());
    }
    let (mut x, mut y) = (Vec::with_capacity(2 * COLUMNS), Vec::with_capacity(2 * COLUMNS));
    for (times, values) in time.chunks(width).zip(values.chunks(width)) {
        let at = |k: usize| (times[k], values[k]);
        let least = |a: usize, b: usize| if values[b] < values[a] { b } else { a };
        let largest = |a: usize, b: usize| if values[b] > values[a] { b } else { a };
        let (low, high) = ((0..values.len()).fold(0, least), (0..values.len()).fold(0, largest));
        for (time, value) in [at(low.min(high)), at(low.max(high))] {
            x.push(time);
            y.push(value);
        }
    }
    (x, y)
}

/// The position of the contact over time, as a second axis in mm; none where there are too few samples.
pub(super) fn positions(time: &[f64], position: &[f64]) -> Option<SecondAxis> {
    let stride = time.len().div_ceil(PLACES).max(1);
    let last = time.len().checked_sub(1).filter(|last| *last > 0)?;
    let kept: Vec<usize> = (0..last).step_by(stride).chain([last]).collect();
    Some(SecondAxis {
        label: "Position $s$ (mm)".to_owned(),
        x: kept.iter().map(|k| time[*k]).collect(),
        value: kept.iter().map(|k| 1e3 * position[*k]).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No sample lies beyond the drawn line, and the extremes are on it.
    #[test]
    fn an_envelope_keeps_the_extremes() {
        let time: Vec<f64> = (0..100_000).map(|k| 1e-6 * f64::from(k)).collect();
        let mut values: Vec<f64> = time.iter().map(|t| (1e3 * t).sin()).collect();
        (values[777], values[54_321]) = (9.0, -8.0);
        let (x, y) = envelope(&time, &values);
        assert!(x.len() <= 2 * COLUMNS && x.is_sorted());
        assert!(y.contains(&9.0) && y.contains(&-8.0));
    }
}
