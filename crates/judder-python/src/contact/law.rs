//! Contact laws.

use crate::arrays;
use crate::choice::named;
use crate::constructed::constructed;
use crate::errors;
use crate::shown::shown;
use crate::watched::{Manner, watched};
use judder_contact::law::file::{from_json, to_json};
use judder_contact::law::sampled::{SampleRequest, sampled};
use judder_contact::law::{KnotValues, LawSamples, PerQuantity, SampledLaw};
use judder_contact::{ContactLaw, ContactResponse, Law, LawError, LawPoint};
use judder_models::bridge;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::law_name::LawName;
use judder_store::{LARGEST_DOCUMENT, read_small_file};
use judder_study::Progress;
use numpy::{IntoPyArray, PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use rayon::prelude::*;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;

/// A contact law: normal force F_k/(E0* R²), contact area A/R² and viscoelastic friction coefficient μ_visc as functions of the sliding
/// speed v τ/R and the indentation y/R.
///
/// ``Law(name)`` is one of the laws that a case can name: ``"oscillator-paper"``, ``"oscillator-paper-corrected"``, ``"hertz"``, ``"bem"``
/// (computed for the substrate of the oscillator paper, which takes seconds to minutes). A law works wherever a law does:
/// ``oscillator.point(law=law)``, ``oscillator.stability_map(..., law=law)``, ``judder.run(..., law=law)``, and saved to a file in a
/// case, ``law = { file = "law.json" }``. Laws can be compared and pickled.
///
/// >>> law = judder.contact.Law("hertz")
/// >>> round(float(law.evaluate(1.0, 1e-2).force), 9)
/// 0.001333333
#[pyclass(frozen, name = "Law", module = "judder.contact")]
pub(crate) struct PyLaw {
    law: Law,
    name: String,
}

impl PyLaw {
    pub(crate) fn law(&self) -> &Law {
        &self.law
    }

    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    fn of(law: Law, name: impl Into<String>) -> Self {
        Self { law, name: name.into() }
    }
}

/// Points that one thread evaluates between two looks at Ctrl-C; as many at most are not worth another thread.
const STRETCH: usize = 1 << 12;

/// Why a function was not sampled: it raised, or its values make no law.
enum Unsampled {
    Raised(PyErr),
    Law(LawError),
}

impl From<LawError> for Unsampled {
    fn from(error: LawError) -> Self {
        Self::Law(error)
    }
}

impl Unsampled {
    fn into_exception(self) -> PyErr {
        match self {
            Self::Raised(error) => error,
            Self::Law(error) => errors::law(&error),
        }
    }
}

#[pymethods]
impl PyLaw {
    #[new]
    #[pyo3(signature = (*given, **named), text_signature = "(name)")]
    fn from_arguments<'py>(
        py: Python<'py>,
        given: &Bound<'py, PyTuple>,
        named: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        constructed::<Self>(py, given, named)
    }

    #[staticmethod]
    #[pyo3(name = "_new")]
    fn of_name(py: Python<'_>, name: &str) -> PyResult<Self> {
        let of_name = named("name", name, &LawName::ALL)?;
        let case = OscillatorCase { law: of_name, ..OscillatorCase::default() };
        let done = watched(py, &Manner::default(), |watch| bridge::contact_of(&case, watch))?;
        let contact = done.settled(|error| errors::model(&error))?;
        Ok(Self::of(contact.contact.law, name))
    }

    /// The law through a table: bicubic splines in ln v and ln y of ln(F/y^(3/2)), ln(A/y) and μ.
    ///
    /// Beyond the table force and area go on as those of Hertz, and friction goes to a limit; ``concern`` says where.
    ///
    /// Args:
    ///     velocity: v τ/R of the columns, float64[n], positive and ascending, evenly spaced or not, at least two.
    ///     indentation: y/R of the rows, float64[m], likewise.
    ///     force: F_k/(E0* R²), float64[m, n], positive.
    ///     area: A/R², float64[m, n], positive.
    ///     friction: μ_visc, float64[m, n].
    ///     source: where the values come from, in words.
    ///
    /// Raises:
    ///     InputError: an array of another shape, or with numbers that are not finite; a force that is the same everywhere.
    ///     LawError: knots that do not ascend, a force or an area that is not positive.
    #[staticmethod]
    #[pyo3(signature = (velocity, indentation, force, area, friction, *, source="a table"))]
    fn from_table(
        velocity: &Bound<'_, PyAny>,
        indentation: &Bound<'_, PyAny>,
        force: &Bound<'_, PyAny>,
        area: &Bound<'_, PyAny>,
        friction: &Bound<'_, PyAny>,
        source: &str,
    ) -> PyResult<Self> {
        let velocities = arrays::vector("velocity", velocity)?;
        let indentations = arrays::vector("indentation", indentation)?;
        let expected = [indentations.len(), velocities.len()];
        let table = |name: &str, object: &Bound<'_, PyAny>| -> PyResult<Vec<f64>> {
            let (values, shape) = arrays::matrix(name, object)?;
            if shape == expected {
                return Ok(values);
            }
            let message = format!("the shape is {shape:?}; (indentations, velocities) is {expected:?}");
            Err(errors::input(name, message))
        };
        let values = PerQuantity {
            force: table("force", force)?,
            area: table("area", area)?,
            friction: table("friction", friction)?,
        };
        let samples = LawSamples { source: source.to_owned(), velocities, indentations, values };
        let law = SampledLaw::new(samples).map_err(|error| errors::law(&error))?;
        check_force("force", &law)?;
        Ok(Self::of(Law::Sampled(Arc::new(law)), source))
    }

    /// The law of a function of your own, sampled as finely as the tolerance asks.
    ///
    /// The function takes two arrays of one shape, the speeds v τ/R and the indentations y/R of points, and returns the three arrays force,
    /// area, friction. It is called a few times with many points; :func:`numpy.vectorize` helps where it takes single numbers.
    ///
    /// Args:
    ///     function: the callable.
    ///     velocity: v τ/R between which it is sampled, (from, to).
    ///     indentation: y/R between which it is sampled.
    ///     tolerance: what the interpolation may leave, relative (of the friction to its largest value). Where a jump or a kink of the
    ///         function keeps it from that, a :class:`judder.JudderWarning` says so; ``errors`` has what was reached.
    ///     source: what to call it.
    ///
    /// Raises:
    ///     InputError: the function returns no three arrays of finite numbers, or a force that is the same everywhere.
    ///     LawError: a range that is none, a force or an area that is not positive.
    ///     Exception: what the function itself raises, as it is, with a note that says where it was called.
    ///
    /// >>> import numpy as np
    /// >>> def own(v, y):
    /// ...     return 4 / 3 * y**1.5, np.pi * y, 0.3 * v / (1 + v**2)
    /// >>> law = judder.contact.Law.from_function(own, velocity=(1e-6, 1e2), indentation=(1e-6, 1e-1))
    /// >>> max(law.errors.values()) < 1e-4
    /// True
    #[staticmethod]
    #[pyo3(signature = (function, *, velocity, indentation, tolerance=1e-4, source="a function"))]
    fn from_function(
        py: Python<'_>,
        function: &Bound<'_, PyAny>,
        velocity: (f64, f64),
        indentation: (f64, f64),
        tolerance: f64,
        source: &str,
    ) -> PyResult<Self> {
        let request = SampleRequest { source: source.to_owned(), velocity, indentation, tolerance };
        let found = sampled(&request, |velocities, indentations| {
            py.check_signals()
                .and_then(|()| called(function, velocities, indentations))
                .map_err(Unsampled::Raised)
        });
        let found = found.map_err(Unsampled::into_exception)?;
        check_force("function", &found.law)?;
        if !found.meets_tolerance {
            let PerQuantity { force, area, friction } = found.law.errors();
            errors::warn(
                py,
                &format!(
                    "the function is too steep for a tolerance of {tolerance:.0e}: force, area and friction are known to {force:.1e}, \
                     {area:.1e} and {friction:.1e}"
                ),
            )?;
        }
        Ok(Self::of(Law::Sampled(Arc::new(found.law)), source))
    }

    /// The law in the text of its file.
    #[staticmethod]
    fn from_json(text: &str) -> PyResult<Self> {
        let law = from_json(text).map_err(|error| errors::law(&error))?;
        let name = match &law {
            Law::Sampled(law) => law.samples().source.clone(),
            law => law.data().map(|data| data.origin().source.clone()).unwrap_or_default(),
        };
        Ok(Self::of(law, name))
    }

    /// Reads a law that ``save``, or an analysis ``contact-law``, has written.
    ///
    /// Raises:
    ///     FileError: the file cannot be read, or is larger than any law.
    ///     LawError: it holds no law.
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        let read = read_small_file(&path, LARGEST_DOCUMENT).and_then(|bytes| {
            String::from_utf8(bytes).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))
        });
        Self::from_json(&read.map_err(|error| errors::file(&path, &error))?)
    }

    /// Writes the law to a file, for a case or another day.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        let text = self.to_json()?;
        let text = text.ok_or_else(|| {
            errors::input("path", "a law that is a formula goes by its name, it has no file")
        })?;
        let written: io::Result<()> = judder_disk::write_whole(&path, |out| out.write_all(text.as_bytes()));
        written.map_err(|error| errors::file(&path, &error))
    }

    /// The text of its file; ``None`` for a law that is a formula.
    fn to_json(&self) -> PyResult<Option<String>> {
        to_json(&self.law).map_err(|error| errors::law(&error))
    }

    /// Force, area, friction and their exact first derivatives by speed and indentation, a :class:`LawResponse` of arrays.
    ///
    /// Many points are computed on all cores, without the interpreter's lock, and Ctrl-C ends that. Of points outside the law's range, as
    /// ``concern`` tells them, a :class:`judder.JudderWarning` says how many there are.
    ///
    /// Args:
    ///     velocity: v τ/R, zero or more, of any shape.
    ///     indentation: y/R, zero or more, of a shape that goes with it (they are broadcast).
    ///     threads: threads to compute with; one a core where none is given. The result does not depend on it.
    ///
    /// Raises:
    ///     InputError: arrays that cannot be broadcast, or with numbers that are negative or not finite.
    #[pyo3(signature = (velocity, indentation, *, threads=None))]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        velocity: &Bound<'py, PyAny>,
        indentation: &Bound<'py, PyAny>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let ([velocities, indentations], shape) =
            arrays::broadcast([("velocity", velocity), ("indentation", indentation)])?;
        for (name, list) in [("velocity", &velocities), ("indentation", &indentations)] {
            if let Some(value) = list.iter().find(|value| **value < 0.0) {
                return Err(errors::input(name, format!("{value} is negative; zero or more is needed")));
            }
        }
        let responses = self.responses(py, &velocities, &indentations, threads)?;
        if let Some(beyond) = self.beyond(&velocities, &indentations) {
            errors::warn(py, &beyond)?;
        }
        let result = PyDict::new(py);
        let put = |name: &str, of: &dyn Fn(&ContactResponse) -> f64| -> PyResult<()> {
            let values: Vec<f64> = responses.iter().map(of).collect();
            let values: Bound<'_, PyArrayDyn<f64>> = values.into_pyarray(py).reshape(shape.clone())?;
            result.set_item(name, values)
        };
        put("force", &|r| r.force.value)?;
        put("force_by_velocity", &|r| r.force.by_velocity)?;
        put("force_by_indentation", &|r| r.force.by_indentation)?;
        put("area", &|r| r.area.value)?;
        put("area_by_velocity", &|r| r.area.by_velocity)?;
        put("area_by_indentation", &|r| r.area.by_indentation)?;
        put("friction", &|r| r.friction.value)?;
        put("friction_by_velocity", &|r| r.friction.by_velocity)?;
        put("friction_by_indentation", &|r| r.friction.by_indentation)?;
        py.import("judder.contact")?.getattr("LawResponse")?.call((), Some(&result))
    }

    /// What makes the law doubtful at a speed and an indentation; ``None`` inside its range of validity.
    fn concern(&self, velocity: f64, indentation: f64) -> Option<String> {
        self.law.concern(velocity, indentation).map(|concern| concern.to_string())
    }

    /// Its name, or where it comes from.
    #[getter(name)]
    fn own_name(&self) -> &str {
        &self.name
    }

    /// Its estimated relative errors ``{"force", "area", "friction"}``; ``None`` for a law that is a formula.
    #[getter]
    fn errors(&self, py: Python<'_>) -> PyResult<Option<Py<PyDict>>> {
        let Some(errors) = self.relative_errors() else { return Ok(None) };
        let dict = PyDict::new(py);
        for (name, value) in [("force", errors.force), ("area", errors.area), ("friction", errors.friction)] {
            dict.set_item(name, value)?;
        }
        Ok(Some(dict.unbind()))
    }

    fn __repr__(&self) -> String {
        format!("Law({:?})", self.name)
    }

    fn _repr_html_(&self) -> String {
        let kind = if self.law.is_formula() { "a formula" } else { "through values" };
        let errors = self.relative_errors().map(|errors| {
            let PerQuantity { force, area, friction } = errors;
            format!("force {force:.1e}, area {area:.1e}, friction {friction:.1e}")
        });
        let rows = [("name", self.name.clone()), ("kind", kind.to_owned())];
        shown("Law", &[rows.as_slice(), &[("errors", errors.unwrap_or_default())]].concat())
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.law == other.law
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        let class = py.get_type::<Self>();
        match self.to_json()? {
            Some(text) => Ok((class.getattr("from_json")?, (text,))),
            None => Ok((class.into_any(), (self.name.clone(),))),
        }
    }
}

