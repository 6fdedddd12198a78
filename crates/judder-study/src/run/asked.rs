//! What a run is asked for, and under which hash each result of it stands.

use super::RunOptions;
use crate::case::file::CaseFile;
use crate::case::study_sweep::StudySweep;
use crate::case::study_sweep::quantity_path::{QuantityPath, QuantitySource};
use crate::error::StudyError;
use crate::input_file::KnownFile;
use crate::model::Case;
use crate::sweep::{SweepPlan, check_together};
use crate::version::version;
use judder_store::{StudyFolder, content_hash, read_small_file};
use serde_json::{Value, json};
use std::sync::Arc;

/// A case with the names and hashes of all that it has, and what of it is wanted.
pub(crate) struct AskedCase<'a> {
    pub(super) file: &'a CaseFile,
    only: &'a [String],
    /// What the study keeps beside its results.
    kept: &'a [(String, Vec<u8>)],
    /// The case with every default and the content of its files.
    pub(super) resolved: Value,
    /// The analyses with their hashes.
    pub(super) analyses: Vec<(String, String)>,
    /// The hashes of the sweeps.
    sweeps: Vec<String>,
    /// The files of the case, as they are in the hashes.
    files: Vec<KnownFile>,
}

impl<'a> AskedCase<'a> {
    /// # Errors
    /// A name in `only` that the case does not have, a file of the case that cannot be read.
    pub(super) fn new(file: &'a CaseFile, options: &'a RunOptions) -> Result<Self, StudyError> {
        let names: Vec<String> = file.case.analysis_names().into_iter().map(str::to_owned).collect();
        let known = || names.iter().chain(file.sweeps.iter().map(|sweep| &sweep.name));
        if let Some(name) = options.only.iter().find(|name| !known().any(|own| own == *name)) {
            return Err(StudyError::UnknownAnalysis {
                name: name.clone(),
                known: known().cloned().collect(),
            });
        }
        let (resolved, files) = resolved_with_files(file)?;
        let hashes = Hashes::of(version(), &file.case, &resolved);
        let hashed = |(index, name): (usize, &String)| (name.clone(), hashes.analysis(index));
        let analyses = names.iter().enumerate().map(hashed).collect();
        let sweeps = file.sweeps.iter().map(|sweep| hashes.sweep(sweep)).collect();
        Ok(Self { file, only: &options.only, kept: &options.files, resolved, analyses, sweeps, files })
    }

    /// Refuses to go on where a file of the case is not what it was when it went into the hashes.
    ///
    /// # Errors
    /// [`StudyError::FileChanged`], [`StudyError::Unreadable`].
    pub(super) fn check_files(&self) -> Result<(), StudyError> {
        self.files.iter().try_for_each(KnownFile::check)
    }

    /// Writes what the study keeps beside its results, where it is not there already.
    ///
    /// # Errors
    /// Failures of the file system.
    pub(super) fn keep_files(&self, store: &StudyFolder) -> Result<(), StudyError> {
        keep_files(store, self.kept)
    }

    pub(super) fn is_wanted(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|only| only == name)
    }

    /// Names and hashes of all analyses and sweeps.
    pub(super) fn all(&self) -> impl Iterator<Item = (&String, &String)> {
        let sweeps = self.file.sweeps.iter().map(|sweep| &sweep.name).zip(&self.sweeps);
        self.analyses.iter().map(|(name, hash)| (name, hash)).chain(sweeps)
    }

    /// Of results that are dropped, by name and hash, those that the build of this version has computed of this same case.
    pub(super) fn computed_by(&self, version: &str, dropped: &[(String, String)]) -> Vec<String> {
        let hashes = Hashes::of(version, &self.file.case, &self.resolved);
        let is_dropped = |index: usize, name: &String| {
            dropped.iter().any(|(own, of)| own == name && *of == hashes.analysis(index))
        };
        let names = self.analyses.iter().map(|(name, _)| name).enumerate();
        names.filter(|(index, name)| is_dropped(*index, name)).map(|(_, name)| name.clone()).collect()
    }

    /// The names that are wanted, analyses first.
    pub(super) fn wanted(&self) -> Vec<String> {
        self.all().map(|(name, _)| name).filter(|name| self.is_wanted(name)).cloned().collect()
    }

    /// The plans of the wanted sweeps.
    ///
    /// # Errors
    /// As of [`SweepPlan::new`]; sweeps that do not fit into memory together.
    pub(super) fn plans(&self) -> Result<Vec<SweepPlan>, StudyError> {
        let sweeps = self.file.sweeps.iter().zip(&self.sweeps);
        let (wanted, hashes): (Vec<_>, Vec<_>) =
            sweeps.filter(|(sweep, _)| self.is_wanted(&sweep.name)).unzip();
        check_together(&wanted)?;
        let file = Arc::new(self.file.clone());
        let plan = |(sweep, hash): (&StudySweep, &String)| SweepPlan::new(&file, sweep, hash, &self.files);
        wanted.into_iter().zip(hashes).map(plan).collect()
    }
}

