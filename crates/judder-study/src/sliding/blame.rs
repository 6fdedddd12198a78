//! Which key of a sliding case is to blame for what an analysis found.

use judder_case::CaseError;
use judder_case::sliding::locus::{Along, Locus};
use judder_case::{CaseFile, SlidingAnalysis, SlidingCase, SlidingProblem};
use judder_sliding::SlidingError;

/// The error of an analysis, at its place in the case file; `None` where no key is to blame.
pub(crate) fn placed(
    error: &SlidingError,
    (file, case): (&CaseFile, &SlidingCase),
    index: usize,
) -> Option<CaseError> {
    let analysis = case.analyses.get(index)?;
    let own = |key: &str| format!("analysis.{}.{key}", analysis.name);
    let reason = || SlidingProblem::Unbuilt { reason: error.to_string() };
    let (path, problem) = match error {
        SlidingError::StepOverLimit { step, limit } => {
            (own("step"), SlidingProblem::StepLimit { step: *step, limit: *limit })
        }
        SlidingError::OffTrack { position, length } => {
            let key = position_key(&analysis.kind);
            let problem =
                SlidingProblem::OffTrack { key: key.to_owned(), position: *position, length: *length };
            (own(key), problem)
        }
        SlidingError::SpragSlip { .. } => ("contact.friction_coefficient".to_owned(), reason()),
        SlidingError::LocksAtOnce { .. } => (own("cut_off"), reason()),
        SlidingError::RunsOff { .. } => (own("position"), reason()),
        SlidingError::NoEquilibrium { .. } => ("motion.load".to_owned(), reason()),
        SlidingError::OpenAtStart { .. } => ("contact.initial_gap".to_owned(), reason()),
        SlidingError::InvalidNumber { name, .. } if name.starts_with("the count") => (own("count"), reason()),
        SlidingError::InvalidNumber { name, .. } if name.starts_with("the frequency") => {
            (own("frequency"), reason())
        }
        SlidingError::InvalidNumber { .. } | SlidingError::Length { .. } => (own(""), reason()),
        _ => return None,
    };
    Some(file.sliding_error(path.trim_end_matches('.'), problem))
}

/// The key of an analysis that says where the contact is.
fn position_key(kind: &SlidingAnalysis) -> &'static str {
    match kind {
        SlidingAnalysis::Locus(Locus { along: Along::Key { .. }, .. }) => "at",
        SlidingAnalysis::Locus(_) => "positions",
        SlidingAnalysis::Growth(_) => "position",
        _ => "to",
    }
}
