//! Which key of a sliding case is to blame for what an analysis found, and what would be right.

use crate::error::ModelError;
use crate::sliding::case::problem::SlidingProblem;
use judder_sliding::SlidingError;
use judder_sliding::edge::RunOff;
use judder_study::model::Refusal;

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

/// A contact that is not on the track: the key that says where it is, and where it is held, m, where one place is meant.
pub(super) fn off_track(error: &ModelError, key: &'static str, held: Option<f64>) -> Option<Refusal> {
    let ModelError::Sliding(SlidingError::OffTrack { position, length }) = error else { return None };
    let problem = match held {
        // on the track as drawn: the deformation takes the contact beyond the end
        Some(held) if (0.0..=*length).contains(&held) => {
            let end = if 2.0 * held < *length { RunOff::First } else { RunOff::Last };
            let reason = SlidingError::RunsOff { position: held, length: *length, end }.to_string();
            SlidingProblem::Unbuilt { reason, advice: INWARDS }
        }
        _ => SlidingProblem::OffTrack { key: key.to_owned(), position: *position, length: *length },
    };
    Some(Refusal::key(key, problem))
}

/// What is to blame whatever the kind of analysis; `None` where no key is.
pub(super) fn blame(error: &ModelError) -> Option<Refusal> {
    let unbuilt = |advice| SlidingProblem::Unbuilt { reason: error.to_string(), advice };
    let refusal = match error {
        ModelError::NoMode { .. } => Refusal::key("frequency", unbuilt(NEAR)),
        ModelError::Sliding(error) => match error {
            SlidingError::StepOverLimit { step, limit } => {
                Refusal::key("step", SlidingProblem::StepLimit { step: *step, limit: *limit })
            }
            SlidingError::SpragSlip { .. } => {
                Refusal::path("contact.friction_coefficient", unbuilt(SPRAG_SLIP))
            }
            SlidingError::CutOff { .. } => Refusal::key("cut_off", unbuilt(BETWEEN)),
            SlidingError::LocksAtOnce { .. } => Refusal::key("cut_off", unbuilt(LOCKS)),
            SlidingError::RunsOff { .. } => Refusal::key("position", unbuilt(INWARDS)),
            SlidingError::NoEquilibrium { .. } => Refusal::path("motion.load", unbuilt(PRESSED)),
            SlidingError::OpenAtStart { .. } => Refusal::path("contact.initial_gap", unbuilt(CLOSED)),
            SlidingError::InvalidNumber { name, .. } if name.starts_with("the count") => {
                Refusal::key("count", unbuilt(COUNT))
            }
            SlidingError::InvalidNumber { .. } | SlidingError::Length { .. } => {
                Refusal::key("", unbuilt(NUMBER))
            }
            _ => return None,
        },
        _ => return None,
    };
    Some(refusal)
}
