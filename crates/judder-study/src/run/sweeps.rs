//! The sweeps of a case: chunks by as many processes as there are, then what they say together.

use super::asked::AskedCase;
use super::{Computed, ForgottenResults, RunOptions, RunReport, SweepWork, compute_in, taken};
use crate::error::StudyError;
use crate::ledger::Study;
use crate::model::Prepared;
use crate::progress::{Progress, announced};
use crate::sweep::{
    ReadChunks, Shard, SweepPlan, SweepReading, compute_anew, joined, mend, read, when_free, work,
};
use judder_store::{SharedStudy, SoundFiles, StoreError, StudyFolder, Summary, SweepChunks, SweepStore};
use serde_json::{Value, json};
use std::mem;
use std::path::Path;
use std::time::Instant;

/// A sweep of which others may compute parts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PartedSweep {
    /// Its name.
    pub name: String,
    /// Chunks of all parts.
    pub chunks: usize,
    /// Those that are there.
    pub done: usize,
}

impl PartedSweep {
    /// What it lacks; nothing where all chunks are there.
    #[must_use]
    pub fn lacking(&self) -> Option<String> {
        let Self { name, chunks, done } = self;
        let missing = chunks.saturating_sub(*done);
        (missing > 0).then(|| format!("{name}: {missing} of {chunks} chunks are missing"))
    }

    /// For `--json`; under the same names as in an estimate.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({ "name": self.name, "chunks": self.chunks, "chunks_done": self.done })
    }
}

/// What became of results that were there before a run.
struct Earlier {
    done: Vec<String>,
    forgotten: ForgottenResults,
    damages: Vec<String>,
    /// What was read of them and is sound.
    sound: SoundFiles,
}

