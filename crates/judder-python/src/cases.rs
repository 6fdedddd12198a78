//! Whole cases: run, check, the command.

use crate::contact::PyLaw;
use crate::errors;
use crate::held::{self, HeldTold};
use crate::watched::{Manner, is_ctrl_c, watched};
use judder_contact::law::file::to_json;
use judder_keys::error::CaseError;
use judder_models::oscillator::case::OscillatorCase;
use judder_study::case::file::CaseFile;
use judder_study::resolve::resolve;
use judder_study::run::{RunOptions, RunReport, hold, run};
use judder_study::{StudyError, home};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// The file in a study folder that holds a law that came from Python.
const LAW_FILE: &str = "law.json";
/// A law that asks nothing of the substrate, in the place of the one that is put there.
const STAND_IN: &str = "contact.law=hertz";

/// A case: its text with a name, or the path of its file.
#[derive(FromPyObject)]
pub(crate) enum CaseSource {
    Text(String, String),
    File(PathBuf),
}

impl CaseSource {
    pub(crate) fn parse(&self, overrides: &[String]) -> Result<CaseFile, CaseError> {
        match self {
            Self::Text(name, text) => judder_models::parse(name, text, overrides),
            Self::File(path) => judder_models::read(path, overrides),
        }
    }

    /// Reads the case with the changes applied.
    pub(crate) fn read(&self, overrides: &[String]) -> PyResult<CaseFile> {
        self.parse(overrides).map_err(|error| errors::case(&error))
    }
}

/// The name of a case, its text, what is changed in it, and the files that it names: all that another machine needs.
pub(crate) type CasePackage = (String, String, Vec<String>, Vec<(String, PathBuf)>);

/// The package of a case.
pub(crate) fn package_of(file: &CaseFile) -> CasePackage {
    let files = file.case.files().into_iter().map(|named| (named.given.clone(), named.path.clone()));
    (format!("{}.toml", file.name), file.text.clone(), file.overrides.clone(), files.collect())
}

/// What `judder check --json` prints, as a text.
#[pyfunction]
pub(crate) fn checked_case(py: Python<'_>, case: CaseSource, overrides: Vec<String>) -> PyResult<String> {
    let file = case.read(&overrides)?;
    let done = watched(py, &Manner::default(), |watch| resolve(&file, watch))?;
    Ok(done.settled(|error| errors::study(&error))?.json().to_string())
}

/// Runs a case into a study folder; says what came of it as a dictionary.
#[pyfunction]
#[pyo3(signature = (case, *, output, only, overrides, fresh, law, threads, progress, report))]
#[allow(clippy::too_many_arguments, reason = "the arguments of `judder.run`")]
pub(crate) fn run_case<'py>(
    py: Python<'py>,
    case: CaseSource,
    output: Option<PathBuf>,
    only: Vec<String>,
    overrides: Vec<String>,
    fresh: bool,
    law: Option<PyRef<'py, PyLaw>>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
    report: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let manner = Manner::on_threads_of_its_own(progress, threads)?;
    let GivenRun { file, files, _beside } = GivenRun::new(&case, overrides, law.as_deref())?;
    let options = RunOptions { only, fresh, files, without_report: !report, ..RunOptions::default() };
    // files that the case names may be large
    let done = watched(py, &manner, |watch| run(&file, &folder_of(&file, output, fresh)?, &options, watch))?;
    if matches!(done.result, Err(StudyError::Interrupted))
        && done.stopped.as_ref().is_none_or(|stop| is_ctrl_c(py, stop))
    {
        return Err(errors::interrupted(&StudyError::Interrupted.to_string()));
    }
    told(py, done.settled(|error| errors::study(&error))?)
}

