//! The pair through time.

use super::pair::PyPair;
use crate::choice::named;
use crate::errors;
use crate::watched::{Manner, watched};
use judder_models::coupled_pair::own_step;
use judder_sliding::SlidingError;
use judder_sliding::march::{ContactMethod, March, MarchSample, MarchSettings, Predictor, Reached};
use judder_sliding::motion::{Motion, Noise, Ramps};
use judder_study::Progress;
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Steps between two looks at Ctrl-C.
const STRETCH: u64 = 4096;
/// Stretches in which progress is told.
const TOLD: u64 = 1000;

/// The numbers that a motion is given by; those of the case where it has one and none are given.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct GivenMotion {
    start: Option<f64>,
    end: Option<f64>,
    velocity: Option<f64>,
    load: Option<f64>,
    initial_gap: Option<f64>,
    velocity_ramp: Option<f64>,
    load_ramp: Option<f64>,
    friction_ramp: Option<f64>,
    gap_ramp: Option<f64>,
    noise: Option<f64>,
    seed: Option<u64>,
}

impl GivenMotion {
    fn over(&self, known: Option<Motion>, length: f64) -> PyResult<Motion> {
        let needed = |name: &str, given: Option<f64>, known: Option<f64>| {
            given.or(known).ok_or_else(|| errors::input(name, "a pair that comes from no case needs it"))
        };
        let ramps = known.map(|motion| motion.ramps).unwrap_or_default();
        let noise = known.map(|motion| motion.noise).unwrap_or_default();
        Ok(Motion {
            start: self.start.or(known.map(|motion| motion.start)).unwrap_or(0.0),
            end: self.end.or(known.map(|motion| motion.end)).unwrap_or(length),
            velocity: needed("velocity", self.velocity, known.map(|motion| motion.velocity))?,
            load: needed("load", self.load, known.map(|motion| motion.load))?,
            initial_gap: self.initial_gap.or(known.map(|motion| motion.initial_gap)).unwrap_or(0.0),
            noise: Noise { force: self.noise.unwrap_or(noise.force), seed: self.seed.unwrap_or(noise.seed) },
            ramps: Ramps {
                velocity: self.velocity_ramp.unwrap_or(ramps.velocity),
                load: self.load_ramp.unwrap_or(ramps.load),
                friction: self.friction_ramp.unwrap_or(ramps.friction),
                gap: self.gap_ramp.unwrap_or(ramps.gap),
            },
            initial_damping: known.and_then(|motion| motion.initial_damping),
        })
    }
}

/// What is kept of a march.
#[derive(Default)]
struct KeptMarch {
    /// time, position, normal and tangential force, sliding velocity, gap, friction.
    columns: [Vec<f64>; 7],
    states: Vec<u8>,
    accelerations: Vec<f64>,
    seen: u64,
}

impl KeptMarch {
    fn take(&mut self, sample: &MarchSample, accelerations: &[f64], every: u64) {
        self.seen += 1;
        if !(self.seen - 1).is_multiple_of(every) {
            return;
        }
        let values = [
            sample.time,
            sample.position,
            sample.normal_force,
            sample.tangential_force,
            sample.sliding_velocity,
            sample.gap,
            sample.friction,
        ];
        for (column, value) in self.columns.iter_mut().zip(values) {
            column.push(value);
        }
        self.states.push(sample.state.number());
        self.accelerations.extend_from_slice(accelerations);
    }
}

fn method(name: &str, cut_off: Option<f64>) -> PyResult<ContactMethod> {
    let methods = [
        ("subs", ContactMethod::Subs { static_slope: false }),
        ("subs-static-slope", ContactMethod::Subs { static_slope: true }),
        ("ensubs", ContactMethod::EnSubs),
        ("film", ContactMethod::Film),
        ("residual-flexibility", ContactMethod::ResidualFlexibility { cut_off: f64::NAN }),
    ];
    match (named("method", name, &methods)?, cut_off) {
        (ContactMethod::ResidualFlexibility { .. }, Some(cut_off)) => {
            Ok(ContactMethod::ResidualFlexibility { cut_off })
        }
        (ContactMethod::ResidualFlexibility { .. }, None) => {
            Err(errors::input("cut_off", "the march with residual flexibility needs one, in Hz"))
        }
        (method, None) => Ok(method),
        (_, Some(_)) => Err(errors::input("cut_off", "only the march with residual flexibility has one")),
    }
}

