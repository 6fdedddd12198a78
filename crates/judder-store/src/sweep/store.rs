//! The chunks of a sweep on the disk.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use tempfile::TempPath;

use super::claim::{self, ChunkClaim, ClaimAnswer};
use super::layout::SweepLayout;
use super::record::{self, ChunkDamage, Found, PointFailure, Record, TRAILER_BYTES};
use super::{group, shard};
use crate::lock::Lock;
use crate::{StoreError, staging};

/// The chunks of one sweep in a study that this process holds, alone or with others.
///
/// A chunk is one file, there whole or not at all: it is written under another name, forced to the disk and renamed, and it says itself whose
/// it is. What it holds depends on nothing but the sweep, so that a study computed by many processes, some of them killed, has the bytes of one
/// computed by a single process. No clock is asked.
///
/// ```
/// use judder_store::{ClaimAnswer, SharedStudy, SweepDimension, SweepLayout, SweepQuantity};
/// # let folder = tempfile::tempdir()?;
/// let study = SharedStudy::join(folder.path().join("study"))?;
/// let sample = SweepDimension { name: "sample".to_owned(), length: 10, chunk: 4 };
/// let layout =
///     SweepLayout::new("robustness", "hash", vec![sample], vec![SweepQuantity::new("growth_rate", "1/s", "Re(λ)")])?;
/// let store = study.sweep(&layout)?;
/// for (chunk, done) in store.done_chunks()?.into_iter().enumerate().filter(|(_, done)| !done) {
///     if let ClaimAnswer::Claimed(claim) = store.claim(chunk)? {
///         let points = layout.points(chunk)?;
///         let values: Vec<f64> = (0..points.count()).map(|point| points.position(point)[0] as f64).collect();
///         store.write(claim, &values, &[])?;
///     }
/// }
/// assert_eq!(store.read(2)?.values, [8.0, 9.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct SweepStore {
    layout: SweepLayout,
    /// The folder of the array `values`.
    chunks: PathBuf,
    /// The folder of claims, and of chunks that are being written.
    claims: PathBuf,
    /// Keeps out those who want the study alone.
    _study: Arc<Lock>,
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

impl SweepStore {
    pub(crate) fn join(study: &Path, lock: &Arc<Lock>, layout: &SweepLayout) -> Result<Self, StoreError> {
        let chunks = group::join(study, layout)?;
        let claims = study.join(format!("{}{}", claim::PREFIX, layout.name()));
        fs::create_dir_all(&claims).map_err(|source| StoreError::write(&claims, 0, source))?;
        Ok(Self { layout: layout.clone(), chunks, claims, _study: Arc::clone(lock) })
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
        let failed = |source| StoreError::read(&self.chunks, source);
        let mut done = vec![false; self.layout.chunk_count()];
        for entry in fs::read_dir(&self.chunks).map_err(failed)? {
            let name = entry.map_err(failed)?.file_name();
            if let Some(chunk) = name.to_str().and_then(|name| self.layout.chunk_of_file(name)) {
                done[chunk] = true;
            }
        }
        Ok(done)
    }

    /// What is known of a chunk; all of it is read and compared with its checksums.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`], a failure of the file system.
    pub fn state(&self, chunk: usize) -> Result<ChunkState, StoreError> {
        let path = self.path(chunk)?;
        let content = match fs::read(&path) {
            Ok(content) => content,
            Err(source) if source.kind() == ErrorKind::NotFound => return Ok(ChunkState::Missing),
            Err(source) => return Err(StoreError::read(&path, source)),
        };
        let points = self.layout.points(chunk)?.count();
        Ok(match record::verified(&self.layout, chunk, points, &content).0 {
            Found::Whole(record) => ChunkState::Done { failures: record.failures.len() },
            Found::Damaged(damage) => ChunkState::Damaged(damage),
            Found::Foreign(hash) => ChunkState::Foreign { hash },
        })
    }

    /// Claims a chunk, to compute it. One that is damaged is computed again.
    ///
    /// Where the file system has no locks a claim is always granted; at worst two compute the same bytes.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`], [`StoreError::ForeignChunk`], failures of the file system.
    pub fn claim(&self, chunk: usize) -> Result<ClaimAnswer, StoreError> {
        let path = self.path(chunk)?;
        let Some(claim) = ChunkClaim::take(&self.claims, chunk)? else { return Ok(ClaimAnswer::Busy) };
        // Looked at with the claim in hand: its last holder may just have finished.
        match self.state(chunk)? {
            ChunkState::Missing | ChunkState::Damaged(_) => {}
            ChunkState::Done { .. } => {
                claim.fulfilled();
                return Ok(ClaimAnswer::Done);
            }
            ChunkState::Foreign { hash } => return Err(self.foreign(path, hash)),
        }
        if let Some(left) = claim.temporary() {
            staging::remove(&left).map_err(|source| StoreError::write(&left, 0, source))?;
        }
        Ok(ClaimAnswer::Claimed(claim))
    }

