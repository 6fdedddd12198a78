//! Where over a map the errors of the law decide.

use super::arrays::MapOverAxes;
use crate::error::ModelError;
use crate::within_law::MARGINAL;
use judder_oscillator::map::LawStanding;
use judder_store::Results;
use judder_study::outcome::Outcome;

/// The name of the array.
pub(crate) const WITHIN_LAW: &str = "within_law";
/// What the errors of a contact law leave of verdicts, by the codes of a map; where there is no steady sliding nothing is open.
pub const STANDINGS: [(u8, &str); 3] = [
    (LawStanding::Decided as u8, "decided"),
    (LawStanding::Marginal as u8, MARGINAL),
    (LawStanding::Unknown as u8, "unknown"),
];

/// What is told of it.
#[derive(Results)]
pub(super) struct ToldWithin {
    marginal_within_law_fraction: f64,
    unknown_within_law_fraction: f64,
}

/// Adds the codes to a map's outcome, and says how many points the law leaves open.
pub(super) fn add(outcome: &mut Outcome, map: MapOverAxes<'_>, codes: Vec<u8>) -> Result<(), ModelError> {
    let count = |standing: LawStanding| codes.iter().filter(|code| **code == standing as u8).count();
    let (all, marginal, unknown) = (codes.len(), count(LawStanding::Marginal), count(LawStanding::Unknown));
    let share = |count: usize| count as f64 / all as f64;
    let told = ToldWithin {
        marginal_within_law_fraction: share(marginal),
        unknown_within_law_fraction: share(unknown),
    };
    outcome.scalars.extend(told.scalars());
    if marginal > 0 {
        outcome.warnings.push(format!(
            "at {marginal} of {all} points the verdict is {MARGINAL}: its errors decide there; they are drawn hatched"
        ));
    }
    if unknown > 0 {
        outcome.warnings.push(format!(
            "at {unknown} of {all} points it is not known what the errors of the law leave of the verdict"
        ));
    }
    let codes = map
        .classes(WITHIN_LAW, codes, &STANDINGS)
        .long_name("what the errors of the contact law leave of the verdict");
    outcome.dataset = std::mem::take(&mut outcome.dataset).with(codes)?;
    Ok(())
}
