//! What a study folder says of its analyses and sweeps: which are done, what came of them, what the user has to know.

use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::outcome::{CheckRecord, Outcome};
use crate::version::{maker, version};
use crate::way::way;
use judder_store::{
    AnalysisRecord, FileDamage, Status, StoreError, StudyFolder, Summary, WriteUnderWay, content_hash,
};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::mem;
use std::path::Path;

/// Names a case, by its resolved form with the hashes of its files.
pub(crate) fn case_hash(resolved: &Value) -> String {
    content_hash(resolved.to_string().as_bytes())
}

/// What a study keeps in `summary.json` beside results and records.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Keepsakes {
    /// The text of the case file, for the report.
    pub(crate) source: String,
    /// The way to that file from the study folder; none where the case came as a text.
    pub(crate) file: Option<String>,
    /// The `--set` options that were on top of it.
    pub(crate) overrides: Vec<String>,
    /// Analysis → its checks.
    pub checks: BTreeMap<String, Vec<CheckRecord>>,
    /// Analysis → how many of its results are missing.
    pub(crate) missing: BTreeMap<String, usize>,
}

impl Keepsakes {
    const KEY: &'static str = "study";

    /// Those of a summary; empty where it has none.
    pub fn of(summary: &Summary) -> Self {
        let kept = summary.extra.get(Self::KEY).cloned().unwrap_or_default();
        serde_json::from_value(kept).unwrap_or_default()
    }

    pub(crate) fn put(&self, summary: &mut Summary) {
        summary.extra.insert(Self::KEY.to_owned(), json!(self));
    }

    /// Names the case whose study this is, in a folder or in none, by what it resolves to, and shows it with what is used.
    pub(crate) fn set_case(
        &mut self,
        summary: &mut Summary,
        file: &CaseFile,
        folder: Option<&Path>,
        resolved: &Value,
        shown: Value,
    ) {
        self.source.clone_from(&file.text);
        self.file = folder.zip(file.path.as_deref()).and_then(|(folder, path)| way(folder, path));
        self.overrides.clone_from(&file.overrides);
        self.put(summary);
        summary.case_hash = case_hash(resolved);
        summary.case = shown;
    }

    /// Takes what is told of the outcome of an analysis with this hash and wall time, or why there is none; gives the error back where the input is to blame.
    ///
    /// # Errors
    /// Interruptions and failures to write, which end a run.
    pub(crate) fn record(
        &mut self,
        summary: &mut Summary,
        name: &str,
        outcome: Result<&mut Outcome, StudyError>,
        (hash, wall_time_s): (String, f64),
    ) -> Result<Option<StudyError>, StudyError> {
        let mut refused = None;
        let (status, warnings) = match outcome {
            Ok(outcome) => {
                summary.results.insert(name.to_owned(), mem::take(&mut outcome.scalars));
                self.checks.insert(name.to_owned(), mem::take(&mut outcome.checks));
                self.missing.insert(name.to_owned(), outcome.missing);
                (Status::Done, mem::take(&mut outcome.warnings))
            }
            Err(error @ (StudyError::Interrupted | StudyError::Store(_))) => return Err(error),
            Err(error) => {
                summary.results.remove(name);
                let reason = error.to_string();
                refused = Some(error).filter(StudyError::is_wrong_input);
                (Status::Failed { reason }, Vec::new())
            }
        };
        let record = AnalysisRecord { hash, status, wall_time_s, warnings };
        summary.analyses.insert(name.to_owned(), record);
        self.put(summary);
        Ok(refused)
    }

    /// Of these results those that are not whole, a line each: which, and why.
    pub(crate) fn lacking(&self, summary: &Summary, names: &[String]) -> Vec<String> {
        let of = |name: &String| match summary.analyses.get(name) {
            None => Some("it was not computed".to_owned()),
            Some(AnalysisRecord { status: Status::Failed { reason }, .. }) => Some(reason.clone()),
            Some(record) => match self.missing.get(name).copied().unwrap_or(0) {
                0 => None,
                count => Some(missing_told(count, &record.warnings)),
            },
        };
        names.iter().filter_map(|name| Some(format!("{name}: {}", of(name)?))).collect()
    }
}

/// A study folder in the making.
pub struct Study<'a> {
    store: &'a StudyFolder,
    /// What is said of the results so far.
    pub summary: Summary,
    pub(crate) kept: Keepsakes,
    /// The names of results that were there, and are dropped, each with its hash.
    pub(crate) forgotten: Vec<(String, String)>,
    /// The version that computed what was there.
    pub(crate) computed_by: String,
    /// What was found damaged of what was there, one line each.
    pub(crate) damages: Vec<String>,
}

