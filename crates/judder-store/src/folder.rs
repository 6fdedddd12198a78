//! The folder of one study.
//!
//! - `listed.rs`: what of it is on the list of what it holds, and how it comes there.

mod listed;

use std::fs;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use serde_json::{Map, Value};

use crate::lock::{self, Lock, LockMode};
use crate::manifest::{self, ManifestKeeper};
use crate::metadata;
use crate::name::check_name;
use crate::staging::{self, Stage};
use crate::sweep::{self, SweepLayout, SweepStore};
use crate::zarr::Elsewhere;
use crate::{Dataset, Status, StoreError, Summary, Table, plain, results, scratch, summary, zarr};

/// The folder of one study, held by this process alone until dropped.
///
/// Everything is written atomically: a reader, another process included, sees the old content or the new; a failed
/// write leaves the old. It can be shared between threads.
#[derive(Debug)]
pub struct StudyFolder {
    path: PathBuf,
    /// Where files go of a study that stays as it is.
    output: Option<PathBuf>,
    /// Taken while the root of `results.zarr` changes, so that two threads do not forget each other's groups.
    publishing: Mutex<()>,
    manifest: Mutex<ManifestKeeper>,
    lock: Arc<Lock>,
}

impl StudyFolder {
    /// Takes a folder for a run: makes it where there is none, takes up the study where there is one, and removes what a
    /// killed run left half-written.
    ///
    /// # Errors
    /// [`StoreError::NotAFolder`] for a file, [`StoreError::ForeignFolder`] for a folder with files and no study,
    /// [`StoreError::NotWritable`], [`StoreError::Locked`] while another process holds the study.
    pub fn create(path: impl AsRef<Path>) -> Result<Self, StoreError> {
        let path = path.as_ref();
        prepare(path)?;
        Self::take(path)
    }

    /// Takes an existing study, to rebuild parts of it.
    ///
    /// # Errors
    /// [`StoreError::NoStudy`] where there is none; else as [`create`](Self::create).
    pub fn open(path: impl AsRef<Path>) -> Result<Self, StoreError> {
        let path = path.as_ref();
        look(path)?;
        Self::take(path)
    }

    /// Looks at an existing study that stays as it is, held by nobody here: files that are written go into another folder, made where there is none.
    ///
    /// # Errors
    /// [`StoreError::NoStudy`]; of the other folder [`StoreError::HoldsStudy`], or [`StoreError::ForeignFolder`] for files of somebody else; else as
    /// [`create`](Self::create).
    pub fn drawn_into(path: impl AsRef<Path>, output: impl AsRef<Path>) -> Result<Self, StoreError> {
        let (path, output) = (path.as_ref(), output.as_ref());
        look(path)?;
        if output.join(summary::FILE).exists() {
            return Err(StoreError::HoldsStudy { path: output.to_owned() });
        }
        let lock = lock::try_lock(&prepare(output)?, LockMode::Alone)?;
        let lock = Arc::new(lock.ok_or_else(|| StoreError::Locked { path: output.to_owned() })?);
        staging::sweep(output, staging::PREFIX)?;
        let manifest = Mutex::new(ManifestKeeper::take(path)?);
        let output = Some(output.to_owned());
        Ok(Self { path: path.to_owned(), output, publishing: Mutex::new(()), manifest, lock })
    }

    /// Takes a folder that is a study already.
    pub(crate) fn take(path: &Path) -> Result<Self, StoreError> {
        let lock = lock::try_lock(&path.join(lock::FILE), LockMode::Alone)?;
        let lock = lock.ok_or_else(|| StoreError::Locked { path: path.to_owned() })?;
        staging::sweep(path, staging::PREFIX)?;
        if lock.is_real() {
            staging::sweep(path, sweep::PREFIX)?;
        }
        results::repair(path)?;
        let manifest = Mutex::new(ManifestKeeper::take(path)?);
        let lock = Arc::new(lock);
        Ok(Self { path: path.to_owned(), output: None, publishing: Mutex::new(()), manifest, lock })
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Forgets all results, for a run from scratch: removes `summary.json`, unread, `results.zarr`, and of the files on the list of what the study
    /// holds those of results, such as tables and laws, and those of the study as a whole that `is_drawn`. Files that are not on the list stay.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn forget(&self, is_drawn: impl Fn(&str) -> bool) -> Result<(), StoreError> {
        let singles = self.manifest().forget(is_drawn)?;
        for single in &singles {
            // a list that names what lies elsewhere is none of this crate's
            if let Ok(path) = self.inner_place(Path::new(single)) {
                remove_file(&path)?;
            }
        }
        self.manifest().take_off(|path, _| singles.iter().any(|single| single == path))?;
        for name in [summary::FILE, results::FOLDER] {
            let path = self.path.join(name);
            let forget = || {
                if name == summary::FILE {
                    staging::clear_place(&path)?;
                }
                // Moved away in one step first, so that a kill leaves no half of it.
                let stage = Stage::new(&self.path)?;
                if path.symlink_metadata().is_ok() {
                    judder_disk::rename(&path, &stage.place(name))
                } else {
                    Ok(())
                }
            };
            forget().map_err(|source| StoreError::write(&path, 0, source))?;
        }
        for prefix in [scratch::PREFIX, staging::STREAM_PREFIX, sweep::PREFIX] {
            staging::sweep(&self.path, prefix)?;
        }
        Ok(())
    }

