//! Classes that say of wrong arguments what functions say.

use pyo3::PyTypeInfo;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// An instance as its static method `_new` makes it: `judder._arguments` has a hand in methods, and can have none in a constructor.
pub(crate) fn constructed<'py, C: PyTypeInfo>(
    py: Python<'py>,
    given: &Bound<'py, PyTuple>,
    named: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    py.get_type::<C>().getattr("_new")?.call(given, named)
}
