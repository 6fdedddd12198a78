//! The analyses of a case into a study folder.

use crate::analyses;
use crate::door;
use crate::error::StudyError;
use crate::input_file;
use crate::kept::{Kept, Place};
use crate::outcome::{CheckRecord, Outcome};
use crate::progress::Progress;
use crate::report;
use crate::told;
use judder_case::{Case, CaseFile, LawName, OscillatorCase};
use judder_store::{AnalysisRecord, Scratch, Status, StudyFolder, Summary, content_hash};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The version that studies are stamped with; another version computes everything again.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What of a case is to be run, and whether from nothing.
#[derive(Debug, Clone, Default)]
pub struct RunOptions {
    /// Only these analyses; all where empty.
    pub only: Vec<String>,
    /// Forget earlier results first.
    pub fresh: bool,
}

/// What a run left.
#[derive(Debug)]
pub struct RunReport {
    /// The study folder.
    pub folder: PathBuf,
    /// The content of its `summary.json`.
    pub summary: Summary,
    /// Its `report.html`.
    pub report: PathBuf,
    /// Analyses that were done before.
    pub skipped: Vec<String>,
    /// Whether every requested result is there.
    pub complete: bool,
    /// Results that are worth a table on the terminal.
    pub tables: Vec<String>,
    /// Warnings and failed checks, one line each; not why an analysis was refused.
    pub messages: Vec<String>,
    /// Analyses without a result because the input is wrong.
    pub refused: Vec<RefusedAnalysis>,
}

/// An analysis without a result because the input is wrong.
#[derive(Debug)]
pub struct RefusedAnalysis {
    /// Its name.
    pub name: String,
    /// What is wrong, and where.
    pub error: StudyError,
}

/// What a study keeps in `summary.json` beside results and records.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(crate) struct Keepsakes {
    /// The text of the case file, for the report.
    pub(crate) source: String,
    /// The `--set` options that were on top of it.
    pub(crate) overrides: Vec<String>,
    /// Analysis → its checks.
    pub(crate) checks: BTreeMap<String, Vec<CheckRecord>>,
    /// Analysis → how many of its results are missing.
    pub(crate) missing: BTreeMap<String, usize>,
}

impl Keepsakes {
    const KEY: &'static str = "study";

    /// Those of a summary; empty where it has none.
    pub(crate) fn of(summary: &Summary) -> Self {
        let kept = summary.extra.get(Self::KEY).cloned().unwrap_or_default();
        serde_json::from_value(kept).unwrap_or_default()
    }

    pub(crate) fn put(&self, summary: &mut Summary) {
        summary.extra.insert(Self::KEY.to_owned(), json!(self));
    }
}

