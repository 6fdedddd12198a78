//! A limit cycle: the motions that lead to it, and one period.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::contributions::{FREQUENCIES, LEFT_OVER, SHARES};
use crate::assembly::march::figure::states_over;
use crate::motion::pictures::multipliers;
use judder_report::{Axis, Layer, Legend, Panel, Role};
use judder_store::Variable;
use judder_study::pictures::{StoredArrays, axis, reals, words};
use serde_json::Value;

/// Growth rate and frequency over the amplitude, forces and states of each contact over a period, the portrait of a point, the observed points, the shares of the modes, the Floquet multipliers.
pub(super) fn limit_cycle(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let mut panels: Vec<Panel> = over_amplitude(dataset).into_iter().collect();
    let Some(phase) = dataset.variable("phase") else { return Some(panels).filter(|own| !own.is_empty()) };
    let across = axis(phase).over(0.0, 1.0);
    let names = words(dataset, "contact").unwrap_or_default();
    let mut contacts: Vec<&String> = names.iter().collect();
    contacts.dedup();
    for contact in contacts {
        for what in ["normal_force", "friction_force"] {
            panels.push(over_period(dataset, &across, dataset.variable(&format!("{contact}.{what}"))?)?);
        }
        let states = states_over(dataset, contact, ("phase", reals(dataset, "phase")?), 0, across.clone())?;
        panels.push(states.with_title(format!("{contact}: states of the points")));
    }
    panels.push(portrait(dataset)?);
    for variable in dataset.variables().iter().filter(|own| own.units == "m/s^2") {
        panels.push(over_period(dataset, &across, variable)?);
    }
    panels.extend(modes(dataset));
    panels.extend(multipliers(dataset));
    Some(panels)
}

/// σ over the amplitude, with the cycle where it passes through zero.
fn over_amplitude(dataset: &StoredArrays<'_>) -> Option<Panel> {
    let (amplitude, growth) = (dataset.variable("amplitude")?, dataset.variable("growth_rate")?);
    for name in ["amplitude", "growth_rate"] {
        dataset.over(name, &["motion"])?;
    }
    let values = |own: &Variable| reals(dataset, &own.name).map(<[f64]>::to_vec);
    let line =
        Layer::line("motions of the mode", values(amplitude)?, values(growth)?, Role::Series(0).solid());
    let mut layers = vec![Layer::horizontal_rule(0.0, ""), line];
    let number = |name: &str| dataset.attributes().get(name).and_then(Value::as_f64);
    if let Some(cycle) = number("cycle_amplitude") {
        layers.push(Layer::points("limit cycle", vec![cycle], vec![0.0], Role::Series(1)));
    }
    let across = Axis::log(axis(amplitude).label);
    Some(Panel::new(across, axis(growth), layers).with_legend(Legend::Below))
}

/// A signal over the period.
fn over_period(dataset: &StoredArrays<'_>, across: &Axis, signal: &Variable) -> Option<Panel> {
    dataset.over(&signal.name, &["phase"])?;
    let line = Layer::line(
        "",
        reals(dataset, "phase")?.to_vec(),
        reals(dataset, &signal.name)?.to_vec(),
        Role::Series(0).solid(),
    );
    Some(Panel::new(across.clone(), axis(signal), vec![line]).with_legend(Legend::Below))
}

/// The share of each mode over its frequency: a stem from zero.
fn modes(dataset: &StoredArrays<'_>) -> Option<Panel> {
    for name in [FREQUENCIES, SHARES] {
        dataset.over(name, &["mode"])?;
    }
    let (across, up) = (dataset.variable(FREQUENCIES)?, dataset.variable(SHARES)?);
    let (frequencies, shares) = (reals(dataset, FREQUENCIES)?, reals(dataset, SHARES)?);
    let stems = frequencies.iter().zip(shares);
    let (x, y): (Vec<f64>, Vec<f64>) =
        stems.flat_map(|(at, share)| [(*at, 0.0), (*at, *share), (f64::NAN, f64::NAN)]).unzip();
    let layers = vec![
        Layer::line("", x, y, Role::Series(0).solid()),
        Layer::points("", frequencies.to_vec(), shares.to_vec(), Role::Series(0)),
    ];
    let highest = frequencies.iter().copied().fold(0.0, f64::max);
    // rigid motions alone lie at 0 Hz
    let reach = if highest > 0.0 { 1.05 * highest } else { 1.0 };
    let panel = Panel::new(axis(across).over(0.0, reach), axis(up).over(0.0, 1.05), layers);
    let left_over = dataset.attributes().get(LEFT_OVER).and_then(Value::as_f64);
    let left_over = left_over.map(|share| format!(", {:.1} % left over", 100.0 * share));
    Some(panel.with_title(format!("modes of frictionless contact{}", left_over.unwrap_or_default())))
}

/// Slip velocity over displacement of the point whose velocity swings most.
fn portrait(dataset: &StoredArrays<'_>) -> Option<Panel> {
    for name in ["slip_displacement", "slip_velocity"] {
        dataset.over(name, &["phase", "contact_point"])?;
    }
    let (displacement, velocity) = (reals(dataset, "slip_displacement")?, reals(dataset, "slip_velocity")?);
    let points = words(dataset, "contact")?.len();
    let of = |all: &[f64], point: usize| {
        all.iter().skip(point).step_by(points.max(1)).copied().collect::<Vec<f64>>()
    };
    let swing = |point: &usize| {
        let own = of(velocity, *point);
        own.iter().copied().fold(f64::NEG_INFINITY, f64::max)
            - own.iter().copied().fold(f64::INFINITY, f64::min)
    };
    let most = (0..points).max_by(|a, b| swing(a).total_cmp(&swing(b)))?;
    let closed = |all: &[f64]| {
        let own = of(all, most);
        own.iter().chain(own.first()).copied().collect::<Vec<f64>>()
    };
    let micrometres = closed(displacement).iter().map(|own| 1e6 * own).collect();
    let layers = vec![
        Layer::horizontal_rule(0.0, ""),
        Layer::line("", micrometres, closed(velocity), Role::Series(0).solid()),
    ];
    let (across, up) = (
        Axis::linear("Displacement along the slip about its mean (µm)"),
        Axis::linear("Slip velocity $v$ (m/s)"),
    );
    Some(Panel::new(across, up, layers).with_title(format!("contact point {}", most + 1)))
}
