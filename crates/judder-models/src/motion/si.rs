//! Motions in SI: what the units of a model are in seconds and metres, where its case is written in SI.

use crate::error::ModelError;
use judder_store::{Dataset, Results, Table, VariableValues};
use serde_json::{Map, Value, json};
use std::borrow::Cow;
use std::f64::consts::TAU;

/// The units of a model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SiUnits {
    /// That of time, in s: 1/ω_nx of the oscillator.
    pub(crate) second: f64,
    /// That of displacements, in m: x0 = F_n/k_x of the oscillator.
    pub(crate) metre: f64,
    /// That of energies, in J: k_x x0² of the oscillator.
    pub(crate) joule: f64,
}

/// Where energy came from and went: the works after the transient and the change of what is stored.
#[derive(Debug, Clone, Copy, PartialEq, Results)]
pub(crate) struct EnergyFlow {
    pub(crate) substrate: f64,
    pub(crate) sliding: f64,
    pub(crate) friction: f64,
    pub(crate) normal: f64,
    pub(crate) damping: f64,
    pub(crate) change: f64,
}

impl EnergyFlow {
    /// All times a unit.
    fn times(self, unit: f64) -> Self {
        Self {
            substrate: unit * self.substrate,
            sliding: unit * self.sliding,
            friction: unit * self.friction,
            normal: unit * self.normal,
            damping: unit * self.damping,
            change: unit * self.change,
        }
    }
}

/// What is told of a motion in SI.
#[derive(Debug, Clone, Copy, PartialEq, Results)]
pub(crate) struct MotionInSi {
    /// rms of x about its mean
    #[result(unit = "m")]
    rms_m: f64,
    /// mean of x
    #[result(unit = "m")]
    mean_m: f64,
    /// of a cycle; the mean time of an oscillation where there is none
    #[result(unit = "s")]
    period_s: Option<f64>,
    /// its inverse
    #[result(unit = "Hz")]
    frequency_hz: Option<f64>,
    /// where energy came from and went, in J
    energy_j: EnergyFlow,
}

/// What is measured by what, of the arrays of motions.
#[derive(Clone, Copy)]
enum MotionDimension {
    Time,
    Length,
    Velocity,
    Frequency,
}

/// The arrays of motions that have a dimension, and what stands at their axes in SI.
const ARRAYS: [(&str, MotionDimension, &str); 27] = [
    ("time", MotionDimension::Time, "Time $t$ (s)"),
    ("event_time", MotionDimension::Time, ""),
    ("path_time", MotionDimension::Time, ""),
    ("oscillation_time", MotionDimension::Time, ""),
    ("oscillation_period", MotionDimension::Time, ""),
    ("settling_time", MotionDimension::Time, "Settling time (s)"),
    ("period", MotionDimension::Time, ""),
    ("x", MotionDimension::Length, "Displacement $x$ (µm)"),
    ("y", MotionDimension::Length, "Displacement $y$ (µm)"),
    ("event_x", MotionDimension::Length, ""),
    ("event_y", MotionDimension::Length, ""),
    ("path_x", MotionDimension::Length, ""),
    ("path_y", MotionDimension::Length, ""),
    ("section_x", MotionDimension::Length, "Displacement $x$ (µm)"),
    ("section_y", MotionDimension::Length, "Displacement $y$ (µm)"),
    ("start_x", MotionDimension::Length, "Displacement $x$ (µm)"),
    ("start_y", MotionDimension::Length, "Displacement $y$ (µm)"),
    ("amplitude", MotionDimension::Length, "Amplitude of $x$ (µm)"),
    ("rms", MotionDimension::Length, "rms of $x$ (µm)"),
    ("branch_rms", MotionDimension::Length, ""),
    ("fold_rms", MotionDimension::Length, ""),
    ("frequency", MotionDimension::Frequency, "Frequency (Hz)"),
    ("velocity_x", MotionDimension::Velocity, "Velocity d$x$/d$t$ (mm/s)"),
    ("velocity_y", MotionDimension::Velocity, "Velocity d$y$/d$t$ (mm/s)"),
    ("start_velocity_x", MotionDimension::Velocity, "Velocity d$x$/d$t$ (mm/s)"),
    ("start_velocity_y", MotionDimension::Velocity, "Velocity d$y$/d$t$ (mm/s)"),
    ("relative_velocity", MotionDimension::Velocity, "Relative velocity $v_{rel}$ (mm/s)"),
];
/// Those of velocities beside them, which stand at no axis of their own.
const VELOCITIES: [&str; 4] = ["event_velocity_x", "event_velocity_y", "path_velocity_x", "path_velocity_y"];

impl SiUnits {
    /// A motion in SI.
    pub(crate) fn motion(self, [rms, mean]: [f64; 2], period: Option<f64>, energy: EnergyFlow) -> MotionInSi {
        let period_s = period.map(|period| period * self.second);
        MotionInSi {
            rms_m: rms * self.metre,
            mean_m: mean * self.metre,
            period_s,
            frequency_hz: period_s.map(f64::recip),
            energy_j: energy.times(self.joule),
        }
    }