/// Runs analyses and sweeps. Analyses are run by whoever holds the study alone: at first where nobody else is there, else at the end.
pub(super) fn run(
    asked: &AskedCase<'_>,
    prepared: &Prepared,
    plans: &[SweepPlan],
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<RunReport, StudyError> {
    let start = Instant::now();
    let mut notes = mended_frames(plans, folder, options)?;
    let earlier = begun(asked, prepared, plans, folder, options, progress)?;
    let shared = joined(folder, progress)?;
    let mut parted = Vec::new();
    for plan in plans {
        let (note, sweep) = worked(&shared, plan, options.sweeps, progress)?;
        notes.extend(note);
        parted.push(sweep);
    }
    let is_part = matches!(options.sweeps, SweepWork::Part(_));
    let mut lacking: Vec<String> =
        if is_part { Vec::new() } else { parted.iter().filter_map(PartedSweep::lacking).collect() };
    let (store, waited) = match shared.leave()? {
        Some(store) => (store, false),
        // whose chunks are all there others may be completing
        None if lacking.is_empty() && !is_part => (alone(folder, progress)?, true),
        None => return Ok(unfinished(folder, parted, lacking, notes)),
    };
    let is_completed = waited && is_done(&store, plans)?;
    let mut sweeps: Vec<(&SweepPlan, Option<SweepReading<'_>>)> = Vec::new();
    if lacking.is_empty() && !is_part && !is_completed {
        for plan in plans {
            let looked = looked_through(&store, plan, options.sweeps, earlier.is_some(), progress)?;
            notes.extend(looked.note);
            lacking.extend(looked.lacking);
            // all values for sensitivity are in memory for one sweep at a time
            let is_kept = plans.len() == 1 || plan.sweep().sensitivity.is_none();
            sweeps.push((plan, looked.reading.filter(|_| is_kept)));
        }
    } else {
        sweeps.extend(plans.iter().map(|plan| (plan, None)));
    }
    if is_part || !lacking.is_empty() {
        return Ok(unfinished(folder, parted, lacking, notes));
    }
    if let Some(earlier) = &earlier {
        store.trust(earlier.sound.clone());
    }
    let analyses = options.sweeps == SweepWork::All;
    let mut computed = compute_in(store, asked, prepared, sweeps, analyses, progress, start)?;
    // what this run did before it shared the study was not done before it, and what it forgot is gone
    if let Some(Earlier { done: mut names, forgotten, damages, .. }) = earlier {
        let of_sweeps = |name: &String| plans.iter().any(|plan| plan.layout().name() == name);
        names.extend(computed.skipped.into_iter().filter(of_sweeps));
        computed.skipped = names;
        computed.forgotten = forgotten;
        computed.damages.extend(damages);
    }
    computed.reported(asked.file.registry(), options, notes, progress)
}

/// Writes coordinates and metadata of damaged sweeps anew, where nobody else is at work; says of which.
fn mended_frames(
    plans: &[SweepPlan],
    folder: &Path,
    options: &RunOptions,
) -> Result<Vec<String>, StudyError> {
    let store = match StudyFolder::open(folder) {
        Ok(store) if !options.fresh => store,
        Ok(_)
        | Err(StoreError::NoStudy { .. } | StoreError::NotAFolder { .. } | StoreError::Locked { .. }) => {
            return Ok(Vec::new());
        }
        Err(error) => return Err(error.into()),
    };
    let mut notes = Vec::new();
    for plan in plans {
        if store.mend_sweep(plan.layout())? {
            let name = plan.layout().name();
            notes.push(format!("{name}: coordinates or metadata were damaged and are written anew"));
        }
    }
    Ok(notes)
}

/// Runs the analyses where nobody else is at work; gives back what became of earlier results.
fn begun(
    asked: &AskedCase<'_>,
    prepared: &Prepared,
    plans: &[SweepPlan],
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<Option<Earlier>, StudyError> {
    if !options.fresh {
        // nothing is rewritten for a case whose sweeps are refused
        for plan in plans {
            SweepChunks::look(folder, plan.layout())?;
        }
    }
    if options.sweeps == SweepWork::Merge {
        return match StudyFolder::open(folder) {
            Ok(_) | Err(StoreError::Locked { .. }) => Ok(None),
            Err(error) => Err(error.into()),
        };
    }
    match taken(folder, options.fresh) {
        Ok(store) if options.sweeps == SweepWork::All => {
            let computed = compute_in(store, asked, prepared, Vec::new(), true, progress, Instant::now())?;
            let Computed { store, skipped: done, forgotten, damages, .. } = computed;
            Ok(Some(Earlier { done, forgotten, damages, sound: store.sound_files() }))
        }
        Ok(_) => Ok(None),
        Err(StudyError::Store(StoreError::Locked { .. })) if !options.fresh => Ok(None),
        Err(error) => Err(error),
    }
}

/// The study held alone, as soon as the others have left it.
fn alone(folder: &Path, progress: &dyn Progress) -> Result<StudyFolder, StudyError> {
    when_free(folder, progress, || StudyFolder::create(folder))
}

/// Whether somebody has completed all these sweeps.
fn is_done(store: &StudyFolder, plans: &[SweepPlan]) -> Result<bool, StudyError> {
    for plan in plans {
        if !store.is_done(plan.layout().name(), plan.layout().hash())? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// A report of a run that leaves the study to others.
fn unfinished(
    folder: &Path,
    parted: Vec<PartedSweep>,
    lacking: Vec<String>,
    notes: Vec<String>,
) -> RunReport {
    RunReport {
        folder: folder.to_owned(),
        summary: Summary::default(),
        parted,
        report: None,
        skipped: Vec::new(),
        forgotten: ForgottenResults::default(),
        complete: lacking.is_empty(),
        tables: Vec::new(),
        notes,
        messages: Vec::new(),
        lacking,
        undrawn: Vec::new(),
        refused: Vec::new(),
    }
}

/// Does what is asked of the chunks of a sweep; says what became of them, and how many are there.
fn worked(
    shared: &SharedStudy,
    plan: &SweepPlan,
    how: SweepWork,
    progress: &dyn Progress,
) -> Result<(Vec<String>, PartedSweep), StudyError> {
    let store = shared.sweep(plan.layout())?;
    let name = plan.layout().name();
    let mut notes = Vec::new();
    let shard = match how {
        SweepWork::All => Some(Shard::WHOLE),
        SweepWork::Part(shard) => Some(shard),
        SweepWork::Merge => None,
    };
    if let Some(shard) = shard
        && let Some(at_once) = work(plan, &store, shard, progress)?
    {
        notes.push(format!(
            "{name}: at last only {at_once} of its chunks were computed at once, as points of them needed the memory of others; --memory gives judder more"
        ));
    }
    if let SweepWork::Part(shard) = how {
        notes.extend(mended(plan, &store, shard, progress)?);
    }
    let done = store.done_chunks()?.into_iter().filter(|done| *done).count();
    let chunks = plan.layout().chunk_count();
    if let SweepWork::Part(shard) = how {
        notes.push(format!("{name}: part {shard} is done; {done} of {chunks} chunks are there"));
    }
    Ok((notes, PartedSweep { name: name.to_owned(), chunks, done }))
}

/// What became of looking at all chunks of a sweep.
struct LookedThrough<'a> {
    note: Option<String>,
    reading: Option<SweepReading<'a>>,
    /// What it lacks, where it is not to be computed.
    lacking: Option<String>,
}

/// Reads all chunks of a sweep that is not done in a study that is held alone; computes damaged ones anew, where anything is to be computed. Says what
/// was found, and what is not whole now. Where this run has compared the study with its list, what is done is not read again.
fn looked_through<'a>(
    study: &StudyFolder,
    plan: &'a SweepPlan,
    how: SweepWork,
    is_compared: bool,
    progress: &dyn Progress,
) -> Result<LookedThrough<'a>, StudyError> {
    let layout = plan.layout();
    let whole = LookedThrough { note: None, reading: None, lacking: None };
    if is_compared && study.is_done(layout.name(), layout.hash())? {
        return Ok(whole);
    }
    let Some(chunks) = SweepChunks::look(study.path(), layout)? else { return Ok(whole) };
    let damaged = match read(plan, &chunks, progress)? {
        ReadChunks::Whole(reading) => {
            return Ok(LookedThrough { reading: Some(reading), ..whole });
        }
        ReadChunks::Damaged(damaged, _) => damaged,
    };
    let (name, count) = (layout.name(), damaged.len());
    if how == SweepWork::Merge {
        return Ok(LookedThrough { lacking: Some(format!("{name}: {} damaged", of_chunks(count))), ..whole });
    }
    compute_anew(plan, &study.sweep(layout)?, damaged, progress)?;
    let reading = Some(read_whole(study, plan, progress)?);
    Ok(LookedThrough { note: Some(anew(name, count)), reading, ..whole })
}

/// Reads all chunks of a sweep.
fn read_whole<'a>(
    study: &StudyFolder,
    plan: &'a SweepPlan,
    progress: &dyn Progress,
) -> Result<SweepReading<'a>, StudyError> {
    let chunks = study.sweep(plan.layout())?;
    match read(plan, &chunks, progress)? {
        ReadChunks::Whole(reading) => Ok(reading),
        ReadChunks::Damaged(_, first) => Err(first.into()),
    }
}

