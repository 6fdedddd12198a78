//! Files that a case names, relative to its own folder.

use std::path::{Path, PathBuf};

use crate::cause::Cause;
use crate::declared::{Allowed, Setting};
use crate::document::Node;
use crate::error::Fault;
use crate::section::{Section, text};
use serde_json::{Value as Json, json};

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
    let what = match std::fs::metadata(&path) {
        Ok(metadata) if metadata.is_file() => return Ok(FileReference { given: given.to_owned(), path }),
        Ok(_) => "is not a file",
        Err(_) => "does not exist",
    };
    Err(refused(name, path, what, node))
}

/// The folder that a path under a key names, relative to `folder`; one of a `--set` option is sought where the program runs first, as whoever types it there means it.
///
/// # Errors
/// Where it was sought, and what is wrong with it.
pub fn find_folder(given: &str, node: &Node, folder: &Path) -> Result<PathBuf, (PathBuf, &'static str)> {
    let here = PathBuf::from(given);
    let path = if node.place.is_option() && here.is_dir() { here } else { folder.join(given) };
    match std::fs::metadata(&path) {
        Ok(metadata) if metadata.is_dir() => Ok(path),
        Ok(_) => Err((path, "is not a folder")),
        Err(_) => Err((path, "does not exist")),
    }
}

fn refused(key: String, path: PathBuf, what: &'static str, node: &Node) -> Fault {
    Cause::File { key, path, what }.at(node.place)
}
