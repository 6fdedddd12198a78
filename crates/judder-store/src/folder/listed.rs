//! What of a study is on the list of what it holds, and how it comes there.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::PoisonError;
use std::{fs, io};

use crate::manifest::{self, FileRecord, SoundFiles};
use crate::name::check_name;
use crate::sweep::{self, ChunkFile, SweepChunks, SweepLayout};
use crate::{
    FileDamage, LARGEST_DOCUMENT, Status, StoreError, StudyFolder, Summary, plain, results, scratch, staging,
    summary, zarr,
};

/// How the names of what analyses keep while they run begin.
const KEPT_WHILE_RUNNING: &[&str] = &[scratch::OF_ANALYSIS, staging::STREAM_PREFIX];

impl StudyFolder {
    /// Writes anew what frames the chunks of a sweep, coordinates and metadata, where that is known to be damaged, a run was killed that wrote it
    /// anew, or nothing lists it; whether it is known. The sweep then has to be finished again.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn mend_sweep(&self, layout: &SweepLayout) -> Result<bool, StoreError> {
        let below = format!("{}/{}/", results::FOLDER, layout.name());
        let chunks = format!("{below}{}", sweep::CHUNKS);
        let is_frame = |path: &str| path.starts_with(&below) && !path.starts_with(&chunks);
        let is_listed = self.manifest().manifest().files.keys().any(|path| is_frame(path));
        let is_whole = match self.refuse_damaged(&below, is_frame) {
            Err(StoreError::Damaged { .. }) => false,
            Ok(()) => sweep::has_frame(&self.path, layout)?,
            Err(error) => return Err(error),
        };
        if is_whole {
            // where no list tells, nothing but the group says what it is; the rest may be anything
            if is_listed || !matches!(SweepChunks::look(&self.path, layout), Ok(Some(_))) {
                return Ok(false);
            }
        }
        self.manifest().begin(&[layout.name()])?;
        sweep::mend(&self.path, layout)?;
        self.consolidate()?;
        Ok(!is_whole)
    }

    /// Lists the files of a sweep whose chunks are all there: these as they were read, what frames them as it is written. What else lies among them is not
    /// judder's.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn list_sweep(&self, layout: &SweepLayout, chunks: Vec<ChunkFile>) -> Result<(), StoreError> {
        let mut files = sweep::frame(&self.path, layout)?;
        files.extend(chunks.into_iter().map(|ChunkFile { path, bytes, hash }| (path, (bytes, hash))));
        let below = format!("{}/{}/", results::FOLDER, layout.name());
        let is_of_sweep = |path: &str| files.contains_key(&self.path.join(path));
        let mut keeper = self.manifest();
        keeper.take_off(|path, _| path.starts_with(&below) && !is_of_sweep(path))?;
        keeper.list_written(Some(layout.name()), files);
        Ok(())
    }

    /// Lists what killed runs have left of results that are none of the `current` ones: arrays that are on no list, and what analyses keep while they run. From
    /// then on it counts as what an earlier case has left. Gives back the names of these results.
    ///
    /// # Errors
    /// Failures of the file system, but for those that concern one file: that stays off the list.
    pub fn list_left(&self, current: &[&str]) -> Result<Vec<String>, StoreError> {
        let mut keeper = self.manifest();
        let mut left = BTreeSet::new();
        let work = work_of_results(&self.path).map_err(|source| StoreError::read(&self.path, source))?;
        for (name, path) in work.iter().filter(|(name, _)| !current.contains(&name.as_str())) {
            let files = if path.is_dir() { manifest::files_below(path) } else { Ok(vec![path.clone()]) };
            for file in files.map_err(|source| StoreError::read(path, source))? {
                let Some(relative) = manifest::relative(&self.path, &file) else { continue };
                if keeper.manifest().files.contains_key(&relative) {
                    continue;
                }
                if let Ok((bytes, hash)) = manifest::hash_of(&file) {
                    let record = FileRecord { bytes, hash, of: Some(name.clone()), build: String::new() };
                    keeper.list(relative, record);
                    left.insert(name.clone());
                }
            }
        }
        Ok(left.into_iter().collect())
    }

    /// Lists all files below a folder of the study that came there by other ways than this crate's, as a part of the study as a whole.
    ///
    /// # Errors
    /// [`StoreError::OutsideFolder`] for a path that leaves the folder, or is one of the store's own; failures of the file system.
    pub fn list_files(&self, below: &str) -> Result<(), StoreError> {
        let path = self.inner_place(Path::new(below))?;
        self.manifest().take_off(|listed, _| Path::new(listed).starts_with(below))?;
        if path.is_dir() { self.manifest().list_folder(&path) } else { Ok(()) }
    }

    /// Takes files that belong to no result off the list at once, before they are written anew one after the other; gives back which.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn begin_files(&self, changes: impl Fn(&str) -> bool) -> Result<Vec<String>, StoreError> {
        if self.output.is_some() {
            return Ok(Vec::new());
        }
        let mut keeper = self.manifest();
        let changes = |path: &str, record: &FileRecord| record.of.is_none() && changes(path);
        let listed = keeper.manifest().files.iter().filter(|(path, record)| changes(path, record));
        let begun = listed.map(|(path, _)| path.clone()).collect();
        keeper.take_off(changes)?;
        Ok(begun)
    }

    /// Removes those of the files with which [`begin_files`](Self::begin_files) began that have not been written anew.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn end_files(&self, begun: &[String]) -> Result<(), StoreError> {
        for left in begun {
            if self.manifest().manifest().files.contains_key(left) {
                continue;
            }
            // a list that names what lies elsewhere is none of this crate's
            if let Ok(place) = self.inner_place(Path::new(left)) {
                super::remove_file(&place)?;
            }
        }
        Ok(())
    }

    /// Takes these results off the list of what the study holds, before they are computed anew: a run that is killed then leaves no list that names
    /// what it was about to replace, but for chunks of sweeps, which are the same when they are computed again.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn begin_results(&self, names: &[&str]) -> Result<(), StoreError> {
        self.manifest().begin(names)
    }

    /// What of the results that the summary calls done is not as it was written, by the names of the results: their files, all of which are read, and
    /// what the summary tells of them.
    ///
    /// # Errors
    /// [`StoreError::Unreadable`] for the first file that cannot be read: whether it is damaged is not known.
    pub fn damages(
        &self,
        summary: &Summary,
    ) -> Result<BTreeMap<String, Vec<(String, FileDamage)>>, StoreError> {
        let mut keeper = self.manifest();
        let done = summary.analyses.iter().filter(|(_, record)| record.status == Status::Done);
        let found = done.map(|(name, _)| (name.clone(), keeper.damages(name, summary)));
        let found: BTreeMap<_, _> = found.filter(|(_, damages)| !damages.is_empty()).collect();
        match found.values().flatten().find(|(_, damage)| !damage.is_damage()) {
            Some((path, damage)) => Err(StoreError::of_damage(self.path.join(path), damage.clone())),
            None => Ok(found),
        }
    }

    /// Whether a result is on the list of what the study holds: no run is at work on it, or was when it ended.
    #[must_use]
    pub fn is_listed(&self, name: &str) -> bool {
        self.manifest().manifest().results.contains_key(name)
    }

    /// The files that were read since the study was taken, and are as they were written.
    #[must_use]
    pub fn sound_files(&self) -> SoundFiles {
        self.manifest().sound().clone()
    }

    /// Takes files for sound that were so when this process held the study before, and have not been written since: they are not read again.
    pub fn trust(&self, sound: SoundFiles) {
        self.manifest().trust(sound);
    }

    /// Whether the study has a list of what it holds.
    #[must_use]
    pub fn has_manifest(&self) -> bool {
        self.manifest().is_on_disk()
    }

    /// Why nothing says that what the study holds is as it was written; none where it has a list.
    #[must_use]
    pub fn without_manifest(&self) -> Option<StoreError> {
        let keeper = self.manifest();
        let path = self.path.join(manifest::FILE);
        match (keeper.is_on_disk(), keeper.was_damaged()) {
            (true, _) => None,
            (false, true) => Some(StoreError::ManifestDamaged { path }),
            (false, false) => Some(StoreError::NoManifest { path: self.path.clone() }),
        }
    }

    /// Writes `manifest.json`, the list of what the study holds, while more is being computed. `build` names the program.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn keep_manifest(&self, build: &str) -> Result<(), StoreError> {
        self.manifest().keep(build, false)
    }

    /// Writes `manifest.json` for a study to which nothing is to be added: the last that a run does. The metadata of all arrays together, which follow
    /// from those of each, are written anew where they are not what follows.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn seal(&self, build: &str) -> Result<(), StoreError> {
        let publishing = self.publishing.lock().unwrap_or_else(PoisonError::into_inner);
        results::consolidate(&self.path)?;
        drop(publishing);
        self.manifest().keep(build, true)
    }

    /// Writes `manifest.json` after something was drawn anew; a study that was not complete is no more so than before.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn seal_as_before(&self, build: &str) -> Result<(), StoreError> {
        if self.output.is_some() {
            return Ok(());
        }
        let mut keeper = self.manifest();
        let was_complete = keeper.was_complete();
        keeper.keep(build, was_complete)
    }

    /// Refuses a summary of which nothing says that it is what was written.
    ///
    /// # Errors
    /// [`StoreError::NoManifest`], [`StoreError::ManifestDamaged`], [`StoreError::NotListed`], [`StoreError::Damaged`].
    pub fn vouch(&self, summary: &Summary) -> Result<(), StoreError> {
        if let Some(error) = self.without_manifest() {
            return Err(error);
        }
        let keeper = self.manifest();
        if let Some(name) =
            summary.analyses.keys().find(|name| !keeper.manifest().results.contains_key(*name))
        {
            return Err(StoreError::NotListed { path: self.path.clone(), name: name.clone() });
        }
        let path = self.path.join(summary::FILE);
        let content = plain::read_small_file(&path, LARGEST_DOCUMENT)
            .map_err(|source| StoreError::read(&path, source))?;
        keeper.manifest().vouch(&self.path, &content, summary)
    }

    /// Puts a file in its place, and on the list of what the study holds.
    pub(super) fn put(&self, of: Option<&str>, path: &Path, content: &[u8]) -> Result<(), StoreError> {
        if let Some(output) = &self.output {
            return staging::write_file(output, path, content);
        }
        let relative = manifest::relative(&self.path, path);
        let relative = relative.ok_or_else(|| StoreError::OutsideFolder { path: path.to_owned() })?;
        self.manifest().take_off(|listed, _| listed == relative)?;
        staging::write_file(&self.path, path, content)?;
        self.manifest().list(relative, FileRecord::new(of, content));
        Ok(())
    }

    /// Refuses files on the list below this path, or at it, that are not as they were written.
    pub(super) fn refuse_damaged(
        &self,
        below: &str,
        is_read: impl Fn(&str) -> bool,
    ) -> Result<(), StoreError> {
        let keeper = self.manifest();
        let listed =
            keeper.manifest().files.iter().filter(|(path, _)| path.starts_with(below) && is_read(path));
        for (path, record) in listed {
            let path = self.path.join(path);
            manifest::check(&path, record, true).map_err(|damage| StoreError::of_damage(path, damage))?;
        }
        Ok(())
    }

    /// What is wrong with a file that is on the list.
    pub(super) fn damage_of(&self, file: &Path) -> Option<FileDamage> {
        let keeper = self.manifest();
        let record = keeper.manifest().files.get(&manifest::relative(&self.path, file)?)?;
        manifest::check(file, record, true).err()
    }
}

/// Where arrays of results lie, and what analyses keep while they run, each with the name of the result.
fn work_of_results(study: &Path) -> io::Result<Vec<(String, PathBuf)>> {
    let mut work = Vec::new();
    let arrays = study.join(results::FOLDER);
    let folders = [(study, KEPT_WHILE_RUNNING), (arrays.as_path(), &[""])];
    for (folder, prefixes) in folders.into_iter().filter(|(folder, _)| folder.is_dir()) {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            // what lies among the arrays and is none is somebody's
            if plain::is_link(&path) || (folder == arrays && zarr::stored_hash(&path).is_none()) {
                continue;
            }
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            let own = prefixes.iter().find_map(|prefix| name.strip_prefix(prefix));
            if let Some(own) = own.filter(|own| check_name("an analysis", own).is_ok()) {
                work.push((own.to_owned(), path));
            }
        }
    }
    Ok(work)
}
