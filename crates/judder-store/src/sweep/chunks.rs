//! The chunks of a sweep as they lie on the disk: listed, read, verified; nothing is written.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use super::damage::ChunkDamage;
use super::layout::SweepLayout;
use super::record::{self, ChunkEnd, PointFailure, Record, TRAILER_BYTES};
use super::{group, shard};
use crate::manifest::{self, Manifest};
use crate::{StoreError, content_hash, plain};

/// The chunks of one sweep in a study, to be looked at: no lock is taken, so that chunks may be added meanwhile.
#[derive(Debug, Clone)]
pub struct SweepChunks {
    layout: SweepLayout,
    /// The folder of the array `values`.
    pub(super) folder: PathBuf,
    /// What the study lists, read where a chunk of another case is found.
    list: Arc<OnceLock<Manifest>>,
}

/// What is known of a chunk.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ChunkState {
    /// There is none.
    Missing,
    /// It is whole.
    Done {
        /// How many of its points failed.
        failures: usize,
    },
    /// It is not as it was written. A claim is granted for it, and writing replaces it.
    Damaged(ChunkDamage),
    /// It is one of another case. A claim is refused.
    Foreign {
        /// The hash of that case.
        hash: String,
    },
}

/// A chunk as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct StoredChunk {
    /// The values of all quantities of its first point, then of the second, row-major; NaN where there is none.
    pub values: Vec<f64>,
    /// The points that failed, by index.
    pub failures: Vec<PointFailure>,
}

/// The file of a chunk as the list of what a study holds has it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChunkFile {
    pub(crate) path: PathBuf,
    pub(crate) bytes: u64,
    /// The hash of its content.
    pub(crate) hash: String,
}

/// A point of a sweep that has no answer, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepFailure {
    /// Its chunk.
    pub chunk: usize,
    /// Its position along each dimension.
    pub position: Vec<usize>,
    /// The error, with its causes.
    pub reason: String,
}

impl SweepChunks {
    pub(super) fn new(layout: &SweepLayout, folder: PathBuf) -> Self {
        Self { layout: layout.clone(), folder, list: Arc::default() }
    }

    /// Looks at a sweep in a study folder, which may be read-only; `None` where it is not begun.
    ///
    /// # Errors
    /// [`StoreError::ForeignSweep`], [`StoreError::OtherLayout`], failures of the file system.
    pub fn look(study: impl AsRef<Path>, layout: &SweepLayout) -> Result<Option<Self>, StoreError> {
        let found = group::look(study.as_ref(), layout)?;
        Ok(found.map(|folder| Self::new(layout, folder)))
    }

    /// Its layout.
    #[must_use]
    pub fn layout(&self) -> &SweepLayout {
        &self.layout
    }

