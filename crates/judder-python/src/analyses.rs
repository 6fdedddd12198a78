//! The models, and one more analysis of a case.

use crate::cases::CaseSource;
use crate::errors;
use crate::held::{self, HeldTold};
use crate::signatures::{Callable, classes};
use crate::watched::{Manner, watched};
use judder_keys::cause::Cause;
use judder_study::StudyError;
use judder_study::case::anywhere::anywhere;
use judder_study::case::compose::joined_by;
use judder_study::case::file::CaseFile;
use judder_study::run::{HeldRun, RefusedAnalysis, RunOptions, compute, hold};
use pyo3::prelude::*;
use serde_json::Value as Json;
use std::path::PathBuf;

/// The classes of the models and their methods, each with its name, what it is `of`, its docs, and its parameters: a name, that of its key,
/// its type, whether it must be given. JSON.
#[pyfunction]
pub(crate) fn declared_models() -> String {
    Json::from(classes().iter().map(Callable::document).collect::<Vec<_>>()).to_string()
}

/// A case, the model that it must be of, and what is changed in it.
type GivenCase = (CaseSource, String, Vec<String>);

/// The case, where it is of the model.
fn read(given: &GivenCase) -> Result<CaseFile, StudyError> {
    let (case, model, overrides) = given;
    let file = case.parse(overrides)?;
    if file.case.model() == model {
        return Ok(file);
    }
    let (name, known) = (file.case.model().to_owned(), vec![model.clone()]);
    Err(file.error("model", Cause::UnknownName { what: "model", name, known }).into())
}

/// What errors call the keys of an analysis that a function was given.
const ARGUMENT: &str = "argument";

/// One more analysis beside those of a case, which is in order, and the name of it.
fn joined(given: &GivenCase, kind: &str, keys: &str) -> Result<(CaseFile, String), StudyError> {
    joined_by(&read(given)?, kind, keys).map_err(|error| error.called(ARGUMENT).into())
}

/// An error of the analysis of this name as one of arguments; any other as it is.
fn of_arguments(error: StudyError, name: &str) -> StudyError {
    match error {
        StudyError::Case(error) if error.key().is_some_and(|key| is_below(&key, name)) => {
            error.called(ARGUMENT).into()
        }
        error => error,
    }
}

/// The same of why an analysis has no result.
fn refused_arguments(refused: RefusedAnalysis, name: &str) -> RefusedAnalysis {
    RefusedAnalysis { error: of_arguments(refused.error, name), ..refused }
}

/// Whether a dotted key is of the analysis of this name.
fn is_below(key: &str, name: &str) -> bool {
    let own = key.strip_prefix("analysis.").and_then(|key| key.strip_prefix(name));
    own.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

/// The text of a case that runs wherever it lies.
#[pyfunction]
pub(crate) fn text_of_case(py: Python<'_>, case: GivenCase) -> PyResult<String> {
    let done = watched(py, &Manner::default(), |_| Ok(anywhere(&read(&case)?)?.source.text))?;
    done.settled(|error| errors::study(&error))
}

/// Computes an analysis of this kind and with these keys, TOML, beside those of a case, in memory; gives back its name and what came of it, which is
/// nothing where it needs a folder.
#[pyfunction]
#[pyo3(signature = (case, kind, keys, *, threads, progress))]
pub(crate) fn held_analysis(
    py: Python<'_>,
    case: GivenCase,
    kind: &str,
    keys: &str,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, Option<HeldTold>)> {
    let manner = Manner::new(progress, threads)?;
    let mut own = String::new();
    let done = watched(py, &manner, |watch| {
        let (file, name) = joined(&case, kind, keys)?;
        own.clone_from(&name);
        let held = hold(&file, &RunOptions { only: vec![name], ..RunOptions::default() }, watch);
        held.map_err(|error| of_arguments(error, &own)).map(|held| {
            held.map(|run| HeldRun {
                refused: run.refused.into_iter().map(|refused| refused_arguments(refused, &own)).collect(),
                ..run
            })
        })
    })?;
    Ok((own, held::told(py, done)?))
}

/// Computes an analysis of this kind and with these keys, TOML, beside those of a case, and of those what it takes up, into a folder.
///
/// Gives back the name of the analysis, and what has to be known of it.
#[pyfunction]
#[pyo3(signature = (case, kind, keys, *, folder, threads, progress))]
pub(crate) fn computed_analysis(
    py: Python<'_>,
    case: GivenCase,
    kind: &str,
    keys: &str,
    folder: PathBuf,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, Vec<String>)> {
    let manner = Manner::on_threads_of_its_own(progress, threads)?;
    let done = watched(py, &manner, |watch| {
        let (file, name) = joined(&case, kind, keys)?;
        let only = file.case.takes_up(&name).into_iter().chain([name.as_str()]).map(str::to_owned).collect();
        let computed = compute(&file, &folder, &RunOptions { only, ..RunOptions::default() }, watch);
        let computed = computed.map_err(|error| of_arguments(error, &name))?;
        match computed.refused.into_iter().next() {
            Some(refused) => Err(refused_arguments(refused, &name).error),
            None => Ok((name, computed.messages)),
        }
    })?;
    done.settled(|error| errors::study(&error))
}
