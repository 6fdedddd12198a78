//! `manifest.json`: what a study was when it was written, file by file, so that damage is told from results.
//!
//! It stands for accidents: a disk that fails, a copy that ends too soon, a file that was edited. It is no signature.
//!
//! - [`Manifest`]: every file with its size and hash, the analysis that it is of and the build that wrote it; of every result the hash of what
//!   `summary.json` tells of it.
//! - `keeper.rs`: the manifest of a study that is being written.
//! - `reader.rs`: the manifest of a study that others may be writing.
//! - `look.rs`: files beside what is listed of them; `checked.rs`: one of them, while it is handed on.

mod checked;
mod keeper;
mod look;
mod reader;

use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::{
    ChunkDamage, LARGEST_DOCUMENT, StoreError, Summary, content_hash, folder, plain, staging, summary, sweep,
};

pub use checked::CheckedFile;
pub(crate) use keeper::{ManifestKeeper, entries, files_below, relative};
pub use look::{FileDamage, SoundFiles};
pub(crate) use look::{check, hash_of};
pub(crate) use reader::ManifestReader;

/// The name of the manifest in a study folder.
pub(crate) const FILE: &str = "manifest.json";

/// What a study was when it was written.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Manifest {
    /// Whether it lists all; not while a run is at work, or has been interrupted.
    pub(crate) complete: bool,
    /// Analysis or sweep → the hash of what the summary tells of it.
    pub(crate) results: BTreeMap<String, String>,
    /// Path in the study, with `/` between folders → what the file was.
    pub(crate) files: BTreeMap<String, FileRecord>,
}

/// A manifest with the hash of itself, by which its own damage is found.
#[derive(Debug, Serialize, Deserialize)]
struct SealedManifest {
    hash: String,
    #[serde(flatten)]
    manifest: Manifest,
}

/// What a file was when it was written.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct FileRecord {
    /// Its size.
    pub(crate) bytes: u64,
    /// The BLAKE3 hash of its content.
    pub(crate) hash: String,
    /// The analysis or sweep that it is of; none for what is of the study as a whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) of: Option<String>,
    /// The build that wrote it; empty until that is known.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub(crate) build: String,
}

impl FileRecord {
    /// That of a file with this content.
    pub(crate) fn new(of: Option<&str>, content: &[u8]) -> Self {
        let (bytes, hash) = (content.len() as u64, content_hash(content));
        Self { bytes, hash, of: of.map(str::to_owned), build: String::new() }
    }

    /// Whether this is the content that was written.
    fn is_of(&self, content: &[u8]) -> bool {
        self.bytes == content.len() as u64 && self.hash == content_hash(content)
    }
}

impl Manifest {
    /// That of a study; `None` where there is none.
    ///
    /// # Errors
    /// [`StoreError::ManifestDamaged`], a failure of the file system.
    pub(crate) fn read(study: &Path) -> Result<Option<Self>, StoreError> {
        let path = study.join(FILE);
        if plain::other_than_file(&path).is_some() {
            return Err(StoreError::ManifestDamaged { path });
        }
        let content = match plain::read_json(&path) {
            Ok(content) => content,
            Err(source) if source.kind() == ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(StoreError::read(&path, source)),
        };
        Self::from_content(&path, &content).map(Some)
    }

    /// That which a file holds.
    fn from_content(path: &Path, content: &[u8]) -> Result<Self, StoreError> {
        match serde_json::from_slice::<SealedManifest>(content) {
            Ok(read) if read.manifest.content()? == content => Ok(read.manifest),
            _ => Err(StoreError::ManifestDamaged { path: path.to_owned() }),
        }
    }

    /// That of a folder that should be a study. One of parts that nobody has merged yet has no summary, and lists nothing.
    ///
    /// # Errors
    /// [`StoreError::NotAFolder`], [`StoreError::NoStudy`], [`StoreError::NoManifest`]; else as of [`Manifest::read`].
    pub(crate) fn of_study(study: &Path) -> Result<Self, StoreError> {
        if study.exists() && !study.is_dir() {
            return Err(StoreError::NotAFolder { path: study.to_owned() });
        }
        match Self::read(study)? {
            Some(manifest) => return Ok(manifest),
            None => folder::look(study)?,
        }
        match study.join(summary::FILE).exists() {
            true => Err(StoreError::NoManifest { path: study.to_owned() }),
            false => Ok(Self::default()),
        }
    }

