//! The analyses of a case, run in no study folder.

use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::model::{Case, Prepared, SampleBlock, Task};
use crate::outcome::Outcome;
use crate::progress::Progress;

/// How many steps the analysis at `index` announces to its progress.
#[must_use]
pub fn steps(case: &Case, index: usize) -> usize {
    case.steps(index)
}

/// Runs the analysis at `index` of a case: nothing is kept, and nothing is known from before.
///
/// # Errors
/// What [`Model::preflight`](crate::model::Model::preflight) refuses, [`StudyError::Interrupted`], or arrays that the store refuses.
pub fn run(file: &CaseFile, index: usize, progress: &dyn Progress) -> Result<Outcome, StudyError> {
    run_alone(&file.case, &admitted(file, index)?, index, progress)
}

/// What the analyses of a case share, where one of them is admitted.
fn admitted(file: &CaseFile, index: usize) -> Result<Prepared, StudyError> {
    let name = file.case.analysis_names().get(index).copied();
    file.case.preflight(file, &|own| name == Some(own))
}

/// The same with what its analyses share.
pub(crate) fn run_alone(
    case: &Case,
    prepared: &Prepared,
    index: usize,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    case.run(index, Task::alone(prepared, progress))
}

/// Runs the analysis at `index` of a case as [`run`] does; one that shows samples hands them to `watch` while it is computed.
///
/// # Errors
/// As [`run`].
pub fn run_watched(
    file: &CaseFile,
    index: usize,
    progress: &dyn Progress,
    watch: &mut dyn FnMut(SampleBlock),
) -> Result<Outcome, StudyError> {
    let prepared = admitted(file, index)?;
    file.case.run(index, Task { watch: Some(watch), ..Task::alone(&prepared, progress) })
}
