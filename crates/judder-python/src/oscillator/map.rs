//! A plane of operating points.

use super::keys::{AskedOscillator, key};
use crate::arrays;
use crate::choice::named;
use crate::errors;
use crate::watched::{Manner, watched};
use judder_keys::keys::{Given, Keys};
use judder_keys::numeric_key::Form;
use judder_keys::quantity::Quantity;
use judder_models::key_plane::{KeyAxis, KeyPlane};
use judder_models::oscillator::keys::OscillatorKey;
use judder_oscillator::Contact;
use judder_oscillator::map::{DecisionMethod, OperatingPlane, StabilityMap, TILE_ROWS};
use judder_study::{Progress, StudyError};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::time::Instant;

/// Points that are decided between two looks at Ctrl-C.
const STRETCH: usize = 1 << 22;

/// A key, its values, and their unit where they have one.
pub(super) type MapSide<'py> = (String, Bound<'py, PyAny>, Option<String>);

/// A key with values of its range.
pub(super) fn axis(argument: &str, side: &MapSide<'_>) -> PyResult<KeyAxis> {
    let (name, values, unit) = side;
    let key = key(name)?;
    let values = arrays::vector(argument, values)?;
    let (form, values) = match unit {
        None => (key.read(Given::Number(values[0])).map_err(|error| errors::case(&error))?.form, values),
        Some(unit) => (Form::Si, in_si(key, argument, unit, &values)?),
    };
    let range = key.entry().rule.range;
    match values.iter().position(|value| !range.contains(*value)) {
        Some(index) => {
            let message =
                format!("value {index} of {} is {}; it must be {range}", key.entry().path, values[index]);
            Err(errors::input(argument, message))
        }
        None => Ok(KeyAxis { key, form, values }),
    }
}

/// Values of this unit in SI units.
fn in_si(key: OscillatorKey, argument: &str, unit: &str, values: &[f64]) -> PyResult<Vec<f64>> {
    let expected = key.entry().rule.dimension;
    let quantity = Quantity::parse(&format!("1 {unit}"));
    let quantity =
        quantity.map_err(|(problem, _)| errors::input(argument, format!("{problem}: `{unit}`")))?;
    if quantity.dimension != expected || expected.is_number() {
        let message = format!("`{unit}` is no unit of {}, which is {expected}", key.entry().path);
        return Err(errors::input(argument, message));
    }
    Ok(values.iter().map(|value| value * quantity.number).collect())
}

/// Verdict and growth rate over two keys, as a dictionary of arrays (rows along y) and of what is known of them.
#[pyfunction]
#[pyo3(signature = (x, y, *, method, growth_rate, law, friction_load, threads, progress, keys))]
#[allow(clippy::too_many_arguments, reason = "the arguments of `judder.oscillator.stability_map`")]
pub(crate) fn oscillator_map<'py>(
    py: Python<'py>,
    x: MapSide<'py>,
    y: MapSide<'py>,
    method: &str,
    growth_rate: bool,
    law: Option<&Bound<'py, PyAny>>,
    friction_load: Option<&str>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
    keys: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let method = named(
        "method",
        method,
        &[("every-point", DecisionMethod::EveryPoint), ("adaptive", DecisionMethod::Adaptive)],
    )?;
    let mut asked = AskedOscillator::new(law, friction_load)?;
    asked.set(keys.iter())?;
    let (x, y) = (axis("x", &x)?, axis("y", &y)?);
    if x.key == y.key {
        return Err(errors::input("y", "both sides vary the same key"));
    }
    let plane = KeyPlane { inputs: asked.case.inputs, x, y };
    for (column, row) in
        [(0, 0), (plane.columns() - 1, 0), (0, plane.rows() - 1), (plane.columns() - 1, plane.rows() - 1)]
    {
        asked.checked(plane.inputs(column, row))?;
    }
    let manner = Manner::new(progress, threads)?;
    let contact = asked.contact(py, &manner)?;
    let done = watched(py, &manner, |watch| {
        let start = Instant::now();
        let made = decided(&contact.contact, &plane, method, growth_rate, watch)?;
        Ok((made, start.elapsed().as_secs_f64()))
    })?;
    let (Decided { map, growth, within_law }, seconds) =
        done.settled(|error: StudyError| errors::study(&error))?;
    let shape = [map.rows, map.columns];
    let result = PyDict::new(py);
    result.set_item("decisions", map.decisions)?;
    result.set_item("seconds", seconds)?;
    result.set_item("classes", map.classes.into_pyarray(py).reshape(shape)?)?;
    let growth = growth.map(|growth| growth.into_pyarray(py).reshape(shape)).transpose()?;
    result.set_item("growth_rate", growth)?;
    let within_law = within_law.map(|codes| codes.into_pyarray(py).reshape(shape)).transpose()?;
    result.set_item("within_law", within_law)?;
    result.set_item("warnings", contact.warnings)?;
    result.set_item("case", asked.told(py))?;
    for (name, axis) in [("x", plane.x), ("y", plane.y)] {
        let entry = axis.key.entry();
        let unit = axis.units();
        let about = (entry.path, entry.name(), axis.values.into_pyarray(py), entry.doc, unit);
        result.set_item(name, about)?;
    }
    Ok(result)
}

/// A map with what was asked for besides.
struct Decided {
    map: StabilityMap,
    growth: Option<Vec<f64>>,
    /// `None` for a formula.
    within_law: Option<Vec<u8>>,
}

/// The map, stretch by stretch where every point is decided, what the errors of the law leave of it, and the growth rates.
fn decided(
    contact: &Contact,
    plane: &KeyPlane,
    method: DecisionMethod,
    wants_growth: bool,
    progress: &dyn Progress,
) -> Result<Decided, StudyError> {
    let (columns, rows) = (plane.columns(), plane.rows());
    let band = (STRETCH / columns).next_multiple_of(TILE_ROWS).max(TILE_ROWS);
    let map = if method == DecisionMethod::Adaptive || rows <= band {
        plane.decide(contact, method).0
    } else {
        progress.begin("verdicts", rows.div_ceil(band));
        let mut classes = Vec::with_capacity(columns * rows);
        for values in plane.y.values.chunks(band) {
            if progress.interrupted() {
                return Err(StudyError::Interrupted);
            }
            let y = KeyAxis { values: values.to_vec(), ..plane.y.clone() };
            classes.extend(KeyPlane { y, ..plane.clone() }.decide(contact, method).0.classes);
            progress.advance();
        }
        progress.end();
        StabilityMap { columns, rows, classes, decisions: columns * rows }
    };
    let within_law = if contact.law.is_formula() {
        None
    } else {
        let codes = plane.within_law(contact, &map, DecisionMethod::Adaptive, &|| progress.interrupted());
        Some(codes.ok_or(StudyError::Interrupted)?)
    };
    if !wants_growth {
        return Ok(Decided { map, growth: None, within_law });
    }
    progress.begin("growth rates", rows);
    let growth = plane.growth_rates(contact, progress)?;
    progress.end();
    Ok(Decided { map, growth: Some(growth), within_law })
}
