//! The manifest of a study that is being written.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::{FileRecord, Manifest, SoundFiles, hash_of, told};
use crate::group_store::WrittenFiles;
use crate::{FileDamage, StoreError, Summary, results, summary, sweep};

/// How long the list of a new study is not forced to the disk: what a disk without power loses of it takes no longer to be computed again.
const YOUNG: Duration = Duration::from_secs(1);

/// The manifest of a study that is held alone.
///
/// What is about to change is taken off the list on the disk first, and comes back with its new content. So a run that is killed, at any instant,
/// leaves a list of which every entry is true: what it was about is not on it, and is computed again. Of chunks of sweeps it says what they are when they are whole.
#[derive(Debug)]
pub(crate) struct ManifestKeeper {
    study: PathBuf,
    /// Whether the study was complete when it was taken.
    was_complete: bool,
    /// What holds now.
    now: Manifest,
    /// What the disk says; none where it says nothing.
    on_disk: Option<Manifest>,
    /// Whether it said what nobody can believe.
    was_damaged: bool,
    /// What has been read and is as it was written.
    sound: SoundFiles,
    /// When a study was taken that had no list.
    taken: Option<Instant>,
}

impl ManifestKeeper {
    /// Takes up that of a study; one that cannot be read lists nothing.
    ///
    /// # Errors
    /// A failure of the file system.
    pub(crate) fn take(study: &Path) -> Result<Self, StoreError> {
        let (on_disk, was_damaged) = match Manifest::read(study) {
            Err(StoreError::ManifestDamaged { .. } | StoreError::Oversized { .. }) => (None, true),
            read => (read?, false),
        };
        let now = on_disk.clone().unwrap_or_default();
        let (was_complete, sound) = (now.complete, SoundFiles::default());
        let taken = on_disk.is_none().then(Instant::now);
        Ok(Self { study: study.to_owned(), was_complete, now, on_disk, was_damaged, sound, taken })
    }

    /// Whether the study was complete when it was taken.
    pub(crate) fn was_complete(&self) -> bool {
        self.was_complete
    }

    /// Whether the manifest that the study had when it was taken was damaged.
    pub(crate) fn was_damaged(&self) -> bool {
        self.was_damaged
    }

    /// Whether the study has a manifest.
    pub(crate) fn is_on_disk(&self) -> bool {
        self.on_disk.is_some()
    }

    /// What holds now.
    pub(crate) fn manifest(&self) -> &Manifest {
        &self.now
    }

    /// What has been read and is as it was written.
    pub(crate) fn sound(&self) -> &SoundFiles {
        &self.sound
    }

    /// Takes for sound what was so before.
    pub(crate) fn trust(&mut self, sound: SoundFiles) {
        self.sound = sound;
    }

    /// Takes off the list what these results are and have, before they are computed anew. Chunks of sweeps stay on it: computed again they are the same, and
    /// one of another case in the place of a listed one is known by that.
    ///
    /// # Errors
    /// A failure of the file system.
    pub(crate) fn begin(&mut self, names: &[&str]) -> Result<(), StoreError> {
        self.now.results.retain(|name, _| !names.contains(&name.as_str()));
        self.take_off(|path, record| {
            record.of.as_deref().is_some_and(|of| names.contains(&of)) && !sweep::is_chunk(Path::new(path))
        })
    }

    /// Takes files off the list before they change.
    ///
    /// # Errors
    /// A failure of the file system.
    pub(crate) fn take_off(&mut self, changes: impl Fn(&str, &FileRecord) -> bool) -> Result<(), StoreError> {
        self.now.files.retain(|path, record| !changes(path, record));
        self.now.complete = false;
        let Some(disk) = &self.on_disk else { return Ok(()) };
        let is_true = !disk.complete
            && disk.files.keys().all(|path| path != summary::FILE && self.now.files.contains_key(path))
            && disk.results.keys().all(|name| self.now.results.contains_key(name));
        if is_true { Ok(()) } else { self.write(self.unfinished()) }
    }

    /// Takes off the list what a run from nothing forgets as a whole: that any result is there, the summary, all arrays. Gives back what else it forgets,
    /// the files of results and those that are drawn, which stay on the list until they are removed: a kill before that must not make them somebody's.
    ///
    /// # Errors
    /// A failure of the file system.
    pub(crate) fn forget(&mut self, is_drawn: impl Fn(&str) -> bool) -> Result<Vec<String>, StoreError> {
        self.now.results.clear();
        let below = format!("{}/", results::FOLDER);
        let is_whole = |path: &str| path == summary::FILE || path.starts_with(&below);
        self.take_off(|path, _| is_whole(path))?;
        let is_single = |path: &str, record: &FileRecord| record.of.is_some() || is_drawn(path);
        let listed = self.now.files.iter().filter(|(path, record)| is_single(path, record));
        Ok(listed.map(|(path, _)| path.clone()).collect())
    }