    /// Takes up a sweep, or begins it. The store holds the study, too.
    ///
    /// # Errors
    /// [`StoreError::ForeignSweep`] where the sweep of another case has this name, [`StoreError::OtherLayout`] where it is laid
    /// out otherwise; failures of the file system.
    pub fn sweep(&self, layout: &SweepLayout) -> Result<SweepStore, StoreError> {
        let _publishing = self.publishing.lock().unwrap_or_else(PoisonError::into_inner);
        let store = SweepStore::join(&self.path, &self.lock, layout)?;
        results::repair(&self.path)?;
        Ok(store)
    }

    /// Makes the metadata of `results.zarr` tell of all its groups, those too that came here by other ways than this crate's; claims of
    /// sweeps go, which nobody can hold beside this.
    ///
    /// # Errors
    /// [`StoreError::DatasetUnreadable`] for a group with damaged metadata; failures of the file system.
    pub fn consolidate(&self) -> Result<(), StoreError> {
        let _publishing = self.publishing.lock().unwrap_or_else(PoisonError::into_inner);
        // nobody else is here: claims are of no use to anyone
        if self.lock.is_real() {
            staging::sweep(&self.path, sweep::PREFIX)?;
        }
        results::consolidate(&self.path)
    }

    /// Writes the arrays of an analysis, in place of those of an earlier run. `hash` names all that they depend on.
    ///
    /// # Errors
    /// [`StoreError::InvalidName`] for a name that cannot be a folder, [`StoreError::DiskFull`] and other failures of the
    /// file system; the earlier arrays then still stand.
    pub fn write_dataset(&self, analysis: &str, hash: &str, dataset: &Dataset) -> Result<(), StoreError> {
        self.publish(analysis, hash, dataset, &Elsewhere::new())
    }

    /// The same for a dataset of which some values lie elsewhere.
    pub(crate) fn publish(
        &self,
        analysis: &str,
        hash: &str,
        dataset: &Dataset,
        elsewhere: &Elsewhere,
    ) -> Result<(), StoreError> {
        check_name("an analysis", analysis)?;
        let below = format!("{}/{analysis}/", results::FOLDER);
        self.manifest().take_off(|path, _| path.starts_with(&below))?;
        let written = results::write(&self.path, &self.publishing, analysis, hash, dataset, elsewhere)?;
        self.manifest().list_written(Some(analysis), written);
        Ok(())
    }

    /// Reads the arrays of an analysis back.
    ///
    /// # Errors
    /// [`StoreError::NoDataset`] where none are stored, [`StoreError::DatasetUnreadable`] where they are damaged or
    /// incomplete.
    pub fn read_dataset(&self, analysis: &str) -> Result<Dataset, StoreError> {
        let group = self.group(analysis)?;
        if !group.exists() {
            return Err(StoreError::NoDataset { path: group });
        }
        self.refuse_damaged(&format!("{}/{analysis}/", results::FOLDER), |_| true)?;
        zarr::read_group(&group)
    }

    /// The attributes of the arrays of an analysis, such as its `kind`; no array is read.
    ///
    /// # Errors
    /// As [`read_dataset`](Self::read_dataset).
    pub fn read_attributes(&self, analysis: &str) -> Result<Map<String, Value>, StoreError> {
        let group = self.group(analysis)?;
        if !group.exists() {
            return Err(StoreError::NoDataset { path: group });
        }
        let own = format!("{}/{analysis}/{}", results::FOLDER, metadata::FILE);
        self.refuse_damaged(&own, |_| true)?;
        zarr::read_attributes(&group)
    }

