//! What the errors of a contact law leave of results, in words.

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

/// Ranges in a row; `None` where there are none.
pub(crate) fn ranges_text(ranges: &Option<Ranges>) -> Option<String> {
    let Some(ranges) = ranges else { return Some("unknown".to_owned()) };
    let text = |[from, to]: &[f64; 2]| format!("{} to {}", short(*from), short(*to));
    (!ranges.is_empty()).then(|| ranges.iter().map(text).collect::<Vec<_>>().join(", "))
}
