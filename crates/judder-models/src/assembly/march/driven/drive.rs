//! What the keys make of an assembly.

use super::settings::{
    CourseSettings, DrivenSettings, FactorSettings, FrictionOverTemperature, TemperatureSettings,
};
use super::signal::{SignalSettings, SweepWord, SwingFrequency, dimension};
use crate::assembly::AssemblySubject;
use crate::assembly::build::Unassembled;
use crate::assembly::case::load::{Load, LoadAmount};
use crate::assembly::march::settings::AssemblyMarch;
use crate::error::ModelError;
use crate::number_columns::number_columns;
use judder_keys::declared::Number;
use judder_keys::dimension::Dimension;
use judder_keys::file_reference::FileReference;
use judder_nonsmooth::NonsmoothError;
use judder_nonsmooth::course::{Course, TimeFactor, TimeTable};
use judder_nonsmooth::excitation::{BandNoise, DrivingSignal, Excitation, FrequencySweep};
use judder_numerics::words::plain;
use judder_study::model::Refusal;

/// What drives a motion.
pub(in crate::assembly::march) struct MotionDrive {
    pub(in crate::assembly::march) course: Course,
    pub(in crate::assembly::march) excitations: Vec<Excitation>,
    /// What each signal of the case is; behind them may be the inertia of what travels.
    pub(super) names: Vec<SignalName>,
}

/// What a signal is.
pub(super) struct SignalName {
    /// As arrays call it.
    pub(super) name: String,
    pub(super) is_force: bool,
    pub(super) direction: &'static str,
    pub(super) words: String,
}

/// Why nothing is driven so.
pub(in crate::assembly::march) enum Undriven {
    /// A key of the analysis is to blame, by its dotted path.
    Key(Unassembled),
    /// A file cannot be used.
    Model(ModelError),
}

impl From<Unassembled> for Undriven {
    fn from(unassembled: Unassembled) -> Self {
        Self::Key(unassembled)
    }
}

impl From<ModelError> for Undriven {
    fn from(error: ModelError) -> Self {
        Self::Model(error)
    }
}

impl From<Undriven> for ModelError {
    fn from(undriven: Undriven) -> Self {
        match undriven {
            Undriven::Key(unassembled) => unassembled.into(),
            Undriven::Model(error) => error,
        }
    }
}

impl Undriven {
    /// As what is refused before a run.
    pub(in crate::assembly::march) fn refusal(self) -> Result<Refusal, ModelError> {
        match self {
            Self::Key(Unassembled { path, cause }) => Ok(Refusal::key(path, *cause)),
            Self::Model(error) => Err(error),
        }
    }
}

/// The error of a key.
fn at<T>(path: &str, made: Result<T, NonsmoothError>) -> Result<T, Undriven> {
    made.map_err(|error| Unassembled::because(path, &error).into())
}

impl MotionDrive {
    /// What the keys of a march make of an assembly, files read.
    pub(in crate::assembly::march) fn new(
        of: &AssemblySubject<'_>,
        asked: &AssemblyMarch,
    ) -> Result<Self, Undriven> {
        let driven = &asked.driven;
        let course = driven.course()?;
        let (mut excitations, mut names) = (Vec::new(), Vec::new());
        for (k, own) in driven.base.iter().flatten().enumerate() {
            let path = format!("base.{k}");
            let signal = signal(&own.acceleration, asked, &format!("{path}.acceleration"))?;
            let forces = of.built.beside_base(of.case, own.direction, &format!("{path}.direction"))?;
            excitations.push(Excitation { signal, forces });
            let direction = own.direction.name();
            names.push(SignalName {
                name: format!("base.{}.{direction}", k + 1),
                is_force: false,
                direction,
                words: format!("acceleration of the base along {direction}"),
            });
        }
        for (k, own) in driven.forces.iter().flatten().enumerate() {
            let path = format!("forces.{k}");
            let signal = signal(&own.force, asked, &format!("{path}.force"))?;
            let forces = of.built.unit_force(&own.nodes, own.direction, &path)?;
            excitations.push(Excitation { signal, forces });
            let direction = own.direction.name();
            names.push(SignalName {
                name: format!("force.{}.{direction}", k + 1),
                is_force: true,
                direction,
                words: format!("force on {} along {direction}", own.nodes.words()),
            });
        }
        if !course.speed.is_constant() && !of.built.travelling.is_empty() {
            let forces = of.built.carried_along(of.case, "course.speed")?;
            excitations.push(Excitation { signal: DrivingSignal::Rate(course.speed.clone()), forces });
        }
        Ok(Self { course, excitations, names })
    }

    /// Whether nothing changes over time.
    pub(in crate::assembly::march) fn is_none(&self) -> bool {
        self.course.is_constant() && self.excitations.is_empty()
    }

