//! The analyses of a case in memory: no folder is made, nothing is known from before and nothing is drawn, unless that is asked for.

use super::analyses::shared;
use super::asked::{AskedCase, keep_files};
use super::{RefusedAnalysis, RunOptions, messages};
use crate::case::file::CaseFile;
use crate::error::StudyError;
use crate::kept::KeptLines;
use crate::ledger::{self, Keepsakes, Study};
use crate::model::{Task, placed};
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::report;
use crate::version::{maker, version};
use judder_report::svg;
use judder_store::{StudyFolder, Summary, VariableValues};
use serde_json::Value;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// What the analyses of a case left, in no folder.
pub struct HeldStudy {
    file: CaseFile,
    /// What a study keeps beside its results, by name.
    files: Vec<(String, Vec<u8>)>,
    /// The case with the content of its files.
    resolved: Value,
    /// Analyses, then sweeps: the name of each and its hash.
    all: Vec<(String, String)>,
    /// What `summary.json` of its folder would hold.
    pub summary: Summary,
    /// The analyses with a result, in the order of the case; what is told of them is in the summary.
    outcomes: Vec<(String, Outcome)>,
}

/// A run of a case in memory.
pub struct HeldRun {
    /// What it left.
    pub study: HeldStudy,
    /// Warnings and failed checks, one line each; not why an analysis was refused.
    pub messages: Vec<String>,
    /// Analyses without a result because the input is wrong.
    pub refused: Vec<RefusedAnalysis>,
}

/// Runs the analyses of a case in memory; `None` where they need a folder: sweeps, whose chunks may be more than memory holds, and analyses
/// that read what others have stored.
///
/// # Errors
/// An unknown name in `only`, a file of the case that cannot be read, [`StudyError::Interrupted`], [`StudyError::HeldTooMuch`].
pub fn hold(
    file: &CaseFile,
    options: &RunOptions,
    progress: &dyn Progress,
) -> Result<Option<HeldRun>, StudyError> {
    let asked = AskedCase::new(file, options)?;
    let wanted = asked.wanted();
    let needs_folder = |name: &String| {
        !file.case.takes_up(name).is_empty() || file.sweeps.iter().any(|sweep| sweep.name == *name)
    };
    if wanted.iter().any(needs_folder) {
        return Ok(None);
    }
    held(&asked, options, progress).map(Some)
}

fn held(asked: &AskedCase<'_>, options: &RunOptions, progress: &dyn Progress) -> Result<HeldRun, StudyError> {
    let start = Instant::now();
    let file = asked.file;
    let prepared = file.case.preflight(file, &|name| asked.is_wanted(name))?;
    let mut summary = Summary { version: version().to_owned(), ..Summary::default() };
    let mut kept = Keepsakes::default();
    let shown = file.case.with_used(asked.resolved.clone())?;
    kept.set_case(&mut summary, file, None, &asked.resolved, shown);
    let (mut outcomes, mut refused) = (Vec::new(), Vec::new());
    let mut bytes = 0;
    // what takes long and all analyses share, such as a law, is computed by the first
    let has_shared = shared(&file.case, &asked.resolved).is_some();
    let known: Mutex<Vec<String>> = Mutex::default();
    let lock = || known.lock().unwrap_or_else(PoisonError::into_inner);
    let wanted = asked.analyses.iter().enumerate().filter(|(_, (name, _))| asked.is_wanted(name));
    for (index, (name, hash)) in wanted {
        let began = Instant::now();
        progress.begin(name, file.case.steps(index));
        let lines = lock().clone();
        let keep = |line: &str| lock().push(line.to_owned());
        let alone = Task::alone(&prepared, progress);
        let task = match has_shared {
            true => Task { shared: KeptLines { lines: &lines, keep: &keep, place: None }, ..alone },
            false => alone,
        };
        let outcome = file.case.run(index, task);
        progress.end();
        asked.check_files()?;
        let took = (hash.clone(), began.elapsed().as_secs_f64());
        let wrong = match outcome.map_err(|error| placed(error, &*file.case, file, index)) {
            Ok(mut outcome) => {
                bytes += bytes_of(&outcome);
                if let Some(limit) = options.most_held.filter(|limit| bytes > *limit) {
                    return Err(StudyError::HeldTooMuch { name: name.clone(), bytes, limit });
                }
                let wrong = kept.record(&mut summary, name, Ok(&mut outcome), took)?;
                outcomes.push((name.clone(), outcome));
                wrong
            }
            Err(error) => kept.record(&mut summary, name, Err(error), took)?,
        };
        refused.extend(wrong.map(|error| RefusedAnalysis { name: name.clone(), error }));
    }
    summary.wall_time_s = start.elapsed().as_secs_f64();
    let messages = messages(&summary, &kept, &refused);
    let all = asked.all().map(|(name, hash)| (name.clone(), hash.clone())).collect();
    let (file, files, resolved) = (file.clone(), options.files.clone(), asked.resolved.clone());
    let study = HeldStudy { file, files, resolved, all, summary, outcomes };
    Ok(HeldRun { study, messages, refused })
}

