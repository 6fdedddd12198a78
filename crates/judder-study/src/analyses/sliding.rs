//! The analyses of a sliding case.

use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::sliding::{SlidingSystem, alone};
use judder_case::{Analysis, SlidingAnalysis, SlidingCase};

/// How many steps an analysis announces.
pub(super) fn steps(_kind: &SlidingAnalysis) -> usize {
    1
}

pub(super) fn run(
    (case, system): (&SlidingCase, &SlidingSystem),
    analysis: &Analysis<SlidingAnalysis>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    if progress.interrupted() {
        return Err(StudyError::Interrupted);
    }
    let mut outcome = match &analysis.kind {
        SlidingAnalysis::Modes { structure, wanted } => {
            let own = &system.parts[*structure].structure;
            let outcome = super::structure::modes((&alone(case, *structure), own), &analysis.name, *wanted)?;
            progress.advance();
            outcome
        }
        SlidingAnalysis::Locus(_) => return Err(StudyError::NotRunYet { kind: "locus" }),
        SlidingAnalysis::Growth(_) => return Err(StudyError::NotRunYet { kind: "growth" }),
        SlidingAnalysis::March(_) => return Err(StudyError::NotRunYet { kind: "march" }),
        SlidingAnalysis::Spectrogram(_) => return Err(StudyError::NotRunYet { kind: "spectrogram" }),
    };
    outcome.warnings.extend(system.warnings.iter().cloned());
    Ok(outcome)
}
