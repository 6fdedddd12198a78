//! The mode that is meant, its march, its growth against its eigenvalue.

use super::AssemblyGrowth;
use crate::assembly::AssemblySubject;
use crate::assembly::meant_mode::near_frequency;
use crate::error::ModelError;
use crate::measured_growth::{checks, far_off};
use judder_assembly::linearised::{Linearised, LinearisedTerms};
use judder_nonsmooth::growth::growth;
use judder_store::{Results, Variable};
use judder_study::Progress;
use judder_study::outcome::Outcome;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// What is told of the growth of a mode.
#[derive(Results)]
pub(super) struct ToldMarchGrowth {
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
    steps: u64,
    /// the step
    step_s: f64,
}

pub(super) fn run(
    of: &AssemblySubject<'_>,
    asked: &AssemblyGrowth,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let steady = of.steady_to_march()?;
    let about = Linearised::new(&of.built.assembly, &steady, LinearisedTerms::default())?;
    let mode = near_frequency(&about, asked.frequency)?;
    progress.go_on()?;
    let told = growth(&of.built.assembly, &steady, &about, &mode, asked.method.march(asked.step))?;
    progress.advance();
    let [measured, predicted] = [told.measured, told.predicted];
    let results = ToldMarchGrowth {
        measured: measured.re,
        predicted: predicted.re,
        frequency_hz: predicted.im / TAU,
        measured_frequency_hz: measured.im / TAU,
        spread: told.spread,
        method: asked.method.name(),
        steps: told.steps,
        step_s: asked.step,
    };
    let Outcome { scalars, dataset, .. } = Outcome::of(&results)?;
    let scalar = |name: &str, value: Complex64| Variable::new(name, &[], &[], vec![value]).units("1/s");
    let (times, amplitudes): (Vec<f64>, Vec<f64>) =
        told.history.iter().map(|[time, amplitude]| (*time, *amplitude)).unzip();
    let amplitude = Variable::new("amplitude", &["time"], &[times.len()], amplitudes);
    let dataset = dataset
        .attribute("method", asked.method.name())?
        .attribute("measured_until_s", told.steps as f64 * asked.step)?
        .with(scalar("measured", measured).long_name("growth rate and angular frequency in the march"))?
        .with(scalar("predicted", predicted).long_name("eigenvalue about steady sliding"))?
        .with(Variable::coordinate("time", times).units("s").long_name("time since the start"))?
        .with(amplitude.units("1").long_name("amplitude of the mode, of that with which it started"))?;
    let mut warnings: Vec<String> = far_off(predicted.im, asked.frequency).into_iter().collect();
    warnings.extend(of.doubts(&steady));
    if !told.is_small {
        warnings.push(
            "a contact point stuck, turned or opened while growth was measured: the motion was not small, and its rate need not be the eigenvalue's".to_owned(),
        );
    }
    let checks = checks(asked.method.name(), measured, predicted);
    let missing = usize::from(!told.is_small);
    Ok(Outcome { scalars, dataset, checks, warnings, missing, ..Outcome::default() })
}
