//! Files that a case names, relative to its own folder.

use std::path::{Path, PathBuf};

use crate::cause::Cause;
use crate::declared::{Allowed, Setting};
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, text};
use judder_disk::kind_in_words;
use serde_json::{Value as Json, json};
use std::fs::FileType;
use std::io::{Error, ErrorKind};
use thiserror::Error;

/// Why a file or a folder that a case names is not to be had.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum PathFault {
    /// Nothing is there.
    #[error("does not exist")]
    Missing,
    /// The system does not tell what is there.
    #[error("cannot be reached: {0}")]
    OutOfReach(ErrorKind),
    /// This is there in the place of a file.
    #[error("is {0}, not a file")]
    NotFile(&'static str),
    /// This is there in the place of a folder.
    #[error("is {0}, not a folder")]
    NotFolder(&'static str),
    /// A folder is there, and no study in it.
    #[error("is a folder, not that of a study")]
    NotStudy,
}

/// A file that a case names; it was there when the case was read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileReference {
    /// The path as the case file has it.
    pub given: String,
    /// The path from the folder in which the program runs.
    pub path: PathBuf,
}

impl FileReference {
    /// Whether the file is the one at `path`, or lies below it, wherever links lead.
    #[must_use]
    pub fn lies_in(&self, path: &Path) -> bool {
        let real = |path: &Path| path.canonicalize().ok();
        real(&self.path).zip(real(path)).is_some_and(|(file, path)| file.starts_with(path))
    }
}

/// Where it lies is found when the folder of the case is known.
impl Setting for FileReference {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::File
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let given = text(&section.path(key), node)?.to_owned();
        Ok(Self { path: PathBuf::from(&given), given })
    }

    fn write(&self, (): &()) -> Json {
        json!(self.given)
    }
}

/// Reads the path under `key` of `section`, relative to `folder`.
pub fn read_file_reference(section: &Section<'_>, key: &str, folder: &Path) -> Result<FileReference, Fault> {
    let node = section.required(key, &format!("{key} = \"…\", a path relative to the case file"))?;
    let name = section.path(key);
    let given = text(&name, node)?;
    let path = folder.join(given);
    match looked_for(&path, FileType::is_file, PathFault::NotFile) {
        Ok(()) => Ok(FileReference { given: given.to_owned(), path }),
        Err(fault) => Err(Cause::File { key: name, path, fault }.at(node.place)),
    }
}

/// The folder that a path under a key names, relative to `folder`; one of a `--set` option is sought where the program runs first, as whoever types it there means it.
///
/// # Errors
/// Where it was sought, and what is wrong with it.
pub fn find_folder(given: &str, node: &Node, folder: &Path) -> Result<PathBuf, (PathBuf, PathFault)> {
    let here = PathBuf::from(given);
    let path = if node.place.is_option() && here.is_dir() { here } else { folder.join(given) };
    match looked_for(&path, FileType::is_dir, PathFault::NotFolder) {
        Ok(()) => Ok(path),
        Err(fault) => Err((path, fault)),
    }
}

/// Looks for what should be of a kind, wherever links lead.
fn looked_for(
    path: &Path,
    is_asked: fn(&FileType) -> bool,
    other: fn(&'static str) -> PathFault,
) -> Result<(), PathFault> {
    match std::fs::metadata(path).map(|metadata| metadata.file_type()) {
        Ok(kind) if is_asked(&kind) => Ok(()),
        Ok(kind) => Err(other(kind_in_words(kind))),
        Err(error) => Err(PathFault::of(&error)),
    }
}

impl PathFault {
    /// What stands under the path in the case; of what is missing as given.
    #[must_use]
    pub fn label(self, missing: &'static str) -> &'static str {
        match self {
            Self::Missing => missing,
            Self::OutOfReach(_) => "out of reach",
            Self::NotFile(_) | Self::NotFolder(_) | Self::NotStudy => "something else",
        }
    }

    /// What would be right; where another path would be, as given.
    #[must_use]
    pub fn help(self, path: &'static str) -> &'static str {
        match self {
            Self::OutOfReach(ErrorKind::PermissionDenied) => {
                "it must be there for you to read, and every folder above it to enter"
            }
            Self::Missing | Self::NotFile(_) | Self::NotFolder(_) | Self::NotStudy | Self::OutOfReach(_) => {
                path
            }
        }
    }

    /// A file where a folder should be has nothing below it.
    fn of(error: &Error) -> Self {
        match error.kind() {
            ErrorKind::NotFound | ErrorKind::NotADirectory => Self::Missing,
            kind => Self::OutOfReach(kind),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_file_is_told_as_what_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        std::fs::write(&path, "").unwrap();
        let looked_for = |path: &Path| looked_for(path, FileType::is_file, PathFault::NotFile);
        assert_eq!(looked_for(&path), Ok(()));
        assert_eq!(looked_for(&path.join("below")), Err(PathFault::Missing));
        assert_eq!(looked_for(folder.path()).unwrap_err().to_string(), "is a folder, not a file");
        let too_long = looked_for(&folder.path().join("x".repeat(4000))).unwrap_err();
        assert!(matches!(too_long, PathFault::OutOfReach(_)), "{too_long}");
        #[cfg(unix)]
        assert_eq!(looked_for(Path::new("/dev/zero")).unwrap_err().to_string(), "is a device, not a file");
    }
}
