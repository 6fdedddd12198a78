//! A choice of a few words.

use crate::errors;
use judder_keys::nearest::nearest;
use pyo3::PyResult;

/// The choice of this name.
pub(crate) fn named<T: Copy>(argument: &str, name: &str, all: &[(&'static str, T)]) -> PyResult<T> {
    all.iter().find(|(known, _)| *known == name).map(|(_, choice)| *choice).ok_or_else(|| {
        let known = meant(name, all.iter().map(|(known, _)| *known));
        errors::input(argument, format!("`{name}` is not known; {known}"))
    })
}

/// Which known word an unknown one is like, and all that are known.
pub(crate) fn meant<'a>(unknown: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<String> = known.map(str::to_owned).collect();
    let near = nearest(unknown, &known).map(|near| format!("is `{near}` meant? "));
    format!("{}known are {}", near.unwrap_or_default(), known.join(", "))
}