    /// Says what the units of an array are.
    pub(crate) fn told_in(self, dataset: Dataset) -> Result<Dataset, ModelError> {
        Ok(dataset.attribute(
            "si_units",
            json!({ "second": self.second, "metre": self.metre, "joule": self.joule }),
        )?)
    }

    /// The units that the attributes of a dataset tell; none where its case is written in groups.
    pub(crate) fn of(attributes: &Map<String, Value>) -> Option<Self> {
        let told = attributes.get("si_units")?;
        let number = |name: &str| told.get(name).and_then(Value::as_f64).filter(|own| *own > 0.0);
        Some(Self { second: number("second")?, metre: number("metre")?, joule: number("joule")? })
    }

    /// What a number is multiplied by to be shown, and the unit in which it is then.
    fn shown(self, measured: MotionDimension) -> (f64, &'static str) {
        match measured {
            MotionDimension::Time => (self.second, "s"),
            MotionDimension::Length => (1e6 * self.metre, "µm"),
            MotionDimension::Velocity => (1e3 * self.metre / self.second, "mm/s"),
            MotionDimension::Frequency => (1.0 / (TAU * self.second), "Hz"),
        }
    }

    /// A quantity as a column in SI beside that in groups; nothing of one without dimension.
    pub(crate) fn add_column(self, table: Table, name: &str, values: &[f64]) -> Result<Table, ModelError> {
        let of = |(own, measured, _): &(&str, MotionDimension, &str)| (*own == name).then_some(*measured);
        let Some(measured) = ARRAYS.iter().find_map(of) else { return Ok(table) };
        let (factor, unit) = match measured {
            MotionDimension::Time => (self.second, "s"),
            MotionDimension::Length => (self.metre, "m"),
            MotionDimension::Velocity => (self.metre / self.second, "m/s"),
            MotionDimension::Frequency => (1.0 / (TAU * self.second), "Hz"),
        };
        Ok(table.column(name, unit, values.iter().map(|value| factor * value).collect::<Vec<_>>())?)
    }
}

/// The arrays of a motion in the units in which they are drawn: SI where the case is written in SI.
pub(crate) fn shown(dataset: &Dataset) -> Cow<'_, Dataset> {
    match SiUnits::of(dataset.attributes()).and_then(|units| converted(dataset, units)) {
        Some(converted) => Cow::Owned(converted),
        None => Cow::Borrowed(dataset),
    }
}

fn converted(dataset: &Dataset, units: SiUnits) -> Option<Dataset> {
    let mut all = Dataset::new();
    for variable in dataset.variables() {
        let known = ARRAYS.iter().find(|(name, ..)| *name == variable.name);
        let measured = known
            .map(|(_, measured, _)| *measured)
            .or_else(|| VELOCITIES.contains(&variable.name.as_str()).then_some(MotionDimension::Velocity));
        let mut variable = variable.clone();
        if let (Some(measured), VariableValues::F64(values)) = (measured, &mut variable.data) {
            let (factor, unit) = units.shown(measured);
            values.iter_mut().for_each(|value| *value *= factor);
            unit.clone_into(&mut variable.units);
        }
        if let Some((.., label)) = known.filter(|(.., label)| !label.is_empty()) {
            variable = variable.attribute("label", *label);
        }
        all = all.with(variable).ok()?;
    }
    for (name, value) in dataset.attributes() {
        all = all.attribute(name, value.clone()).unwrap_or_default();
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_store::Variable;

    #[test]
    fn arrays_are_drawn_in_si_where_units_are_known() {
        let dataset = || {
            Dataset::new()
                .with(Variable::coordinate("time", vec![0.0, 2.0]).units("1"))
                .and_then(|own| own.with(Variable::new("x", &["time"], &[2], vec![1.0, 3.0]).units("1")))
                .unwrap()
        };
        let units = SiUnits { second: 0.025, metre: 4e-3, joule: 8e-4 };
        let told = units.told_in(dataset()).unwrap();
        let shown_in_si = shown(&told);
        let values = |name: &str| match &shown_in_si.variable(name).unwrap().data {
            VariableValues::F64(values) => values.clone(),
            _ => panic!("numbers"),
        };
        assert_eq!((values("time"), values("x")), (vec![0.0, 0.05], vec![4e3, 1.2e4]));
        assert_eq!(shown_in_si.variable("x").unwrap().units, "µm");
        assert!(matches!(shown(&dataset()), Cow::Borrowed(_)));
        let [substrate, sliding, friction, normal, damping, change] = [3.0, -1.0, 2.0, 0.5, -2.0, 0.5];
        let energy = EnergyFlow { substrate, sliding, friction, normal, damping, change };
        let motion = units.motion([0.5, 1.0], Some(6.0), energy);
        assert_eq!((motion.energy_j.friction, motion.energy_j.change), (1.6e-3, 4e-4));
        assert_eq!(motion.rms_m, 2e-3);
        assert!((motion.period_s.unwrap() - 0.15).abs() < 1e-15);
        assert!((motion.frequency_hz.unwrap() - 1.0 / 0.15).abs() < 1e-12);
    }
}