/// Runs the analyses of a case that are not done yet, then draws figures and report.
///
/// # Errors
/// An unknown name in `only`, a folder that cannot be written, or [`StudyError::Interrupted`]; what was done until then is kept.
pub fn run(
    file: &CaseFile,
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<RunReport, StudyError> {
    let Computed { store, summary, skipped, complete, tables, messages, refused, .. } =
        compute(file, folder, options, progress)?;
    let report = report::write(&store, &summary)?;
    Ok(RunReport { folder: folder.to_owned(), summary, report, skipped, complete, tables, messages, refused })
}

/// What the analyses of a case left, before anything is drawn.
pub(crate) struct Computed {
    /// The study folder.
    pub(crate) store: StudyFolder,
    /// The content of its `summary.json`.
    pub(crate) summary: Summary,
    /// Analyses that were done before.
    pub(crate) skipped: Vec<String>,
    /// Whether every requested result is there.
    pub(crate) complete: bool,
    tables: Vec<String>,
    messages: Vec<String>,
    refused: Vec<RefusedAnalysis>,
}

/// Runs the analyses of a case that are not done yet.
///
/// # Errors
/// As of [`run`].
pub(crate) fn compute(
    file: &CaseFile,
    folder: &Path,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<Computed, StudyError> {
    let start = Instant::now();
    let names = analyses::names(&file.case);
    if let Some(name) = options.only.iter().find(|name| !names.contains(name)) {
        return Err(StudyError::UnknownAnalysis { name: name.clone(), known: names });
    }
    let is_wanted = |name: &str| options.only.is_empty() || options.only.iter().any(|only| only == name);
    let prepared = door::check(file, is_wanted)?;
    let store = StudyFolder::create(folder)?;
    if options.fresh {
        store.forget()?;
    }
    let resolved = with_files(file.case.resolved(), &file.case)?;
    let hashes: Vec<String> = (0..names.len()).map(|index| analysis_hash(&resolved, index)).collect();
    let mut study = Study::open(&store, names.iter().zip(&hashes))?;
    study.set_case(file, &resolved);
    let (mut skipped, mut refused) = (Vec::new(), Vec::new());
    let law = shared_law(&file.case, &resolved);
    let all: Vec<(String, String)> = names.iter().cloned().zip(hashes.iter().cloned()).collect();
    for (index, (name, hash)) in names.iter().zip(hashes.clone()).enumerate() {
        if !is_wanted(name) {
            continue;
        }
        if store.is_done(name, &hash)? {
            skipped.push(name.clone());
            continue;
        }
        progress.begin(name, analyses::steps(&file.case, index));
        let began = Instant::now();
        // under a name that the shared law does not have
        let scratch = store.scratch(&format!("of-{name}"), &hash)?;
        // a line that cannot be kept costs a rerun, no result
        let keep = |line: &str| {
            let _ = scratch.keep(line);
        };
        let shared = law.as_deref().map(|of| store.scratch(LAW_POINTS, of)).transpose()?;
        let keep_shared = |line: &str| {
            let _ = shared.as_ref().map(|shared| shared.keep(line));
        };
        let place = Place { study: &store, analysis: name, hash: &hash, all: &all };
        let own = Kept { lines: scratch.lines(), keep: &keep, place: Some(place) };
        let lines = shared.as_ref().map_or(&[][..], Scratch::lines);
        let of_law = Kept { lines, keep: &keep_shared, place: None };
        let outcome = analyses::run_from((&file.case, &prepared), index, (of_law, own), progress);
        progress.end();
        let outcome = outcome.map_err(|error| door::placed(error, file, index));
        if let Some(error) = study.keep(name, hash, outcome, began.elapsed().as_secs_f64())? {
            refused.push(RefusedAnalysis { name: name.clone(), error });
        }
        scratch.discard()?;
    }
    if let Some(law) = &law
        && all_done(&store, &names, &hashes)?
    {
        store.scratch(LAW_POINTS, law)?.discard()?;
    }
    study.summary.wall_time_s = start.elapsed().as_secs_f64();
    store.write_summary(&study.summary)?;
    let wanted: Vec<String> = names.into_iter().filter(|name| is_wanted(name)).collect();
    let complete = study.is_complete(&wanted);
    let messages = messages(&study.summary, &study.kept, &refused);
    let summary = study.summary;
    let tables = told::tables(&summary, &wanted);
    Ok(Computed { store, summary, skipped, complete, tables, messages, refused })
}

/// Where the solved contacts of the law are kept that the analyses of an oscillator case share.
const LAW_POINTS: &str = "law";

/// What the law depends on that a case has computed for all its analyses; `None` where it has none.
fn shared_law(case: &Case, resolved: &Value) -> Option<String> {
    let Case::Oscillator(OscillatorCase { law: LawName::Bem, .. }) = case else { return None };
    let of = json!([VERSION, resolved["substrate"], resolved["files"], resolved["contact"]["law"]]);
    Some(content_hash(of.to_string().as_bytes()))
}

fn all_done(store: &StudyFolder, names: &[String], hashes: &[String]) -> Result<bool, StudyError> {
    for (name, hash) in names.iter().zip(hashes) {
        if !store.is_done(name, hash)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The resolved case with the content of every file that it names, by its hash.
fn with_files(mut resolved: Value, case: &Case) -> Result<Value, StudyError> {
    for file in case.files() {
        resolved["files"][&file.given] = json!(content_hash(&input_file::bytes(&file.path)?));
    }
    Ok(resolved)
}

/// Names all that the result of an analysis depends on: the case without its list of analyses and its title, this analysis, the version.
pub(crate) fn analysis_hash(resolved: &Value, index: usize) -> String {
    let mut model = resolved.clone();
    let mut analysis = model.get("analysis").and_then(|list| list.get(index)).cloned();
    if let Some(object) = analysis.as_mut().and_then(Value::as_object_mut) {
        // it decides whether there is a result, not which
        object.remove("memory_limit");
    }
    if let Some(object) = model.as_object_mut() {
        object.remove("analysis");
        object.remove("title");
    }
    let others = used_by(resolved, analysis.as_ref());
    if others.is_empty() {
        return content_hash(json!([VERSION, model, analysis]).to_string().as_bytes());
    }
    content_hash(json!([VERSION, model, analysis, others]).to_string().as_bytes())
}

/// The other analyses whose results an analysis takes, as the case describes them.
fn used_by<'a>(resolved: &'a Value, analysis: Option<&Value>) -> Vec<&'a Value> {
    let names: Vec<&str> = ["of", "locus"].iter().filter_map(|key| analysis?.get(key)?.as_str()).collect();
    let all = resolved.get("analysis").and_then(Value::as_array).into_iter().flatten();
    all.filter(|other| other["name"].as_str().is_some_and(|name| names.contains(&name))).collect()
}

/// A study folder in the making.
pub(crate) struct Study<'a> {
    store: &'a StudyFolder,
    pub(crate) summary: Summary,
    kept: Keepsakes,
}

impl<'a> Study<'a> {
    /// Takes up what an earlier run left of these analyses under these hashes, and drops the rest: what another case left
    /// must not stand under this one's name.
    pub(crate) fn open<'b>(
        store: &'a StudyFolder,
        analyses: impl Iterator<Item = (&'b String, &'b String)>,
    ) -> Result<Self, StudyError> {
        let current: BTreeMap<&String, &String> = analyses.collect();
        let mut summary = store.read_summary()?.unwrap_or_default();
        let mut kept = Keepsakes::of(&summary);
        VERSION.clone_into(&mut summary.version);
        summary.warnings.clear();
        summary.analyses.retain(|name, record| current.get(name) == Some(&&record.hash));
        let stays = |name: &String| summary.analyses.contains_key(name);
        summary.results.retain(|name, _| stays(name));
        kept.checks.retain(|name, _| stays(name));
        kept.missing.retain(|name, _| stays(name));
        kept.put(&mut summary);
        Ok(Self { store, summary, kept })
    }

    /// Names the case whose study this is.
    fn set_case(&mut self, file: &CaseFile, resolved: &Value) {
        self.kept.source.clone_from(&file.text);
        self.kept.overrides.clone_from(&file.overrides);
        self.kept.put(&mut self.summary);
        self.summary.case_hash = content_hash(resolved.to_string().as_bytes());
        self.summary.case = resolved.clone();
    }

    /// Whether these analyses are done and miss nothing.
    pub(crate) fn is_complete(&self, names: &[String]) -> bool {
        names.iter().all(|name| {
            let done = self.summary.analyses.get(name).is_some_and(|record| record.status == Status::Done);
            done && self.kept.missing.get(name).copied().unwrap_or(0) == 0
        })
    }

    /// Stores the outcome of an analysis, or why there is none; gives the error back where the input is to blame. Interruptions
    /// and failures to write end the run.
    pub(crate) fn keep(
        &mut self,
        name: &str,
        hash: String,
        outcome: Result<Outcome, StudyError>,
        wall_time_s: f64,
    ) -> Result<Option<StudyError>, StudyError> {
        let mut refused = None;
        let (status, warnings) = match outcome {
            Ok(outcome) => {
                if !outcome.is_stored {
                    self.store.write_dataset(name, &hash, &outcome.dataset)?;
                }
                if let Some(table) = &outcome.table {
                    self.store.write_table(name, table)?;
                }
                for (path, content) in &outcome.files {
                    self.store.write_file(path, content)?;
                }
                self.summary.results.insert(name.to_owned(), outcome.scalars);
                self.kept.checks.insert(name.to_owned(), outcome.checks);
                self.kept.missing.insert(name.to_owned(), outcome.missing);
                (Status::Done, outcome.warnings)
            }
            Err(error @ (StudyError::Interrupted | StudyError::Store(_))) => return Err(error),
            Err(error) => {
                self.summary.results.remove(name);
                let reason = error.to_string();
                refused = Some(error).filter(StudyError::is_wrong_input);
                (Status::Failed { reason }, Vec::new())
            }
        };
        let record = AnalysisRecord { hash, status, wall_time_s, warnings };
        self.summary.analyses.insert(name.to_owned(), record);
        self.kept.put(&mut self.summary);
        self.store.write_summary(&self.summary)?;
        Ok(refused)
    }
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
        for check in kept.checks.get(name).into_iter().flatten().filter(|check| !check.passed()) {
            messages.push(format!(
                "{name}: check failed: {}: {:.1e}, at most {:.0e}",
                check.name, check.figure, check.limit
            ));
        }
    }
    messages
}