/// Writes files into a study, where they are not there already.
///
/// # Errors
/// Failures of the file system.
pub(super) fn keep_files(store: &StudyFolder, files: &[(String, Vec<u8>)]) -> Result<(), StudyError> {
    for (name, content) in files {
        let there = read_small_file(&store.path().join(name), content.len() as u64);
        if !there.is_ok_and(|there| there == *content) {
            store.write_file(name, content)?;
        }
    }
    Ok(())
}

/// The resolved case with the content of every file that it names, by its hash, and the files.
///
/// # Errors
/// A file that cannot be read.
pub fn resolved_with_files(case: &CaseFile) -> Result<(Value, Vec<KnownFile>), StudyError> {
    let (mut resolved, mut files) = (case.resolved(), Vec::new());
    for file in case.case.files() {
        let known = KnownFile::new(&file.path)?;
        resolved["files"][&file.given] = json!(known.hash);
        files.push(known);
    }
    Ok((resolved, files))
}

/// Names all that the result of an analysis of a case depends on: its canonical form without its list of analyses and its title, this
/// analysis, those whose results it takes up, the version, which names the sources of the build.
pub fn analysis_hash(case: &Case, resolved: &Value, index: usize) -> String {
    Hashes::of(version(), case, resolved).analysis(index)
}

/// The hashes of the results of a case.
struct Hashes<'a> {
    /// Whose they are.
    version: &'a str,
    case: &'a Case,
    resolved: &'a Value,
    /// The case without what is asked of it, which all of them have.
    model: Value,
}

impl<'a> Hashes<'a> {
    /// Of the build of this version.
    fn of(version: &'a str, case: &'a Case, resolved: &'a Value) -> Self {
        Self { version, case, resolved, model: model(resolved) }
    }

    /// That of an analysis.
    fn analysis(&self, index: usize) -> String {
        let mut analysis = self.resolved.get("analysis").and_then(|list| list.get(index)).cloned();
        let others = taken_up(self.case, self.resolved, analysis.as_ref());
        if let Some(object) = analysis.as_mut().and_then(Value::as_object_mut) {
            for key in self.case.limits() {
                object.remove(*key);
            }
        }
        if others.is_empty() {
            return content_hash(json!([self.version, self.model, analysis]).to_string().as_bytes());
        }
        content_hash(json!([self.version, self.model, analysis, others]).to_string().as_bytes())
    }

    /// Names all that the values of a sweep depend on: the case without its lists of analyses and sweeps and its title, the sweep, the analyses
    /// that its quantities take, the version.
    fn sweep(&self, sweep: &StudySweep) -> String {
        let of = |quantity: &QuantityPath| match &quantity.source {
            QuantitySource::Analysis { index, .. } => self.resolved["analysis"].get(index).cloned(),
            QuantitySource::Point { .. } => None,
        };
        let analyses: Vec<Value> = sweep.quantities.iter().filter_map(of).collect();
        content_hash(json!([self.version, self.model, sweep.resolved(), analyses]).to_string().as_bytes())
    }
}

/// The other analyses whose results an analysis takes up, as the case describes them.
fn taken_up<'a>(case: &Case, resolved: &'a Value, analysis: Option<&Value>) -> Vec<&'a Value> {
    let name = analysis.and_then(|analysis| analysis["name"].as_str()).unwrap_or_default();
    let names = case.takes_up(name);
    let all = resolved.get("analysis").and_then(Value::as_array).into_iter().flatten();
    all.filter(|other| other["name"].as_str().is_some_and(|name| names.contains(&name))).collect()
}

/// The case without its title and without what is asked of it.
fn model(resolved: &Value) -> Value {
    let mut model = resolved.clone();
    if let Some(object) = model.as_object_mut() {
        for key in ["analysis", "sweep", "title"] {
            object.remove(key);
        }
    }
    model
}