    /// Reads a sweep at some of its points, to draw what is too much for memory. `choose` gets names and lengths of its dimensions and gives the
    /// positions along each of them; those beyond its end are left out. Only the chunks in which chosen points lie are read, one after the other.
    ///
    /// # Errors
    /// As [`read_dataset`](Self::read_dataset); a group that is no sweep.
    pub fn read_points(
        &self,
        name: &str,
        choose: impl FnOnce(&[(String, usize)]) -> Vec<Vec<usize>>,
    ) -> Result<Dataset, StoreError> {
        let group = self.group(name)?;
        if !group.exists() {
            return Err(StoreError::NoDataset { path: group });
        }
        // of the chunks only those that are read
        let values = format!("{}/{name}/{}", results::FOLDER, sweep::CHUNKS);
        self.refuse_damaged(&format!("{}/{name}/", results::FOLDER), |path| !path.starts_with(&values))?;
        sweep::read_points(&group, choose, &|file| self.damage_of(file))
    }

    /// Whether an analysis need not be run again: the summary calls it done under this hash, and its arrays are there,
    /// written under the same hash.
    ///
    /// # Errors
    /// As [`read_summary`](Self::read_summary).
    pub fn is_done(&self, analysis: &str, hash: &str) -> Result<bool, StoreError> {
        let group = self.group(analysis)?;
        let summary = self.read_summary()?;
        let record = summary.as_ref().and_then(|summary| summary.analyses.get(analysis));
        let recorded = record.is_some_and(|record| record.hash == hash && record.status == Status::Done);
        Ok(recorded
            && self.is_listed(analysis)
            && zarr::stored_hash(&group).is_some_and(|stored| stored == hash))
    }

    /// Writes `summary.json`. What it tells of the result `renewed` is new; what it tells of others must be what it was, or they count as damaged.
    ///
    /// # Errors
    /// [`StoreError::SummaryUnwritable`] for a wall time that is not finite; failures of the file system.
    pub fn write_summary(&self, summary: &Summary, renewed: Option<&str>) -> Result<(), StoreError> {
        let content = summary::content(&self.path, summary)?;
        let mut keeper = self.manifest();
        keeper.renew(summary, renewed)?;
        staging::write_file(&self.path, &self.path.join(summary::FILE), &content)?;
        keeper.list_summary(&content, summary);
        Ok(())
    }

    /// Reads `summary.json`; `None` where there is none yet.
    ///
    /// # Errors
    /// [`StoreError::SummaryUnreadable`] for a damaged or foreign one.
    pub fn read_summary(&self) -> Result<Option<Summary>, StoreError> {
        summary::read(&self.path)
    }

    /// Writes `<name>.csv` and returns its path.
    ///
    /// # Errors
    /// As [`write_dataset`](Self::write_dataset).
    pub fn write_table(&self, name: &str, table: &Table) -> Result<PathBuf, StoreError> {
        check_name("a table", name)?;
        let path = self.path.join(format!("{name}.csv"));
        let content = table.to_csv().map_err(|source| StoreError::write(&path, 0, source))?;
        self.put(Some(name), &path, &content)?;
        Ok(path)
    }

    /// Writes another file of the study, such as `figures/map.svg`, with the folders that it needs, and returns its path.
    ///
    /// # Errors
    /// [`StoreError::OutsideFolder`] for a path that is absolute, leaves the folder, or is one of the store's own,
    /// [`StoreError::LinkInPlace`] where it leaves through a link; failures of the file system.
    pub fn write_file(&self, relative: impl AsRef<Path>, content: &[u8]) -> Result<PathBuf, StoreError> {
        self.write_file_of(None, relative.as_ref(), content)
    }

    /// The same for a file that is a part of what an analysis left, such as a sound: without it the analysis is not done.
    ///
    /// # Errors
    /// As of [`write_file`](Self::write_file).
    pub fn write_file_of(
        &self,
        analysis: Option<&str>,
        relative: &Path,
        content: &[u8],
    ) -> Result<PathBuf, StoreError> {
        let path = self.inner_place(relative)?;
        let folder = path.parent().unwrap_or(&self.path);
        judder_disk::create_folders(folder)
            .map_err(|source| StoreError::write(&path, content.len() as u64, source))?;
        self.put(analysis, &path, content)?;
        Ok(path)
    }

