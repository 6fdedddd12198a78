//! The analyses and sweeps of a case into a study folder, or in memory.
//!
//! - `asked`: what is wanted, under which hash.
//! - `analyses`: its analyses, one at a time.
//! - `sweeps`: chunks, by as many processes as there are.
//! - `held`: its analyses in no folder, but in memory.

mod analyses;
mod asked;
mod held;
mod sweeps;

pub use asked::{analysis_hash, resolved_with_files};
pub use held::{HeldRun, HeldStudy, hold};
pub use sweeps::PartedSweep;

use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::ledger::{Keepsakes, Study, case_hash};
use crate::model::Prepared;
use crate::outcome::CheckRecord;
use crate::progress::{Progress, announced};
use crate::registry::Registry;
use crate::report::{self, WrittenPage};
use crate::sweep::{Shard, SweepEstimate, SweepPlan, SweepReading};
use crate::terminal_tables;
use crate::version::{maker, version};
use analyses::{AnalysisRunner, shared};
use asked::AskedCase;
use judder_store::{Status, StudyFolder, Summary};
use serde_json::Value;
use std::mem;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What of a case is to be run, and whether from nothing.
#[derive(Debug, Clone, Default)]
pub struct RunOptions {
    /// Only these analyses; all where empty.
    pub only: Vec<String>,
    /// Forget earlier results first.
    pub fresh: bool,
    /// What is done of the sweeps.
    pub sweeps: SweepWork,
    /// What the study keeps beside its results, by name: files of the case that no other place has.
    pub files: Vec<(String, Vec<u8>)>,
    /// Whether neither figures nor page are drawn.
    pub without_report: bool,
    /// Bytes of arrays that a run without a folder may hold; any number where none is given.
    pub most_held: Option<u64>,
}

/// What is done of the sweeps of a case.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum SweepWork {
    /// All chunks that are missing; then, as of the analyses, summary and report.
    #[default]
    All,
    /// A part of the chunks, and nothing else: one job of many.
    Part(Shard),
    /// No chunk, no analysis: summary and report of what is there.
    Merge,
}

/// What a run left.
#[derive(Debug)]
pub struct RunReport {
    /// The study folder.
    pub folder: PathBuf,
    /// The content of its `summary.json`; empty where the study is left to others.
    pub summary: Summary,
    /// The sweeps of a study that is left to others: a part was asked for, or chunks of a merge are missing or damaged.
    pub parted: Vec<PartedSweep>,
    /// Its `report.html`; none where other processes are still at work on the study, or a part or no report was asked for.
    pub report: Option<PathBuf>,
    /// Analyses that were done before.
    pub skipped: Vec<String>,
    /// Results that were there and are dropped.
    pub forgotten: ForgottenResults,
    /// Whether every requested result is there.
    pub complete: bool,
    /// Results that are worth a table on the terminal.
    pub tables: Vec<String>,
    /// What became of the sweeps, one line each.
    pub notes: Vec<String>,
    /// Warnings and failed checks, one line each; not why an analysis was refused.
    pub messages: Vec<String>,
    /// Requested results that are not whole, a line each: which, and why.
    pub lacking: Vec<String>,
    /// Figures that the report lacks, a line each, among the messages too.
    pub undrawn: Vec<String>,
    /// Analyses without a result because the input is wrong.
    pub refused: Vec<RefusedAnalysis>,
}

/// Results that were there and are dropped, by name.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ForgottenResults {
    /// Those of which what they depend on in the case has changed.
    pub changed: Vec<String>,
    /// Those that the case no longer has, finished or not; their files stay.
    pub gone: Vec<String>,
    /// Those of this case that another build had computed.
    pub of_other_build: Vec<String>,
    /// The version of that build.
    pub version: String,
}

impl ForgottenResults {
    /// What a study has dropped; of what is `left` nothing was told before.
    fn of(study: &Study<'_>, asked: &AskedCase<'_>, left: Vec<String>) -> Self {
        let version = study.computed_by.clone();
        let of_other_build = asked.computed_by(&version, &study.forgotten);
        let names = study.forgotten.iter().map(|(name, _)| name);
        let others = names.filter(|name| !of_other_build.contains(name)).cloned();
        let (changed, mut gone): (Vec<_>, Vec<_>) =
            others.partition(|name| asked.all().any(|(own, _)| own == name));
        gone.extend(left);
        Self { changed, gone, of_other_build, version }
    }

    /// A line for each reason why results are dropped.
    #[must_use]
    pub fn told(&self) -> Vec<String> {
        let (changed, built) = (self.changed.join(", "), self.of_other_build.join(", "));
        let mut lines = Vec::new();
        if !built.is_empty() {
            let (then, now) = (&self.version, version());
            lines.push(format!(
                "forgotten, since judder {then} computed them and this is judder {now}: {built}"
            ));
        }
        if !changed.is_empty() {
            lines.push(format!("forgotten, since what they depend on has changed: {changed}"));
        }
        if !self.gone.is_empty() {
            let gone = self.gone.join(", ");
            lines.push(format!(
                "forgotten, since the case no longer has them: {gone}; their files stay until `judder run --fresh`"
            ));
        }
        lines
    }
}

