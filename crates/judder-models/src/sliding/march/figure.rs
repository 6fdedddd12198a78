//! Marches: signals over time, with the position of the contact above.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use judder_numerics::contact_state::ContactState;
use judder_report::{Axis, Layer, Legend, Panel, Role, SecondAxis, Style};
use judder_study::pictures::{StoredArrays, at, axis, codes, middle, picked, reals};
use serde_json::Value;

/// Columns of a history, each with its smallest and its largest value: a few a pixel of the drawing would not be told apart.
const COLUMNS: usize = 700;
/// Points of the second axis.
const PLACES: usize = 200;
/// What a logarithmic axis shows below the largest amplitude, and above it.
const DECADES: f64 = 1e-4;
const ROOM: f64 = 2.0;

/// The colours of the states, as of every model.
pub(crate) const STATES: [(ContactState, Role); 4] = [
    (ContactState::Stick, Role::Stick),
    (ContactState::SlipBehind, Role::Stable),
    (ContactState::SlipAhead, Role::SlipAhead),
    (ContactState::LiftOff, Role::LiftOff),
];

/// The signal of the march, its amplitude, normal force, what the contact does, sliding velocity.
pub(crate) fn march(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let signal = dataset.attributes().get("signal")?.as_str()?;
    let style = Role::Series(0).solid();
    let own = history(dataset, signal, style)?;
    let with_bursts = Panel { layers: own.layers.into_iter().chain(bursts(dataset)).collect(), ..own };
    let amplitude = panel(dataset, signal, vec![swing(dataset, signal, "", style)?])?;
    let mut panels = vec![with_bursts, logarithmic(amplitude).with_title("amplitude: √2 rms of a column")];
    for name in ["normal_force", "sliding_velocity"].into_iter().filter(|name| *name != signal) {
        panels.push(history(dataset, name, style)?);
        if name == "normal_force" {
            panels.extend(states(dataset));
        }
    }
    Some(panels)
}

/// How much of each column the contact spends in each state.
fn states(dataset: &StoredArrays<'_>) -> Option<Panel> {
    dataset.over("state", &["state_time"])?;
    let (times, all) = (reals(dataset, "state_time")?, codes(dataset, "state")?);
    let width = times.len().div_ceil(COLUMNS).max(1);
    let middles: Vec<f64> = times.chunks(width).map(middle).collect();
    let layer = |(state, role): &(ContactState, Role)| {
        let share = |column: &[u8]| {
            column.iter().filter(|code| **code == state.number()).count() as f64 / column.len() as f64
        };
        let shares = all.chunks(width).map(share).collect();
        Layer::line(state.name(), middles.clone(), shares, role.solid())
    };
    let occurs = |(state, _): &&(ContactState, Role)| all.contains(&state.number());
    let layers = STATES.iter().filter(occurs).map(layer).collect();
    let panel = panel(dataset, "state", layers)?;
    let up = Axis::linear("Share of a column").over(0.0, 1.0);
    Some(Panel { y: up, ..panel }.with_title("what the contact does"))
}

/// A signal over time.
pub fn history(dataset: &StoredArrays<'_>, name: &str, style: Style) -> Option<Panel> {
    panel(dataset, name, vec![trace(dataset, name, "", style)?])
}

/// The values of a signal over time as a line.
pub fn trace(dataset: &StoredArrays<'_>, name: &str, label: &str, style: Style) -> Option<Layer> {
    dataset.over(name, &["time"])?;
    let (x, y) = envelope(reals(dataset, "time")?, reals(dataset, name)?);
    Some(Layer::line(label, x, y, style))
}

/// How far a signal swings about its mean in each column, √2 times the rms, as a line.
pub fn swing(dataset: &StoredArrays<'_>, name: &str, label: &str, style: Style) -> Option<Layer> {
    dataset.over(name, &["time"])?;
    let (x, y) = swings(reals(dataset, "time")?, reals(dataset, name)?);
    Some(Layer::line(label, x, y, style))
}

/// Layers over the time of a march, with the end of its ramps and the position of the contact.
pub fn panel(dataset: &StoredArrays<'_>, name: &str, mut layers: Vec<Layer>) -> Option<Panel> {
    dataset.over("position", &["time"])?;
    let time = reals(dataset, "time")?;
    let (first, last) = (*time.first()?, *time.last()?);
    let settled = dataset.attributes().get("settled_s").and_then(Value::as_f64);
    if let Some(settled) = settled.filter(|settled| *settled > 0.0 && last > *settled) {
        layers.push(Layer::vertical_rule(settled, ""));
        layers.push(Layer::key("end of the ramps", Role::Reference.dotted()));
    }
    let across = Axis::linear("Time $t$ (s)");
    let across = if last > first { across.over(first, last) } else { across };
    let panel = Panel::new(across, axis(dataset.variable(name)?), layers).with_legend(Legend::Below);
    Some(match reals(dataset, "position").and_then(|own| positions(time, own)) {
        Some(second) => panel.with_second_axis(second),
        None => panel,
    })
}