    /// Writes a claimed chunk; it is on the disk when this returns. The arguments are those of [`SweepLayout::encode`].
    ///
    /// # Errors
    /// As [`SweepLayout::encode`]; [`StoreError::DiskFull`] and other failures of the file system. The claim ends, and nothing half-written
    /// stays.
    pub fn write(
        &self,
        claim: ChunkClaim,
        values: &[f64],
        failures: &[PointFailure],
    ) -> Result<(), StoreError> {
        let content = self.layout.encode(claim.chunk, values, failures)?;
        self.put(claim.chunk, &content, claim.temporary())?;
        claim.fulfilled();
        Ok(())
    }

    /// Writes a chunk that was encoded elsewhere by [`SweepLayout::encode`]; one that is done stays.
    ///
    /// # Errors
    /// [`StoreError::DamagedChunk`], [`StoreError::ForeignChunk`] where these bytes are not that chunk, or what lies there is one of another case;
    /// failures of the file system.
    pub fn write_encoded(&self, chunk: usize, content: &[u8]) -> Result<(), StoreError> {
        self.decoded(chunk, content)?;
        match self.state(chunk)? {
            ChunkState::Done { .. } => Ok(()),
            ChunkState::Foreign { hash } => Err(self.foreign(self.path(chunk)?, hash)),
            ChunkState::Missing | ChunkState::Damaged(_) => self.put(chunk, content, None),
        }
    }

    /// Reads a chunk.
    ///
    /// # Errors
    /// [`StoreError::NoSuchChunk`], [`StoreError::MissingChunk`], [`StoreError::DamagedChunk`], [`StoreError::ForeignChunk`], failures of the file
    /// system.
    pub fn read(&self, chunk: usize) -> Result<StoredChunk, StoreError> {
        let path = self.path(chunk)?;
        match fs::read(&path) {
            Ok(content) => self.decoded(chunk, &content),
            Err(source) if source.kind() == ErrorKind::NotFound => Err(StoreError::MissingChunk { path }),
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
    fn path(&self, chunk: usize) -> Result<PathBuf, StoreError> {
        Ok(self.chunks.join(self.layout.file_name(chunk)?))
    }

    fn foreign(&self, path: PathBuf, found: String) -> StoreError {
        StoreError::ForeignChunk { path, expected: self.layout.hash().to_owned(), found }
    }

    /// The record of a chunk, where it is found.
    fn sound(&self, chunk: usize, found: Found) -> Result<Record, StoreError> {
        let path = self.path(chunk)?;
        match found {
            Found::Whole(record) => Ok(record),
            Found::Damaged(damage) => Err(StoreError::DamagedChunk { path, damage }),
            Found::Foreign(hash) => Err(self.foreign(path, hash)),
        }
    }

    /// What the content of the file of a chunk says.
    fn decoded(&self, chunk: usize, content: &[u8]) -> Result<StoredChunk, StoreError> {
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
        let read = || -> io::Result<Found> {
            let mut file = File::open(&path)?;
            let size = file.metadata()?.len();
            let before = size.saturating_sub(TRAILER_BYTES as u64);
            let trailer = read_from(&mut file, before)?;
            let length = record::length(&trailer).filter(|length| *length as u64 <= before);
            let Some(length) = length else { return Ok(Found::Damaged(ChunkDamage::NoRecord)) };
            let shard = before - length as u64;
            let end = read_from(&mut file, shard)?;
            Ok(record::read(&self.layout, chunk, points, &end, shard))
        };
        let found = read().map_err(|source| StoreError::read(&path, source))?;
        self.sound(chunk, found)
    }

    /// Puts a chunk in its place: written elsewhere on the same disk, forced there, renamed.
    fn put(&self, chunk: usize, content: &[u8], temporary: Option<PathBuf>) -> Result<(), StoreError> {
        let path = self.path(chunk)?;
        let write = || -> io::Result<()> {
            let (mut file, staged) = match temporary {
                Some(place) => (File::create(&place)?, TempPath::try_from_path(place)?),
                None => tempfile::Builder::new()
                    .suffix(".partial")
                    .make_in(&self.claims, |place| File::create_new(place))?
                    .into_parts(),
            };
            file.write_all(content)?;
            file.sync_all()?;
            staged.persist(&path)?;
            staging::sync_folder(&self.chunks)
        };
        write().map_err(|source| StoreError::write(&path, content.len() as u64, source))
    }
}

/// The rest of a file.
fn read_from(file: &mut File, start: u64) -> io::Result<Vec<u8>> {
    let mut rest = Vec::new();
    file.seek(SeekFrom::Start(start))?;
    file.read_to_end(&mut rest)?;
    Ok(rest)
}
