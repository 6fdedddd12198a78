//! One module a kind of analysis; each turns a case and its settings into an [`Outcome`].

mod axis;
pub(crate) mod contact;
mod critical;
mod equivalent_damping;
mod spectrum;
mod stability_map;
mod steady_states;
mod two_degrees;

pub(crate) use steady_states::SteadyState;

use crate::bridge::{self, CaseContact};
use crate::computed_law::{NO_POINTS, Points};
use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::spectrum_source::temperature_warning;
use judder_case::{Case, MapMethod, OscillatorAnalysis, OscillatorCase};
use judder_oscillator::Contact;

/// The names of the analyses of a case, in its order.
#[must_use]
pub fn names(case: &Case) -> Vec<String> {
    match case {
        Case::Oscillator(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
        Case::Contact(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
        Case::TwoDegrees(case) => case.analyses.iter().map(|a| a.name.clone()).collect(),
    }
}

/// How many steps the analysis at `index` announces to its progress.
#[must_use]
pub fn steps(case: &Case, index: usize) -> usize {
    let curves = |family: &Option<judder_case::Family<_>>| family.as_ref().map_or(1, |f| f.values.len());
    match case {
        Case::Oscillator(case) => match &case.analyses[index].kind {
            OscillatorAnalysis::EquivalentDamping { sweep, family }
            | OscillatorAnalysis::Spectrum { sweep, family }
            | OscillatorAnalysis::CriticalShearStrength { sweep, family, .. }
            | OscillatorAnalysis::CriticalLoad { sweep, family, .. } => sweep.points * curves(family),
            // the decisions and the boundaries are a step each, the growth rates one a row
            OscillatorAnalysis::StabilityMap(map) if map.method == MapMethod::EveryPoint => 2 + map.y.points,
            OscillatorAnalysis::StabilityMap(_) => 2,
        },
        Case::Contact(case) => contact::steps(&case.analyses[index].kind),
        Case::TwoDegrees(_) => 1,
    }
}

/// Runs the analysis at `index` of a case.
///
/// # Errors
/// [`StudyError::Interrupted`], or arrays that the store refuses.
pub fn run(case: &Case, index: usize, progress: &dyn Progress) -> Result<Outcome, StudyError> {
    run_from(case, index, NO_POINTS, progress)
}

/// Runs the analysis at `index` of a case; a law goes on from the points that an interrupted run has solved.
pub(crate) fn run_from(
    case: &Case,
    index: usize,
    points: Points<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    match case {
        Case::Oscillator(case) => {
            let case = &bridge::with_material(case)?;
            let CaseContact { contact, warnings } = bridge::contact(case, points, progress)?;
            let mut outcome = oscillator((case, &contact), &case.analyses[index].kind, progress)?;
            outcome.warnings.extend(warnings);
            outcome.warnings.extend(temperature_warning(&case.substrate)?);
            Ok(outcome)
        }
        Case::Contact(case) => contact::run(case, &case.analyses[index], points, progress),
        Case::TwoDegrees(case) => two_degrees::run(case, &case.analyses[index].kind, progress),
    }
}

fn oscillator(
    (case, contact): (&OscillatorCase, &Contact),
    analysis: &OscillatorAnalysis,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    match analysis {
        OscillatorAnalysis::EquivalentDamping { sweep, family } => {
            equivalent_damping::run((case, contact), sweep, family.as_ref(), progress)
        }
        OscillatorAnalysis::Spectrum { sweep, family } => {
            spectrum::run((case, contact), sweep, family.as_ref(), progress)
        }
        OscillatorAnalysis::CriticalShearStrength { sweep, within, family } => critical::run(
            (case, contact),
            critical::Sought::ShearStrength,
            sweep,
            within,
            family.as_ref(),
            progress,
        ),
        OscillatorAnalysis::CriticalLoad { sweep, within, family } => {
            critical::run((case, contact), critical::Sought::Load, sweep, within, family.as_ref(), progress)
        }
        OscillatorAnalysis::StabilityMap(map) => stability_map::run((case, contact), map, progress),
    }
}
