//! Chunks claimed, computed, written: by as many threads and processes as there are.

use super::evaluate::Evaluator;
use super::plan::SweepPlan;
use super::shard::Shard;
use crate::error::StudyError;
use crate::progress::Progress;
use judder_store::{ChunkState, ClaimAnswer, SweepStore};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

/// How long to wait before looking again whether another process has written its chunks.
const PAUSE: Duration = Duration::from_millis(50);

/// What became of a part of the chunks.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Worked {
    /// Chunks that this process has computed.
    pub(crate) computed: usize,
    /// Chunks that were damaged and are computed anew.
    pub(crate) damaged: usize,
}

/// Computes the chunks of a part that are not there yet, and waits for those that other processes compute meanwhile.
///
/// # Errors
/// [`StudyError::Interrupted`]: what is written until then stays. Failures of the file system, a chunk of another case.
pub(crate) fn work(
    (plan, store): (&SweepPlan, &SweepStore),
    shard: Shard,
    progress: &dyn Progress,
) -> Result<Worked, StudyError> {
    let damaged = damaged(store, shard, progress)?;
    let missing = |done: &[bool]| -> Vec<usize> {
        let is_missing = |chunk: &usize| shard.takes(*chunk) && (!done[*chunk] || damaged.contains(chunk));
        (0..done.len()).filter(is_missing).collect()
    };
    let mut left = missing(&store.done_chunks()?);
    let computed = AtomicUsize::new(0);
    if !left.is_empty() {
        let evaluator = Evaluator::new(plan, progress)?;
        progress.begin(plan.layout().name(), left.len());
        let worked = loop {
            let busy = match round(&evaluator, store, (&left, &computed), progress) {
                Ok(busy) => busy,
                Err(error) => break Err(error),
            };
            if busy.is_empty() {
                break Ok(());
            }
            left = busy;
            thread::sleep(PAUSE);
        };
        progress.end();
        worked?;
    }
    Ok(Worked { computed: computed.into_inner(), damaged: damaged.len() })
}

/// Goes over these chunks once; gives back those that others are computing.
fn round(
    evaluator: &Evaluator<'_>,
    store: &SweepStore,
    (chunks, computed): (&[usize], &AtomicUsize),
    progress: &dyn Progress,
) -> Result<Vec<usize>, StudyError> {
    let busy: Result<Vec<Option<usize>>, StudyError> = chunks
        .par_iter()
        .with_max_len(1)
        .map(|chunk| {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            match store.claim(*chunk)? {
                ClaimAnswer::Busy => return Ok(Some(*chunk)),
                ClaimAnswer::Done => {}
                ClaimAnswer::Claimed(claim) => {
                    let content = evaluator.chunk(*chunk, progress)?;
                    store.write(claim, &content.values, &content.failures)?;
                    computed.fetch_add(1, Ordering::Relaxed);
                }
            }
            progress.advance();
            Ok(None)
        })
        .collect();
    Ok(busy?.into_iter().flatten().collect())
}

/// The chunks of a part that are there and cannot be read; a claim grants them again.
pub(super) fn damaged(
    store: &SweepStore,
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
            Ok(matches!(store.state(*chunk)?, ChunkState::Damaged(_)).then_some(*chunk))
        })
        .collect();
    Ok(looked?.into_iter().flatten().collect())
}