impl PyLaw {
    /// Its estimated relative errors; none of a formula.
    fn relative_errors(&self) -> Option<PerQuantity<f64>> {
        match &self.law {
            Law::Sampled(law) => Some(law.errors()),
            law => law.data().map(|data| data.errors().total()),
        }
    }

    /// How many of these points lie outside the law's range, and how one of them does.
    fn beyond(&self, velocities: &[f64], indentations: &[f64]) -> Option<String> {
        let points = velocities.iter().zip(indentations);
        let mut concerns = points.filter_map(|(v, y)| self.law.concern(*v, *y));
        let first = concerns.next()?;
        let (count, all) = (concerns.count() + 1, velocities.len());
        Some(format!("outside the law's range at {count} of {all} points, for one: {first}"))
    }

    /// What the law gives at points: few of them here and now, many side by side.
    fn responses(
        &self,
        py: Python<'_>,
        velocities: &[f64],
        indentations: &[f64],
        threads: Option<usize>,
    ) -> PyResult<Vec<ContactResponse>> {
        let manner = Manner::new(None, threads)?;
        let at = |(v, y): (&f64, &f64)| self.law.evaluate(&LawPoint::new(*v, *y));
        if velocities.len() <= STRETCH {
            return Ok(py.detach(|| velocities.iter().zip(indentations).map(at).collect()));
        }
        let done = watched(py, &manner, |watch| {
            let stretches = velocities.par_chunks(STRETCH).zip(indentations.par_chunks(STRETCH));
            let of_stretches = stretches.map(|(velocities, indentations)| {
                let goes_on = !watch.interrupted();
                goes_on.then(|| velocities.iter().zip(indentations).map(at).collect::<Vec<_>>())
            });
            let found: Option<Vec<Vec<ContactResponse>>> = of_stretches.collect();
            found.map(|found| found.concat()).ok_or(())
        })?;
        done.settled(|()| errors::fault())
    }
}

