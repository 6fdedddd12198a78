//! What is put together before it takes its place.

use crate::calls;
use crate::fault::{Call, pass};
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use tempfile::Builder;

/// A folder of a name that nobody else has, on the disk of what is to be written, so that a rename can leave it. Removed when dropped.
#[derive(Debug)]
pub struct StagingFolder(PathBuf);

impl StagingFolder {
    /// Makes one in `parent` whose name begins so.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn new(parent: &Path, prefix: &str) -> io::Result<Self> {
        pass(Call::CreateFolder, parent)?;
        let folder = Builder::new().prefix(prefix).tempdir_in(parent)?;
        Ok(Self(folder.keep()))
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for StagingFolder {
    fn drop(&mut self) {
        // what stays is removed when the study is taken
        let _ = calls::remove(&self.0);
    }
}

/// A file of a name that nobody else has. Removed when dropped, unless it has taken its place.
#[derive(Debug)]
pub struct StagedFile {
    file: File,
    path: Option<PathBuf>,
}

impl StagedFile {
    /// Makes one in `folder` whose name begins and ends so, readable for whom other files are.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn new(folder: &Path, prefix: &str, suffix: &str) -> io::Result<Self> {
        let named = Builder::new().prefix(prefix).suffix(suffix).make_in(folder, calls::create_new_file)?;
        let (file, path) = named.keep()?;
        Ok(Self { file, path: Some(path) })
    }

    /// Writes bytes where it stands, and forces it to the disk.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn write_and_sync(&self, bytes: &[u8]) -> io::Result<()> {
        calls::write(&self.file, bytes)?;
        calls::sync(&self.file)
    }

    /// Gives it its place, in that of a file that stands there.
    ///
    /// # Errors
    /// A failure of the file system; it is removed then.
    pub fn take_place(mut self, place: &Path) -> io::Result<()> {
        if let Some(path) = &self.path {
            calls::rename(path, place)?;
        }
        self.path = None;
        Ok(())
    }
}

impl Drop for StagedFile {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            let _ = calls::remove_file(path);
        }
    }
}
