//! What the errors of a contact law leave of results, in words.

use crate::oscillator::point::SteadyPoint;
use judder_contact::Law;
use judder_oscillator::undecided::Ranges;
use judder_study::text::short;

/// The verdict where the law with its errors has others too.
pub(crate) const MARGINAL: &str = "marginal within the law";

/// That nothing is known of the errors of a law, in words.
pub(crate) fn unknown_errors(law: &Law) -> Option<String> {
    (!law.knows_its_errors()).then(|| {
        "the law has too few values along speed or indentation, fewer than three, to tell its errors: whether they decide a verdict or a \
         threshold is not known"
            .to_owned()
    })
}

/// That the errors of the law decide at a point, in words.
pub(crate) fn told_marginal(steady: &SteadyPoint) -> Option<String> {
    if steady.marginal_within_law() != Some(true) {
        return None;
    }
    let unknown = || "unknown".to_owned();
    let off = steady.equivalent_damping_error().map_or_else(unknown, short);
    let rates = steady.growth_rate_within_law();
    let rates =
        rates.map_or_else(unknown, |[least, most]| format!("from {} to {}", short(least), short(most)));
    Some(format!(
        "the errors of the law decide here: ξ_eq = {} ± {off}, growth rate {rates}; a law of a finer accuracy has smaller errors",
        short(steady.linearisation.equivalent_damping()),
    ))
}

/// Ranges in a row; `None` where there are none.
pub(crate) fn ranges_text(ranges: &Option<Ranges>) -> Option<String> {
    let Some(ranges) = ranges else { return Some("unknown".to_owned()) };
    let text = |[from, to]: &[f64; 2]| format!("{} to {}", short(*from), short(*to));
    (!ranges.is_empty()).then(|| ranges.iter().map(text).collect::<Vec<_>>().join(", "))
}
