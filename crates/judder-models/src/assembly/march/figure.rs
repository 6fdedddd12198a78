//! A motion: forces over time, and what every contact point does.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::driven::COURSE;
use crate::sliding::march::figure::{STATES, history, panel, trace};
use judder_numerics::contact_state::ContactState;
use judder_report::figure::{Class, ClassMap};
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_store::Variable;
use judder_study::pictures::{StoredArrays, axis, codes, picked, reals, words};
use serde_json::Value;
use std::f64::consts::SQRT_2;

/// Columns of the picture of states.
const COLUMNS: usize = 900;
/// Periods of the strongest line that are shown closely, at its end.
const CLOSE: f64 = 12.0;

/// Normal and friction forces of each contact, then the states of its points over the whole motion and over its end; what changes over time, and accelerations of the observed
/// points.
pub(super) fn march(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let names = words(dataset, "contact").unwrap_or_default();
    let mut contacts: Vec<&String> = names.iter().collect();
    contacts.dedup();
    let mut panels = Vec::new();
    for contact in contacts {
        for what in ["normal_force", "friction_force"] {
            let panel = history(dataset, &format!("{contact}.{what}"), Role::Series(0).solid())?;
            panels.push(with_transient(dataset, panel));
        }
        panels.push(states(dataset, contact, 0)?.with_title(format!("{contact}: states of the points")));
        if let Some(first) = last_periods(dataset, reals(dataset, "state_time")?) {
            panels.push(states(dataset, contact, first)?.with_title(format!("{contact}: the last periods")));
        }
    }
    panels.extend(course(dataset));
    for variable in
        dataset.variables().iter().filter(|own| own.units == "m/s^2" || own.name.starts_with("force."))
    {
        let panel = history(dataset, &variable.name, Role::Series(0).solid())?;
        panels.push(with_transient(dataset, panel));
    }
    panels.extend(octaves(dataset));
    Some(panels)
}

/// Levels of the observed points, each octave from edge to edge; what is unknown is a gap.
fn octaves(dataset: &StoredArrays<'_>) -> Option<Panel> {
    let bands = reals(dataset, "octave_band")?;
    let edges = bands.iter().flat_map(|band| [band / SQRT_2, band * SQRT_2]);
    let edges: Vec<f64> = edges.collect();
    let over_bands = |own: &&Variable| own.units == "dB";
    let layer = |(k, own): (usize, &Variable)| {
        dataset.over(&own.name, &["octave_band"])?;
        let levels = reals(dataset, &own.name)?.iter().flat_map(|level| [*level; 2]).collect();
        let name = own.name.trim_end_matches(".level");
        Some(Layer::line(name, edges.clone(), levels, Role::Series(k).solid()))
    };
    let layers: Vec<Layer> =
        dataset.variables().iter().filter(over_bands).enumerate().filter_map(layer).collect();
    let first = dataset.variables().iter().find(over_bands)?;
    let across = Axis::log("Frequency (Hz)");
    let panel = Panel::new(across, axis(first), layers).with_legend(Legend::Below);
    Some(panel.with_title("levels after the transient, in octaves"))
}

/// What speeds, loads and friction are multiplied by, where they change.
fn course(dataset: &StoredArrays<'_>) -> Option<Panel> {
    let known = COURSE.into_iter().filter(|(name, _)| dataset.variable(name).is_some());
    let line = |(k, (name, words))| trace(dataset, name, words, Role::Series(k).solid());
    let layers: Vec<Layer> = known.clone().enumerate().filter_map(line).collect();
    let (name, _) = known.clone().next()?;
    panel(dataset, name, layers)
        .map(|panel| with_transient(dataset, panel).with_title("what changes over time"))
}

/// The first instant of the last periods; none where all instants are of these.
fn last_periods(dataset: &StoredArrays<'_>, times: &[f64]) -> Option<usize> {
    let frequency = dataset.attributes().get("frequency_hz").and_then(Value::as_f64)?;
    let from = times.last()? - CLOSE / frequency;
    Some(times.partition_point(|time| *time < from)).filter(|first| 2 * first > times.len())
}