/// The same panel with a logarithmic axis of amplitudes, up to what comes after the ramps.
pub fn logarithmic(panel: Panel) -> Panel {
    let settled = panel.layers.iter().find_map(|layer| match layer {
        Layer::Rule(rule) => Some(rule.value),
        _ => None,
    });
    let lines = panel.layers.iter().filter_map(|layer| match layer {
        Layer::Line(line) => Some(line.x.iter().zip(&line.y)),
        _ => None,
    });
    let after = |(x, y): &(&f64, &f64)| y.is_finite() && settled.is_none_or(|settled| **x > settled);
    let largest = lines.flatten().filter(after).map(|(_, y)| *y).fold(0.0, f64::max);
    let up = Axis::log(panel.y.label.clone());
    let up = if largest > 0.0 { up.over(DECADES * largest, ROOM * largest) } else { up };
    Panel { y: up, ..panel }
}

/// The peaks of the bursts.
fn bursts(dataset: &StoredArrays<'_>) -> Option<Layer> {
    for name in ["burst_time", "burst_peak"] {
        dataset.over(name, &["burst"])?;
    }
    let (times, peaks) = (reals(dataset, "burst_time")?, reals(dataset, "burst_peak")?);
    let layer = || Layer::points("peak of a burst", times.to_vec(), peaks.to_vec(), Role::Series(1));
    (!times.is_empty()).then(layer)
}

/// √2 times the rms about the mean of each column, in its middle.
pub fn swings(time: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let width = time.len().div_ceil(COLUMNS).max(2);
    let column = |(times, values): (&[f64], &[f64])| {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let square = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count;
        (middle(times), (2.0 * square).sqrt())
    };
    time.chunks(width).zip(values.chunks(width)).map(column).unzip()
}

/// A line that fills the space between smallest and largest value of each column.
fn envelope(time: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let width = time.len().div_ceil(COLUMNS).max(1);
    if width <= 2 {
        return (time.to_vec(), values.to_vec());
    }
    let (mut x, mut y) = (Vec::with_capacity(2 * COLUMNS), Vec::with_capacity(2 * COLUMNS));
    for (times, values) in time.chunks(width).zip(values.chunks(width)) {
        let point = |k: usize| (at(times, k), at(values, k));
        let least = |a: usize, b: usize| if at(values, b) < at(values, a) { b } else { a };
        let largest = |a: usize, b: usize| if at(values, b) > at(values, a) { b } else { a };
        // what is none begins a gap
        let first = values.iter().position(|value| value.is_nan()).unwrap_or(0);
        let (low, high) = ((0..values.len()).fold(first, least), (0..values.len()).fold(first, largest));
        for (time, value) in [point(low.min(high)), point(low.max(high))] {
            x.push(time);
            y.push(value);
        }
    }
    (x, y)
}

/// The position of the contact over time, as a second axis in mm; none where there are too few samples.
pub(crate) fn positions(time: &[f64], position: &[f64]) -> Option<SecondAxis> {
    let stride = time.len().div_ceil(PLACES).max(1);
    let last = time.len().checked_sub(1).filter(|last| *last > 0)?;
    let kept: Vec<usize> = (0..last).step_by(stride).chain([last]).collect();
    Some(SecondAxis {
        label: "Position $s$ (mm)".to_owned(),
        x: picked(time, &kept),
        value: kept.iter().map(|k| 1e3 * at(position, *k)).collect(),
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

    /// What happens within the ramps does not set the axis.
    #[test]
    fn the_logarithmic_axis_is_that_of_what_comes_after_the_ramps() {
        let line = Layer::line("", vec![0.0, 1.0, 2.0], vec![1e3, 5.0, 2.0], Role::Series(0));
        let panel = |layers| Panel::new(Axis::linear(""), Axis::linear(""), layers);
        let range = |layers| logarithmic(panel(layers)).y.range.unwrap();
        assert_eq!(range(vec![line.clone()]).1, ROOM * 1e3);
        assert_eq!(range(vec![line, Layer::vertical_rule(0.5, "")]), (DECADES * 5.0, ROOM * 5.0));
    }

    /// A sine about a mean has its amplitude in every column of whole periods.
    #[test]
    fn a_swing_is_an_amplitude() {
        let time: Vec<f64> = (0..70_000).map(f64::from).collect();
        let values: Vec<f64> =
            time.iter().map(|t| 5.0 + 3.0 * (0.1 * std::f64::consts::TAU * t).sin()).collect();
        let (x, y) = swings(&time, &values);
        assert_eq!((x.len(), x[0]), (COLUMNS, 49.5));
        assert!(y.iter().all(|y| (y - 3.0).abs() < 1e-9), "{y:?}");
    }
}
