//! What `judder check` shows: the resolved case with and without units, its stability limits, and what a run would take.

mod sweeps;

use crate::case::file::CaseFile;
use crate::error::StudyError;
use serde_json::Value;

/// A checked case.
#[derive(Debug, Clone)]
pub struct Resolved {
    /// The document of `judder check --json`.
    pub document: Value,
    /// What `judder check` prints on a terminal.
    pub text: String,
}

impl Resolved {
    /// The document of `judder check --json`.
    #[must_use]
    pub fn json(&self) -> Value {
        self.document.clone()
    }

    /// What `judder check` prints on a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        self.text.clone()
    }
}

/// Resolves a case and looks at its operating point; runs no analysis.
///
/// # Errors
/// Matrices that are not finite at the case's own parameters, a sweep that a run would refuse.
pub fn resolve(file: &CaseFile) -> Result<Resolved, StudyError> {
    sweeps::added(file.case.resolve(file)?, file)
}
