//! What a run is asked for, and under which hash each result of it stands.

use super::RunOptions;
use crate::case::file::CaseFile;
use crate::case::study_sweep::StudySweep;
use crate::case::study_sweep::quantity_path::QuantitySource;
use crate::error::StudyError;
use crate::input_file::KnownFile;
use crate::model::Case;
use crate::sweep::SweepPlan;
use crate::version::version;
use judder_store::{StudyFolder, content_hash, read_small_file};
use serde_json::{Value, json};

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
        let hashed =
            |(index, name): (usize, &String)| (name.clone(), analysis_hash(&file.case, &resolved, index));
        let analyses = names.iter().enumerate().map(hashed).collect();
        let sweeps = file.sweeps.iter().map(|sweep| sweep_hash(&resolved, sweep)).collect();
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
        let names = self.analyses.iter().enumerate();
        let hashed = names.map(|(index, (name, _))| {
            (name, analysis_hash_by(version, &self.file.case, &self.resolved, index))
        });
        hashed
            .filter(|(name, hash)| dropped.iter().any(|(own, of)| own == *name && of == hash))
            .map(|(name, _)| name.clone())
            .collect()
    }

    /// The names that are wanted, analyses first.
    pub(super) fn wanted(&self) -> Vec<String> {
        self.all().map(|(name, _)| name).filter(|name| self.is_wanted(name)).cloned().collect()
    }

    /// The plans of the wanted sweeps.
    ///
    /// # Errors
    /// As of [`SweepPlan::new`].
    pub(super) fn plans(&self) -> Result<Vec<SweepPlan>, StudyError> {
        let sweeps = self.file.sweeps.iter().zip(&self.sweeps);
        let wanted = sweeps.filter(|(sweep, _)| self.is_wanted(&sweep.name));
        wanted.map(|(sweep, hash)| SweepPlan::new(self.file, sweep, hash, &self.files)).collect()
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
    analysis_hash_by(version(), case, resolved, index)
}

/// The same hash as another build has it.
fn analysis_hash_by(version: &str, case: &Case, resolved: &Value, index: usize) -> String {
    let model = model(resolved);
    let mut analysis = resolved.get("analysis").and_then(|list| list.get(index)).cloned();
    let others = taken_up(case, resolved, analysis.as_ref());
    if let Some(object) = analysis.as_mut().and_then(Value::as_object_mut) {
        for key in case.limits() {
            object.remove(*key);
        }
    }
    if others.is_empty() {
        return content_hash(json!([version, model, analysis]).to_string().as_bytes());
    }
    content_hash(json!([version, model, analysis, others]).to_string().as_bytes())
}

/// The other analyses whose results an analysis takes up, as the case describes them.
fn taken_up<'a>(case: &Case, resolved: &'a Value, analysis: Option<&Value>) -> Vec<&'a Value> {
    let name = analysis.and_then(|analysis| analysis["name"].as_str()).unwrap_or_default();
    let names = case.takes_up(name);
    let all = resolved.get("analysis").and_then(Value::as_array).into_iter().flatten();
    all.filter(|other| other["name"].as_str().is_some_and(|name| names.contains(&name))).collect()
}

/// Names all that the values of a sweep depend on: the case without its lists of analyses and sweeps and its title, the sweep, the analyses
/// that its quantities take, the version.
fn sweep_hash(resolved: &Value, sweep: &StudySweep) -> String {
    let model = model(resolved);
    let of = |quantity: &crate::case::study_sweep::quantity_path::QuantityPath| match &quantity.source {
        QuantitySource::Analysis { index, .. } => resolved["analysis"].get(index).cloned(),
        QuantitySource::Point { .. } => None,
    };
    let analyses: Vec<Value> = sweep.quantities.iter().filter_map(of).collect();
    content_hash(json!([version(), model, sweep.resolved(), analyses]).to_string().as_bytes())
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
