//! Studies in memory: what the analyses of a case left, with its arrays for NumPy.

use crate::errors;
use crate::watched::{Manner, Watched, is_ctrl_c, watched};
use judder_store::{Variable, VariableValues};
use judder_study::StudyError;
use judder_study::report::write_copied;
use judder_study::run::{HeldRun, HeldStudy};
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde_json::{Value, json};
use std::path::PathBuf;

/// What the analyses of a case left, in no folder.
#[pyclass(name = "HeldStudy", module = "judder._judder", frozen)]
pub(crate) struct PyHeldStudy(HeldStudy);

#[pymethods]
impl PyHeldStudy {
    /// What `summary.json` of its folder would hold.
    #[getter]
    fn summary(&self) -> PyResult<String> {
        serde_json::to_string(&self.0.summary).map_err(errors::system)
    }

    /// The arrays of an analysis, and what is told of them: JSON, `attributes` and the `variables`, each with `name`, `dimensions`, `attributes` and
    /// whether it `is_coordinate`.
    fn arrays<'py>(&self, py: Python<'py>, name: &str) -> PyResult<(String, Vec<Bound<'py, PyAny>>)> {
        let Some(outcome) = self.0.outcome(name) else { return Err(PyKeyError::new_err(name.to_owned())) };
        let variables = outcome.dataset.variables();
        let told: Vec<Value> = variables
            .iter()
            .map(|own| {
                json!({
                    "name": own.name, "dimensions": own.dimensions, "attributes": own.told(),
                    "is_coordinate": own.is_coordinate,
                })
            })
            .collect();
        let told = json!({ "attributes": outcome.dataset.attributes(), "variables": told });
        let arrays: PyResult<Vec<_>> = variables.iter().map(|own| array(py, own)).collect();
        Ok((told.to_string(), arrays?))
    }

    /// Tables, sounds, laws, fields, by their paths in the folder of a study.
    fn files<'py>(&self, py: Python<'py>) -> Vec<(String, Bound<'py, PyBytes>)> {
        let files = self.0.files().into_iter();
        files.map(|(path, content)| (path, PyBytes::new(py, &content))).collect()
    }

    /// The figures (SVG) by their names.
    fn figures(&self, py: Python<'_>) -> Vec<(String, String)> {
        py.detach(|| self.0.figures())
    }

    /// Writes it into a folder as a run into that folder leaves it, with or without the report.
    fn save(&self, py: Python<'_>, folder: PathBuf, report: bool) -> PyResult<()> {
        let done = watched(py, &Manner::default(), |_| self.0.save(&folder, report))?;
        done.settled(|error| errors::study(&error))
    }
}

/// Completes a copy of a study in its new folder: its report.
#[pyfunction]
pub(crate) fn copied_study(py: Python<'_>, folder: PathBuf) -> PyResult<()> {
    let done = watched(py, &Manner::default(), |_| write_copied(judder_models::REGISTRY, &folder).map(drop))?;
    done.settled(|error| errors::study(&error))
}

/// A run in memory as Python takes it: the study, what has to be known, the analyses that were refused with their errors.
pub(crate) type HeldTold = (PyHeldStudy, Vec<String>, Vec<(String, Py<PyAny>)>);

/// What came of a run in memory; nothing where the case needs a folder.
///
/// # Errors
/// Those of the run; what an interrupted one did is gone.
pub(crate) fn told(
    py: Python<'_>,
    done: Watched<Result<Option<HeldRun>, StudyError>>,
) -> PyResult<Option<HeldTold>> {
    let is_ended = done.stopped.as_ref().is_none_or(|stop| is_ctrl_c(py, stop));
    if matches!(done.result, Err(StudyError::Interrupted)) && is_ended {
        return Err(errors::interrupted(
            "interrupted; nothing is kept of a run in memory: with a folder as `output` the same call goes on from there",
        ));
    }
    let Some(HeldRun { study, messages, refused }) = done.settled(|error| errors::study(&error))? else {
        return Ok(None);
    };
    let refused = refused.into_iter();
    let refused = refused.map(|own| (own.name, errors::study(&own.error).into_value(py).into_any()));
    Ok(Some((PyHeldStudy(study), messages, refused.collect())))
}

/// The values of a variable, copied: what is done with them does not change the study. Words are a list.
fn array<'py>(py: Python<'py>, variable: &Variable) -> PyResult<Bound<'py, PyAny>> {
    match &variable.data {
        VariableValues::F64(values) => shaped(py, values, &variable.shape),
        VariableValues::Complex(values) => shaped(py, values, &variable.shape),
        VariableValues::I64(values) => shaped(py, values, &variable.shape),
        VariableValues::U8(values) => shaped(py, values, &variable.shape),
        VariableValues::Text(values) => values.into_pyobject(py),
    }
}

fn shaped<'py, T: Element + Copy>(
    py: Python<'py>,
    values: &[T],
    shape: &[usize],
) -> PyResult<Bound<'py, PyAny>> {
    Ok(PyArray1::from_slice(py, values).reshape(shape.to_vec())?.into_any())
}