/// Runs a case in memory, of which the results may take so many bytes; nothing where it needs a folder.
#[pyfunction]
#[pyo3(signature = (case, *, only, overrides, law, memory, threads, progress))]
#[allow(clippy::too_many_arguments, reason = "the arguments of `judder.run`")]
pub(crate) fn held_case(
    py: Python<'_>,
    case: CaseSource,
    only: Vec<String>,
    overrides: Vec<String>,
    law: Option<PyRef<'_, PyLaw>>,
    memory: u64,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Option<HeldTold>> {
    let manner = Manner::new(progress, threads)?;
    let GivenRun { file, files, _beside } = GivenRun::new(&case, overrides, law.as_deref())?;
    let options = RunOptions { only, files, most_held: Some(memory), ..RunOptions::default() };
    held::told(py, watched(py, &manner, |watch| hold(&file, &options, watch))?)
}

/// A case that is to run, with a law in place of its own where one is given.
struct GivenRun {
    file: CaseFile,
    /// What the study keeps beside its results.
    files: Vec<(String, Vec<u8>)>,
    /// Where the law lies until the study keeps it.
    _beside: Option<TempDir>,
}

impl GivenRun {
    fn new(case: &CaseSource, overrides: Vec<String>, law: Option<&PyLaw>) -> PyResult<Self> {
        let Some(law) = law else {
            return Ok(Self { file: case.read(&overrides)?, files: Vec::new(), _beside: None });
        };
        let beside = tempfile::tempdir().map_err(errors::system)?;
        let (file, content) = with_law_in(beside.path(), case, overrides, law)?;
        Ok(Self { file, files: vec![(LAW_FILE.to_owned(), content.into_bytes())], _beside: Some(beside) })
    }
}

/// Where a run of a case goes: where it is told to; else a case file as it is to its own folder, and any other case, of which a program may have many, to
/// one that no other case has.
pub(crate) fn folder_of(
    file: &CaseFile,
    output: Option<PathBuf>,
    fresh: bool,
) -> Result<PathBuf, StudyError> {
    match output {
        Some(output) => Ok(output),
        None if file.path.is_some() && file.overrides.is_empty() => home::of_file(file, fresh),
        None => home::of_content(file),
    }
}

/// A case with a law in the place of its own, as a file of a folder that is no study; gives back the content of the file, too.
pub(crate) fn with_law_in(
    folder: &Path,
    case: &CaseSource,
    overrides: Vec<String>,
    law: &PyLaw,
) -> PyResult<(CaseFile, String)> {
    let path = folder.join(LAW_FILE);
    let text = lawful(case, &overrides, law)?;
    fs::write(&path, &text).map_err(|error| errors::file(&path, &error))?;
    Ok((with_law_file(case, overrides, &path)?, text))
}

/// The file of a law that a case can take.
fn lawful(case: &CaseSource, overrides: &[String], law: &PyLaw) -> PyResult<String> {
    match case.parse(overrides) {
        Ok(CaseFile { case, .. }) if case.of::<OscillatorCase>().is_some() => {}
        Ok(CaseFile { case, .. }) => {
            return Err(errors::input("law", format!("a case of model `{}` takes none", case.model())));
        }
        // it may lack nothing but a law
        Err(error) => {
            let overrides = [overrides, &[STAND_IN.to_owned()]].concat();
            case.parse(&overrides).map_err(|_| errors::case(&error))?;
        }
    }
    let text = to_json(law.law()).map_err(|error| errors::law(&error))?;
    text.ok_or_else(|| {
        errors::input("law", "a law that has a name goes into the case: set={\"contact.law\": name}")
    })
}

/// A case with the law in a file; wherever that lies, the case calls it by the same name.
fn with_law_file(case: &CaseSource, mut overrides: Vec<String>, path: &Path) -> PyResult<CaseFile> {
    let of_file = |path: &str| format!("contact.law={{ file = {} }}", serde_json::Value::from(path));
    let path = std::path::absolute(path).map_err(errors::system)?;
    overrides.push(of_file(&path.to_string_lossy()));
    let mut file = case.read(&overrides)?;
    if let Some(OscillatorCase { law_file: Some(law), .. }) = file.case.of_mut() {
        LAW_FILE.clone_into(&mut law.given);
    }
    if let Some(last) = file.source.overrides.last_mut() {
        *last = of_file(LAW_FILE);
    }
    Ok(file)
}

fn told(py: Python<'_>, report: RunReport) -> PyResult<Bound<'_, PyDict>> {
    let told = PyDict::new(py);
    told.set_item("folder", report.folder)?;
    told.set_item("complete", report.complete)?;
    told.set_item("skipped", report.skipped)?;
    told.set_item("messages", report.messages)?;
    told.set_item("notes", report.notes)?;
    let refused: Vec<(String, Py<PyAny>)> = report
        .refused
        .into_iter()
        .map(|refused| (refused.name, errors::study(&refused.error).into_value(py).into_any()))
        .collect();
    told.set_item("refused", refused)?;
    Ok(told)
}

/// The command `judder`: does what the words say and returns the exit code.
#[pyfunction]
pub(crate) fn command(py: Python<'_>, words: Vec<OsString>) -> u8 {
    py.detach(|| judder_cli::main_with(words))
}
