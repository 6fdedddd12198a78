//! Which key of a sliding case is to blame for what an analysis found, and what would be right.

use crate::error::StudyError;
use crate::sliding::{SlidingSystem, method, step};
use judder_case::CaseError;
use judder_case::sliding::locus::{Along, Locus};
use judder_case::{CaseFile, SlidingAnalysis, SlidingCase, SlidingProblem};
use judder_sliding::SlidingError;
use judder_sliding::edge::RunOff;
use judder_sliding::motion::Motion;

const SPRAG_SLIP: &str = "give a smaller friction coefficient, or incline the slider less";
const BETWEEN: &str =
    "give a frequency above those that matter and below the highest, such as cut_off = \"60 kHz\"";
const LOCKS: &str = "give another cut_off, or a smaller friction coefficient";
const INWARDS: &str = "hold the contact farther from the end of the track";
const PRESSED: &str =
    "let the load press the slider onto the track: mind the sign of motion.load.force and its direction";
const CLOSED: &str = "give motion.ramps.gap a time, such as \"0.1 s\", or contact.initial_gap = \"0 m\"";
const COUNT: &str = "ask for fewer branches, or keep more modes in the reductions";
const NEAR: &str = "a locus shows the frequencies at this position; give one of them";
const NUMBER: &str = "give a number that is allowed";

/// The error of an analysis, at its place in the case file; `None` where no key is to blame.
pub(crate) fn placed(
    error: &StudyError,
    (file, case): (&CaseFile, &SlidingCase),
    index: usize,
) -> Option<CaseError> {
    let analysis = case.analyses.get(index)?;
    let own = |key: &str| format!("analysis.{}.{key}", analysis.name);
    let unbuilt = |advice| SlidingProblem::Unbuilt { reason: error.to_string(), advice };
    let (path, problem) = match error {
        StudyError::NoMode { .. } => (own("frequency"), unbuilt(NEAR)),
        StudyError::Sliding(error) => match error {
            SlidingError::StepOverLimit { step, limit } => {
                (own("step"), SlidingProblem::StepLimit { step: *step, limit: *limit })
            }
            SlidingError::OffTrack { position, length } => {
                let (key, length) = (position_key(&analysis.kind), *length);
                let problem = match held(&analysis.kind) {
                    // on the track as drawn: the deformation takes the contact beyond the end
                    Some(position) if (0.0..=length).contains(&position) => {
                        let end = if 2.0 * position < length { RunOff::First } else { RunOff::Last };
                        let reason = SlidingError::RunsOff { position, length, end }.to_string();
                        SlidingProblem::Unbuilt { reason, advice: INWARDS }
                    }
                    _ => SlidingProblem::OffTrack { key: key.to_owned(), position: *position, length },
                };
                (own(key), problem)
            }
            SlidingError::SpragSlip { .. } => {
                ("contact.friction_coefficient".to_owned(), unbuilt(SPRAG_SLIP))
            }
            SlidingError::CutOff { .. } => (own("cut_off"), unbuilt(BETWEEN)),
            SlidingError::LocksAtOnce { .. } => (own("cut_off"), unbuilt(LOCKS)),
            SlidingError::RunsOff { .. } => (own("position"), unbuilt(INWARDS)),
            SlidingError::NoEquilibrium { .. } => ("motion.load".to_owned(), unbuilt(PRESSED)),
            SlidingError::OpenAtStart { .. } => ("contact.initial_gap".to_owned(), unbuilt(CLOSED)),
            SlidingError::InvalidNumber { name, .. } if name.starts_with("the count") => {
                (own("count"), unbuilt(COUNT))
            }
            SlidingError::InvalidNumber { .. } | SlidingError::Length { .. } => (own(""), unbuilt(NUMBER)),
            _ => return None,
        },
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

/// Where an analysis holds the contact, m.
fn held(kind: &SlidingAnalysis) -> Option<f64> {
    match kind {
        SlidingAnalysis::Locus(Locus { along: Along::Key { at, .. }, .. }) => Some(*at),
        SlidingAnalysis::Growth(growth) => Some(growth.position),
        _ => None,
    }
}

/// Refuses what an analysis would refuse at its first step: places off the track, steps over the limit, a gap that nothing closes.
///
/// # Errors
/// As the analysis.
pub(crate) fn admit(kind: &SlidingAnalysis, system: &SlidingSystem) -> Result<(), SlidingError> {
    let pair = &system.pair;
    match kind {
        SlidingAnalysis::Locus(locus) => match &locus.along {
            Along::Positions(range) => {
                pair.edge_point(range.from)?;
                pair.edge_point(range.to)?;
            }
            Along::Key { at, .. } => {
                pair.edge_point(*at)?;
            }
        },
        SlidingAnalysis::March(march) => {
            let motion = Motion { start: march.from, end: march.to, ..system.motion };
            step(pair, method(march.method), march.step, motion)?;
        }
        SlidingAnalysis::Growth(growth) => {
            pair.edge_point(growth.position)?;
            step(pair, method(growth.method()), growth.step, system.motion.held(growth.position))?;
        }
        SlidingAnalysis::Modes { .. } | SlidingAnalysis::Spectrogram(_) => {}
    }
    Ok(())
}
