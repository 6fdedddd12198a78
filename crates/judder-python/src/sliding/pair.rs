//! A slider on its track.

use crate::arrays;
use crate::cases::{CasePackage, CaseSource, package_of};
use crate::choice::named;
use crate::constructed::constructed;
use crate::errors;
use crate::shown::shown;
use crate::watched::{Manner, watched};
use judder_contact::friction::{Friction, TableInterpolation};
use judder_models::coupled_pair::{CoupledPair, coupled_pair};
use judder_sliding::body::{Body, ModalPoint};
use judder_sliding::edge::Interpolation;
use judder_sliding::motion::Motion;
use judder_sliding::pair::{Observed, Pair, PairSide, Slider, TrackBody};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// Two structures in sliding contact, in their own modes.
///
/// ``judder.sliding.load_pair(case)`` builds, reduces and couples the structures of a sliding case; ``Pair(slider, track, friction=0.3)``
/// takes modal data. A pair does not change.
///
/// Args:
///     slider: a :class:`Slider`.
///     track: a :class:`Track`.
///     friction: the coefficient, or speeds in m/s and coefficients, two arrays.
///     interpolation: how the edge runs between its nodes: ``"linear"``, or ``"hermite"``, C¹.
///     side: on which side of the edge, seen from its first node to its last, the slider lies: ``"left"`` or ``"right"``.
///     observed: displacements to watch, :class:`Observed`.
///
/// Raises:
///     InputError: an array of another shape, or with numbers that are not finite.
///     SlidingError: modes, loads or an edge that cannot be.
#[pyclass(frozen, name = "Pair", module = "judder.sliding")]
pub(crate) struct PyPair {
    pub(super) pair: Pair,
    /// What its case prescribes.
    pub(super) motion: Option<Motion>,
    warnings: Vec<String>,
    origin: PairOrigin,
}

/// What a pair was made of, for a copy in another process.
enum PairOrigin {
    /// The arguments of `Pair`.
    Given(Py<PyTuple>),
    /// A case, and what holds the files of its objects.
    Case { package: CasePackage, _inputs: Option<Py<PyAny>> },
}

/// A friction coefficient, or speeds and coefficients.
#[derive(FromPyObject)]
enum GivenFriction<'py> {
    Constant(f64),
    Table(Bound<'py, PyAny>, Bound<'py, PyAny>),
}

impl GivenFriction<'_> {
    fn friction(&self) -> PyResult<Friction> {
        let friction = match self {
            Self::Constant(coefficient) => return Ok(Friction::Constant(*coefficient)),
            Self::Table(speeds, coefficients) => Friction::table(
                arrays::vector("friction", speeds)?,
                arrays::vector("friction", coefficients)?,
                TableInterpolation::Linear,
            ),
        };
        friction.map_err(|error| errors::sliding(&error.into()))
    }
}

