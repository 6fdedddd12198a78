//! Files that a case names, read whole.

use crate::error::StudyError;
use std::fmt::Display;
use std::path::Path;

/// The error of a file that cannot be used.
pub(crate) fn unusable(path: &Path, reason: &impl Display) -> StudyError {
    StudyError::File { path: path.to_owned(), reason: reason.to_string() }
}

/// The bytes of a file.
///
/// # Errors
/// [`StudyError::File`] with what the system says.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>, StudyError> {
    std::fs::read(path).map_err(|error| unusable(path, &format!("the file cannot be read: {error}")))
}

/// The text of a file.
///
/// # Errors
/// [`StudyError::File`] with what the system says, or with the first byte that is no text.
pub(crate) fn text(path: &Path) -> Result<String, StudyError> {
    String::from_utf8(bytes(path)?).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..valid].iter().filter(|byte| **byte == b'\n').count() + 1;
        unusable(path, &format!("line {line} is not UTF-8 text; save the file as UTF-8 (`°C` is often not)"))
    })
}