/// Computes the damaged chunks of a part anew; says how many they were.
fn mended(
    plan: &SweepPlan,
    store: &SweepStore,
    shard: Shard,
    progress: &dyn Progress,
) -> Result<Option<String>, StudyError> {
    let count = mend(plan, store, shard, progress)?;
    Ok((count > 0).then(|| anew(plan.layout().name(), count)))
}

fn anew(name: &str, count: usize) -> String {
    let chunks =
        if count == 1 { "1 damaged chunk was".to_owned() } else { format!("{count} damaged chunks were") };
    format!("{name}: {chunks} computed anew")
}

fn of_chunks(count: usize) -> String {
    if count == 1 { "1 chunk is".to_owned() } else { format!("{count} chunks are") }
}

/// Keeps what a sweep says whose chunks are all there, and may have been read; gives its name back where that was kept before.
pub(super) fn finished(
    store: &StudyFolder,
    study: &mut Study<'_>,
    plan: &SweepPlan,
    reading: Option<SweepReading<'_>>,
    progress: &dyn Progress,
) -> Result<Option<String>, StudyError> {
    let layout = plan.layout();
    if store.is_done(layout.name(), layout.hash())? {
        return Ok(Some(layout.name().to_owned()));
    }
    let began = Instant::now();
    let mut reading = reading.map_or_else(|| read_whole(store, plan, progress), Ok)?;
    let files = mem::take(&mut reading.files);
    let what = format!("what the points of {} say together", layout.name());
    let outcome = announced(progress, &what, || reading.outcome(plan, progress));
    store.list_sweep(layout, files)?;
    study.keep(layout.name(), layout.hash().to_owned(), outcome, began.elapsed().as_secs_f64())?;
    store.consolidate()?;
    Ok(None)
}
