//! Chunks claimed, computed, written: by as many threads and processes as there are.

use super::evaluate::{ChunkStop, Evaluator};
use super::plan::SweepPlan;
use super::shard::Shard;
use super::waiting::Waiting;
use crate::error::StudyError;
use crate::progress::{Progress, announced};
use judder_memory::Crowded;
use judder_numerics::parallel;
use judder_store::{ClaimAnswer, StoreError, SweepChunks, SweepStore};
use rayon::prelude::*;
use std::process;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Takes process numbers that follow each other far apart.
const SPREAD: u64 = 0x9E37_79B1;

/// Computes the chunks of a part that are not there yet, and waits for those that other processes compute meanwhile. Gives back how many were computed
/// at once at last, where the memory of the process was not enough for as many as there are threads.
///
/// # Errors
/// [`StudyError::Interrupted`]: what is written until then stays. Failures of the file system, a chunk of another case.
pub(crate) fn work(
    plan: &SweepPlan,
    store: &SweepStore,
    shard: Shard,
    progress: &dyn Progress,
) -> Result<Option<u64>, StudyError> {
    let done = store.done_chunks()?;
    let mut missing: Vec<usize> =
        (0..done.len()).filter(|chunk| shard.takes(*chunk) && !done[*chunk]).collect();
    // processes that begin together do not all ask for the same chunks
    let first = u64::from(process::id()) * SPREAD % missing.len().max(1) as u64;
    missing.rotate_left(first as usize);
    compute(plan, store, missing, true, progress)
}

/// Computes the chunks of a part anew that are there and cannot be read; gives back how many they are. All chunks of the part are read.
///
/// # Errors
/// As of [`work`].
pub(crate) fn mend(
    plan: &SweepPlan,
    store: &SweepStore,
    shard: Shard,
    progress: &dyn Progress,
) -> Result<usize, StudyError> {
    let damaged = damaged(store, shard, progress)?;
    let count = damaged.len();
    compute_anew(plan, store, damaged, progress)?;
    Ok(count)
}

/// Computes these chunks anew, which are damaged.
///
/// # Errors
/// As of [`work`].
pub(crate) fn compute_anew(
    plan: &SweepPlan,
    store: &SweepStore,
    damaged: Vec<usize>,
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    compute(plan, store, damaged, false, progress).map(drop)
}

/// Computes these chunks, but for those that others have done meanwhile; where none of them was there, a chunk that is there now is not opened.
/// Gives back how many were computed at once at last, where the memory of the process was not enough for as many as there are threads.
fn compute(
    plan: &SweepPlan,
    store: &SweepStore,
    left: Vec<usize>,
    were_missing: bool,
    progress: &dyn Progress,
) -> Result<Option<u64>, StudyError> {
    if left.is_empty() {
        return Ok(None);
    }
    let name = plan.layout().name();
    let make = || Evaluator::new(plan, progress);
    let evaluator = announced(progress, &format!("preparing the points of {name}"), make)?;
    progress.begin(name, left.len());
    let work = ChunkWork { evaluator: &evaluator, store, were_missing, progress };
    let worked = work.rounds(left);
    progress.end();
    worked
}

/// What chunks are computed with.
struct ChunkWork<'a> {
    evaluator: &'a Evaluator<'a>,
    store: &'a SweepStore,
    were_missing: bool,
    progress: &'a dyn Progress,
}

/// What became of a chunk in a round.
enum ChunkFate {
    /// It is there.
    Done,
    /// Another is computing it.
    Busy,
    /// It needs more memory than its part.
    Crowded(Crowded),
}