    /// What to know of a motion that is driven so.
    pub(in crate::assembly::march) fn warnings(
        &self,
        of: &AssemblySubject<'_>,
        AssemblyMarch { modes, step, .. }: &AssemblyMarch,
    ) -> Vec<String> {
        /// Of a step: samples that lie so close are not between steps by rounding.
        const CLOSE: f64 = 1.0 - 1e-6;
        let mut warnings = Vec::new();
        let imposes = |own: &Load| matches!(own.amount, LoadAmount::Displacement(_));
        if !(self.course.load.is_constant() && self.course.load.at(0.0) == 1.0)
            && of.case.loads.iter().any(imposes)
        {
            warnings.push(
                "displacements that loads impose follow the course without the inertia of what they displace, and gaps at nodes that they displace stay those of the full loads".to_owned(),
            );
        }
        if !self.course.is_constant() && *modes > 0 {
            warnings.push(
                "speeds, loads or friction change over time: the modes in the motion are those about steady sliding with the case's own values".to_owned(),
            );
        }
        for (excitation, own) in self.excitations.iter().zip(&self.names) {
            if let DrivingSignal::Samples(samples) = &excitation.signal
                && let Some(least) = samples.closest().filter(|least| *least < CLOSE * step)
            {
                warnings.push(format!(
                    "samples of the {} lie {} s apart, closer than the steps: what lies between two steps is not seen",
                    own.words,
                    plain(least)
                ));
            }
        }
        let turning = of.case.structures.iter().filter(|own| own.rotation.is_some());
        let turning: Vec<String> = turning.map(|own| format!("`{}`", own.name)).collect();
        if !self.course.speed.is_one() && !turning.is_empty() {
            warnings.push(format!(
                "the speed of sliding changes over time, but what turning does to {} stays that of its full speed",
                turning.join(", ")
            ));
        }
        warnings
    }
}

/// Two columns in SI units; `header` is what the file could begin with.
fn columns(
    file: &FileReference,
    dimensions: [Dimension; 2],
    header: &str,
) -> Result<[Vec<f64>; 2], ModelError> {
    let found = number_columns(&file.path, dimensions.map(|own| Number::any(own).scaled()), header)?;
    Ok(found.map(|column| column.values.into_iter().map(|value| value.number).collect()))
}

impl DrivenSettings {
    fn course(&self) -> Result<Course, Undriven> {
        let factor = |key: &str, pick: fn(&CourseSettings) -> Option<&FactorSettings>| {
            let own = self.course.as_ref().and_then(pick);
            own.map(|own| own.factor(&format!("course.{key}"))).transpose()
        };
        let one = || TimeFactor::Constant(1.0);
        let mut course = Course {
            speed: factor("speed", |own| own.speed.as_ref())?.unwrap_or_else(one),
            load: factor("load", |own| own.load.as_ref())?.unwrap_or_else(one),
            friction: factor("friction", |own| own.friction.as_ref())?.into_iter().collect(),
        };
        at("course.friction", course.check())?;
        if let (Some(temperature), Some(friction)) = (&self.temperature, &self.friction_over_temperature) {
            let temperature = temperature.over_time()?;
            let [times, values] = friction.table()?;
            let table = TimeTable { times, values };
            at("friction_over_temperature", table.check())?;
            let places = [&*table.times, &*table.values];
            course
                .friction
                .push(at("temperature", TimeFactor::over("the temperature in K", &temperature, places))?);
            at("friction_over_temperature", course.check())?;
        }
        Ok(course)
    }
}

impl FactorSettings {
    fn factor(&self, path: &str) -> Result<TimeFactor, Undriven> {
        let factor = match self {
            Self::Rise(time) => TimeFactor::Rise(*time),
            Self::Table { times, factors } => {
                TimeFactor::Table(TimeTable { times: times.clone(), values: factors.clone() })
            }
            Self::File(file) => {
                let [times, values] = columns(file, [Dimension::TIME, Dimension::NUMBER], "time [s],factor")?;
                TimeFactor::Table(TimeTable { times, values })
            }
        };
        at(path, factor.check())?;
        Ok(factor)
    }
}

impl TemperatureSettings {
    fn over_time(&self) -> Result<TimeTable, Undriven> {
        let [times, values] = match self {
            Self::Table { times, temperatures } => [times.clone(), temperatures.clone()],
            Self::File(file) => {
                columns(file, [Dimension::TIME, Dimension::TEMPERATURE], "time [s],temperature [degC]")?
            }
        };
        let table = TimeTable { times, values };
        at("temperature", table.check())?;
        Ok(table)
    }
}

impl FrictionOverTemperature {
    fn table(&self) -> Result<[Vec<f64>; 2], Undriven> {
        match self {
            Self::Table { temperatures, factors } => Ok([temperatures.clone(), factors.clone()]),
            Self::File(file) => {
                let dimensions = [Dimension::TEMPERATURE, Dimension::NUMBER];
                Ok(columns(file, dimensions, "temperature [degC],factor")?)
            }
        }
    }
}

/// A signal that lasts as long as the motion and that its steps can follow.
fn signal<const IS_FORCE: bool>(
    own: &SignalSettings<IS_FORCE>,
    asked: &AssemblyMarch,
    path: &str,
) -> Result<DrivingSignal, Undriven> {
    let signal = match own {
        SignalSettings::Swing { amplitude, frequency: SwingFrequency::Steady { frequency, phase } } => {
            DrivingSignal::Sine { amplitude: *amplitude, angular_frequency: *frequency, phase: *phase }
        }
        SignalSettings::Swing { amplitude, frequency: SwingFrequency::Sweeping { from, to, sweep } } => {
            DrivingSignal::Sweep(FrequencySweep {
                amplitude: *amplitude,
                from: *from,
                to: *to,
                duration: asked.duration,
                is_logarithmic: *sweep == SweepWord::Logarithmic,
            })
        }
        SignalSettings::Random { rms, band, seed } => {
            DrivingSignal::Random(BandNoise::new(*rms, *band, *seed))
        }
        SignalSettings::Samples { file, scale } => {
            let header = if IS_FORCE { "time [s],force [N]" } else { "time [s],acceleration [m/s^2]" };
            let [times, mut values] = columns(file, [Dimension::TIME, dimension(IS_FORCE)], header)?;
            values.iter_mut().for_each(|value| *value *= scale);
            DrivingSignal::Samples(TimeTable { times, values })
        }
    };
    at(path, signal.check(asked.step))?;
    at(path, signal.covers(asked.duration))?;
    Ok(signal)
}
