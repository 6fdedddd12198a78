//! What is kept of what drives a motion: factors and signals at the times of its signals.

use super::drive::{MotionDrive, SignalName};
use crate::error::ModelError;
use judder_nonsmooth::course::{Course, TimeFactor};
use judder_store::{Dataset, Variable};

/// The arrays of the course, with their words.
pub(in crate::assembly::march) const COURSE: [(&str, &str); 3] =
    [("course.speed", "speed"), ("course.load", "loads"), ("course.friction", "friction")];

/// A dataset with what drives its motion at these times in s.
pub(in crate::assembly::march) fn with_drive(
    mut dataset: Dataset,
    drive: &MotionDrive,
    times: &[f64],
) -> Result<Dataset, ModelError> {
    let over_time = |name: &str, unit: &str, words: &str, label: String, values: Vec<f64>| {
        let variable = Variable::new(name, &["time"], &[values.len()], values).units(unit);
        variable.long_name(words).attribute("label", label)
    };
    let Course { speed, load, friction } = &drive.course;
    let factors = [std::slice::from_ref(speed), std::slice::from_ref(load), friction];
    let changing =
        COURSE.into_iter().zip(factors).filter(|(_, factors)| !factors.iter().all(TimeFactor::is_one));
    for ((name, words), factors) in changing {
        let at = |time: &f64| factors.iter().map(|factor| factor.at(*time)).product();
        let values = times.iter().map(at).collect();
        let words = format!("what {words} is multiplied by");
        dataset = dataset.with(over_time(name, "1", &words, "Factor (1)".to_owned(), values))?;
    }
    for (excitation, SignalName { name, is_force, words, .. }) in drive.excitations.iter().zip(&drive.names) {
        let mut signal = excitation.signal.clone();
        let values = times.iter().map(|time| signal.at(*time)).collect();
        let (unit, label) = match is_force {
            true => ("N", format!("Force {name}, $F$ (N)")),
            false => ("m/s^2", format!("Acceleration {name}, $a$ (m/s^{{2}})")),
        };
        dataset = dataset.with(over_time(name, unit, words, label, values))?;
    }
    Ok(dataset)
}

/// A dataset with the accelerations beside what does not shake of observed displacements, each with its name and its samples beside the base: these lie `lag` behind
/// the times of the signals.
pub(in crate::assembly::march) fn with_absolute(
    mut dataset: Dataset,
    drive: &MotionDrive,
    times: &[f64],
    lag: f64,
    observed: impl Iterator<Item = Result<(String, Vec<f64>), ModelError>>,
) -> Result<Dataset, ModelError> {
    let shakes = |own: &SignalName, name: &str| {
        !own.is_force && name.rsplit_once('.').is_some_and(|(_, direction)| direction == own.direction)
    };
    for own in observed {
        let (name, mut values) = own?;
        let pairs = drive.excitations.iter().zip(&drive.names);
        let bases: Vec<_> = pairs.filter(|(_, own)| shakes(own, &name)).collect();
        if bases.is_empty() {
            continue;
        }
        for (excitation, _) in bases {
            let mut signal = excitation.signal.clone();
            values.iter_mut().zip(times).for_each(|(value, time)| *value += signal.at(time - lag));
        }
        let variable = Variable::new(&format!("{name}.absolute"), &["time"], &[values.len()], values);
        let words = format!("acceleration of the observed point beside what does not shake, {name}");
        let label = format!("Acceleration {name}, with the base's (m/s^{{2}})");
        dataset = dataset.with(variable.units("m/s^2").long_name(&words).attribute("label", label))?;
    }
    Ok(dataset)
}
