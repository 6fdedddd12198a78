//! One operating point.

use super::keys::AskedOscillator;
use crate::contact::PyLaw;
use crate::errors;
use crate::shown::shown;
use crate::watched::Manner;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::{Form, Value};
use judder_models::bridge;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::inputs::TimeForm;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::point::{AnalysedPoint, SteadyPoint, point_with};
use judder_oscillator::mechanism::Mechanism;
use num_complex::Complex64;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::OnceLock;

/// The steady sliding of an oscillator at one operating point, and what small motions about it do: what
/// :func:`judder.oscillator.point` returns.
///
/// It does not change. Arrays are made when they are asked for; points can be compared and pickled.
#[pyclass(frozen, module = "judder.oscillator")]
pub(crate) struct OscillatorPoint {
    case: OscillatorCase,
    law: Option<Py<PyLaw>>,
    steady: SteadyPoint,
    /// Thresholds, shares and warnings: what takes longer than the rest, when first asked for.
    whole: OnceLock<AnalysedPoint>,
}

/// What [`rebuilt_point`] takes.
type PickledPoint = (Vec<(f64, bool)>, bool, Py<PyAny>, &'static str);

/// Analyses one operating point of the oscillator of the oscillator paper.
///
/// Every argument but ``law`` and ``friction_load`` is a key of an oscillator case by its last name, :class:`judder.oscillator.Keys`: a number is
/// the dimensionless group (or the pure number), a text carries a unit, ``velocity="30 mm/s"``. What is not given has the oscillator paper's value.
///
/// Args:
///     law: ``"oscillator-paper"``, ``"oscillator-paper-corrected"``, ``"hertz"``, ``"bem"`` (computed at its first use, which takes
///         seconds to minutes), or a :class:`judder.contact.Law`.
///     friction_load: ``"normal-load"`` or ``"contact-force"``.
///     keys: all other keys.
///
/// Returns:
///     An :class:`OscillatorPoint`, the same numbers as ``judder point --json`` to the last digit.
///
/// Raises:
///     CaseError: a value out of range or with a wrong unit.
///     OscillatorError: no steady sliding, or several states of it.
///
/// >>> point = judder.oscillator.point(velocity=1e-4, normal_load=1e-6, shear_strength=0.01)
/// >>> point.verdict, point.eigenvalues.shape
/// ('unstable', (4,))
/// >>> judder.oscillator.point(velocity="30 mm/s").mechanism
/// 'none'
#[pyfunction]
#[pyo3(signature = (*, law=None, friction_load=None, **keys))]
pub(crate) fn point(
    py: Python<'_>,
    law: Option<&Bound<'_, PyAny>>,
    friction_load: Option<&str>,
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<OscillatorPoint> {
    let mut asked = AskedOscillator::new(law, friction_load)?;
    asked.set(keys.into_iter().flatten())?;
    solved(py, asked)
}

fn solved(py: Python<'_>, asked: AskedOscillator) -> PyResult<OscillatorPoint> {
    let contact = match asked.contact_at_hand() {
        Some(contact) => contact,
        None => asked.contact(py, &Manner::default())?.contact,
    };
    let steady = SteadyPoint::new(&contact, bridge::groups(&asked.case.inputs));
    let steady = steady.map_err(|error| errors::oscillator(&error))?;
    Ok(OscillatorPoint { case: asked.case, law: asked.law, steady, whole: OnceLock::new() })
}

/// The operating point of unpickled values: number and whether it has a unit, a pair a key.
#[pyfunction]
pub(crate) fn rebuilt_point(
    py: Python<'_>,
    values: Vec<(f64, bool)>,
    is_relaxation: bool,
    law: &Bound<'_, PyAny>,
    friction_load: &str,
) -> PyResult<OscillatorPoint> {
    let mut asked = AskedOscillator::new(Some(law), Some(friction_load))?;
    let time = if is_relaxation { OscillatorKey::RetardationTime } else { OscillatorKey::RelaxationTime };
    for (entry, (number, is_si)) in
        OscillatorKey::ALL.iter().zip(values).filter(|(entry, _)| entry.key != time)
    {
        let form = if is_si { Form::Si } else { Form::Group };
        asked.case.inputs.set(entry.key, Value { number, form });
    }
    asked.checked(asked.case.inputs)?;
    solved(py, asked)
}

/// The growth rate of a point solved `times` over: the work of `point` without the call, for benchmarks.
#[pyfunction]
pub(crate) fn repeated_points(py: Python<'_>, times: usize) -> PyResult<f64> {
    let asked = AskedOscillator::new(None, None)?;
    let contact = asked.contact_at_hand().ok_or_else(errors::fault)?;
    let mut sum = 0.0;
    py.detach(|| {
        for _ in 0..times {
            let groups = std::hint::black_box(bridge::groups(&asked.case.inputs));
            sum += SteadyPoint::new(&contact, groups).map_or(f64::NAN, |point| point.growth_rate());
        }
    });
    Ok(sum / times as f64)
}

fn square<T: numpy::Element + Copy>(
    py: Python<'_>,
    entries: [[T; 2]; 2],
) -> PyResult<Bound<'_, PyArray2<T>>> {
    let rows = entries.map(|row| row.to_vec()).to_vec();
    Ok(PyArray2::from_vec2(py, &rows)?)
}

impl OscillatorPoint {
    fn whole(&self, py: Python<'_>) -> PyResult<&AnalysedPoint> {
        if let Some(whole) = self.whole.get() {
            return Ok(whole);
        }
        let law = self.law.as_ref().map(|law| law.clone_ref(py));
        let asked = AskedOscillator { case: self.case.clone(), law };
        let contact = asked.contact(py, &Manner::default())?;
        let whole = py.detach(|| point_with(&self.case, &contact)).map_err(|error| errors::model(&error))?;
        Ok(self.whole.get_or_init(|| whole))
    }
}

#[pymethods]
impl OscillatorPoint {
    /// The four eigenvalues λ/ω_nx, complex128[4], sorted by imaginary, then real part.
    #[getter]
    fn eigenvalues<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Complex64>> {
        PyArray1::from_slice(py, &self.steady.eigenvalues)
    }

    /// The growth rate, the largest real part of the eigenvalues, in units of ω_nx; above 0 steady sliding is unstable.
    #[getter]
    fn growth_rate(&self) -> f64 {
        self.steady.growth_rate()
    }

    /// ``"stable"``, ``"marginal"`` or ``"unstable"``; ``"unresolved"`` where there is no verdict.
    #[getter]
    fn verdict(&self) -> &'static str {
        self.steady.verdict()
    }

    /// How far the growth rate may be off by the errors of the contact law; 0 for a formula, ``None`` where they are not known.
    #[getter]
    fn growth_rate_error(&self) -> Option<f64> {
        self.steady.growth_rate_error()
    }

    /// Whether the contact law with its errors has other verdicts too; ``None`` where its errors are not known.
    #[getter]
    fn marginal_within_law(&self) -> Option<bool> {
        self.steady.marginal_within_law()
    }

    /// What carries an instability: ``"flutter"``, ``"negative-damping"``, ``"both"``, ``"normal-force-coupling"``, ``"destabilised-by-damping"``, or ``"none"``.
    #[getter]
    fn mechanism(&self) -> &'static str {
        self.steady.class.mechanism().name()
    }

    /// The damping matrix C of (19), float64[2, 2], dimensionless.
    #[getter]
    fn damping<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        square(py, self.steady.linearisation.damping())
    }

    /// The stiffness matrix K of (19), float64[2, 2], dimensionless.
    #[getter]
    fn stiffness<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        square(py, self.steady.linearisation.stiffness())
    }

    /// ξ_eq of (23), the damping that the oscillator feels along the sliding direction.
    #[getter]
    fn equivalent_damping(&self) -> f64 {
        self.steady.linearisation.equivalent_damping()
    }

    /// How far ξ_eq may be off by the errors of the contact law; 0 for a formula, ``None`` where they are not known.
    #[getter]
    fn equivalent_damping_error(&self) -> Option<f64> {
        self.steady.equivalent_damping_error()
    }

    /// The displacement x/x0 of steady sliding, with x0 = F_n/k_x.
    #[getter]
    fn x(&self) -> f64 {
        self.steady.equilibrium.x
    }

    /// The displacement y/x0 of steady sliding.
    #[getter]
    fn y(&self) -> f64 {
        self.steady.equilibrium.y
    }

    /// The indentation y/R of steady sliding.
    #[getter]
    fn indentation(&self) -> f64 {
        self.steady.equilibrium.indentation
    }

    /// The contact force F_k/(E0* R²) of steady sliding.
    #[getter]
    fn force(&self) -> f64 {
        self.steady.equilibrium.response.force.value
    }

    /// The contact area A/R² of steady sliding.
    #[getter]
    fn area(&self) -> f64 {
        self.steady.equilibrium.response.area.value
    }

    /// The viscoelastic friction coefficient μ_visc of steady sliding.
    #[getter]
    fn viscoelastic_friction(&self) -> f64 {
        self.steady.equilibrium.response.friction.value
    }

    /// All thresholds τ0/E0* of flutter without damping at this speed and load, float64[n], ascending; searched when first asked for.
    #[getter]
    fn critical_shear_strength<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(self.whole(py)?.critical_shear_strength.clone().into_pyarray(py))
    }

    /// All thresholds F_n/(E0* R²) of flutter without damping at this speed and shear strength, float64[n], ascending; searched when first
    /// asked for.
    #[getter]
    fn critical_load<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(self.whole(py)?.critical_load.clone().into_pyarray(py))
    }

    /// What makes the law doubtful here, a sentence each.
    #[getter]
    fn warnings(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        Ok(self.whole(py)?.warnings.clone())
    }

    /// The document of ``judder point --json``, as a text; ``json.loads`` makes a dictionary of it.
    fn to_json(&self, py: Python<'_>) -> PyResult<String> {
        Ok(self.whole(py)?.json().to_string())
    }

    fn __repr__(&self) -> String {
        let (verdict, rate) = (self.steady.verdict(), self.steady.growth_rate());
        let within = match self.steady.marginal_within_law() {
            Some(true) => ", marginal within the law",
            _ => "",
        };
        match self.steady.class.mechanism() {
            Mechanism::None => format!("OscillatorPoint({verdict}{within}, growth rate {rate:.6e})"),
            mechanism => {
                format!("OscillatorPoint({verdict} by {}{within}, growth rate {rate:.6e})", mechanism.name())
            }
        }
    }

    fn _repr_html_(&self) -> String {
        let of_mechanism = match self.steady.class.mechanism() {
            Mechanism::None => String::new(),
            mechanism => mechanism.name().to_owned(),
        };
        let rows = [
            ("verdict", self.steady.verdict().to_owned()),
            ("mechanism", of_mechanism),
            ("growth rate", format!("{:.6e}", self.steady.growth_rate())),
            ("equivalent damping", format!("{:.6e}", self.steady.linearisation.equivalent_damping())),
            ("indentation y/R", format!("{:.6e}", self.steady.equilibrium.indentation)),
        ];
        shown("OscillatorPoint", &rows)
    }

    fn __eq__(&self, other: &Self) -> bool {
        let same_law = match (&self.law, &other.law) {
            (None, None) => self.case.law == other.case.law,
            (Some(own), Some(other)) => own.get().law() == other.get().law(),
            _ => false,
        };
        same_law
            && self.case.inputs == other.case.inputs
            && self.case.friction_load == other.case.friction_load
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, PickledPoint)> {
        let rebuild = py.import("judder._judder")?.getattr("rebuilt_point")?;
        let values = OscillatorKey::ALL.iter().map(|entry| self.case.inputs.get(entry.key));
        let values = values.map(|value| (value.number, value.form == Form::Si)).collect();
        let law = match &self.law {
            Some(law) => law.clone_ref(py).into_any(),
            None => self.case.law.name().into_pyobject(py)?.into_any().unbind(),
        };
        let is_relaxation = self.case.time_form() == TimeForm::Relaxation;
        Ok((rebuild, (values, is_relaxation, law, self.case.friction_load.name())))
    }
}