/// An attribute of an argument, as a list of numbers.
fn list(argument: &str, object: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<f64>> {
    arrays::vector(&format!("{argument}.{name}"), &object.getattr(name)?)
}

fn body(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<Body> {
    Ok(Body {
        eigenvalues: list(argument, object, "eigenvalues")?,
        alpha: object.getattr("alpha")?.extract()?,
        beta: object.getattr("beta")?.extract()?,
    })
}

/// The shape of an argument, refused where it is another.
fn shaped(
    name: &str,
    object: &Bound<'_, PyAny>,
    expected: &[Option<usize>],
) -> PyResult<(Vec<f64>, Vec<usize>)> {
    let (values, shape) = arrays::any(name, object)?;
    let fits = shape.len() == expected.len()
        && shape
            .iter()
            .zip(expected)
            .all(|(found, expected)| expected.is_none_or(|expected| *found == expected));
    if fits && !values.is_empty() {
        return Ok((values, shape));
    }
    let sides: Vec<String> =
        expected.iter().map(|side| side.map_or("any".to_owned(), |side| side.to_string())).collect();
    Err(errors::input(name, format!("the shape is {shape:?}; ({}) is needed", sides.join(", "))))
}

/// Rows of Φ along x and y.
fn rows(values: &[f64]) -> [Vec<f64>; 2] {
    let (x, y) = values.split_at(values.len() / 2);
    [x.to_vec(), y.to_vec()]
}

fn slider(object: &Bound<'_, PyAny>) -> PyResult<Slider> {
    let body = body("slider", object)?;
    let (place, _) = shaped("slider.contact", &object.getattr("contact")?, &[Some(2)])?;
    let modes = body.modes();
    let (own, _) = shaped("slider.contact_rows", &object.getattr("contact_rows")?, &[Some(2), Some(modes)])?;
    let contact = ModalPoint { place: [place[0], place[1]], rows: rows(&own) };
    let (load, inertia) = (list("slider", object, "load")?, list("slider", object, "inertia")?);
    Ok(Slider { body, contact, load, inertia })
}

fn track(object: &Bound<'_, PyAny>) -> PyResult<TrackBody> {
    let body = body("track", object)?;
    let (places, shape) = shaped("track.nodes", &object.getattr("nodes")?, &[None, Some(2)])?;
    let expected = [Some(shape[0]), Some(2), Some(body.modes())];
    let (own, _) = shaped("track.node_rows", &object.getattr("node_rows")?, &expected)?;
    let nodes = places.chunks_exact(2).zip(own.chunks_exact(2 * body.modes()));
    let nodes =
        nodes.map(|(place, own)| ModalPoint { place: [place[0], place[1]], rows: rows(own) }).collect();
    Ok(TrackBody { body, nodes })
}

fn observed(object: &Bound<'_, PyAny>) -> PyResult<Observed> {
    let side: String = object.getattr("side")?.extract()?;
    let side = named("observed.side", &side, &[("slider", PairSide::Slider), ("track", PairSide::Track)])?;
    Ok(Observed { side, row: list("observed", object, "row")?, rigid: object.getattr("rigid")?.extract()? })
}

#[pymethods]
impl PyPair {
    #[new]
    #[pyo3(
        signature = (*given, **named),
        text_signature = "(slider, track, *, friction, interpolation='linear', side='left', observed=())"
    )]
    fn from_arguments<'py>(
        py: Python<'py>,
        given: &Bound<'py, PyTuple>,
        named: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        constructed::<Self>(py, given, named)
    }

    #[staticmethod]
    #[pyo3(
        name = "_new",
        signature = (slider, track, *, friction, interpolation="linear", side="left", observed=Vec::new())
    )]
    fn of_arguments(
        slider: &Bound<'_, PyAny>,
        track: &Bound<'_, PyAny>,
        friction: &Bound<'_, PyAny>,
        interpolation: &str,
        side: &str,
        observed: Vec<Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let given = (slider, track, friction, interpolation, side, observed.clone());
        let origin = PairOrigin::Given(given.into_pyobject(slider.py())?.unbind());
        let friction: GivenFriction<'_> = friction.extract().map_err(|_| {
            errors::argument("friction", "a number, or speeds and coefficients, two arrays, are needed")
        })?;
        let interpolation = named("interpolation", interpolation, &Interpolation::ALL)?;
        let is_left = named("side", side, &[("left", true), ("right", false)])?;
        let watched = observed.iter().map(self::observed).collect::<PyResult<_>>()?;
        let structures = (self::slider(slider)?, self::track(track)?);
        let pair =
            Pair::new(structures.0, structures.1, interpolation, is_left, friction.friction()?, watched);
        let pair = pair.map_err(|error| errors::sliding(&error))?;
        Ok(Self { pair, motion: None, warnings: Vec::new(), origin })
    }

    /// The pair of a sliding case; see :func:`judder.sliding.load_pair`.
    #[staticmethod]
    #[pyo3(signature = (case, overrides, *, inputs=None))]
    fn from_source(
        py: Python<'_>,
        case: CaseSource,
        overrides: Vec<String>,
        inputs: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let file = case.read(&overrides)?;
        let done = watched(py, &Manner::default(), |_| coupled_pair(&file))?;
        let CoupledPair { pair, motion, warnings } = done.settled(|error| errors::model(&error))?;
        let origin = PairOrigin::Case { package: package_of(&file), _inputs: inputs };
        Ok(Self { pair, motion: Some(motion), warnings, origin })
    }

    /// Modes of both structures.
    #[getter]
    fn modes(&self) -> usize {
        self.pair.modes()
    }

    /// ω² of all modes in 1/s², those of the slider first, float64[modes].
    #[getter]
    fn eigenvalues<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.pair.eigenvalues().into_pyarray(py)
    }

    /// Distances of the track's nodes from its first along the direction of sliding, m, float64[nodes].
    #[getter]
    fn node_positions<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.pair.node_positions())
    }

    /// How many displacements are watched.
    #[getter]
    fn observed(&self) -> usize {
        self.pair.observed().len()
    }

    /// What has to be known of the pair of a case, a sentence each.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    /// The case that it comes from with all that another machine needs; ``None`` for modal data.
    #[getter]
    fn package(&self) -> Option<CasePackage> {
        match &self.origin {
            PairOrigin::Case { package, .. } => Some(package.clone()),
            PairOrigin::Given(_) => None,
        }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let module = py.import("judder._pairs")?;
        match &self.origin {
            PairOrigin::Given(given) => Ok((module.getattr("given")?, given.bind(py).clone().into_any())),
            PairOrigin::Case { package, .. } => {
                Ok((module.getattr("of_package")?, module.call_method1("packed", (package.clone(),))?))
            }
        }
    }

    fn __copy__(own: Py<Self>) -> Py<Self> {
        own
    }

    fn __deepcopy__(own: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        own
    }

    fn __repr__(&self) -> String {
        format!("Pair({} modes, track of {} nodes)", self.pair.modes(), self.pair.track().nodes.len())
    }

    fn _repr_html_(&self) -> String {
        let rows = [
            ("modes", self.pair.modes().to_string()),
            ("nodes of the track", self.pair.track().nodes.len().to_string()),
            ("observed", self.pair.observed().len().to_string()),
            ("warnings", self.warnings.join("; ")),
        ];
        shown("Pair", &rows)
    }
}
