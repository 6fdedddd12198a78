//! The chunks of a sweep on the disk.

use std::fs;
use std::io::{self, ErrorKind};
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use judder_disk::StagedFile;

use super::chunks::{ChunkState, SweepChunks};
use super::claim::{self, ChunkClaim, ClaimAnswer};
use super::group;
use super::layout::SweepLayout;
use super::record::PointFailure;
use crate::lock::Lock;
use crate::lock_sign::LockSign;
use crate::{StoreError, WriteUnderWay};

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
    chunks: SweepChunks,
    /// The folder of claims, and of chunks that are being written.
    claims: PathBuf,
    /// Keeps out those who want the study alone.
    _study: Arc<Lock>,
}

impl SweepStore {
    pub(crate) fn join(study: &Path, lock: &Arc<Lock>, layout: &SweepLayout) -> Result<Self, StoreError> {
        let chunks = SweepChunks::new(layout, group::join(study, layout)?);
        let claims = study.join(format!("{}{}", claim::PREFIX, layout.name()));
        judder_disk::create_folders(&claims).map_err(|source| StoreError::write(&claims, 0, source))?;
        Ok(Self { chunks, claims, _study: Arc::clone(lock) })
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
        Ok(ClaimAnswer::Claimed(claim))
    }

    /// What is known of who is computing a chunk.
    #[must_use]
    pub fn claim_sign(&self, chunk: usize) -> LockSign {
        ChunkClaim::sign(&self.claims, chunk)
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
        let content = self.layout().encode(claim.chunk(), values, failures)?;
        self.put(claim.chunk(), &content)?;
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
            ChunkState::Missing | ChunkState::Damaged(_) => self.put(chunk, content),
        }
    }

    /// Puts a chunk in its place: written elsewhere on the same disk, forced there, renamed.
    fn put(&self, chunk: usize, content: &[u8]) -> Result<(), StoreError> {
        let path = self.path(chunk)?;
        let _write = WriteUnderWay::begin();
        let write = || -> io::Result<()> {
            // a name of its own, should locks keep nobody out
            let staged = StagedFile::new(&self.claims, &format!("{chunk}."), ".partial")?;
            staged.write_and_sync(content)?;
            // a folder is no chunk, and no file takes the place of one
            if fs::symlink_metadata(&path).is_ok_and(|there| there.is_dir()) {
                judder_disk::remove(&path)?;
            }
            staged.take_place(&path)?;
            judder_disk::sync_folder(&self.folder)
        };
        let written = match write() {
            // somebody who believed to be alone has cleared the folder of claims
            Err(source) if source.kind() == ErrorKind::NotFound => {
                judder_disk::create_folders(&self.claims).and_then(|()| write())
            }
            written => written,
        };
        written.map_err(|source| StoreError::write(&path, content.len() as u64, source))
    }
}

impl Deref for SweepStore {
    type Target = SweepChunks;

    fn deref(&self) -> &SweepChunks {
        &self.chunks
    }
}
