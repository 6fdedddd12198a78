//! How the contact force swings while the contact is held: what the measured growth rates are taken from, as a history.

use crate::analyses::Prepared;
use crate::error::StudyError;
use crate::pictures::complexes;
use crate::progress::Progress;
use crate::sliding::method;
use judder_case::sliding::analysis::SlidingAnalysis;
use judder_case::{Case, CaseFile};
use judder_sliding::SlidingError;
use judder_sliding::coupling::Sliding;
use judder_sliding::growth::{GrowthSettings, Held};
use judder_sliding::march::{March, MarchSettings, Method, Predictor, Sample, Start};
use judder_sliding::motion::{Motion, Noise, Ramps};
use judder_sliding::pair::Pair;
use judder_sliding::shape::mode_shape;
use judder_store::{AnalysisRecord, Dataset, Status, StudyFolder, Summary, Variable};
use num_complex::Complex64;
use std::f64::consts::TAU;
use std::time::Instant;

/// Share of the normal force by which the mode swings at first.
const AMPLITUDE: f64 = 1e-5;
/// How far a history reaches, over the length of the measurement.
const REACH: f64 = 1.25;

/// What is added to the name of a growth analysis to name its history.
pub(super) const HISTORY: &str = "-history";

/// Keeps the history of every growth analysis that is done.
pub(super) fn keep(
    (file, prepared): (&CaseFile, &Prepared),
    (store, summary): (&StudyFolder, &mut Summary),
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    let (Case::Sliding(case), Prepared::Sliding(system)) = (&file.case, prepared) else { return Ok(()) };
    progress.begin("histories of growth", case.analyses.len());
    for analysis in &case.analyses {
        if progress.interrupted() {
            return Err(StudyError::Interrupted);
        }
        progress.advance();
        let (SlidingAnalysis::Growth(asked), Some(record), Some(result)) =
            (&analysis.kind, summary.analyses.get(&analysis.name), summary.results.get(&analysis.name))
        else {
            continue;
        };
        let hash = record.hash.clone();
        let began = Instant::now();
        let known = store.read_dataset(&analysis.name)?;
        let number = |key: &str| result.get(key).and_then(serde_json::Value::as_f64);
        let pair_of = |key: &str| complexes(&known, key).and_then(|values| values.first().copied());
        let (Some(step), Some(steps), Some(measured), Some(predicted)) =
            (number("step_s"), number("steps"), pair_of("measured"), pair_of("predicted"))
        else {
            continue;
        };
        let settings = GrowthSettings {
            method: method(asked.method),
            step,
            position: asked.position,
            velocity: case.motion.velocity,
            load: case.motion.load.force,
        };
        let history = History::marched(&system.pair, &settings, predicted, steps as u64)?;
        let dataset = history.dataset(asked.method.name(), &settings, [measured, predicted])?;
        let name = format!("{}{HISTORY}", analysis.name);
        store.write_dataset(&name, &hash, &dataset)?;
        let wall_time_s = began.elapsed().as_secs_f64();
        let record = AnalysisRecord { hash, status: Status::Done, wall_time_s, warnings: Vec::new() };
        summary.analyses.insert(name, record);
    }
    progress.end();
    Ok(())
}

/// The amplitude of the normal force's swing about its rest, by the largest deviation of every period.
struct History {
    /// s.
    times: Vec<f64>,
    /// N.
    amplitudes: Vec<f64>,
    /// Of the swing that the mode was started with, N.
    start: f64,
    /// How long growth was measured, s.
    measured_until: f64,
}

impl History {
    /// Marches as [`judder_sliding::growth::frozen_growth`] does, and somewhat further.
    fn marched(
        pair: &Pair,
        settings: &GrowthSettings,
        eigenvalue: Complex64,
        steps: u64,
    ) -> Result<Self, StudyError> {
        let held = Held::new(pair, settings)?;
        let motion = Motion {
            start: settings.position,
            end: settings.position,
            velocity: settings.velocity,
            load: settings.load,
            initial_gap: 0.0,
            noise: Noise::default(),
            ramps: Ramps::default(),
            initial_damping: None,
        };
        let marched = MarchSettings {
            method: settings.method,
            predictor: Predictor::default(),
            step: settings.step,
            motion,
        };
        let mut march = March::held(pair, marched, &started(pair, settings, &held, eigenvalue)?)?;
        let (mut times, mut amplitudes): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        let mut take = |sample: &Sample, _: &[f64]| {
            let swing = (sample.normal_force - held.normal_force).abs();
            let period = (sample.time * eigenvalue.im / TAU) as usize;
            if period >= times.len() {
                times.push(sample.time);
                amplitudes.push(swing);
            } else if amplitudes[period] < swing {
                (times[period], amplitudes[period]) = (sample.time, swing);
            }
        };
        march.advance((REACH * steps as f64) as u64, &mut take)?;
        // the last period is not whole
        times.pop();
        amplitudes.pop();
        let start = AMPLITUDE * held.normal_force;
        Ok(Self { times, amplitudes, start, measured_until: steps as f64 * settings.step })
    }

    fn dataset(
        &self,
        method: &str,
        settings: &GrowthSettings,
        [measured, predicted]: [Complex64; 2],
    ) -> Result<Dataset, StudyError> {
        let scalar = |name: &str, value: Complex64| Variable::new(name, &[], &[], vec![value]).units("1/s");
        let amplitude = Variable::new("amplitude", &["time"], &[self.times.len()], self.amplitudes.clone());
        Ok(Dataset::new()
            .attribute("kind", "growth")?
            .attribute("method", method)?
            .attribute("position_m", settings.position)?
            .attribute("start_amplitude_n", self.start)?
            .attribute("measured_until_s", self.measured_until)?
            .with(scalar("measured", measured).long_name("growth rate and angular frequency in the march"))?
            .with(scalar("predicted", predicted).long_name("eigenvalue with the contact held"))?
            .with(
                Variable::coordinate("time", self.times.clone()).units("s").long_name("time since the start"),
            )?
            .with(
                amplitude
                    .units("N")
                    .long_name("largest deviation of the normal force from its rest in each period"),
            )?)
    }
}

/// Rest, disturbed by the mode of an eigenvalue.
fn started(
    pair: &Pair,
    settings: &GrowthSettings,
    held: &Held,
    eigenvalue: Complex64,
) -> Result<Start, SlidingError> {
    let shape = mode_shape(&held.coupling, (&pair.eigenvalues(), &pair.damping()), eigenvalue);
    let at = |time: f64| -> Vec<f64> {
        let swing = AMPLITUDE * held.normal_force * (eigenvalue * time).exp();
        held.state.iter().zip(&shape).map(|(rest, mode)| rest + (swing * mode).re).collect()
    };
    let touch = match settings.method {
        Method::Subs { static_slope: false } => pair.undeformed(settings.position)?,
        _ => pair.deformed(settings.position, &held.state)?,
    };
    let Sliding { friction, direction, .. } = Sliding::at(pair.friction(), settings.velocity);
    let force = |time: f64| {
        let normal = held.normal_force * (1.0 + AMPLITUDE * (eigenvalue * time).exp().re);
        [0, 1].map(|k| normal * (touch.normal[k] - direction * friction * touch.tangent[k]))
    };
    let before = -settings.step;
    Ok(Start { now: at(0.0), before: at(before), forces: [force(0.0), force(before)] })
}
