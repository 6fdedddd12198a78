//! The analyses of a structure case.

mod diagnosis;
mod eigen;
mod eigen_sweep;
mod fields;
mod modes;
mod reduced_files;
mod reduction;
mod shapes;
mod undamped;

pub(super) use modes::run as modes;

use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::structure::Structure;
use judder_case::{Analysis, StructureAnalysis, StructureCase};

/// How many steps an analysis announces.
pub(super) fn steps(kind: &StructureAnalysis) -> usize {
    match kind {
        StructureAnalysis::EigenSweep(sweep) => {
            sweep.sweep.values.len() * sweep.family.as_ref().map_or(1, |family| family.values.len())
        }
        _ => 1,
    }
}

pub(super) fn run(
    (case, structure): (&StructureCase, &Structure),
    analysis: &Analysis<StructureAnalysis>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    if progress.interrupted() {
        return Err(StudyError::Interrupted);
    }
    let mut outcome = match &analysis.kind {
        StructureAnalysis::Modes(settings) => {
            modes::run((case, structure), &analysis.name, settings.wanted(), None)
        }
        StructureAnalysis::Reduction(settings) => {
            reduction::run((case, structure), &analysis.name, settings.count)
        }
        StructureAnalysis::Eigen(settings) => eigen::run((case, structure), &analysis.name, &settings.region),
        StructureAnalysis::EigenSweep(settings) => eigen_sweep::run((case, structure), settings, progress),
    }?;
    progress.advance();
    outcome.warnings.extend(structure.warnings.iter().cloned());
    Ok(outcome)
}