    /// Whether each chunk is there, by its number. One list of a folder tells; no chunk is opened.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn done_chunks(&self) -> Result<Vec<bool>, StoreError> {
        let failed = |source| StoreError::read(&self.folder, source);
        let mut done = vec![false; self.layout.chunk_count()];
        for entry in fs::read_dir(&self.folder).map_err(failed)? {
            let name = entry.map_err(failed)?.file_name();
            let chunk = name.to_str().and_then(|name| self.layout.chunk_of_file(name));
            if let Some(done) = chunk.and_then(|chunk| done.get_mut(chunk)) {
                *done = true;
            }
        }
        Ok(done)
    }

    /// Whether a chunk is there; it is not opened.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`], a failure of the file system.
    pub fn has(&self, chunk: usize) -> Result<bool, StoreError> {
        let path = self.path(chunk)?;
        path.try_exists().map_err(|source| StoreError::read(&path, source))
    }

    /// What is known of a chunk; all of it is read and compared with its checksums.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`], a failure of the file system.
    pub fn state(&self, chunk: usize) -> Result<ChunkState, StoreError> {
        let path = self.path(chunk)?;
        let content = match content(&path) {
            Ok(content) => content,
            Err(source) if source.kind() == ErrorKind::NotFound => return Ok(ChunkState::Missing),
            // something else stands in its place
            Err(source) if source.kind() == ErrorKind::InvalidInput => {
                return Ok(ChunkState::Damaged(ChunkDamage::NoRecord));
            }
            Err(source) => return Err(StoreError::read(&path, source)),
        };
        let points = self.layout.points(chunk)?.count();
        let found = record::verified(&self.layout, chunk, points, &content).0;
        Ok(match self.beside_list(&path, found)? {
            ChunkEnd::Whole(record) => ChunkState::Done { failures: record.failures.len() },
            ChunkEnd::Damaged(damage) => ChunkState::Damaged(damage),
            ChunkEnd::Foreign(hash) => ChunkState::Foreign { hash },
        })
    }

    /// Reads a chunk.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`], [`StoreError::MissingChunk`], [`StoreError::DamagedChunk`], [`StoreError::ForeignChunk`], failures of the file
    /// system.
    pub fn read(&self, chunk: usize) -> Result<StoredChunk, StoreError> {
        self.decoded(chunk, &self.content(chunk)?)
    }

    /// Reads a chunk, and says of its file what [`StudyFolder::list_sweep`](crate::StudyFolder::list_sweep) takes.
    ///
    /// # Errors
    /// As of [`read`](Self::read).
    pub fn read_to_list(&self, chunk: usize) -> Result<(StoredChunk, ChunkFile), StoreError> {
        let (path, content) = (self.path(chunk)?, self.content(chunk)?);
        let file = ChunkFile { path, bytes: content.len() as u64, hash: content_hash(&content) };
        Ok((self.decoded(chunk, &content)?, file))
    }

    /// The bytes of a chunk.
    fn content(&self, chunk: usize) -> Result<Vec<u8>, StoreError> {
        let path = self.path(chunk)?;
        match content(&path) {
            Ok(content) => Ok(content),
            Err(source) if source.kind() == ErrorKind::NotFound => Err(StoreError::MissingChunk { path }),
            Err(source) if source.kind() == ErrorKind::InvalidInput => {
                Err(StoreError::DamagedChunk { path, damage: ChunkDamage::NoRecord })
            }
            Err(source) => Err(StoreError::read(&path, source)),
        }
    }

    /// All points that failed so far, by chunk and point. Only the records of the chunks are read.
    ///
    /// # Errors
    /// [`StoreError::DamagedChunk`], [`StoreError::ForeignChunk`], failures of the file system.
    pub fn failures(&self) -> Result<Vec<SweepFailure>, StoreError> {
        let mut failures = Vec::new();
        for (chunk, _) in self.done_chunks()?.iter().enumerate().filter(|(_, done)| **done) {
            let points = self.layout.points(chunk)?;
            for PointFailure { index, reason } in self.record(chunk, points.count())?.failures {
                failures.push(SweepFailure { chunk, position: points.position(index), reason });
            }
        }
        Ok(failures)
    }

    /// The chunks that are there and not whole, or not of this case; every chunk is read and compared with its checksums.
    ///
    /// # Errors
    /// A failure of the file system.
    pub fn verify(&self) -> Result<Vec<(usize, ChunkState)>, StoreError> {
        let mut unsound = Vec::new();
        for (chunk, _) in self.done_chunks()?.iter().enumerate().filter(|(_, done)| **done) {
            match self.state(chunk)? {
                ChunkState::Done { .. } | ChunkState::Missing => {}
                state => unsound.push((chunk, state)),
            }
        }
        Ok(unsound)
    }

    /// Where the file of a chunk is, or will be.
    pub(super) fn path(&self, chunk: usize) -> Result<PathBuf, StoreError> {
        Ok(self.folder.join(self.layout.file_name(chunk)?))
    }

    pub(super) fn foreign(&self, path: PathBuf, found: String) -> StoreError {
        StoreError::ForeignChunk { path, expected: self.layout.hash().to_owned(), found }
    }

    /// What was found of a chunk: one of another case is damage where the list of the study says that something else was written here.
    fn beside_list(&self, path: &Path, found: ChunkEnd) -> Result<ChunkEnd, StoreError> {
        if !matches!(found, ChunkEnd::Foreign(_)) {
            return Ok(found);
        }
        let study = self.folder.ancestors().nth(group::DEPTH).unwrap_or(&self.folder);
        // a list that cannot be read says nothing
        let list = self.list.get_or_init(|| Manifest::read(study).ok().flatten().unwrap_or_default());
        let listed = manifest::relative(study, path).and_then(|path| list.files.get(&path).cloned());
        Ok(match listed.map(|record| manifest::check(path, &record, true)) {
            Some(Err(damage)) if damage.is_damage() => ChunkEnd::Damaged(ChunkDamage::OtherCase),
            _ => found,
        })
    }

    /// The record of a chunk, where it is found.
    fn sound(&self, chunk: usize, found: ChunkEnd) -> Result<Record, StoreError> {
        let path = self.path(chunk)?;
        match self.beside_list(&path, found)? {
            ChunkEnd::Whole(record) => Ok(record),
            ChunkEnd::Damaged(damage) => Err(StoreError::DamagedChunk { path, damage }),
            ChunkEnd::Foreign(hash) => Err(self.foreign(path, hash)),
        }
    }

    /// What the content of the file of a chunk says.
    pub(super) fn decoded(&self, chunk: usize, content: &[u8]) -> Result<StoredChunk, StoreError> {
        let points = self.layout.points(chunk)?;
        let (found, shard) = record::verified(&self.layout, chunk, points.count(), content);
        let failures = self.sound(chunk, found)?.failures;
        match shard::decode(&self.layout, &points, shard) {
            Ok(values) => Ok(StoredChunk { values, failures }),
            Err(source) => Err(StoreError::unreadable(&self.path(chunk)?, source)),
        }
    }

    /// Reads the record of a chunk alone.
    fn record(&self, chunk: usize, points: usize) -> Result<Record, StoreError> {
        let path = self.path(chunk)?;
        let read = || -> io::Result<ChunkEnd> {
            if plain::is_link(&path) {
                return Ok(ChunkEnd::Damaged(ChunkDamage::NoRecord));
            }
            let mut file = plain::open(&path)?;
            let size = file.metadata()?.len();
            let before = size.saturating_sub(TRAILER_BYTES as u64);
            let trailer = read_from(&mut file, before)?;
            let length = record::length(&trailer).filter(|length| *length as u64 <= before);
            let Some(length) = length else { return Ok(ChunkEnd::Damaged(ChunkDamage::NoRecord)) };
            let shard = before - length as u64;
            let end = read_from(&mut file, shard)?;
            Ok(record::read(&self.layout, chunk, points, &end, shard))
        };
        let found = read().map_err(|source| StoreError::read(&path, source))?;
        self.sound(chunk, found)
    }
}

/// The rest of a file, where there is memory for it.
fn read_from(file: &mut File, start: u64) -> io::Result<Vec<u8>> {
    plain::ask(u128::from(file.metadata()?.len().saturating_sub(start)))?;
    let mut rest = Vec::new();
    file.seek(SeekFrom::Start(start))?;
    file.read_to_end(&mut rest)?;
    Ok(rest)
}

/// What the file of a chunk holds; a link is none, wherever it leads.
fn content(path: &Path) -> io::Result<Vec<u8>> {
    if plain::is_link(path) { Err(ErrorKind::InvalidInput.into()) } else { plain::read(path) }
}
