//! Files that a case names, read whole.

use crate::error::StudyError;
use judder_store::{LARGEST_DOCUMENT, content_hash, read_small_file};
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// The error of a file that cannot be used.
pub fn unusable(path: &Path, reason: &impl Display) -> StudyError {
    StudyError::File { path: path.to_owned(), reason: reason.to_string() }
}

/// The bytes of a regular file, where there is memory for them.
///
/// # Errors
/// [`StudyError::Unreadable`].
pub fn bytes(path: &Path) -> Result<Vec<u8>, StudyError> {
    bytes_up_to(path, u64::MAX)
}

fn bytes_up_to(path: &Path, largest: u64) -> Result<Vec<u8>, StudyError> {
    read_small_file(path, largest).map_err(|source| StudyError::Unreadable { path: path.to_owned(), source })
}

/// The text of a file, no longer than any document is.
///
/// # Errors
/// [`StudyError::Unreadable`], [`StudyError::File`] with the first byte that is no text.
pub fn text(path: &Path) -> Result<String, StudyError> {
    String::from_utf8(bytes_up_to(path, LARGEST_DOCUMENT)?).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..valid].iter().filter(|byte| **byte == b'\n').count() + 1;
        unusable(path, &format!("line {line} is not UTF-8 text; save the file as UTF-8 (`°C` is often not)"))
    })
}

/// A file as it was when its content went into a hash.
#[derive(Debug, Clone)]
pub struct KnownFile {
    path: PathBuf,
    /// Of its content.
    pub hash: String,
    stamp: Stamp,
}

/// What changes of a file with its content, as far as the system tells: a copy of the same bytes may differ, too.
type Stamp = (u64, Option<SystemTime>);

impl KnownFile {
    /// # Errors
    /// [`StudyError::Unreadable`].
    pub fn new(path: &Path) -> Result<Self, StudyError> {
        let stamp = Self::stamp_of(path)?;
        Ok(Self { path: path.to_owned(), hash: content_hash(&bytes(path)?), stamp })
    }

    /// Refuses a file with another content; it is read where the system tells of a change.
    ///
    /// # Errors
    /// [`StudyError::FileChanged`], [`StudyError::Unreadable`].
    pub fn check(&self) -> Result<(), StudyError> {
        if Self::stamp_of(&self.path)? == self.stamp || content_hash(&bytes(&self.path)?) == self.hash {
            return Ok(());
        }
        Err(StudyError::FileChanged { path: self.path.clone() })
    }

    fn stamp_of(path: &Path) -> Result<Stamp, StudyError> {
        let unreadable = |source| StudyError::Unreadable { path: path.to_owned(), source };
        let metadata = std::fs::metadata(path).map_err(unreadable)?;
        Ok((metadata.len(), metadata.modified().ok()))
    }
}
