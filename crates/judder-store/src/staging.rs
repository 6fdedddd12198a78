//! The atomic write: everything is put together in a staging folder inside the study, forced to the disk, and then renamed
//! into place. A write that fails removes its staging folder; one that is killed leaves it for [`sweep`].

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use judder_disk::StagingFolder;

use crate::StoreError;

/// How the names of staging folders begin.
pub(crate) const PREFIX: &str = ".partial-";
/// How the names of the folders begin in which streams lie until they are finished.
pub(crate) const STREAM_PREFIX: &str = ".stream-";

/// A staging folder, on the disk of the study so that a rename can leave it. Removed when dropped.
pub(crate) struct Stage(StagingFolder);

impl Stage {
    pub(crate) fn new(study: &Path) -> io::Result<Self> {
        StagingFolder::new(study, PREFIX).map(Self)
    }

    /// A place in the staging folder.
    pub(crate) fn place(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Writes a file into the staging folder and forces it to the disk.
    pub(crate) fn file(&self, name: &str, content: &[u8]) -> io::Result<PathBuf> {
        let place = self.place(name);
        let file = judder_disk::create_new_file(&place)?;
        judder_disk::write(&file, content)?;
        judder_disk::sync(&file)?;
        Ok(place)
    }
}

/// Writes a file so that a reader sees what was at `target` before, or all of `content`.
pub(crate) fn write_file(study: &Path, target: &Path, content: &[u8]) -> Result<(), StoreError> {
    let write = || {
        let stage = Stage::new(study)?;
        let staged = stage.file("content", content)?;
        clear_place(target)?;
        rename(&staged, target)
    };
    write().map_err(|source| StoreError::write(target, content.len() as u64, source))
}

/// The same for a file that a disk without power may lose: it is not forced there, which takes longer than all else.
pub(crate) fn write_unforced(study: &Path, target: &Path, content: &[u8]) -> Result<(), StoreError> {
    let write = || {
        let stage = Stage::new(study)?;
        let staged = stage.place("content");
        judder_disk::write(&judder_disk::create_new_file(&staged)?, content)?;
        clear_place(target)?;
        judder_disk::rename(&staged, target)
    };
    write().map_err(|source| StoreError::write(target, content.len() as u64, source))
}

/// Removes what has the name of a file and is none: a link, a pipe, a folder without anything in it.
///
/// # Errors
/// [`io::ErrorKind::IsADirectory`] for a folder that holds something, which is somebody's; a failure of the file system.
pub(crate) fn clear_place(target: &Path) -> io::Result<()> {
    match fs::symlink_metadata(target) {
        Ok(there) if there.is_dir() && fs::read_dir(target)?.next().is_some() => {
            Err(io::ErrorKind::IsADirectory.into())
        }
        Ok(there) if !there.is_file() => judder_disk::remove(target),
        _ => Ok(()),
    }
}

/// Puts a staged file or folder in the place of whatever stands there, a folder among it.
pub(crate) fn put(staged: &Path, target: &Path) -> io::Result<()> {
    judder_disk::remove(target)?;
    rename(staged, target)
}

/// Renames a staged file or folder to a place where there is nothing, or a file to replace.
pub(crate) fn rename(staged: &Path, target: &Path) -> io::Result<()> {
    judder_disk::rename(staged, target)?;
    target.parent().map_or(Ok(()), judder_disk::sync_folder)
}

/// Puts a staged folder at `target`; what stood there ends up in the staging folder.
///
/// One step where the system can exchange two folders (Linux, macOS). Elsewhere two: in the moment between, `target` is
/// absent, never half there.
pub(crate) fn replace_folder(stage: &Stage, staged: &Path, target: &Path) -> io::Result<()> {
    if !target.exists() {
        return rename(staged, target);
    }
    if judder_disk::exchange(staged, target).is_err() {
        replace_in_two_steps(staged, target, &stage.place("replaced"))?;
    }
    target.parent().map_or(Ok(()), judder_disk::sync_folder)
}

fn replace_in_two_steps(staged: &Path, target: &Path, aside: &Path) -> io::Result<()> {
    judder_disk::rename(target, aside)?;
    judder_disk::rename(staged, target).or_else(|source| {
        judder_disk::rename(aside, target)?;
        Err(source)
    })
}

/// Forces the entries of a folder, and of all folders in it, to the disk.
pub(crate) fn sync_tree(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            sync_tree(&entry.path())?;
        }
    }
    judder_disk::sync_folder(folder)
}

/// Removes all of a study whose names begin so: the staging folders that a killed run left, what analyses kept while they ran.
pub(crate) fn sweep(study: &Path, prefix: &str) -> Result<(), StoreError> {
    for entry in fs::read_dir(study).map_err(|source| StoreError::read(study, source))? {
        let entry = entry.map_err(|source| StoreError::read(study, source))?;
        if entry.file_name().to_string_lossy().starts_with(prefix) {
            let left = entry.path();
            judder_disk::remove(&left).map_err(|source| StoreError::FileSystem {
                action: "remove",
                path: left,
                source,
            })?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_steps_replace_a_folder_or_leave_it() {
        let study = tempfile::tempdir().unwrap();
        let place = |name: &str| study.path().join(name);
        for name in ["new", "old"] {
            fs::create_dir(place(name)).unwrap();
            fs::write(place(name).join("content"), name).unwrap();
        }
        let content = |name: &str| fs::read_to_string(place(name).join("content")).unwrap();
        replace_in_two_steps(&place("missing"), &place("old"), &place("aside")).unwrap_err();
        assert_eq!(content("old"), "old");
        replace_in_two_steps(&place("new"), &place("old"), &place("aside")).unwrap();
        assert_eq!((content("old"), content("aside")), ("new".to_owned(), "old".to_owned()));
    }
}