impl ChunkWork<'_> {
    /// Goes over these chunks until others are computing none of them, as long as they show a sign of life; those that need more memory than a part of
    /// what the process may take are computed again with fewer at once.
    fn rounds(&self, mut left: Vec<usize>) -> Result<Option<u64>, StudyError> {
        let mut waiting = Waiting::new(self.progress);
        let (mut at_once, mut fewer) = (parallel::threads() as u64, None);
        loop {
            let fates = self.round(&left, at_once)?;
            // fewer each time, down to one, which nothing is put off for
            let fit = fates.iter().filter_map(|fate| match fate {
                ChunkFate::Crowded(crowded) => Some(crowded.at_once),
                _ => None,
            });
            let crowded = fit.max();
            let undone = left.iter().zip(&fates).filter(|(_, fate)| !matches!(fate, ChunkFate::Done));
            left = undone.map(|(chunk, _)| *chunk).collect();
            let Some(first) = left.first() else { return Ok(fewer) };
            match crowded {
                Some(fit) => (at_once, fewer) = (fit, Some(fit)),
                None => waiting.pause(self.store.claim_sign(*first))?,
            }
        }
    }

    /// Goes over these chunks once, so many at a time; says what became of each.
    fn round(&self, chunks: &[usize], at_once: u64) -> Result<Vec<ChunkFate>, StudyError> {
        let workers = chunks.len().min(at_once as usize);
        let next = AtomicUsize::new(0);
        // a worker is done with a chunk before it takes the next: however work within chunks is spread, no more of them are in memory than there are workers
        let fates = parallel::try_each_place(workers, |_| {
            let mut own = Vec::new();
            while let Some((place, chunk)) = take(&next, chunks) {
                let fate = self.one(chunk, workers as u64);
                if fate.is_err() {
                    // the others begin no more
                    next.store(chunks.len(), Ordering::Relaxed);
                }
                own.push((place, fate?));
            }
            Ok::<_, StudyError>(own)
        })?;
        let mut fates: Vec<(usize, ChunkFate)> = fates.into_iter().flatten().collect();
        fates.sort_unstable_by_key(|(place, _)| *place);
        Ok(fates.into_iter().map(|(_, fate)| fate).collect())
    }

    /// Computes a chunk, if nobody else does.
    fn one(&self, chunk: usize, at_once: u64) -> Result<ChunkFate, StudyError> {
        self.progress.go_on()?;
        // many others may have been here since the list was made
        if self.were_missing && self.store.has(chunk)? {
            self.progress.advance();
            return Ok(ChunkFate::Done);
        }
        match self.store.claim(chunk)? {
            ClaimAnswer::Busy => return Ok(ChunkFate::Busy),
            ClaimAnswer::Done => {}
            ClaimAnswer::Claimed(claim) => match self.evaluator.chunk_among(at_once, chunk, self.progress) {
                Ok(content) => self.store.write(claim, &content.values, &content.failures)?,
                Err(ChunkStop::Crowded(crowded)) => return Ok(ChunkFate::Crowded(crowded)),
                Err(ChunkStop::Failed(error)) => return Err(error),
            },
        }
        self.progress.advance();
        Ok(ChunkFate::Done)
    }
}

/// The next of the chunks, with its place among them.
fn take(next: &AtomicUsize, chunks: &[usize]) -> Option<(usize, usize)> {
    let place = next.fetch_add(1, Ordering::Relaxed);
    chunks.get(place).map(|chunk| (place, *chunk))
}

/// The chunks of a part that are there and cannot be read.
///
/// # Errors
/// A chunk of another case, failures of the file system, [`StudyError::Interrupted`].
pub(crate) fn damaged(
    store: &SweepChunks,
    shard: Shard,
    progress: &dyn Progress,
) -> Result<Vec<usize>, StudyError> {
    let done = store.done_chunks()?;
    let mine: Vec<usize> = (0..done.len()).filter(|chunk| done[*chunk] && shard.takes(*chunk)).collect();
    let looked: Result<Vec<Option<usize>>, StudyError> = mine
        .par_iter()
        .map(|chunk| {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            match store.read(*chunk) {
                Ok(_) | Err(StoreError::MissingChunk { .. }) => Ok(None),
                Err(StoreError::DamagedChunk { .. }) => Ok(Some(*chunk)),
                Err(error) => Err(error.into()),
            }
        })
        .collect();
    Ok(looked?.into_iter().flatten().collect())
}
