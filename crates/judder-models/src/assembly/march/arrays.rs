//! What is stored of a motion: signals, and states of the points over time.

use super::recorded::{Recorded, Signals};
use super::settings::AssemblyMarch;
use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use judder_assembly::contact_point::ContactPoint;
use judder_numerics::contact_state::ContactState;
use judder_store::{Dataset, Variable, VariableValues};

/// Signals of the contacts and of the observed points, states of the contact points over time.
pub(super) fn dataset(
    of: &AssemblySubject<'_>,
    asked: &AssemblyMarch,
    recorded: &Recorded,
    signals: Signals,
) -> Result<Dataset, ModelError> {
    let time = Variable::coordinate("time", signals.time).units("s").long_name("time since the start");
    let dataset = Dataset::new()
        .attribute("method", asked.method.name())?
        .attribute("step_s", asked.step)?
        .attribute("transient_s", asked.transient)?
        .attribute("sample_rate_hz", signals.rate)?
        .with(time.attribute("label", "Time $t$ (s)"))?;
    let interfaces = &of.built.assembly.interfaces;
    let points: usize = interfaces.iter().map(|interface| interface.points.len()).sum();
    let mut columns = signals.columns.into_iter();
    let names = interfaces.iter().map(|interface| &interface.name);
    let dataset = names.into_iter().try_fold(dataset, |dataset, name| forces(dataset, name, &mut columns))?;
    let velocities: Vec<Vec<f64>> = columns.by_ref().take(points).collect();
    let watched = of.built.watched.iter();
    let dataset =
        watched.into_iter().try_fold(dataset, |dataset, own| observed(dataset, &own.name, &mut columns))?;
    if points == 0 {
        return Ok(dataset);
    }
    over_points(contact_points(dataset, of)?, recorded, &velocities)
}

/// A signal over time with its unit, what it is, and how an axis is labelled.
fn signal(name: &str, unit: &str, words: &str, label: String, values: Vec<f64>) -> Variable {
    let variable = Variable::new(name, &["time"], &[values.len()], values).units(unit);
    variable.long_name(words).attribute("label", label)
}

/// N and T of a contact.
fn forces(
    dataset: Dataset,
    contact: &str,
    columns: &mut impl Iterator<Item = Vec<f64>>,
) -> Result<Dataset, ModelError> {
    let mut next = || columns.next().unwrap_or_default();
    let normal = signal(
        &format!("{contact}.normal_force"),
        "N",
        &format!("normal forces of {contact}"),
        format!("Normal force of {contact}, $N$ (N)"),
        next(),
    );
    let friction = signal(
        &format!("{contact}.friction_force"),
        "N",
        &format!("friction on the slider along the slip of {contact}"),
        format!("Friction of {contact}, $T$ (N)"),
        next(),
    );
    Ok(dataset.with(normal)?.with(friction)?)
}

/// Acceleration and velocity of an observed displacement.
fn observed(
    dataset: Dataset,
    name: &str,
    columns: &mut impl Iterator<Item = Vec<f64>>,
) -> Result<Dataset, ModelError> {
    let mut next = || columns.next().unwrap_or_default();
    let acceleration = signal(
        name,
        "m/s^2",
        &format!("acceleration of the observed point, {name}"),
        format!("Acceleration {name}, $ü$ (m/s^{{2}})"),
        next(),
    );
    let velocity = signal(
        &format!("{name}.velocity"),
        "m/s",
        &format!("velocity of the observed point, {name}"),
        format!("Velocity {name}, $u̇$ (m/s)"),
        next(),
    );
    Ok(dataset.with(acceleration)?.with(velocity)?)
}

/// The contact points, their contacts and places.
fn contact_points(dataset: Dataset, of: &AssemblySubject<'_>) -> Result<Dataset, ModelError> {
    let interfaces = &of.built.assembly.interfaces;
    let all: Vec<(&str, &ContactPoint)> =
        interfaces.iter().flat_map(|own| own.points.iter().map(|point| (own.name.as_str(), point))).collect();
    let of_points =
        |name: &str, values: VariableValues| Variable::new(name, &["contact_point"], &[all.len()], values);
    let numbers = (1..=all.len() as i64).collect::<Vec<_>>();
    let names: Vec<String> = all.iter().map(|(name, _)| (*name).to_owned()).collect();
    let mut dataset = dataset
        .with(Variable::coordinate("contact_point", numbers).long_name("number of the contact point"))?
        .with(of_points("contact", names.into()).long_name("contact of the point"))?;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let along: Vec<f64> = all.iter().map(|(_, point)| point.place[axis]).collect();
        let words = format!("place of the contact point along {name}");
        dataset = dataset.with(of_points(name, along.into()).units("m").long_name(&words))?;
    }
    Ok(dataset)
}

/// Velocities at the times of the signals, states and normal forces at those of the states.
fn over_points(
    dataset: Dataset,
    recorded: &Recorded,
    velocities: &[Vec<f64>],
) -> Result<Dataset, ModelError> {
    let (points, samples) = (velocities.len(), velocities.first().map_or(0, Vec::len));
    let by_time: Vec<f64> =
        (0..samples).flat_map(|k| velocities.iter().map(move |column| column[k])).collect();
    let times = recorded.state_times();
    let (dimensions, shape) = (["state_time", "contact_point"], [times.len(), points]);
    let velocity = Variable::new("velocity", &["time", "contact_point"], &[samples, points], by_time);
    let words = "velocity of the slider beside the track's undisturbed place, along the slip";
    let states =
        Variable::classes("state", &dimensions, &shape, recorded.states.clone(), &ContactState::CODES);
    let forces = Variable::new("point_normal_force", &dimensions, &shape, recorded.normal_forces.clone());
    Ok(dataset
        .with(velocity.units("m/s").long_name(words))?
        .with(Variable::coordinate("state_time", times).units("s").long_name("time of the states"))?
        .with(states.long_name("what each contact point does"))?
        .with(forces.units("N").long_name("normal force of each contact point"))?)
}
