//! The contact of steady sliding, computed.

use crate::arrays;
use crate::choice::named;
use crate::errors;
use crate::watched::{Manner, watched};
use judder_contact::indenter::{HeightMap, IndenterShape};
use judder_contact::kernel::layer::BondedLayer;
use judder_contact::law::{LawMaterial, LawTerm};
use judder_contact::steady::refinement::ErrorEstimate;
use judder_contact::steady::{GridChoice, SteadyContact, SteadyQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The indenter: a name, or heights with their spacing.
#[derive(FromPyObject)]
pub(crate) enum Indenter<'py> {
    Name(String),
    Heights(Bound<'py, PyAny>, f64),
}

/// Force, area, friction, depth with their errors, and the fields on the finest grid, as a dictionary.
#[pyfunction]
#[pyo3(signature = (velocity, *, indentation, load, modulus_ratio, terms, layer, shape, accuracy, cells, memory))]
#[allow(clippy::too_many_arguments, reason = "the arguments of `judder.contact.solve`")]
pub(crate) fn contact_solution<'py>(
    py: Python<'py>,
    velocity: f64,
    indentation: Option<f64>,
    load: Option<f64>,
    modulus_ratio: f64,
    terms: Vec<(f64, f64)>,
    layer: Option<(f64, f64)>,
    shape: Indenter<'py>,
    accuracy: f64,
    cells: Option<usize>,
    memory: u64,
) -> PyResult<Bound<'py, PyDict>> {
    let loading = match (indentation, load) {
        (Some(depth), None) => Loading::Indentation(positive("indentation", depth)?),
        (None, Some(force)) => Loading::Load(positive("load", force)?),
        _ => return Err(errors::input("indentation", "give either an indentation or a load")),
    };
    let velocity = positive("velocity", velocity)?;
    let terms =
        terms.into_iter().map(|(retardation_time, compliance)| LawTerm { retardation_time, compliance });
    let material = LawMaterial { modulus_ratio, terms: terms.collect() };
    let material = material.checked().map_err(|error| errors::law(&error))?;
    let profile = profile(shape)?;
    let substrate = match layer {
        Some(layer) => material.sliding(velocity).as_layer(bonded(layer, &profile, loading)?),
        None => material.sliding(velocity),
    };
    let question = SteadyQuestion {
        substrate: &substrate,
        profile: &profile,
        loading,
        accuracy,
        grid: cells.map_or(GridChoice::Automatic, GridChoice::Cells),
        limits: UnilateralLimits::default(),
        memory,
    };
    let done = watched(py, &Manner::default(), |_| solve(&question))?;
    let contact = done.settled(|error| errors::contact(&error))?;
    answer(py, &contact)
}

fn positive(name: &str, value: f64) -> PyResult<f64> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(errors::input(name, format!("{value} must be positive and finite")))
    }
}

/// The layer of this thickness over R and this Poisson's ratio: under a cylinder alone, and thicker than it is pressed in.
fn bonded(
    (thickness, poisson_ratio): (f64, f64),
    profile: &IndenterShape,
    loading: Loading,
) -> PyResult<BondedLayer> {
    if !matches!(profile, IndenterShape::Cylinder { .. }) {
        let message =
            "a layer has a thickness under a cylinder alone: give `shape=\"cylinder\"`, or no thickness";
        return Err(errors::input("substrate", message));
    }
    let layer = BondedLayer::new(thickness, poisson_ratio);
    let layer = layer.map_err(|error| errors::input("substrate", error))?;
    match loading {
        Loading::Indentation(depth) if depth >= thickness => {
            let message = format!("{depth} R is no less than the thickness of the layer, {thickness} R");
            Err(errors::input("indentation", message))
        }
        _ => Ok(layer),
    }
}

/// The shape of a radius.
type ShapeOfRadius = fn(f64) -> IndenterShape;

/// Indenters of a radius, by their names.
const SHAPES: [(&str, ShapeOfRadius); 3] = [
    ("paraboloid", |radius| IndenterShape::Paraboloid { radius }),
    ("sphere", |radius| IndenterShape::Sphere { radius }),
    ("cylinder", |radius| IndenterShape::Cylinder { radius }),
];

fn profile(shape: Indenter<'_>) -> PyResult<IndenterShape> {
    match shape {
        Indenter::Name(name) => {
            let of_radius = named("shape", &name, &SHAPES)?;
            Ok(of_radius(1.0))
        }
        Indenter::Heights(heights, spacing) => {
            let (heights, [rows, columns]) = arrays::matrix("shape", &heights)?;
            let map = HeightMap::new(heights, columns, rows, positive("spacing", spacing)?, false);
            Ok(IndenterShape::HeightMap(map.map_err(|error| errors::input("shape", error))?))
        }
    }
}

fn answer<'py>(py: Python<'py>, contact: &SteadyContact) -> PyResult<Bound<'py, PyDict>> {
    let result = PyDict::new(py);
    let refinement = &contact.refinement;
    for (name, ErrorEstimate { value, error, .. }) in [
        ("force", refinement.force),
        ("area", refinement.area),
        ("friction", refinement.friction),
        ("indentation", refinement.indentation),
        ("peak_pressure", refinement.peak_pressure),
    ] {
        result.set_item(name, value)?;
        result.set_item(format!("{name}_error"), error)?;
    }
    result.set_item("friction_from_dissipation", contact.friction_from_dissipation)?;
    result.set_item("converged", contact.converged)?;
    let levels: Vec<(usize, f64, f64, f64, f64)> = refinement
        .levels
        .iter()
        .map(|level| (level.cells, level.force, level.area, level.friction, level.indentation))
        .collect();
    result.set_item("levels", levels)?;
    let (grid, solution) = (&contact.finest.grid, &contact.finest.solution);
    let shape = [grid.rows, grid.columns];
    result.set_item(
        "x",
        (0..grid.columns).map(|column| grid.x(column)).collect::<Vec<f64>>().into_pyarray(py),
    )?;
    result.set_item("y", (0..grid.rows).map(|row| grid.y(row)).collect::<Vec<f64>>().into_pyarray(py))?;
    result.set_item("pressure", solution.pressure.clone().into_pyarray(py).reshape(shape)?)?;
    result.set_item("gap", solution.gap.clone().into_pyarray(py).reshape(shape)?)?;
    Ok(result)
}
