//! The right to compute one chunk.

use std::path::{Path, PathBuf};

use crate::StoreError;
use crate::lock::{self, Lock, LockMode};
use crate::lock_sign::LockSign;

/// How the names of the folders begin in which the claims of a sweep lie, and chunks that are being written.
pub(crate) const PREFIX: &str = ".sweep-";

/// The right to compute one chunk of a sweep, which no other process and no other thread has meanwhile. It ends when dropped, and with the
/// process however it ends.
#[derive(Debug)]
pub struct ChunkClaim {
    chunk: usize,
    file: PathBuf,
    _lock: Lock,
}

/// The answer to a claim.
#[derive(Debug)]
pub enum ClaimAnswer {
    /// The chunk is to be computed, by the holder of this.
    Claimed(ChunkClaim),
    /// Another is computing it.
    Busy,
    /// It is done.
    Done,
}

impl ChunkClaim {
    /// Locks the file of a claim; `None` while another holds it.
    ///
    /// The file stays when a claim ends without a chunk: whoever opened it before could else lock a file that is gone, beside one who makes it
    /// anew.
    pub(super) fn take(claims: &Path, chunk: usize) -> Result<Option<Self>, StoreError> {
        let file = Self::file(claims, chunk);
        let lock = lock::try_lock(&file, LockMode::Alone)?;
        Ok(lock.map(|lock| Self { chunk, file, _lock: lock }))
    }

    /// What is known of who has claimed a chunk.
    pub(super) fn sign(claims: &Path, chunk: usize) -> LockSign {
        LockSign::of(Self::file(claims, chunk))
    }

    fn file(claims: &Path, chunk: usize) -> PathBuf {
        claims.join(format!("{chunk}.claim"))
    }

    /// The chunk.
    #[must_use]
    pub fn chunk(&self) -> usize {
        self.chunk
    }

    /// Ends the claim of a chunk that is done.
    pub(super) fn fulfilled(self) {
        // A file that stays is removed when the study is taken alone; nothing depends on it.
        let _ = judder_disk::remove_file(&self.file);
    }
}
