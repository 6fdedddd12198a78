//! The manifest of a study that others may be writing.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::look::{FileStamp, stamp};
use super::{CheckedFile, FILE, FileRecord, Manifest, check, relative};
use crate::{StoreError, plain};

/// The manifest of a study, read anew where it has changed.
#[derive(Debug, Clone)]
pub(crate) struct ManifestReader {
    study: PathBuf,
    known: Arc<Mutex<Option<Known>>>,
}

/// A manifest and the state of its file.
#[derive(Debug, Clone)]
struct Known {
    stamp: FileStamp,
    manifest: Arc<Manifest>,
}

impl ManifestReader {
    pub(crate) fn new(study: &Path) -> Self {
        Self { study: study.to_owned(), known: Arc::default() }
    }

    /// `None` where there is none, else whether it lists all.
    pub(crate) fn is_complete(&self) -> Result<Option<bool>, StoreError> {
        Ok(self.now()?.map(|known| known.manifest.complete))
    }

    /// Refuses a file that is listed and not as it was written. One that does not fit is looked at again where the list has changed meanwhile: a run
    /// was replacing it.
    pub(crate) fn check(&self, path: &Path) -> Result<(), StoreError> {
        self.compared(path, true).map(drop)
    }

    /// Opens a file that is handed on as it is read: only its size is compared before.
    pub(crate) fn open(&self, path: &Path) -> Result<CheckedFile, StoreError> {
        let record = self.compared(path, false)?;
        let opened = plain::open(path).and_then(|file| CheckedFile::new(file, record));
        opened.map_err(|source| StoreError::read(path, source))
    }

    /// What is listed of a file, which it is: by its size, and by its content where that is to be read.
    fn compared(&self, path: &Path, by_content: bool) -> Result<Option<FileRecord>, StoreError> {
        let Some(relative) = relative(&self.study, path) else { return Ok(None) };
        let mut last = None;
        loop {
            let Some(known) = self.now()? else { return Ok(None) };
            let Some(record) = known.manifest.files.get(&relative) else { return Ok(None) };
            let Err(damage) = check(path, record, by_content) else { return Ok(Some(record.clone())) };
            if last == Some(known.stamp) {
                return Err(StoreError::of_damage(path.to_owned(), damage));
            }
            last = Some(known.stamp);
        }
    }

    /// What holds now.
    fn now(&self) -> Result<Option<Known>, StoreError> {
        let path = self.study.join(FILE);
        let Ok(metadata) = fs::metadata(&path) else { return Ok(None) };
        let stamp = stamp(&metadata);
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if known.as_ref().is_none_or(|known| known.stamp != stamp) {
            *known = Manifest::read(&self.study)?.map(|read| Known { stamp, manifest: Arc::new(read) });
        }
        Ok(known.clone())
    }
}
