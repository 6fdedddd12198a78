//! What is stored of a motion: signals, and states of the points over time.

use super::settings::AssemblyMarch;
use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use judder_assembly::contact_point::ContactPoint;
use judder_numerics::contact_state::ContactState;
use judder_store::{Dataset, Variable, VariableValues};

/// The arrays that grow: time, the signals of the contacts and of the observed points, velocities and states of the contact points over time.
pub(super) fn growing(of: &AssemblySubject<'_>) -> Vec<Variable> {
    let time = signal("time", "s", "time since the start", "Time $t$ (s)".to_owned());
    let interfaces = &of.built.assembly.interfaces;
    let forces = interfaces.iter().flat_map(|interface| forces(&interface.name));
    let observed = of.built.watched.iter().flat_map(|own| observed(&own.name));
    let points: usize = interfaces.iter().map(|interface| interface.points.len()).sum();
    let of_points = if points > 0 { over_points(points).to_vec() } else { Vec::new() };
    std::iter::once(time).chain(forces).chain(observed).chain(of_points).collect()
}

/// What is stored beside them: how it was marched, and the contact points.
pub(super) fn rest(
    of: &AssemblySubject<'_>,
    asked: &AssemblyMarch,
    [sample_rate, pass_band]: [f64; 2],
    frequency: Option<f64>,
) -> Result<Dataset, ModelError> {
    let mut dataset = Dataset::new()
        .attribute("kind", super::KIND.name)?
        .attribute("method", asked.method.name())?
        .attribute("step_s", asked.step)?
        .attribute("transient_s", asked.transient)?
        .attribute("sample_rate_hz", sample_rate)?
        .attribute("pass_band_hz", pass_band)?;
    if let Some(frequency) = frequency {
        dataset = dataset.attribute("frequency_hz", frequency)?;
    }
    let touches = of.built.assembly.interfaces.iter().any(|interface| !interface.points.is_empty());
    if touches { contact_points(dataset, of) } else { Ok(dataset) }
}

/// A signal over time with its unit, what it is, and how an axis is labelled.
fn signal(name: &str, unit: &str, words: &str, label: String) -> Variable {
    let variable = Variable::new(name, &["time"], &[0], Vec::<f64>::new()).units(unit);
    variable.long_name(words).attribute("label", label)
}

/// N and T of a contact.
fn forces(contact: &str) -> [Variable; 2] {
    [
        signal(
            &format!("{contact}.normal_force"),
            "N",
            &format!("normal forces of {contact}, means over the time of a sample"),
            format!("Normal force of {contact}, $N$ (N)"),
        ),
        signal(
            &format!("{contact}.friction_force"),
            "N",
            &format!("friction on the slider along the slip of {contact}, means over the time of a sample"),
            format!("Friction of {contact}, $T$ (N)"),
        ),
    ]
}

/// Acceleration and velocity of an observed displacement.
fn observed(name: &str) -> [Variable; 2] {
    [
        signal(
            name,
            "m/s^2",
            &format!("acceleration of the observed point, {name}"),
            format!("Acceleration {name}, $ü$ (m/s^{{2}})"),
        ),
        signal(
            &format!("{name}.velocity"),
            "m/s",
            &format!("velocity of the observed point, {name}"),
            format!("Velocity {name}, $u̇$ (m/s)"),
        ),
    ]
}

/// The contact points, their contacts and places.
pub(in crate::assembly) fn contact_points(
    dataset: Dataset,
    of: &AssemblySubject<'_>,
) -> Result<Dataset, ModelError> {
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
fn over_points(points: usize) -> [Variable; 4] {
    let (dimensions, shape) = (["state_time", "contact_point"], [0, points]);
    let numbers = Vec::<f64>::new;
    let velocity = Variable::new("velocity", &["time", "contact_point"], &shape, numbers());
    let words = "velocity of the slider beside the track's undisturbed place, along the slip";
    let states = Variable::classes("state", &dimensions, &shape, Vec::new(), &ContactState::CODES);
    let forces = Variable::new("point_normal_force", &dimensions, &shape, numbers());
    [
        velocity.units("m/s").long_name(words),
        Variable::coordinate("state_time", numbers()).units("s").long_name("time of the states"),
        states.long_name("what each contact point does"),
        forces.units("N").long_name("normal force of each contact point"),
    ]
}
