//! Files beside what is listed of them.

use std::collections::BTreeMap;
use std::fs;
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::time::SystemTime;

use judder_disk::kind_in_words;
use rayon::prelude::*;

use super::FileRecord;
use crate::plain;

/// Bytes that are read at a time.
const BLOCK: usize = 1 << 20;

/// What is wrong with a file of a study.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FileDamage {
    /// It is not there.
    #[error("it is missing")]
    Missing,
    /// Something else has its name.
    #[error("{0} stands in its place")]
    Other(&'static str),
    /// It is shorter or longer than it was written.
    #[error("it has {found} bytes, where {expected} were written")]
    Size {
        /// Bytes that were written.
        expected: u64,
        /// Bytes that are there.
        found: u64,
    },
    /// It is as long as it was written, with other content.
    #[error("its content is not what was written")]
    Content,
    /// It cannot be read, which says nothing of what it holds.
    #[error("it cannot be read: {0}")]
    Unreadable(String),
}

impl FileDamage {
    /// Whether the file is known not to be as it was written.
    #[must_use]
    pub fn is_damage(&self) -> bool {
        !matches!(self, Self::Unreadable(_))
    }
}

/// Files of a study that were read and are as they were written, by their paths in it.
#[derive(Debug, Clone, Default)]
pub struct SoundFiles(BTreeMap<String, (FileStamp, String)>);

/// By what a file is known to have been written since: when it was, its size.
pub(crate) type FileStamp = (Option<SystemTime>, u64);

/// The stamp of a file.
pub(crate) fn stamp(metadata: &fs::Metadata) -> FileStamp {
    (metadata.modified().ok(), metadata.len())
}

impl SoundFiles {
    /// Compares files of a study with what is listed of them, by their content, on all cores; one that was sound and was not written since is not
    /// read. Gives back what is wrong, in the order of the files.
    pub(crate) fn check_all(
        &mut self,
        study: &Path,
        files: Vec<(&String, &FileRecord)>,
    ) -> Vec<(String, FileDamage)> {
        let of = |(path, record): &(&String, &FileRecord)| self.check(study, path, record);
        let looked: Vec<Result<Option<FileStamp>, FileDamage>> = files.par_iter().map(of).collect();
        let mut damages = Vec::new();
        for ((path, record), found) in files.into_iter().zip(looked) {
            match found {
                Ok(None) => {}
                Ok(Some(stamp)) => drop(self.0.insert(path.clone(), (stamp, record.hash.clone()))),
                Err(damage) => damages.push((path.clone(), damage)),
            }
        }
        damages
    }

    /// Compares a file; gives back its stamp where it was read.
    fn check(&self, study: &Path, path: &str, record: &FileRecord) -> Result<Option<FileStamp>, FileDamage> {
        let file = study.join(path);
        let Ok(metadata) = fs::symlink_metadata(&file) else {
            return check(&file, record, true).map(|()| None);
        };
        let stamp = stamp(&metadata);
        let is_known = self.0.get(path).is_some_and(|(known, hash)| *known == stamp && *hash == record.hash);
        if metadata.is_file() && is_known {
            return Ok(None);
        }
        check(&file, record, true).map(|()| Some(stamp))
    }
}

/// Compares a file with what is listed of it: by its size, and by its content where that is to be read.
pub(crate) fn check(path: &Path, record: &FileRecord, by_content: bool) -> Result<(), FileDamage> {
    let unreadable = |source: std::io::Error| FileDamage::Unreadable(source.to_string());
    let metadata = match fs::symlink_metadata(path) {
        Ok(metadata) => metadata,
        Err(source) if matches!(source.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
            return Err(FileDamage::Missing);
        }
        Err(source) => return Err(unreadable(source)),
    };
    if !metadata.is_file() {
        return Err(FileDamage::Other(kind_in_words(metadata.file_type())));
    }
    if metadata.len() != record.bytes {
        return Err(FileDamage::Size { expected: record.bytes, found: metadata.len() });
    }
    if by_content && hash_of(path).map_err(unreadable)?.1 != record.hash {
        return Err(FileDamage::Content);
    }
    Ok(())
}

/// Size and hash of a file.
pub(crate) fn hash_of(path: &Path) -> std::io::Result<(u64, String)> {
    let mut file = plain::open(path)?;
    let mut hasher = blake3::Hasher::new();
    let mut block = vec![0; BLOCK.min(file.metadata()?.len().max(1) as usize)];
    let mut bytes = 0;
    loop {
        match file.read(&mut block) {
            Ok(0) => return Ok((bytes, hasher.finalize().to_hex().to_string())),
            Ok(count) => {
                bytes += count as u64;
                hasher.update(block.get(..count).unwrap_or_default());
            }
            Err(source) if source.kind() == ErrorKind::Interrupted => {}
            Err(source) => return Err(source),
        }
    }
}