    /// Where a relative path leads, which is inside the study folder and none of the store's own files.
    fn inner_place(&self, relative: &Path) -> Result<PathBuf, StoreError> {
        let outside = || StoreError::OutsideFolder { path: relative.to_owned() };
        if !is_plain_place(relative) {
            return Err(outside());
        }
        let root = self.output.as_ref().unwrap_or(&self.path);
        let path = root.join(relative);
        let folder = path.parent().unwrap_or(root);
        let failed = |source| StoreError::read(&path, source);
        // Asked before any folder is made: a link may lead elsewhere.
        let existing = folder.ancestors().find(|ancestor| ancestor.exists()).unwrap_or(folder);
        let real = existing.canonicalize().map_err(failed)?;
        if real.starts_with(root.canonicalize().map_err(failed)?) {
            return Ok(path);
        }
        let inner = existing.ancestors().take_while(|ancestor| *ancestor != root);
        match inner.into_iter().find(|ancestor| plain::is_link(ancestor)) {
            Some(link) => Err(StoreError::LinkInPlace { path: link.to_owned() }),
            None => Err(outside()),
        }
    }

    fn manifest(&self) -> MutexGuard<'_, ManifestKeeper> {
        self.manifest.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The folder of an analysis in the store.
    fn group(&self, analysis: &str) -> Result<PathBuf, StoreError> {
        check_name("an analysis", analysis)?;
        Ok(self.path.join(results::FOLDER).join(analysis))
    }
}

/// Removes a file of the study; a folder in its place that holds something is somebody's, and stays.
fn remove_file(path: &Path) -> Result<(), StoreError> {
    let is_kept =
        path.symlink_metadata().is_ok_and(|there| there.is_dir()) && staging::clear_place(path).is_err();
    if is_kept {
        Ok(())
    } else {
        judder_disk::remove(path).map_err(|source| StoreError::write(path, 0, source))
    }
}

/// Refuses what is no study.
pub(crate) fn look(path: &Path) -> Result<(), StoreError> {
    if path.exists() && !path.is_dir() {
        return Err(StoreError::NotAFolder { path: path.to_owned() });
    }
    let is_there = |name: &str| {
        let path = path.join(name);
        path.try_exists().map_err(|source| StoreError::read(&path, source))
    };
    if is_there(summary::FILE)? || is_there(results::FOLDER)? {
        return Ok(());
    }
    Err(StoreError::NoStudy { path: path.to_owned() })
}

/// Makes the folder of a study where there is none, and returns the place of its lock.
pub(crate) fn prepare(path: &Path) -> Result<PathBuf, StoreError> {
    let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    if whole.to_str().is_none() {
        return Err(StoreError::PathNotText { path: path.to_owned() });
    }
    judder_disk::create_folders(path).map_err(|source| match source.kind() {
        ErrorKind::AlreadyExists | ErrorKind::NotADirectory => {
            StoreError::NotAFolder { path: path.to_owned() }
        }
        _ => StoreError::write(path, 0, source),
    })?;
    refuse_foreign(path)?;
    Ok(path.join(lock::FILE))
}

/// Refuses a folder that holds files of someone else.
fn refuse_foreign(path: &Path) -> Result<(), StoreError> {
    let mut names = Vec::new();
    for entry in fs::read_dir(path).map_err(|source| StoreError::read(path, source))? {
        names.push(entry.map_err(|source| StoreError::read(path, source))?.file_name());
    }
    // Asked after the list is made: whoever began this study meanwhile began with its lock.
    if path.join(summary::FILE).exists() || path.join(lock::FILE).exists() {
        return Ok(());
    }
    match names.iter().min() {
        Some(first) => {
            let holds = first.to_string_lossy().into_owned();
            Err(StoreError::ForeignFolder { path: path.to_owned(), holds })
        }
        None => Ok(()),
    }
}

/// Whether a relative path stays inside and names none of the store's own files.
fn is_plain_place(relative: &Path) -> bool {
    let plain = |component: Component| match component {
        Component::Normal(name) => !name.to_string_lossy().starts_with('.'),
        _ => false,
    };
    let files = [summary::FILE, manifest::FILE];
    let own = relative.starts_with(results::FOLDER) || files.iter().any(|file| relative == Path::new(file));
    relative.file_name().is_some() && relative.components().all(plain) && !own
}
