//! Steady sliding along a sweep.

use crate::bridge;
use crate::error::ModelError;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::sweep::Sweep;
use judder_contact::{ContactLaw, ValidityConcern};
use judder_numerics::parallel;
use judder_oscillator::equilibrium::{Equilibrium, equilibrium};
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::{Coefficients, Contact, OscillatorError};
use judder_study::Progress;
use judder_study::text::short;

/// Steady sliding at one point of a sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SteadyState {
    pub(crate) coefficients: Coefficients,
    pub(crate) equilibrium: Equilibrium,
    pub(crate) linearisation: Linearisation,
}

impl SteadyState {
    pub(crate) fn new(contact: &Contact, inputs: &OscillatorInputs) -> Result<Self, OscillatorError> {
        let coefficients = bridge::groups(inputs).coefficients()?;
        let equilibrium = equilibrium(contact, &coefficients)?;
        let linearisation = Linearisation::new(contact.friction_load, &coefficients, &equilibrium.response);
        Ok(Self { coefficients, equilibrium, linearisation })
    }
}

/// The steady states along a sweep, in its order; a point without one says why.
pub(crate) fn along(
    contact: &Contact,
    inputs: &OscillatorInputs,
    sweep: &Sweep<OscillatorKey>,
    progress: &dyn Progress,
) -> Result<Vec<Result<SteadyState, OscillatorError>>, ModelError> {
    parallel::try_each(&sweep.values(), |value| {
        if progress.interrupted() {
            return Err(ModelError::Interrupted);
        }
        let mut here = *inputs;
        sweep.set(&mut here, *value);
        let state = SteadyState::new(contact, &here);
        progress.advance();
        Ok(state)
    })
}

/// A warning for each way in which points lie outside the law's range of validity: how many, and one of them.
pub(crate) fn validity_warnings<'a>(
    contact: &Contact,
    states: impl Iterator<Item = &'a SteadyState>,
) -> Vec<String> {
    let (mut deep, mut tail, mut count) = (Vec::new(), Vec::new(), 0);
    for state in states {
        count += 1;
        match contact.law.concern(state.coefficients.velocity, state.equilibrium.indentation) {
            Some(concern @ ValidityConcern::TooDeep { .. }) => deep.push(concern),
            Some(
                concern @ (ValidityConcern::FrictionTail { .. }
                | ValidityConcern::SpeedBeyondTable { .. }
                | ValidityConcern::TooShallow { .. }
                | ValidityConcern::BeyondSamples { .. }),
            ) => tail.push(concern),
            None => (),
        }
    }
    [deep, tail]
        .into_iter()
        .filter_map(|concerns| {
            let first = concerns.first()?;
            Some(format!(
                "outside the law's range at {} of {count} points looked at, for one: {first}",
                concerns.len()
            ))
        })
        .collect()
}

/// A warning that names the points of a sweep without steady sliding, and how many there are.
pub(crate) fn failure_warning(
    states: &[Result<SteadyState, OscillatorError>],
    values: &[f64],
) -> Option<String> {
    let mut failures =
        states.iter().zip(values).filter_map(|(state, value)| Some((state.as_ref().err()?, value)));
    let (error, value) = failures.next()?;
    Some(format!(
        "no result at {} of {} points, the first at {}: {error}",
        failures.count() + 1,
        values.len(),
        short(*value)
    ))
}