/// The same panel with the end of the transient.
fn with_transient(dataset: &StoredArrays<'_>, mut panel: Panel) -> Panel {
    let until = dataset.attributes().get("transient_s").and_then(Value::as_f64);
    if let Some(until) = until.filter(|until| *until > 0.0) {
        panel.layers.push(Layer::vertical_rule(until, ""));
        panel.layers.push(Layer::key("end of the transient", Role::Reference.dotted()));
    }
    panel
}

/// The axis of so many points: of few each has its number, and no number stands between them.
fn of_points(count: usize) -> Axis {
    const FEW: usize = 8;
    let axis = Axis::linear("Contact point").over(0.5, count as f64 + 0.5);
    match count {
        0..=FEW => Axis { names: (1..=count).map(|own| (own as f64, own.to_string())).collect(), ..axis },
        _ => axis,
    }
}

/// The states of the points of a contact from an instant on: time across, points in their order upwards.
fn states(dataset: &StoredArrays<'_>, contact: &str, first: usize) -> Option<Panel> {
    let times = reals(dataset, "state_time")?;
    let (unit, factor) = if *times.last()? < 1.0 { ("ms", 1e3) } else { ("s", 1.0) };
    let columns: Vec<f64> = times.iter().map(|time| factor * time).collect();
    states_over(dataset, contact, ("state_time", &columns), first, Axis::linear(format!("Time $t$ ({unit})")))
}

/// The same over these columns, one a row of the states; `rows` is their dimension.
pub(in crate::assembly) fn states_over(
    dataset: &StoredArrays<'_>,
    contact: &str,
    (rows, columns): (&str, &[f64]),
    first: usize,
    across: Axis,
) -> Option<Panel> {
    dataset.over("contact", &["contact_point"])?;
    dataset.over("state", &[rows, "contact_point"])?;
    let (names, all) = (words(dataset, "contact")?, codes(dataset, "state")?);
    let own = names.iter().enumerate().filter(|(_, own)| *own == contact);
    let own: Vec<usize> = own.map(|(point, _)| point).collect();
    let shown: Vec<usize> = (first..columns.len())
        .step_by(columns.len().saturating_sub(first).div_ceil(COLUMNS).max(1))
        .collect();
    let code =
        |instant: usize, point: usize| all.get(instant * names.len() + point).copied().unwrap_or(u8::MAX);
    let is_there = |state: ContactState| {
        shown.iter().any(|instant| own.iter().any(|point| code(*instant, *point) == state.number()))
    };
    let drawn: Vec<(ContactState, Role)> = STATES.into_iter().filter(|(state, _)| is_there(*state)).collect();
    let place = |number: u8| drawn.iter().position(|(state, _)| state.number() == number).unwrap_or(0) as u8;
    let map = ClassMap {
        x: picked(columns, &shown),
        y: (1..=own.len()).map(|number| number as f64).collect(),
        codes: own
            .iter()
            .flat_map(|point| shown.iter().map(move |instant| (*instant, *point)))
            .map(|(instant, point)| place(code(instant, point)))
            .collect(),
        classes: drawn.iter().map(|(state, role)| Class::new(state.name(), *role)).collect(),
    };
    Some(Panel::new(across, of_points(own.len()), vec![Layer::Classes(map)]).with_legend(Legend::Below))
}

#[cfg(test)]
mod tests {
    use super::of_points;

    #[test]
    fn few_points_have_their_numbers() {
        assert_eq!(of_points(1).names, [(1.0, "1".to_owned())]);
        assert_eq!(of_points(3).names.len(), 3);
        assert!(of_points(9).names.is_empty());
        assert_eq!(of_points(1).range, Some((0.5, 1.5)));
    }
}
