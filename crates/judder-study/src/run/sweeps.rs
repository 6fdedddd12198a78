//! The sweeps of a case: chunks by as many processes as there are, then what they say together.

use super::asked::Asked;
use super::{RunOptions, RunReport, SweepWork, compute_in, taken};
use crate::analyses::Prepared;
use crate::error::StudyError;
use crate::ledger::Study;
use crate::progress::Progress;
use crate::sweep::{Shard, SweepPlan, damaged, finish, joined, mend, work};
use judder_store::{SharedStudy, StoreError, StudyFolder, Summary, SweepChunks, SweepStore};
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

/// Runs analyses and sweeps. Analyses are run by whoever holds the study alone: at first where nobody else is there, else at the end.
pub(super) fn run(
    (asked, prepared, plans): (&Asked<'_>, &Prepared, &[SweepPlan]),
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<RunReport, StudyError> {
    if !options.fresh {
        // nothing is rewritten for a case whose sweeps are refused
        for plan in plans {
            SweepChunks::look(folder, plan.layout())?;
        }
    }
    let mut done_before = None;
    match taken(folder, options.fresh) {
        Ok(store) if options.sweeps == SweepWork::All => {
            done_before = Some(compute_in(store, (asked, prepared), (&[], true), progress)?.skipped);
        }
        Ok(_) => {}
        Err(StudyError::Store(StoreError::Locked { .. })) if !options.fresh => {}
        Err(error) => return Err(error),
    }
    let shared = joined(folder, progress)?;
    let mut notes = Vec::new();
    let mut is_whole = true;
    for plan in plans {
        let (note, whole) = worked(&shared, plan, options.sweeps, progress)?;
        notes.extend(note);
        is_whole &= whole;
    }
    let mut left = shared.leave()?;
    if is_whole && left.is_none() && !matches!(options.sweeps, SweepWork::Part(_)) {
        left = alone(folder, options.waits, progress)?;
    }
    if let (Some(store), true) = (&left, is_whole) {
        for plan in plans {
            let (note, whole) = looked_through(store, plan, options.sweeps, progress)?;
            notes.extend(note);
            is_whole &= whole;
        }
    }
    match (left, options.sweeps) {
        (Some(store), SweepWork::All | SweepWork::Merge) if is_whole => {
            let analyses = options.sweeps == SweepWork::All;
            let mut computed = compute_in(store, (asked, prepared), (plans, analyses), progress)?;
            // what this run did before it shared the study was not done before it
            if let Some(mut names) = done_before {
                let of_sweeps = |name: &String| plans.iter().any(|plan| plan.layout().name() == name);
                names.extend(computed.skipped.into_iter().filter(of_sweeps));
                computed.skipped = names;
            }
            computed.reported(notes)
        }
        (left, how) => {
            let is_part = matches!(how, SweepWork::Part(_));
            if left.is_none() && !is_part {
                notes.push(
                    "other processes hold this study: `judder merge` writes summary and report when they have ended"
                        .to_owned(),
                );
            }
            let summary =
                left.as_ref().map(StudyFolder::read_summary).transpose()?.flatten().unwrap_or_default();
            Ok(unfinished(folder, summary, (is_part, notes)))
        }
    }
}

/// How long to wait before asking again for a study that others hold.
const PAUSE: Duration = Duration::from_millis(50);
/// How often to ask for a study that others share, when all chunks are there: for some seconds, since they are about to see it too.
const ASKED: usize = 200;

/// The study held alone, if the others leave it soon; however late where that is wanted.
fn alone(folder: &Path, waits: bool, progress: &dyn Progress) -> Result<Option<StudyFolder>, StudyError> {
    let mut asked = 0;
    while waits || asked < ASKED {
        asked += 1;
        match StudyFolder::create(folder) {
            Err(StoreError::Locked { .. }) if progress.interrupted() => return Err(StudyError::Interrupted),
            Err(StoreError::Locked { .. }) => thread::sleep(PAUSE),
            taken => return Ok(Some(taken?)),
        }
    }
    Ok(None)
}

/// A report of a run that leaves the study to others.
fn unfinished(folder: &Path, summary: Summary, (complete, notes): (bool, Vec<String>)) -> RunReport {
    RunReport {
        folder: folder.to_owned(),
        summary,
        report: None,
        skipped: Vec::new(),
        complete,
        tables: Vec::new(),
        notes,
        messages: Vec::new(),
        refused: Vec::new(),
    }
}

/// Does what is asked of the chunks of a sweep; says what became of them, and whether all are there.
fn worked(
    shared: &SharedStudy,
    plan: &SweepPlan,
    how: SweepWork,
    progress: &dyn Progress,
) -> Result<(Vec<String>, bool), StudyError> {
    let store = shared.sweep(plan.layout())?;
    let name = plan.layout().name();
    let mut notes = Vec::new();
    let shard = match how {
        SweepWork::All => Some(Shard::WHOLE),
        SweepWork::Part(shard) => Some(shard),
        SweepWork::Merge => None,
    };
    if let Some(shard) = shard {
        work((plan, &store), shard, progress)?;
    }
    if let SweepWork::Part(shard) = how {
        notes.extend(mended((plan, &store), shard, progress)?);
    }
    let there = store.done_chunks()?.into_iter().filter(|done| *done).count();
    let all = plan.layout().chunk_count();
    match how {
        SweepWork::Part(shard) => {
            notes.push(format!("{name}: part {shard} is done; {there} of {all} chunks are there"));
        }
        SweepWork::Merge if there < all => {
            notes.push(format!(
                "{name}: {} of {all} chunks are missing; `judder run` computes them",
                all - there
            ));
        }
        SweepWork::All | SweepWork::Merge => {}
    }
    Ok((notes, there == all))
}

/// Reads all chunks of a sweep in a study that is held alone; computes damaged ones anew, where anything is to be computed. Says what was found,
/// and whether all are whole now.
fn looked_through(
    study: &StudyFolder,
    plan: &SweepPlan,
    how: SweepWork,
    progress: &dyn Progress,
) -> Result<(Option<String>, bool), StudyError> {
    let store = study.sweep(plan.layout())?;
    match how {
        SweepWork::Part(_) => Ok((None, true)),
        SweepWork::All => Ok((mended((plan, &store), Shard::WHOLE, progress)?, true)),
        SweepWork::Merge => {
            let count = damaged(&store, Shard::WHOLE, progress)?.len();
            let name = plan.layout().name();
            let note = (count > 0)
                .then(|| format!("{name}: {count} chunks are damaged; `judder run` computes them anew"));
            Ok((note, count == 0))
        }
    }
}

/// Computes the damaged chunks of a part anew; says how many they were.
fn mended(
    (plan, store): (&SweepPlan, &SweepStore),
    shard: Shard,
    progress: &dyn Progress,
) -> Result<Option<String>, StudyError> {
    let count = mend((plan, store), shard, progress)?;
    let name = plan.layout().name();
    Ok((count > 0).then(|| format!("{name}: {count} damaged chunks were computed anew")))
}

/// Keeps what a sweep says whose chunks are all there; gives its name back where that was kept before.
pub(super) fn finished(
    store: &StudyFolder,
    study: &mut Study<'_>,
    plan: &SweepPlan,
    progress: &dyn Progress,
) -> Result<Option<String>, StudyError> {
    let layout = plan.layout();
    if store.is_done(layout.name(), layout.hash())? {
        return Ok(Some(layout.name().to_owned()));
    }
    let began = Instant::now();
    let outcome = finish(plan, &store.sweep(layout)?, progress);
    study.keep(layout.name(), layout.hash().to_owned(), outcome, began.elapsed().as_secs_f64())?;
    store.consolidate()?;
    Ok(None)
}