    /// Lists a file that has been written.
    pub(crate) fn list(&mut self, path: String, record: FileRecord) {
        self.now.files.insert(path, record);
    }

    /// Lists files that have been written.
    pub(crate) fn list_written(&mut self, of: Option<&str>, files: WrittenFiles) {
        for (path, (bytes, hash)) in files {
            if let Some(relative) = relative(&self.study, &path) {
                let record = FileRecord { bytes, hash, of: of.map(str::to_owned), build: String::new() };
                self.list(relative, record);
            }
        }
    }

    /// Reads and lists all files of a folder of the study, as a part of it as a whole.
    ///
    /// # Errors
    /// A failure of the file system.
    pub(crate) fn list_folder(&mut self, folder: &Path) -> Result<(), StoreError> {
        let files = files_below(folder).map_err(|source| StoreError::read(folder, source))?;
        let read = |path: PathBuf| match hash_of(&path) {
            Ok(listed) => Ok((path, listed)),
            Err(source) => Err(StoreError::read(&path, source)),
        };
        let files = files.into_iter().map(read).collect::<Result<_, _>>()?;
        self.list_written(None, files);
        Ok(())
    }

    /// Takes the summary off the list, and what it tells of a result that is new in it.
    ///
    /// # Errors
    /// A failure of the file system.
    pub(crate) fn renew(&mut self, summary: &Summary, renewed: Option<&str>) -> Result<(), StoreError> {
        let stays = |name: &str| summary.analyses.contains_key(name) && Some(name) != renewed;
        self.now.results.retain(|name, _| stays(name));
        self.take_off(|path, _| path == summary::FILE)
    }

    /// Lists the summary, and what it tells of results that are not on the list; what it tells of others must be what it was.
    pub(crate) fn list_summary(&mut self, content: &[u8], summary: &Summary) {
        self.list(summary::FILE.to_owned(), FileRecord::new(None, content));
        for name in summary.analyses.keys() {
            self.now.results.entry(name.clone()).or_insert_with(|| told(summary, name));
        }
    }

    /// Writes the list, of this build where that was not known. Until it is complete the summary is not on it, which changes with every result.
    ///
    /// # Errors
    /// A failure of the file system.
    pub(crate) fn keep(&mut self, build: &str, complete: bool) -> Result<(), StoreError> {
        self.now.files.values_mut().filter(|record| record.build.is_empty()).for_each(|record| {
            build.clone_into(&mut record.build);
        });
        self.now.complete = complete;
        let listed = if complete { self.now.clone() } else { self.unfinished() };
        if self.on_disk.as_ref() == Some(&listed) { Ok(()) } else { self.write(listed) }
    }

    /// What holds now without the summary, which changes with every result: so one write takes a finished study up again.
    fn unfinished(&self) -> Manifest {
        let mut listed = self.now.clone();
        listed.files.remove(summary::FILE);
        listed
    }

    /// What is wrong with a result: its files, and what the summary tells of it. Nothing is known of one that is not on the list.
    pub(crate) fn damages(&mut self, name: &str, summary: &Summary) -> Vec<(String, FileDamage)> {
        let Self { study, now, sound, .. } = self;
        let mut damages = sound.check_all(study, now.files_of(name).collect());
        if now.results.get(name).is_some_and(|listed| *listed != told(summary, name)) {
            damages.push((summary::FILE.to_owned(), FileDamage::Content));
        }
        damages
    }

    fn write(&mut self, listed: Manifest) -> Result<(), StoreError> {
        let is_young = self.taken.is_some_and(|taken| taken.elapsed() < YOUNG);
        listed.write(&self.study, !is_young)?;
        self.on_disk = Some(listed);
        Ok(())
    }
}

/// The path of a file of a study as the manifest has it; none where it is no text.
pub(crate) fn relative(study: &Path, path: &Path) -> Option<String> {
    let parts: Option<Vec<&str>> =
        path.strip_prefix(study).ok()?.components().map(|part| part.as_os_str().to_str()).collect();
    Some(parts?.join("/"))
}

/// All files below a folder, by their paths.
pub(crate) fn files_below(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let (mut found, mut folders) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(folder) = folders.pop() {
        let (files, below) = entries(&folder)?;
        found.extend(files);
        folders.extend(below);
    }
    found.sort();
    Ok(found)
}

/// What a folder holds: what is no folder, links among it, and folders.
pub(crate) fn entries(folder: &Path) -> io::Result<(Vec<PathBuf>, Vec<PathBuf>)> {
    let (mut files, mut folders) = (Vec::new(), Vec::new());
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() { folders.push(entry.path()) } else { files.push(entry.path()) }
    }
    Ok((files, folders))
}
