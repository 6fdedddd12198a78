//! The analyses of a case, run in no study folder.

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
/// [`StudyError::Interrupted`], or arrays that the store refuses.
pub fn run(case: &Case, index: usize, progress: &dyn Progress) -> Result<Outcome, StudyError> {
    run_alone(case, &case.prepared()?, index, progress)
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
    case: &Case,
    index: usize,
    progress: &dyn Progress,
    watch: &mut dyn FnMut(SampleBlock),
) -> Result<Outcome, StudyError> {
    let prepared = case.prepared()?;
    case.run(index, Task { watch: Some(watch), ..Task::alone(&prepared, progress) })
}
