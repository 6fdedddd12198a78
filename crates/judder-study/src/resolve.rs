//! What `judder check` shows: the resolved case with and without units, its stability limits, and what a run would take.

mod resolved;
mod sweeps;

pub use resolved::Resolved;

use crate::case::file::CaseFile;
use crate::error::StudyError;

/// Resolves a case and looks at its operating point; runs no analysis.
///
/// # Errors
/// Matrices that are not finite at the case's own parameters, a sweep that a run would refuse.
pub fn resolve(file: &CaseFile) -> Result<Resolved, StudyError> {
    let used = file.case.with_used(file.case.resolved())?;
    sweeps::added(file.case.resolve(file, used)?, file)
}