/// Bytes of the arrays and files of an outcome.
fn bytes_of(outcome: &Outcome) -> u64 {
    let of_values = |values: &VariableValues| match values {
        VariableValues::F64(values) => size_of_val(values.as_slice()),
        VariableValues::Complex(values) => size_of_val(values.as_slice()),
        VariableValues::I64(values) => size_of_val(values.as_slice()),
        VariableValues::U8(values) => values.len(),
        VariableValues::Text(values) => values.iter().map(String::len).sum(),
    };
    let arrays: usize = outcome.dataset.variables().iter().map(|own| of_values(&own.data)).sum();
    let files: usize = outcome.files.iter().map(|(_, content)| content.len()).sum();
    (arrays + files) as u64
}

impl HeldStudy {
    /// What an analysis left, where it has a result.
    #[must_use]
    pub fn outcome(&self, name: &str) -> Option<&Outcome> {
        self.outcomes.iter().find(|(own, _)| own == name).map(|(_, outcome)| outcome)
    }

    /// The files that its folder would have beside arrays, summary and report, by their paths in it: tables, sounds, laws, fields.
    #[must_use]
    pub fn files(&self) -> Vec<(String, Vec<u8>)> {
        let mut files = self.files.clone();
        for (name, outcome) in &self.outcomes {
            let table = outcome.table.as_ref().and_then(|table| table.to_csv().ok());
            files.extend(table.map(|content| (format!("{name}.csv"), content)));
            files.extend(outcome.files.iter().cloned());
        }
        files.sort();
        files
    }

    /// The figures of its analyses (SVG) by their names; those that cannot be drawn are left out.
    #[must_use]
    pub fn figures(&self) -> Vec<(String, String)> {
        let Some(model) = self.file.registry().model_of(&self.summary.case) else { return Vec::new() };
        let drawn = self.outcomes.iter().filter_map(|(name, outcome)| {
            let figure = model.figure(name, name, &outcome.dataset).ok()??;
            Some((figure.name.clone(), svg(&figure).ok()?))
        });
        drawn.collect()
    }

    /// Writes it into a folder as a run into that folder leaves it, but for the report, which may be left out.
    ///
    /// # Errors
    /// A folder that cannot be written, or holds something else.
    pub fn save(&self, folder: &Path, with_report: bool) -> Result<(), StudyError> {
        let store = StudyFolder::create(folder)?;
        keep_files(&store, &self.files)?;
        let mut study = Study::open(&store, self.all.iter().map(|(name, hash)| (name, hash)))?;
        study.set_case(&self.file, &self.resolved, self.summary.case.clone());
        let own = Keepsakes::of(&self.summary);
        store.begin_results(&self.summary.analyses.keys().map(String::as_str).collect::<Vec<_>>())?;
        for (name, record) in &self.summary.analyses {
            if let Some(outcome) = self.outcome(name) {
                ledger::write(&store, name, &record.hash, outcome)?;
            }
            study.take_over(name, record, (&self.summary, &own));
        }
        study.summary.wall_time_s = self.summary.wall_time_s;
        store.write_summary(&study.summary, None)?;
        if with_report {
            report::write(self.file.registry(), &store, &study.summary)?;
        }
        Ok(store.seal(maker())?)
    }
}
