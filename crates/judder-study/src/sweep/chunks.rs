//! Chunks claimed, computed, written: by as many threads and processes as there are.

use super::evaluate::Evaluator;
use super::plan::SweepPlan;
use super::shard::Shard;
use super::waiting::Waiting;
use crate::error::StudyError;
use crate::progress::{Progress, announced};
use judder_store::{ClaimAnswer, StoreError, SweepChunks, SweepStore};
use rayon::prelude::*;
use std::process;

/// Takes process numbers that follow each other far apart.
const SPREAD: u64 = 0x9E37_79B1;

/// Computes the chunks of a part that are not there yet, and waits for those that other processes compute meanwhile.
///
/// # Errors
/// [`StudyError::Interrupted`]: what is written until then stays. Failures of the file system, a chunk of another case.
pub(crate) fn work(
    plan: &SweepPlan,
    store: &SweepStore,
    shard: Shard,
    progress: &dyn Progress,
) -> Result<(), StudyError> {
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
    compute(plan, store, damaged, false, progress)
}

/// Computes these chunks, but for those that others have done meanwhile; where none of them was there, a chunk that is there now is not opened.
fn compute(
    plan: &SweepPlan,
    store: &SweepStore,
    left: Vec<usize>,
    were_missing: bool,
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    if left.is_empty() {
        return Ok(());
    }
    let name = plan.layout().name();
    let make = || Evaluator::new(plan, progress);
    let evaluator = announced(progress, &format!("preparing the points of {name}"), make)?;
    progress.begin(name, left.len());
    let worked = rounds(&evaluator, store, left, were_missing, progress);
    progress.end();
    worked
}

/// Goes over these chunks until others are computing none of them, as long as they show a sign of life.
fn rounds(
    evaluator: &Evaluator<'_>,
    store: &SweepStore,
    mut left: Vec<usize>,
    were_missing: bool,
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    let mut waiting = Waiting::new(progress);
    loop {
        left = round(evaluator, store, &left, were_missing, progress)?;
        let Some(first) = left.first() else { return Ok(()) };
        waiting.pause(store.claim_sign(*first))?;
    }
}

/// Goes over these chunks once; gives back those that others are computing.
fn round(
    evaluator: &Evaluator<'_>,
    store: &SweepStore,
    chunks: &[usize],
    were_missing: bool,
    progress: &dyn Progress,
) -> Result<Vec<usize>, StudyError> {
    let busy: Result<Vec<Option<usize>>, StudyError> = chunks
        .par_iter()
        .with_max_len(1)
        .map(|chunk| {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            // many others may have been here since the list was made
            if were_missing && store.has(*chunk)? {
                progress.advance();
                return Ok(None);
            }
            match store.claim(*chunk)? {
                ClaimAnswer::Busy => return Ok(Some(*chunk)),
                ClaimAnswer::Done => {}
                ClaimAnswer::Claimed(claim) => {
                    let content = evaluator.chunk(*chunk, progress)?;
                    store.write(claim, &content.values, &content.failures)?;
                }
            }
            progress.advance();
            Ok(None)
        })
        .collect();
    Ok(busy?.into_iter().flatten().collect())
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
