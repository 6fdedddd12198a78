//! The analyses of a sliding case.

mod growth;
mod locus;

use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::sliding::{SlidingSystem, alone};
use judder_case::sliding::locus::Along;
use judder_case::{Analysis, SlidingAnalysis, SlidingCase};

/// How many steps an analysis announces.
pub(super) fn steps(kind: &SlidingAnalysis) -> usize {
    match kind {
        SlidingAnalysis::Locus(settings) => match &settings.along {
            Along::Positions(positions) => positions.points,
            Along::Key { sweep, .. } => sweep.values.len(),
        },
        _ => 1,
    }
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
        SlidingAnalysis::Locus(settings) => locus::run((case, system), settings, progress)?,
        SlidingAnalysis::Growth(settings) => growth::run((case, system), settings, progress)?,
        SlidingAnalysis::March(_) => return Err(StudyError::NotRunYet { kind: "march" }),
        SlidingAnalysis::Spectrogram(_) => return Err(StudyError::NotRunYet { kind: "spectrogram" }),
    };
    outcome.warnings.extend(system.warnings.iter().cloned());
    Ok(outcome)
}
