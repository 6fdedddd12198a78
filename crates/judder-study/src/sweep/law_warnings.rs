//! What a finished sweep has to say of its contact law.

use super::evaluate::{Evaluator, of_one_law};
use super::plan::SweepPlan;
use crate::analyses::steady_states::{SteadyState, validity_warnings};
use crate::bridge;
use crate::error::StudyError;
use crate::progress::Progress;
use judder_case::OscillatorCase;

/// How the law is doubtful at some points, evenly over the sweep; where the case is read anew, the points say it themselves.
///
/// # Errors
/// As of [`Evaluator::new`].
pub(super) fn law_warnings(plan: &SweepPlan, progress: &dyn Progress) -> Result<Vec<String>, StudyError> {
    /// As many as are looked at.
    const LOOKED: u64 = 512;
    if of_one_law(plan).is_none() {
        return Ok(Vec::new());
    }
    let evaluator = Evaluator::new(plan, progress)?;
    let Some(set) = evaluator.of_one_law() else { return Ok(Vec::new()) };
    let points = plan.sweep.points();
    let looked = points.min(LOOKED);
    let (mut states, mut substrates) = (Vec::new(), Vec::new());
    for k in 0..looked {
        let number = u128::from(k) * u128::from(points) / u128::from(looked);
        let Ok(inputs) = set.at(&plan.sweep.values_of(number as u64)) else { continue };
        states.extend(SteadyState::new(&set.contact, &inputs));
        let here = OscillatorCase { inputs, ..set.case.clone() };
        let contact = bridge::with_law(&here, set.contact.law.clone());
        substrates.extend(contact.into_iter().flat_map(|contact| contact.warnings));
    }
    let of_substrates = substrates.first().map(|first| match substrates.len() as u64 {
        count if count == looked => first.clone(),
        count => format!("at {count} of {looked} points looked at, for one: {first}"),
    });
    let of_points = of_substrates.into_iter().chain(validity_warnings(&set.contact, states.iter()));
    Ok(set.computed.iter().cloned().chain(of_points).collect())
}