impl<'a> Study<'a> {
    /// Takes up what an earlier run left of these analyses under these hashes, and drops the rest: what another case left
    /// must not stand under this one's name, nor what is damaged.
    pub fn open<'b>(
        store: &'a StudyFolder,
        analyses: impl Iterator<Item = (&'b String, &'b String)>,
    ) -> Result<Self, StudyError> {
        let current: BTreeMap<&String, &String> = analyses.collect();
        let (mut summary, mut damages) = match store.read_summary() {
            // where nothing says that the folder is a study of judder's, the file is somebody's
            Err(
                error @ (StoreError::SummaryUnreadable { .. }
                | StoreError::Oversized { .. }
                | StoreError::Damaged { .. }),
            ) if store.has_manifest() => {
                store.write_summary(&Summary::default(), None)?;
                (Summary::default(), vec![error.to_string()])
            }
            read => (read?.unwrap_or_default(), Vec::new()),
        };
        let damaged = store.damages(&summary)?;
        store.begin_results(&damaged.keys().map(String::as_str).collect::<Vec<_>>())?;
        for (name, found) in &damaged {
            damages.extend(damage_told(name, found));
            summary.analyses.remove(name);
        }
        damages.extend(unlisted_told(store, &summary));
        // what a run was at work on when it ended may be anything
        summary.analyses.retain(|name, _| store.is_listed(name));
        let mut kept = Keepsakes::of(&summary);
        let computed_by = mem::replace(&mut summary.version, version().to_owned());
        summary.warnings.clear();
        let is_current = |name: &String, record: &AnalysisRecord| current.get(name) == Some(&&record.hash);
        let all = summary.analyses.iter();
        let dropped = all.filter(|(name, record)| !is_current(name, record));
        let forgotten = dropped.map(|(name, record)| (name.clone(), record.hash.clone())).collect();
        summary.analyses.retain(|name, record| is_current(name, record));
        let stays = |name: &String| summary.analyses.contains_key(name);
        summary.results.retain(|name, _| stays(name));
        kept.checks.retain(|name, _| stays(name));
        kept.missing.retain(|name, _| stays(name));
        kept.put(&mut summary);
        Ok(Self { store, summary, kept, forgotten, computed_by, damages })
    }

    /// Names the case whose study this is, by what it resolves to, and shows it with what is used.
    pub(crate) fn set_case(&mut self, file: &CaseFile, resolved: &Value, shown: Value) {
        self.kept.set_case(&mut self.summary, file, Some(self.store.path()), resolved, shown);
    }

    /// Takes over what the summary of a study in memory tells of a result.
    pub(crate) fn take_over(&mut self, name: &str, record: &AnalysisRecord, held: (&Summary, &Keepsakes)) {
        let (summary, kept) = held;
        self.summary.analyses.insert(name.to_owned(), record.clone());
        match summary.results.get(name) {
            Some(found) => drop(self.summary.results.insert(name.to_owned(), found.clone())),
            None => drop(self.summary.results.remove(name)),
        }
        self.kept.checks.extend(kept.checks.get(name).map(|own| (name.to_owned(), own.clone())));
        self.kept.missing.extend(kept.missing.get(name).map(|own| (name.to_owned(), *own)));
        self.kept.put(&mut self.summary);
    }

    /// Of these results those that are not whole, a line each: which, and why.
    pub fn lacking(&self, names: &[String]) -> Vec<String> {
        self.kept.lacking(&self.summary, names)
    }

    /// Stores the outcome of an analysis, or why there is none; gives the error back where the input is to blame. Interruptions
    /// and failures to write end the run.
    pub fn keep(
        &mut self,
        name: &str,
        hash: String,
        outcome: Result<Outcome, StudyError>,
        wall_time_s: f64,
    ) -> Result<Option<StudyError>, StudyError> {
        let took = (hash, wall_time_s);
        // what took long to compute is not lost to an end in the midst of this
        let _write = WriteUnderWay::begin();
        let refused = match outcome {
            Ok(mut outcome) => {
                write(self.store, name, &took.0, &outcome)?;
                self.kept.record(&mut self.summary, name, Ok(&mut outcome), took)?
            }
            Err(error) => self.kept.record(&mut self.summary, name, Err(error), took)?,
        };
        self.store.write_summary(&self.summary, Some(name))?;
        self.store.keep_manifest(maker())?;
        Ok(refused)
    }
}

/// How many results an analysis misses, and what it has warned of, which says why.
fn missing_told(count: usize, warnings: &[String]) -> String {
    let counted =
        if count == 1 { "1 of its results is".to_owned() } else { format!("{count} of its results are") };
    let why = if warnings.is_empty() { String::new() } else { format!(": {}", warnings.join("; ")) };
    format!("{counted} missing{why}")
}

/// What is told of results of which nothing says that they are as they were written.
fn unlisted_told(store: &StudyFolder, summary: &Summary) -> Option<String> {
    let names: Vec<&str> = summary.analyses.keys().map(String::as_str).collect();
    let reason = match store.without_manifest().filter(|_| !names.is_empty())? {
        StoreError::ManifestDamaged { .. } => "`manifest.json` is damaged",
        _ => "there is no `manifest.json`",
    };
    Some(format!(
        "{reason}, so that nothing says whether these are as they were written, and they do not count: {}",
        names.join(", ")
    ))
}

/// What is told of a damaged result.
fn damage_told(name: &str, found: &[(String, FileDamage)]) -> Option<String> {
    let (path, damage) = found.first()?;
    let others = match found.len() {
        1 => String::new(),
        2 => "; so is 1 more file".to_owned(),
        count => format!("; so are {} more files", count - 1),
    };
    Some(format!("{name}: is damaged and does not count ({path}: {damage}{others})"))
}

/// Stores arrays, table and files of an outcome.
pub(crate) fn write(
    store: &StudyFolder,
    name: &str,
    hash: &str,
    outcome: &Outcome,
) -> Result<(), StudyError> {
    if !outcome.is_stored {
        store.write_dataset(name, hash, &outcome.dataset)?;
    }
    if let Some(table) = &outcome.table {
        store.write_table(name, table)?;
    }
    for (path, content) in &outcome.files {
        store.write_file_of(Some(name), Path::new(path), content)?;
    }
    Ok(())
}
