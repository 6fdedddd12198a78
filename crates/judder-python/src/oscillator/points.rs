//! Operating points over arrays.

use super::keys::AskedOscillator;
use super::map::{MapSide, axis};
use crate::choice::meant;
use crate::errors;
use crate::watched::{Manner, watched};
use judder_keys::keys::Keys;
use judder_models::key_plane::KeyAxis;
use judder_models::oscillator::inputs::OscillatorInputs;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::oscillator::law_name::LawName;
use judder_models::point_arrays::{Doubts, PointArrays, point_arrays, quantities};
use judder_study::model::OperatingQuantity;
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Operating points at values of keys that belong together, all of one length, as a dictionary of arrays and of what is known of them.
#[pyfunction]
#[pyo3(signature = (varied, *, quantities, law, friction_load, threads, progress, keys))]
#[allow(clippy::too_many_arguments, reason = "the arguments of `judder.oscillator.points`")]
pub(crate) fn oscillator_points<'py>(
    py: Python<'py>,
    varied: Vec<MapSide<'py>>,
    quantities: Option<Vec<String>>,
    law: Option<&Bound<'py, PyAny>>,
    friction_load: Option<&str>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
    keys: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let wanted = wanted(quantities)?;
    let mut asked = AskedOscillator::new(law, friction_load)?;
    asked.set(keys.iter())?;
    let axes = varied.iter().map(|side| axis(&side.0, side)).collect::<PyResult<Vec<_>>>()?;
    refuse(&asked, &axes)?;
    let count = axes.first().map_or(1, |axis| axis.values.len());
    let base = asked.case.inputs;
    let inputs = |index: usize| {
        axes.iter().fold(base, |mut inputs: OscillatorInputs, axis| {
            axis.set(&mut inputs, index);
            inputs
        })
    };
    let of_substrate = |axis: &KeyAxis| axis.key.entry().section() == "substrate";
    let checked = if axes.iter().any(of_substrate) { count } else { count.min(1) };
    (0..checked).try_for_each(|index| asked.checked(inputs(index)))?;
    let manner = Manner::new(progress, threads)?;
    let contact = asked.contact(py, &manner)?;
    let done = watched(py, &manner, |watch| point_arrays(&contact.contact, &inputs, count, wanted, watch))?;
    let found = done.settled(|error| errors::model(&error))?;
    let result = told(py, found)?;
    result.set_item("warnings", contact.warnings)?;
    result.set_item("case", asked.told(py))?;
    let about = |axis: KeyAxis| {
        let (entry, units) = (axis.key.entry(), axis.units());
        (entry.path, entry.name(), entry.doc, units, axis.values.into_pyarray(py))
    };
    result.set_item("keys", axes.into_iter().map(about).collect::<Vec<_>>())?;
    Ok(result)
}

/// The quantities of these names; those that need no search where none are named.
fn wanted(names: Option<Vec<String>>) -> PyResult<Vec<OperatingQuantity>> {
    let Some(names) = names else { return Ok(quantities(false)) };
    let all = quantities(true);
    let find = |name: &String| {
        let found = all.iter().find(|own| own.name == name).copied();
        found.ok_or_else(|| {
            let known = meant(name, all.iter().map(|own| own.name));
            errors::input("quantities", format!("there is no `{name}`; {known}"))
        })
    };
    names.iter().map(find).collect()
}

/// Refuses what cannot be varied together, and what another law would belong to at every point.
fn refuse(asked: &AskedOscillator, axes: &[KeyAxis]) -> PyResult<()> {
    let is_varied = |key| axes.iter().any(|axis| axis.key == key);
    if is_varied(OscillatorKey::RetardationTime) && is_varied(OscillatorKey::RelaxationTime) {
        let message = "give the retardation or the relaxation time, not both";
        return Err(errors::input("relaxation_time", message));
    }
    let times = [OscillatorKey::RetardationTime, OscillatorKey::RelaxationTime];
    let twice = |(index, axis): &(usize, &KeyAxis)| axes[..*index].iter().any(|own| own.key == axis.key);
    if let Some((_, axis)) = axes.iter().enumerate().find(twice) {
        return Err(errors::input(axis.key.entry().name(), "is given twice"));
    }
    let changes_law =
        |axis: &&KeyAxis| axis.key.entry().section() == "substrate" && !times.contains(&axis.key);
    match axes.iter().find(changes_law) {
        Some(axis) if asked.case.law == LawName::Bem => {
            let message = "the law `bem` is computed for one substrate, and an array would need one law a point; \
                           a [[sweep]] of a case computes them";
            Err(errors::input(axis.key.entry().name(), message))
        }
        _ => Ok(()),
    }
}

/// The values of the quantities, the eigenvalues, and the doubts.
fn told(py: Python<'_>, found: PointArrays) -> PyResult<Bound<'_, PyDict>> {
    let PointArrays { quantities, values, eigenvalues, failed, beyond } = found;
    let result = PyDict::new(py);
    let column = |index: usize| values.iter().map(|row| row[index]).collect::<Vec<f64>>().into_pyarray(py);
    let columns: Vec<_> = quantities
        .iter()
        .enumerate()
        .map(|(index, own)| (own.name, own.units, own.long_name, own.flags.to_vec(), column(index)))
        .collect();
    result.set_item("quantities", columns)?;
    let (count, flat) = (eigenvalues.len(), eigenvalues.into_iter().flatten().collect::<Vec<_>>());
    result.set_item("eigenvalues", flat.into_pyarray(py).reshape([count, 4])?)?;
    let doubts = |Doubts { count, first }: Doubts| (count, first);
    result.set_item("failed", doubts(failed))?;
    result.set_item("beyond", doubts(beyond))?;
    Ok(result)
}