    /// Writes it, forced to the disk or not.
    pub(crate) fn write(&self, study: &Path, is_forced: bool) -> Result<(), StoreError> {
        let write = if is_forced { staging::write_file } else { staging::write_unforced };
        let (path, content) = (study.join(FILE), self.content()?);
        let size = content.len() as u64;
        plain::check_size(size, LARGEST_DOCUMENT).map_err(|source| StoreError::read(&path, source))?;
        write(study, &path, &content)
    }

    /// The content of its file.
    fn content(&self) -> Result<Vec<u8>, StoreError> {
        let unwritable = |source| StoreError::SummaryUnwritable { path: FILE.into(), source };
        let hash = content_hash(&serde_json::to_vec(self).map_err(unwritable)?);
        let mut content = serde_json::to_vec_pretty(&SealedManifest { hash, manifest: self.clone() })
            .map_err(unwritable)?;
        content.push(b'\n');
        Ok(content)
    }

    /// Whether a summary tells of listed results what was not told.
    fn is_other(&self, summary: &Summary) -> bool {
        self.results.iter().any(|(name, hash)| *hash != told(summary, name))
    }

    /// Refuses a summary that is not what was written: its file, or what it tells of results that are listed.
    ///
    /// # Errors
    /// [`StoreError::Damaged`].
    pub(crate) fn vouch(&self, study: &Path, content: &[u8], summary: &Summary) -> Result<(), StoreError> {
        let is_listed = |record: &FileRecord| record.is_of(content);
        if self.files.get(summary::FILE).is_none_or(is_listed) && !self.is_other(summary) {
            return Ok(());
        }
        Err(StoreError::Damaged { path: study.join(summary::FILE), damage: FileDamage::Content })
    }

    /// Whether a file of a finished study is of a result that it no longer has: an earlier case has left it.
    pub(crate) fn is_earlier(&self, file: &FileRecord) -> bool {
        self.complete && file.of.as_ref().is_some_and(|of| !self.results.contains_key(of))
    }

    /// The files of an analysis or a sweep.
    pub(crate) fn files_of(&self, name: &str) -> impl Iterator<Item = (&String, &FileRecord)> {
        self.files.iter().filter(move |(_, record)| record.of.as_deref() == Some(name))
    }
}

/// Refuses the content of the summary of a study where the content of its manifest says that it was another; for studies that lie elsewhere.
///
/// # Errors
/// [`StoreError::ManifestDamaged`], [`StoreError::Damaged`], [`StoreError::SummaryUnreadable`].
pub fn vouch_for(study: &Path, manifest: &[u8], content: &[u8]) -> Result<(), StoreError> {
    let path = study.join(summary::FILE);
    let manifest = Manifest::from_content(&study.join(FILE), manifest)?;
    match serde_json::from_slice::<Summary>(content) {
        Err(source) => Err(StoreError::SummaryUnreadable { path, source }),
        Ok(summary) => manifest.vouch(study, content, &summary),
    }
}

/// Refuses the content of a file of a study that is not of this size with this hash, as its manifest has them; for studies that lie elsewhere.
///
/// # Errors
/// [`StoreError::DamagedChunk`] for a chunk of a sweep, else [`StoreError::Damaged`].
pub fn vouch_for_file(path: &Path, bytes: u64, hash: &str, content: &[u8]) -> Result<(), StoreError> {
    let record = FileRecord { bytes, hash: hash.to_owned(), of: None, build: String::new() };
    let path = path.to_owned();
    match record.is_of(content) {
        true => Ok(()),
        false if sweep::is_chunk(&path) => {
            Err(StoreError::DamagedChunk { path, damage: ChunkDamage::Values })
        }
        false => Err(StoreError::Damaged { path, damage: FileDamage::Content }),
    }
}

/// The hash of what a summary tells of an analysis or a sweep: its results, its record, and what tables by such names hold for it among the rest.
pub(crate) fn told(summary: &Summary, name: &str) -> String {
    let tables = summary.extra.iter().filter_map(|(key, table)| Some((key, table.as_object()?)));
    let rest: BTreeMap<String, &Value> = tables
        .flat_map(|(key, tables)| tables.iter().map(move |(own, table)| (format!("{key}.{own}"), table)))
        .filter_map(|(key, table)| Some((key, table.as_object()?.get(name)?)))
        .collect();
    let told = json!([summary.results.get(name), summary.analyses.get(name), rest]);
    content_hash(told.to_string().as_bytes())
}
