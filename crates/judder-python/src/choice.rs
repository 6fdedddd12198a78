//! A choice of a few words.

use crate::errors;
use pyo3::PyResult;

/// The choice of this name.
pub(crate) fn named<T: Copy>(argument: &str, name: &str, all: &[(&'static str, T)]) -> PyResult<T> {
    all.iter().find(|(known, _)| *known == name).map(|(_, choice)| *choice).ok_or_else(|| {
        let known: Vec<&str> = all.iter().map(|(known, _)| *known).collect();
        errors::input(argument, format!("`{name}` is not known; known are {}", known.join(", ")))
    })
}
