//! What a finished sweep has to say of its contact law, and of eq. (3).

use super::OfOneLaw;
use crate::bridge;
use crate::error::ModelError;
use crate::known_substrate::KnownSubstrate;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::quasi_steady::{self, QuasiSteadyCondition};
use crate::oscillator::steady_states::{SteadyState, validity_warnings};
use crate::within_law::MARGINAL;
use judder_oscillator::within_law::WithinLaw;
use judder_study::case::study_sweep::StudySweep;
use judder_study::model::Case;

/// How the law is doubtful at some points, evenly over the sweep.
///
/// # Errors
/// Data that cannot be read.
pub(super) fn law_warnings(set: &OfOneLaw, sweep: &StudySweep) -> Result<Vec<String>, ModelError> {
    /// As many as are looked at.
    const LOOKED: u64 = 512;
    let looked = sweep.points().min(LOOKED);
    let (mut points, mut states, mut substrates) = (Vec::new(), Vec::new(), Vec::new());
    let count = sweep.points();
    for k in 0..looked {
        let number = u128::from(k) * u128::from(count) / u128::from(looked);
        let Ok(inputs) = set.inputs(&sweep.values_of(number as u64)) else { continue };
        points.push(inputs);
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
    let is_marginal = |state: &&SteadyState| {
        WithinLaw::new(&set.contact, &state.coefficients, &state.equilibrium)
            .is_some_and(|within| !within.is_decided())
    };
    let marginal = states.iter().filter(is_marginal).count();
    let undecided = (marginal > 0).then(|| {
        format!(
            "at {marginal} of {looked} points looked at the verdict is {MARGINAL}: its errors decide there"
        )
    });
    let substrate = KnownSubstrate::of(&set.case)?;
    let of_band = substrate.band_warning(&set.contact, points.iter().copied());
    let broken = QuasiSteadyCondition::worst(points.into_iter(), Some(&set.contact), &substrate.terms)
        .and_then(|condition| condition.warning(None));
    Ok(set.computed.iter().cloned().chain(of_points).chain(undecided).chain(of_band).chain(broken).collect())
}

/// That eq. (3) is broken at some of the points, evenly over the sweep, of a case that is read anew at each.
pub(crate) fn read_anew(sweep: &StudySweep, case_at: &dyn Fn(&[f64]) -> Option<Case>) -> Option<String> {
    /// As many as are looked at: each reads the case, and a substrate that moves.
    const LOOKED: u64 = 16;
    let points = sweep.points();
    let looked = points.min(LOOKED);
    let at = |k: u64| {
        let number =
            if looked > 1 { u128::from(k) * u128::from(points - 1) / u128::from(looked - 1) } else { 0 };
        let case = case_at(&sweep.values_of(number as u64))?;
        let case = bridge::with_material(case.of()?).ok()?;
        QuasiSteadyCondition::at(&case.inputs, None, &quasi_steady::terms(&case).ok()?)
    };
    let conditions = (0..looked).filter_map(at);
    let worst = conditions.max_by(|a, b| a.figures.figure.total_cmp(&b.figures.figure))?;
    worst.warning(None)
}