/// An analysis without a result because the input is wrong.
#[derive(Debug)]
pub struct RefusedAnalysis {
    /// Its name.
    pub name: String,
    /// What is wrong, and where.
    pub error: StudyError,
}

/// Runs the analyses and sweeps of a case that are not done yet, then draws figures and report.
///
/// # Errors
/// An unknown name in `only`, a folder that cannot be written, or [`StudyError::Interrupted`]; what was done until then is kept.
pub fn run(
    file: &CaseFile,
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<RunReport, StudyError> {
    let start = Instant::now();
    let (asked, prepared) = prepared(file, options, progress)?;
    let plans = asked.plans()?;
    if plans.is_empty() && matches!(options.sweeps, SweepWork::Part(_)) {
        let known = file.sweeps.iter().map(|sweep| sweep.name.clone()).collect();
        return Err(StudyError::NoParts { known });
    }
    if !plans.is_empty() {
        return sweeps::run(&asked, &prepared, &plans, folder, options, progress);
    }
    let store = taken(folder, options.fresh)?;
    let analyses = options.sweeps == SweepWork::All;
    let computed = compute_in(store, &asked, &prepared, Vec::new(), analyses, progress, start)?;
    computed.reported(file.registry(), options, Vec::new(), progress)
}

/// What is asked for, and what its analyses share.
fn prepared<'a>(
    file: &'a CaseFile,
    options: &'a RunOptions,
    progress: &dyn Progress,
) -> Result<(AskedCase<'a>, Prepared), StudyError> {
    let asked = announced(progress, "reading the files of the case", || AskedCase::new(file, options))?;
    let prepare = || file.case.preflight(file, &|name| asked.is_wanted(name));
    let prepared = announced(progress, "preparing the model", prepare)?;
    Ok((asked, prepared))
}

/// By what a study knows a case and what was computed of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Identity {
    /// The case with every default, and its files by the hashes of what they hold.
    pub resolved: Value,
    /// The hash of that.
    pub case_hash: String,
    /// Analyses, then sweeps: the name of each and the hash of all that its results depend on.
    pub results: Vec<(String, String)>,
}

/// By what a study of this case is known; computes nothing.
///
/// # Errors
/// A file of the case that cannot be read.
pub fn identity(file: &CaseFile) -> Result<Identity, StudyError> {
    let options = RunOptions::default();
    let asked = AskedCase::new(file, &options)?;
    let results = asked.all().map(|(name, hash)| (name.clone(), hash.clone())).collect();
    Ok(Identity { case_hash: case_hash(&asked.resolved), results, resolved: asked.resolved })
}

/// The plans of these sweeps of a case, of all where none is named.
///
/// # Errors
/// A name that the case does not have, a quantity that no operating point has, a file of the case that cannot be read.
pub fn plans(file: &CaseFile, only: &[String]) -> Result<Vec<SweepPlan>, StudyError> {
    AskedCase::new(file, &RunOptions { only: only.to_vec(), ..RunOptions::default() })?.plans()
}

