//! The mode that is meant, its march, its growth against its eigenvalue.

use super::history::ForceHistory;
use crate::error::ModelError;
use crate::measured_growth::{FAR, MeantMode, SOUGHT, checks, far_off, near};
use crate::sliding::case::SlidingCase;
use crate::sliding::growth::settings::GrowthAnalysis;
use crate::sliding::system::{MarchStep, ReducedPair, step};
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::growth::{AMPLITUDE, GrowthSettings, Held, watched_growth};
use judder_sliding::pair::Pair;
use judder_sliding::spectrum::{Spectrum, WantedEigenvalues};
use judder_store::{Results, Variable};
use judder_study::Progress;
use judder_study::outcome::Outcome;
use num_complex::Complex64;
use std::f64::consts::TAU;

pub(super) fn run(
    case: &SlidingCase,
    system: &ReducedPair,
    settings: &GrowthAnalysis,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let (pair, position) = (&system.pair, settings.position);
    let method = settings.method();
    pair.edge_point(position)?;
    let MarchStep { step, limit } = step(pair, method, settings.step, system.motion.held(position))?;
    let (velocity, load) = (case.motion.velocity, case.motion.load.force);
    let asked = GrowthSettings { method, step, position, velocity, load };
    let held = Held::new(pair, &asked)?;
    held.coupling.check(position, pair.friction().at(velocity.abs()).coefficient)?;
    let eigenvalue = meant(pair, &held, position, settings.frequency)?;
    if progress.interrupted() {
        return Err(ModelError::Interrupted);
    }
    let mut history = ForceHistory::of(eigenvalue);
    let growth =
        watched_growth(pair, &asked, &held, eigenvalue, &mut |time, swing| history.see(time, swing))?;
    progress.advance();
    let [measured, predicted] = [growth.measured, growth.predicted];
    let told = ToldGrowth {
        measured: measured.re,
        predicted: predicted.re,
        frequency_hz: predicted.im / TAU,
        measured_frequency_hz: measured.im / TAU,
        spread: growth.spread,
        method: settings.word.name(),
        position_m: position,
        normal_force: held.normal_force,
        steps: growth.steps,
        step_s: step,
        step_limit_s: limit,
    };
    let scalar = |name: &str, value: Complex64| Variable::new(name, &[], &[], vec![value]).units("1/s");
    let Outcome { scalars, dataset, .. } = Outcome::of(&told)?;
    let dataset = dataset
        .attribute("position_m", position)?
        .attribute("method", settings.word.name())?
        .attribute("start_amplitude_n", AMPLITUDE * held.normal_force)?
        .attribute("measured_until_s", growth.steps as f64 * step)?
        .with(scalar("measured", measured).long_name("growth rate and angular frequency in the march"))?
        .with(scalar("predicted", predicted).long_name("eigenvalue with the contact held"))?;
    let dataset = history.kept(dataset)?;
    let checks = checks(settings.word.name(), measured, predicted);
    let far_off = far_off(predicted.im, settings.frequency);
    let warnings = far_off.into_iter().chain(system.beyond_friction()).collect();
    Ok(Outcome { scalars, dataset, checks, warnings, ..Outcome::default() })
}

/// What is told of the growth of a mode.
#[derive(Results)]
pub(super) struct ToldGrowth {
    /// growth rate in the march
    #[result(unit = "1/s")]
    measured: f64,
    /// growth rate that the eigenvalue says
    #[result(unit = "1/s")]
    predicted: f64,
    /// frequency that the eigenvalue says
    frequency_hz: f64,
    /// frequency in the march
    measured_frequency_hz: f64,
    /// how much the measured growth differs from half to half
    #[result(unit = "1/s")]
    spread: f64,
    /// how the march goes
    method: &'static str,
    /// where the contact is held
    position_m: f64,
    /// the force there, at rest
    #[result(unit = "N")]
    normal_force: f64,
    steps: u64,
    /// the step
    step_s: f64,
    /// the longest that it may be
    step_limit_s: f64,
}

/// The eigenvalue that is meant by a frequency in rad/s: of those near it the one that grows fastest, else the nearest.
///
/// # Errors
/// [`ModelError::NoMode`] where the nearest is far off.
fn meant(pair: &Pair, held: &Held, position: f64, frequency: f64) -> Result<Complex64, ModelError> {
    let refuse = |known| Err(ModelError::NoMode { asked_hz: frequency / TAU, position, known });
    let highest = pair.eigenvalues().iter().fold(0.0_f64, |m, own| m.max(*own)).sqrt();
    if frequency > (1.0 + FAR) * highest {
        return refuse(format!("its structures have none above {:.1} Hz", highest / TAU));
    }
    let function = PairCharacteristic::new(&held.coupling, &pair.eigenvalues(), &pair.damping())?;
    let all = Spectrum::new(&function, position, WantedEigenvalues::Below(SOUGHT * frequency))?.eigenvalues;
    let swinging: Vec<Complex64> = all.into_iter().filter(|s| s.im > 0.0).collect();
    match near(&swinging, frequency) {
        Some(MeantMode::Found(place)) => Ok(swinging[place]),
        Some(MeantMode::TooFar(place)) => {
            refuse(format!("the nearest swings at {:.1} Hz", swinging[place].im / TAU))
        }
        None => refuse(format!("there is none up to {:.1} Hz", SOUGHT * frequency / TAU)),
    }
}
