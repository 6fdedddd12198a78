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
use judder_study::run::{RunOptions, compute, hold};
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
        let (file, name) = joined_by(&read(&case)?, kind, keys)?;
        own.clone_from(&name);
        hold(&file, &RunOptions { only: vec![name], ..RunOptions::default() }, watch)
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
        let (file, name) = joined_by(&read(&case)?, kind, keys)?;
        let only = file.case.takes_up(&name).into_iter().chain([name.as_str()]).map(str::to_owned).collect();
        let computed = compute(&file, &folder, &RunOptions { only, ..RunOptions::default() }, watch)?;
        Ok((name, computed))
    })?;
    let (name, computed) = done.settled(|error| errors::study(&error))?;
    match computed.refused.first() {
        Some(refused) => Err(errors::study(&refused.error)),
        None => Ok((name, computed.messages)),
    }
}