/// What the wanted sweeps of a case would take; writes nothing.
///
/// # Errors
/// As of [`run`], and of [`SweepEstimate::new`].
pub fn dry_run(
    file: &CaseFile,
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<Vec<SweepEstimate>, StudyError> {
    let (asked, _) = prepared(file, options, progress)?;
    asked.plans()?.iter().map(|plan| SweepEstimate::new(plan, folder, progress)).collect()
}

/// What the analyses of a case left, before anything is drawn.
pub struct Computed {
    /// The study folder.
    pub store: StudyFolder,
    /// The content of its `summary.json`.
    pub summary: Summary,
    /// Analyses that were done before.
    pub skipped: Vec<String>,
    /// Results that were there and are dropped.
    forgotten: ForgottenResults,
    tables: Vec<String>,
    /// What was found damaged, one line each.
    damages: Vec<String>,
    /// Warnings and failed checks, one line each; not why an analysis was refused.
    pub messages: Vec<String>,
    /// Requested results that are not whole, a line each: which, and why.
    pub lacking: Vec<String>,
    /// Analyses without a result because the input is wrong.
    pub refused: Vec<RefusedAnalysis>,
}

impl Computed {
    /// Draws figures and page, where they are asked for.
    fn reported(
        self,
        registry: Registry,
        options: &RunOptions,
        notes: Vec<String>,
        progress: &dyn Progress,
    ) -> Result<RunReport, StudyError> {
        let Self { store, summary, skipped, forgotten, tables, damages, messages, lacking, refused } = self;
        let draw = || report::write(registry, &store, &summary);
        let drawn = || announced(progress, "drawing figures and report", draw);
        let report = if options.without_report { None } else { Some(drawn()?) };
        let undrawn = report.as_ref().map(WrittenPage::lacking).unwrap_or_default();
        store.seal(maker())?;
        let folder = store.path().to_owned();
        Ok(RunReport {
            folder,
            summary,
            parted: Vec::new(),
            report: report.map(|page| page.path),
            skipped,
            forgotten,
            complete: lacking.is_empty(),
            tables,
            notes,
            messages: [damages, messages, undrawn.clone()].concat(),
            lacking,
            undrawn,
            refused,
        })
    }
}

/// Runs the analyses of a case that are not done yet.
///
/// # Errors
/// As of [`run`].
pub fn compute(
    file: &CaseFile,
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<Computed, StudyError> {
    let start = Instant::now();
    let (asked, prepared) = prepared(file, options, progress)?;
    compute_in(taken(folder, options.fresh)?, &asked, &prepared, Vec::new(), true, progress, start)
}

/// The study in a folder, held alone; without earlier results where it is to be fresh.
fn taken(folder: &Path, fresh: bool) -> Result<StudyFolder, StudyError> {
    let store = StudyFolder::create(folder)?;
    if fresh {
        store.forget(report::is_drawn)?;
    }
    Ok(store)
}

/// Runs the wanted analyses that are not done yet, where they are to be run, and finishes these sweeps, whose chunks are all there. The run began at `start`.
fn compute_in(
    store: StudyFolder,
    asked: &AskedCase<'_>,
    prepared: &Prepared,
    sweeps: Vec<(&SweepPlan, Option<SweepReading<'_>>)>,
    analyses: bool,
    progress: &dyn Progress,
    start: Instant,
) -> Result<Computed, StudyError> {
    asked.keep_files(&store)?;
    let look = || Study::open(&store, asked.all());
    let mut study = announced(progress, "looking at what is there", look)?;
    study.set_case(asked.file, &asked.resolved, asked.file.case.with_used(asked.resolved.clone())?);
    let (mut skipped, mut refused) = (Vec::new(), Vec::new());
    let shared = shared(&asked.file.case, &asked.resolved);
    let all = &asked.analyses;
    let runner = AnalysisRunner { file: asked.file, prepared, store: &store, all, shared: shared.as_deref() };
    let wanted = all.iter().enumerate().filter(|(_, (name, _))| analyses && asked.is_wanted(name));
    let mut missing = Vec::new();
    for (index, (name, hash)) in wanted {
        if store.is_done(name, hash)? {
            store.discard_work(name)?;
            skipped.push(name.clone());
        } else {
            missing.push((index, name, hash));
        }
    }
    store.begin_results(&missing.iter().map(|(_, name, _)| name.as_str()).collect::<Vec<_>>())?;
    for (index, name, hash) in missing {
        let began = Instant::now();
        let (outcome, scratch) = runner.run(index, progress)?;
        asked.check_files()?;
        let took = began.elapsed().as_secs_f64();
        let keep = || study.keep(name, hash.clone(), outcome, took);
        if let Some(error) = announced(progress, &format!("storing {name}"), keep)? {
            refused.push(RefusedAnalysis { name: name.clone(), error });
        }
        scratch.discard()?;
    }
    runner.discard_shared()?;
    for (plan, reading) in sweeps {
        skipped.extend(sweeps::finished(&store, &mut study, plan, reading, progress)?);
    }
    study.summary.wall_time_s = start.elapsed().as_secs_f64();
    store.write_summary(&study.summary, None)?;
    let left = store.list_left(&asked.all().map(|(name, _)| name.as_str()).collect::<Vec<_>>())?;
    store.keep_manifest(maker())?;
    let wanted = asked.wanted();
    let lacking = study.kept.lacking(&study.summary, &wanted);
    let messages = messages(&study.summary, &study.kept, &refused);
    let damages = mem::take(&mut study.damages);
    let forgotten = ForgottenResults::of(&study, asked, left);
    let summary = study.summary;
    let tables = terminal_tables::tables(asked.file.registry(), &summary, &wanted);
    Ok(Computed { store, summary, skipped, forgotten, tables, damages, messages, lacking, refused })
}

/// Everything that the user should read, in the order of the case: failures, warnings, checks beyond their limits.
fn messages(summary: &Summary, kept: &Keepsakes, refused: &[RefusedAnalysis]) -> Vec<String> {
    let mut messages = Vec::new();
    for (name, record) in report::in_order(summary) {
        let is_refused = refused.iter().any(|refused| refused.name == *name);
        if let (Status::Failed { reason }, false) = (&record.status, is_refused) {
            messages.push(format!("{name}: {reason}"));
        }
        messages.extend(record.warnings.iter().map(|warning| format!("{name}: {warning}")));
        let failures = kept.checks.get(name).into_iter().flatten().filter_map(CheckRecord::failure);
        messages.extend(failures.map(|failure| format!("{name}: {failure}")));
    }
    messages
}