/// The predictor of this name, where the method has one.
fn predictor(name: Option<&str>, method: ContactMethod) -> PyResult<Predictor> {
    match (name, method) {
        (None, _) => Ok(Predictor::default()),
        (Some(name), ContactMethod::EnSubs | ContactMethod::Film) => {
            named("predictor", name, &Predictor::ALL)
        }
        (Some(_), _) => Err(errors::input("predictor", "only the marches `ensubs` and `film` have one")),
    }
}

/// Signals of a march, as a dictionary of arrays.
#[pyfunction]
#[pyo3(signature = (pair, motion, *, method, predictor, cut_off, step, every, progress))]
#[allow(clippy::too_many_arguments, reason = "the arguments of `judder.sliding.march`")]
pub(crate) fn sliding_march<'py>(
    py: Python<'py>,
    pair: PyRef<'py, PyPair>,
    motion: GivenMotion,
    method: &str,
    predictor: Option<&str>,
    cut_off: Option<f64>,
    step: Option<f64>,
    every: u64,
    progress: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    if every == 0 {
        return Err(errors::input("every", "1 keeps every step, 0 would keep none"));
    }
    let pair: &PyPair = &pair;
    let method = self::method(method, cut_off)?;
    let predictor = self::predictor(predictor, method)?;
    let motion = motion.over(pair.motion, pair.pair.length())?;
    let manner = Manner::new(progress, Some(1))?;
    let done = watched(py, &manner, |watch| {
        let step = match step {
            Some(step) => step,
            None => own_step(&pair.pair, method, motion)?,
        };
        let settings = MarchSettings { method, predictor, step, motion };
        marched(March::new(&pair.pair, settings)?, every, watch).map(|(kept, reached)| (kept, reached, step))
    })?;
    let (kept, reached, step) = done.settled(|error| errors::sliding(&error))?;
    told(py, kept, reached, step)
}

fn marched(
    mut march: March<'_>,
    every: u64,
    progress: &dyn Progress,
) -> Result<(KeptMarch, Reached), SlidingError> {
    let all = march.all_steps();
    let stretch = (all / TOLD).clamp(1, STRETCH);
    progress.begin("march", usize::try_from(all.div_ceil(stretch)).unwrap_or(usize::MAX));
    let mut kept = KeptMarch::default();
    loop {
        if progress.interrupted() {
            return Err(SlidingError::Interrupted);
        }
        let reached = march.advance(stretch, &mut |sample: &MarchSample, accelerations: &[f64]| {
            kept.take(sample, accelerations, every);
        })?;
        progress.advance();
        if reached != Reached::Steps {
            progress.end();
            return Ok((kept, reached));
        }
    }
}

fn told(py: Python<'_>, kept: KeptMarch, reached: Reached, step: f64) -> PyResult<Bound<'_, PyDict>> {
    let result = PyDict::new(py);
    let count = kept.states.len();
    let names =
        ["time", "position", "normal_force", "tangential_force", "sliding_velocity", "gap", "friction"];
    for (name, column) in names.into_iter().zip(kept.columns) {
        result.set_item(name, column.into_pyarray(py))?;
    }
    result.set_item("state", kept.states.into_pyarray(py))?;
    let observed = kept.accelerations.len().checked_div(count).unwrap_or(0);
    result.set_item("accelerations", kept.accelerations.into_pyarray(py).reshape([count, observed])?)?;
    result.set_item("step", step)?;
    result.set_item("ran_off", matches!(reached, Reached::RunOff(_)))?;
    Ok(result)
}
