//! Eigenvalues of the pair against the position of the contact.

use super::pair::PyPair;
use crate::arrays;
use crate::choice::named;
use crate::errors;
use crate::watched::{Manner, watched};
use judder_sliding::locus::{Conditions, Configuration, Locus, LocusSettings, locus_until};
use judder_study::Progress;
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Branches, zones and normal forces, as a dictionary.
#[pyfunction]
#[pyo3(signature = (pair, positions, *, count, velocity, load, configuration, damped, threads))]
#[allow(clippy::too_many_arguments, reason = "the arguments of `judder.sliding.locus`")]
pub(crate) fn sliding_locus<'py>(
    py: Python<'py>,
    pair: PyRef<'py, PyPair>,
    positions: &Bound<'py, PyAny>,
    count: usize,
    velocity: Option<f64>,
    load: Option<f64>,
    configuration: &str,
    damped: bool,
    threads: Option<usize>,
) -> PyResult<Bound<'py, PyDict>> {
    let pair: &PyPair = &pair;
    let number = |name: &str, given: Option<f64>, known: Option<f64>| {
        let number =
            given.or(known).ok_or_else(|| errors::input(name, "a pair that comes from no case needs it"))?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(errors::input(name, format!("{number} must be finite")))
        }
    };
    let conditions = Conditions {
        configuration: named("configuration", configuration, &Configuration::ALL)?,
        is_damped: damped,
        velocity: number("velocity", velocity, pair.motion.map(|motion| motion.velocity))?,
        load: number("load", load, pair.motion.map(|motion| motion.load))?,
    };
    let positions = arrays::vector("positions", positions)?;
    let settings = LocusSettings { conditions, count, positions };
    let manner = Manner::new(None, threads)?;
    let done = watched(py, &manner, |watch| locus_until(&pair.pair, &settings, &|| watch.interrupted()))?;
    told(py, done.settled(|error| errors::sliding(&error))?)
}

fn told(py: Python<'_>, locus: Locus) -> PyResult<Bound<'_, PyDict>> {
    let result = PyDict::new(py);
    let rows = locus.positions.len();
    let branches = locus.followed.eigenvalues.first().map_or(0, Vec::len);
    let eigenvalues = locus.followed.eigenvalues.concat();
    result.set_item("positions", locus.positions.into_pyarray(py))?;
    result.set_item("eigenvalues", eigenvalues.into_pyarray(py).reshape([rows, branches])?)?;
    result.set_item("normal_force", locus.normal_forces.into_pyarray(py))?;
    let zones: Vec<_> = locus
        .followed
        .zones
        .iter()
        .map(|zone| {
            let ends = (zone.ends[0].name(), zone.ends[1].name());
            (zone.from, zone.to, ends, zone.peak, zone.growth_rate, zone.frequency_hz)
        })
        .collect();
    result.set_item("zones", zones)?;
    Ok(result)
}
