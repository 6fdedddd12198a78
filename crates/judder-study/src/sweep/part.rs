//! Chunks and points for whoever hands them out to machines of his own.

use super::chunks::damaged;
use super::evaluate::Evaluator;
use super::plan::{StoredColumn, SweepPlan};
use super::shard::Shard;
use super::waiting::when_free;
use crate::error::StudyError;
use crate::progress::Progress;
use judder_store::{ClaimAnswer, SharedStudy, SweepChunks};
use std::path::Path;

/// What became of chunks that were handed out.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Handed {
    /// Those that are in the folder now.
    pub done: Vec<usize>,
    /// Those that another process is computing.
    pub busy: Vec<usize>,
}

/// The study of a folder, shared with others, as soon as nobody holds it alone.
///
/// # Errors
/// Failures of the file system, [`StudyError::NoSignOfLife`], [`StudyError::Interrupted`].
pub fn joined(folder: &Path, progress: &dyn Progress) -> Result<SharedStudy, StudyError> {
    when_free(folder, progress, || SharedStudy::join(folder))
}

/// The chunks of a sweep that a study folder lacks, and those in it that cannot be read; writes nothing. All that is there is read and compared
/// with its checksums.
///
/// # Errors
/// A sweep or a chunk of another case, failures of the file system, [`StudyError::Interrupted`].
pub fn missing(plan: &SweepPlan, folder: &Path, progress: &dyn Progress) -> Result<Vec<usize>, StudyError> {
    let layout = plan.layout();
    let Some(chunks) = SweepChunks::look(folder, layout)? else {
        return Ok((0..layout.chunk_count()).collect());
    };
    let damaged = damaged(&chunks, Shard::WHOLE, progress)?;
    let done = chunks.done_chunks()?;
    Ok((0..done.len()).filter(|chunk| !done[*chunk] || damaged.binary_search(chunk).is_ok()).collect())
}

impl Evaluator<'_> {
    /// Computes chunks into a study folder that other processes work on, too, one after the other on this thread.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`]: what is written until then stays. Failures of the file system, a chunk of another case.
    pub fn chunks_into(
        &self,
        folder: &Path,
        chunks: &[usize],
        progress: &dyn Progress,
    ) -> Result<Handed, StudyError> {
        let store = joined(folder, progress)?.sweep(self.plan.layout())?;
        let mut handed = Handed::default();
        for chunk in chunks {
            match store.claim(*chunk)? {
                ClaimAnswer::Busy => {
                    handed.busy.push(*chunk);
                    continue;
                }
                ClaimAnswer::Done => {}
                ClaimAnswer::Claimed(claim) => {
                    let content = self.chunk(*chunk, progress)?;
                    store.write(claim, &content.values, &content.failures)?;
                }
            }
            handed.done.push(*chunk);
        }
        Ok(handed)
    }

    /// Computes one point of a chunk: its columns, and why something of it is missing or doubtful.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`], a chunk that is not there.
    pub fn point_of(
        &self,
        chunk: usize,
        index: usize,
        progress: &dyn Progress,
    ) -> Result<(Vec<f64>, Option<String>), StudyError> {
        let mut row = vec![f64::NAN; self.plan.columns.len()];
        let reason = self.point(&self.plan.layout().points(chunk)?.position(index), &mut row, progress)?;
        Ok((row, reason))
    }
}

impl SweepPlan {
    /// The columns of a point of a chunk that nobody could compute.
    ///
    /// # Errors
    /// A chunk that is not there.
    pub fn point_without_values(&self, chunk: usize, index: usize) -> Result<Vec<f64>, StudyError> {
        let at = self.values_at(&self.layout().points(chunk)?.position(index));
        let of = |column: &StoredColumn| match column {
            StoredColumn::Key(k) => at[*k],
            _ => f64::NAN,
        };
        Ok(self.columns.iter().map(of).collect())
    }
}
