//! The folder of one study while several processes work on its sweeps.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::lock::{self, Lock, LockMode};
use crate::sweep::{SweepLayout, SweepStore};
use crate::{StoreError, StudyFolder, folder};

/// The folder of one study, held together with other processes: all may work on its sweeps, none rewrites the rest.
///
/// There is no coordinator. Whoever leaves last gets the study alone, to complete it:
///
/// ```
/// use judder_store::{SharedStudy, StudyFolder};
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("study");
/// let (one, other) = (SharedStudy::join(&path)?, SharedStudy::join(&path)?);
/// assert!(StudyFolder::create(&path).is_err(), "an ordinary run keeps out");
/// assert!(one.leave()?.is_none());
/// let alone: Option<StudyFolder> = other.leave()?;
/// assert!(alone.is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SharedStudy {
    path: PathBuf,
    lock: Arc<Lock>,
}

impl SharedStudy {
    /// Joins those at work on a study, or begins it: makes the folder where there is none.
    ///
    /// # Errors
    /// [`StoreError::Locked`] while an ordinary run holds the study, or one that completes it; else as
    /// [`StudyFolder::create`].
    pub fn join(path: impl AsRef<Path>) -> Result<Self, StoreError> {
        let path = path.as_ref();
        let lock = lock::try_lock(&folder::prepare(path)?, LockMode::Shared)?;
        let lock = lock.ok_or_else(|| StoreError::Locked { path: path.to_owned() })?;
        Ok(Self { path: path.to_owned(), lock: Arc::new(lock) })
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Takes up a sweep, or begins it. The store holds the study, too.
    ///
    /// # Errors
    /// As [`StudyFolder::sweep`].
    pub fn sweep(&self, layout: &SweepLayout) -> Result<SweepStore, StoreError> {
        SweepStore::join(&self.path, &self.lock, layout)
    }

    /// Leaves the study; whoever leaves last gets it alone. `None` while others are at work, who will get it when they leave;
    /// a [`SweepStore`] of this process that is not dropped yet is such another.
    ///
    /// It lets go first and tries for the whole then, so that of two that leave together one gets it. Where the file system has
    /// no locks everybody gets it: look whether all chunks are done.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn leave(self) -> Result<Option<StudyFolder>, StoreError> {
        let Self { path, lock } = self;
        drop(lock);
        match StudyFolder::take(&path) {
            Ok(alone) => Ok(Some(alone)),
            Err(StoreError::Locked { .. }) => Ok(None),
            Err(failure) => Err(failure),
        }
    }
}