/// Refuses a force that no depth changes: whoever gives one has forgotten the arguments, and no load finds its depth.
fn check_force(argument: &str, law: &SampledLaw) -> PyResult<()> {
    match law.samples().values.force.as_slice() {
        [first, rest @ ..] if rest.iter().all(|other| other == first) => {
            let message = format!(
                "the force is {first} at every speed and indentation, and must rise with the indentation, as 4/3*y**1.5 does"
            );
            Err(errors::input(argument, message))
        }
        _ => Ok(()),
    }
}

/// The values of a user's function at these points.
fn called(function: &Bound<'_, PyAny>, velocities: &[f64], indentations: &[f64]) -> PyResult<KnotValues> {
    let py = function.py();
    let at = (PyArray1::from_slice(py, velocities), PyArray1::from_slice(py, indentations));
    let given = function.call1(at).inspect_err(|error| {
        let note = "raised by the function that was given to `judder.contact.Law.from_function`";
        // without the note it is the same exception
        drop(error.value(py).call_method1("add_note", (note,)));
    })?;
    let triple = given.extract::<(Bound<'_, PyAny>, Bound<'_, PyAny>, Bound<'_, PyAny>)>();
    let (force, area, friction) = triple
        .map_err(|_| errors::input("function", "it must return three arrays: force, area, friction"))?;
    let numpy = py.import("numpy")?;
    let list = |name: &str, object: &Bound<'_, PyAny>| -> PyResult<Vec<f64>> {
        let count = velocities.len();
        let spread = numpy.call_method1("broadcast_to", (object, (count,)));
        let spread = spread.map_err(|error| {
            let shape = numpy.call_method1("shape", (object,));
            let shape = shape.map_or_else(|_| error.to_string(), |shape| shape.to_string());
            let message =
                format!("its {name} has the shape {shape}, and ({count},) is needed, a value a point");
            errors::input("function", message)
        })?;
        arrays::vector(&format!("{name} of the function"), &spread)
    };
    Ok(PerQuantity {
        force: list("force", &force)?,
        area: list("area", &area)?,
        friction: list("friction", &friction)?,
    })
}
