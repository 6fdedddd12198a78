//! Errors of the crates below as exceptions of `judder.errors`: the same message, the same fields.

mod fields;

use fields::ErrorFields;
use judder_contact::LawError;
use judder_contact::steady::SteadyError;
use judder_examples::ExampleError;
use judder_explorer::ExplorerError;
use judder_keys::cause::Cause;
use judder_keys::error::CaseError;
use judder_models::ModelError;
use judder_oscillator::OscillatorError;
use judder_sliding::SlidingError;
use judder_store::StoreError;
use judder_study::StudyError;
use miette::Diagnostic;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::fmt::{Debug, Display};
use std::io;
use std::path::Path;

/// The name of an error's variant, as its cause.
fn variant(error: &impl Debug) -> String {
    let shown = format!("{error:?}");
    shown.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// The kind of a cause: its variant, or what a part of the case calls it.
fn kind(cause: &Cause) -> String {
    match cause {
        Cause::Problem(problem) => problem.kind().to_owned(),
        _ => variant(cause),
    }
}

/// An exception of `judder.errors`; where that cannot be made, why.
fn exception(
    class: &str,
    message: String,
    cause: &str,
    fields: impl FnOnce(&Bound<'_, PyDict>) -> PyResult<()>,
) -> PyErr {
    Python::attach(|py| {
        let made = || -> PyResult<Bound<'_, PyAny>> {
            let dict = PyDict::new(py);
            fields(&dict)?;
            py.import("judder.errors")?.getattr(class)?.call1((message, cause, dict))
        };
        made().map_or_else(|error| error, PyErr::from_value)
    })
}

/// An exception of this class with the fields that its error tells.
fn told<E: Display + Debug + ErrorFields>(class: &str, error: &E) -> PyErr {
    exception(class, error.to_string(), &variant(error), |dict| error.put(dict))
}

/// An argument that cannot be.
pub(crate) fn input(argument: &str, message: impl Display) -> PyErr {
    of_argument("InputError", argument, message)
}

/// An argument of a type that it cannot have.
pub(crate) fn argument(argument: &str, message: impl Display) -> PyErr {
    of_argument("ArgumentError", argument, message)
}

fn of_argument(class: &str, argument: &str, message: impl Display) -> PyErr {
    exception(class, format!("{argument}: {message}"), "Input", |dict| dict.set_item("argument", argument))
}

/// The system does not give what a call needs.
pub(crate) fn system(error: impl Display) -> PyErr {
    exception("SystemRefusal", error.to_string(), "System", |_| Ok(()))
}

/// A file that the system does not read or write: an `OSError` too, with number and path.
pub(crate) fn file(path: &Path, error: &io::Error) -> PyErr {
    let class = match error.kind() {
        io::ErrorKind::NotFound => "MissingFileError",
        _ => "FileError",
    };
    exception(class, format!("{}: {error}", path.display()), "File", |dict| {
        dict.set_item("path", path)?;
        dict.set_item("number", error.raw_os_error())
    })
}

/// What has to be known before a result is trusted.
pub(crate) fn warn(py: Python<'_>, message: &str) -> PyResult<()> {
    py.import("judder._warned")?.call_method1("warn", (message,)).map(|_| ())
}

/// An example that there is not, or that cannot be written.
pub(crate) fn example(error: &ExampleError) -> PyErr {
    match error {
        ExampleError::Unknown { .. } => input("name", error),
        error => told("StoreError", error),
    }
}

/// A page that cannot be served.
pub(crate) fn explorer(error: &ExplorerError) -> PyErr {
    match error {
        ExplorerError::Case(error) => case(error),
        ExplorerError::Study(error) => study(error),
        ExplorerError::Bind { .. } => input("port", error),
        error => system(error),
    }
}

/// A fault of judder itself.
pub(crate) fn fault() -> PyErr {
    let message =
        "judder has failed at something that it should have refused: please report what you asked for";
    exception("FaultError", message.to_owned(), "Fault", |_| Ok(()))
}

/// A case that is wrong, with its place.
pub(crate) fn case(error: &CaseError) -> PyErr {
    let place = error.line_and_column();
    exception("CaseError", error.to_string(), &kind(error.cause()), |dict| {
        dict.set_item("file", error.source_name())?;
        dict.set_item("line", place.map(|(line, _)| line))?;
        dict.set_item("column", place.map(|(_, column)| column))?;
        dict.set_item("text", error.place())?;
        dict.set_item("key", error.key())?;
        dict.set_item("help", error.help().map(|help| help.to_string()))?;
        dict.set_item("others", error.others().iter().map(ToString::to_string).collect::<Vec<String>>())
    })
}

/// An oscillator without an answer.
pub(crate) fn oscillator(error: &OscillatorError) -> PyErr {
    told("OscillatorError", error)
}

/// A pair of structures without an answer.
pub(crate) fn sliding(error: &SlidingError) -> PyErr {
    told("SlidingError", error)
}

/// A contact without an answer.
pub(crate) fn contact(error: &SteadyError) -> PyErr {
    told("ContactError", error)
}

/// A law that cannot be.
pub(crate) fn law(error: &LawError) -> PyErr {
    told("LawError", error)
}

/// A study folder that cannot be written or read.
pub(crate) fn store(error: &StoreError) -> PyErr {
    told("StoreError", error)
}

/// A study without a result: the error of the crate that it comes from, where there is one.
pub(crate) fn study(error: &StudyError) -> PyErr {
    match (error, ModelError::of(error)) {
        (_, Some(error)) => model(error),
        (StudyError::Case(error), _) => case(error),
        (StudyError::Store(error), _) => store(error),
        (StudyError::Interrupted, _) => interrupted(&error.to_string()),
        _ => told("StudyError", error),
    }
}

/// An analysis without a result: the error of the crate that it comes from, where there is one.
pub(crate) fn model(error: &ModelError) -> PyErr {
    match error {
        ModelError::Study(error) => study(error),
        ModelError::Oscillator(error) => oscillator(error),
        ModelError::Sliding(error) => sliding(error),
        ModelError::Contact(error) => contact(error),
        ModelError::Law(error) => law(error),
        ModelError::Interrupted => interrupted(&error.to_string()),
        ModelError::Structure(_) => told("StructureError", error),
        ModelError::Material(_)
        | ModelError::Indenter(_)
        | ModelError::Cylinder(_)
        | ModelError::Periodic(_)
        | ModelError::Transient(_) => told("ContactError", error),
        _ => told("StudyError", error),
    }
}

/// Ctrl-C, where what was done is kept.
pub(crate) fn interrupted(message: &str) -> PyErr {
    Python::attach(|py| {
        let made = || py.import("judder.errors")?.getattr("Interrupted")?.call1((message,));
        made().map_or_else(|error| error, PyErr::from_value)
    })
}
