//! What `judder check` shows: the resolved case with and without units, its stability limits, and what a run would take.

mod resolved;
mod sweeps;

pub use resolved::Resolved;

use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::progress::{Progress, announced};

/// Resolves a case and looks at its operating point; runs no analysis.
///
/// # Errors
/// Matrices that are not finite at the case's own parameters, a sweep that a run would refuse.
pub fn resolve(file: &CaseFile, progress: &dyn Progress) -> Result<Resolved, StudyError> {
    let use_all = || file.case.with_used(file.case.resolved());
    let used = announced(progress, "reading the files of the case", use_all)?;
    let model = "building the model of the case, for its size and what its analyses would take";
    let resolved = announced(progress, model, || file.case.resolve(file, used))?;
    announced(progress, "laying out the sweeps", || sweeps::added(resolved, file))
}
