//! Where over a map the errors of the law decide.

use crate::error::ModelError;
use crate::within_law::MARGINAL;
use judder_oscillator::map::{LawStanding, StabilityMap};
use judder_store::Variable;
use judder_study::axis::Axis;
use judder_study::outcome::Outcome;
use serde_json::json;

/// The name of the array.
pub(crate) const WITHIN_LAW: &str = "within_law";
/// What its codes mean; where there is no steady sliding nothing is open.
const MEANINGS: [(u8, &str); 3] = [
    (LawStanding::Decided as u8, "decided"),
    (LawStanding::Marginal as u8, MARGINAL),
    (LawStanding::Unknown as u8, "unknown"),
];

/// Adds the codes to a map's outcome, and says how many points the law leaves open.
pub(super) fn add(
    outcome: &mut Outcome,
    (x, y, map): (&Axis, &Axis, &StabilityMap),
    codes: Vec<u8>,
) -> Result<(), ModelError> {
    let count = |standing: LawStanding| codes.iter().filter(|code| **code == standing as u8).count();
    let (all, marginal, unknown) = (codes.len(), count(LawStanding::Marginal), count(LawStanding::Unknown));
    let share = |count: usize| json!(count as f64 / all as f64);
    outcome.scalars.insert("marginal_within_law_fraction".to_owned(), share(marginal));
    outcome.scalars.insert("unknown_within_law_fraction".to_owned(), share(unknown));
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
    let codes =
        Variable::classes(WITHIN_LAW, &[y.name(), x.name()], &[map.rows, map.columns], codes, &MEANINGS)
            .long_name("what the errors of the contact law leave of the verdict");
    outcome.dataset = std::mem::take(&mut outcome.dataset).with(codes)?;
    Ok(())
}
