//! What can be asked of one operating point of an oscillator, a number each.

use crate::bridge;
use crate::error::StudyError;
use crate::models::oscillator::point::{LOADS, SAMPLES, SHEAR_STRENGTHS, SteadyPoint};
use crate::models::oscillator::stability_map::ONE_WAY;
use judder_case::{Case, OscillatorInputs, TwoDegreesCase};
use judder_contact::{ContactLaw, ValidityConcern};
use judder_oscillator::critical::{Thresholds, thresholds};
use judder_oscillator::equilibrium::Equilibrium;
use judder_oscillator::mechanism::{StabilityClass, Verdict};
use judder_oscillator::spectrum::{eigenvalues, growth_rate, leading};
use judder_oscillator::{Contact, Groups, LinearSystem, OscillatorError};
use std::cell::OnceCell;

/// A quantity of an operating point, as a column of a sweep.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointQuantity {
    /// Its name in a case file.
    pub(super) name: &'static str,
    /// Its unit; empty for codes.
    pub(super) units: &'static str,
    /// What it is, with its symbol.
    pub(super) long_name: &'static str,
    /// What each code means, where it is a code.
    pub(super) flags: &'static [&'static str],
    value: fn(&PointState<'_>) -> f64,
}

impl PointQuantity {
    /// Whether it is a root that has to be sought.
    pub(super) fn is_sought(&self) -> bool {
        self.name.starts_with("critical_") || self.name.starts_with("threshold_")
    }
}

/// The codes of `verdict`: its order.
const VERDICTS: [&str; 3] = ["stable", "marginal", "unstable"];
/// The codes of `marginal_within_law`: its order.
const MARGINAL: [&str; 2] = ["decided", "marginal"];
/// The codes of `mechanism`: its order.
const MECHANISMS: [&str; 6] =
    ["none", "flutter", "negative-damping", "both", "normal-force-coupling", "destabilised-by-damping"];
/// The same of a system that has no normal force.
const MECHANISMS_OF_LINEAR_SYSTEMS: [&str; 6] = {
    let mut names = MECHANISMS;
    names[4] = ONE_WAY;
    names
};

const fn number(
    name: &'static str,
    long_name: &'static str,
    value: fn(&PointState<'_>) -> f64,
) -> PointQuantity {
    PointQuantity { name, units: "1", long_name, flags: &[], value }
}

const fn code(
    name: &'static str,
    (long_name, flags): (&'static str, &'static [&'static str]),
    value: fn(&PointState<'_>) -> f64,
) -> PointQuantity {
    PointQuantity { name, units: "", long_name, flags, value }
}

/// How many of [`POINT_QUANTITIES`] any linear system has: the first.
const OF_LINEAR_SYSTEMS: usize = 4;
/// Those.
const LINEAR_QUANTITIES: [PointQuantity; OF_LINEAR_SYSTEMS] = {
    let [growth_rate, frequency, verdict, mechanism, ..] = POINT_QUANTITIES;
    [growth_rate, frequency, verdict, PointQuantity { flags: &MECHANISMS_OF_LINEAR_SYSTEMS, ..mechanism }]
};

/// Those of an oscillator.
const POINT_QUANTITIES: [PointQuantity; 18] = [
    number("growth_rate", "growth rate, Re λ/ω_nx", |p| p.steady.growth_rate()),
    number("frequency", "frequency of the fastest growing mode, Im λ/ω_nx", |p| {
        leading(&p.steady.eigenvalues).im
    }),
    code("verdict", ("verdict", &VERDICTS), |p| {
        position(&VERDICTS, p.steady.class.verdict().map(Verdict::name))
    }),
    code("mechanism", ("mechanism", &MECHANISMS), |p| {
        position(&MECHANISMS, Some(p.steady.class.mechanism().name()))
    }),
    number("equivalent_damping", "equivalent damping ξ_eq, eq. (23)", |p| {
        p.steady.linearisation.equivalent_damping()
    }),
    number("equivalent_damping_error", "error of ξ_eq by those of the contact law", |p| {
        p.steady.equivalent_damping_error().unwrap_or(f64::NAN)
    }),
    number("growth_rate_error", "error of the growth rate by those of the contact law, Re λ/ω_nx", |p| {
        p.steady.growth_rate_error().unwrap_or(f64::NAN)
    }),
    code("marginal_within_law", ("whether the law with its errors has other verdicts", &MARGINAL), |p| {
        p.steady.marginal_within_law().map_or(f64::NAN, |marginal| f64::from(u8::from(marginal)))
    }),
    number("equilibrium_x", "displacement x_e/x_0", |p| p.equilibrium().x),
    number("equilibrium_y", "displacement y_e/x_0", |p| p.equilibrium().y),
    number("indentation", "indentation y_e/R", |p| p.equilibrium().indentation),
    number("contact_force", "contact force F_k/(E0* R²)", |p| p.equilibrium().response.force.value),
    number("contact_area", "contact area A/R²", |p| p.equilibrium().response.area.value),
    number("viscoelastic_friction", "viscoelastic friction μ_visc", |p| {
        p.equilibrium().response.friction.value
    }),
    number("critical_shear_strength", "lowest τ0/E0* at which the undamped modes merge, eq. (27)", |p| {
        lowest(&p.strengths().conservative)
    }),
    number("critical_load", "lowest F_n/(E0* R²) at which the undamped modes merge, eq. (28)", |p| {
        lowest(&p.loads().conservative)
    }),
    number(
        "threshold_shear_strength",
        "lowest τ0/E0* at which stability of the damped system changes",
        |p| lowest(&p.strengths().full),
    ),
    number("threshold_load", "lowest F_n/(E0* R²) at which stability of the damped system changes", |p| {
        lowest(&p.loads().full)
    }),
];

/// The quantities of the operating point of a case; a model without an operating point has none.
pub(super) fn known(case: &Case) -> &'static [PointQuantity] {
    match case {
        Case::Oscillator(_) => &POINT_QUANTITIES,
        Case::TwoDegrees(_) => &LINEAR_QUANTITIES,
        _ => &[],
    }
}

/// The four quantities of any linear system.
pub(super) struct LinearValues([f64; OF_LINEAR_SYSTEMS]);

impl LinearValues {
    pub(super) fn of(&self, quantity: &PointQuantity) -> f64 {
        let place = POINT_QUANTITIES.iter().position(|own| own.name == quantity.name);
        place.and_then(|place| self.0.get(place)).copied().unwrap_or(f64::NAN)
    }

    fn new(system: &LinearSystem) -> Result<Self, OscillatorError> {
        let (eigenvalues, class) = (eigenvalues(&system.reduced()?)?, StabilityClass::of_system(system)?);
        let verdict = position(&VERDICTS, class.verdict().map(Verdict::name));
        let mechanism = position(&MECHANISMS, Some(class.mechanism().name()));
        Ok(Self([growth_rate(&eigenvalues), leading(&eigenvalues).im, verdict, mechanism]))
    }
}

/// Those of a two-degrees case.
///
/// # Errors
/// Matrices that are not finite, or a mass matrix that is not positive definite.
pub(super) fn linear_values(case: &TwoDegreesCase) -> Result<LinearValues, StudyError> {
    let matrices =
        case.matrices(&case.values()).map_err(|cause| StudyError::Unsupported(cause.to_string()))?;
    let (mass, damping, stiffness) = (matrices.mass, matrices.damping, matrices.stiffness);
    Ok(LinearValues::new(&LinearSystem { mass, damping, stiffness })?)
}

/// Steady sliding at one point with what is asked of it; thresholds are sought when the first quantity asks.
pub(super) struct PointState<'a> {
    contact: &'a Contact,
    steady: SteadyPoint,
    strengths: OnceCell<Thresholds>,
    loads: OnceCell<Thresholds>,
}

impl<'a> PointState<'a> {
    /// # Errors
    /// A group out of range, no steady sliding, no eigenvalues.
    pub(super) fn new(contact: &'a Contact, inputs: &OscillatorInputs) -> Result<Self, OscillatorError> {
        let steady = SteadyPoint::new(contact, bridge::groups(inputs))?;
        Ok(Self { contact, steady, strengths: OnceCell::new(), loads: OnceCell::new() })
    }

    pub(super) fn value(&self, quantity: &PointQuantity) -> f64 {
        (quantity.value)(self)
    }

    /// How the point lies outside the range of its law, where it does.
    pub(super) fn concern(&self) -> Option<ValidityConcern> {
        let velocity = self.steady.groups.coefficients().ok()?.velocity;
        self.contact.law.concern(velocity, self.steady.equilibrium.indentation)
    }

    fn equilibrium(&self) -> &Equilibrium {
        &self.steady.equilibrium
    }

    fn strengths(&self) -> &Thresholds {
        self.strengths.get_or_init(|| {
            thresholds(self.contact, &SHEAR_STRENGTHS, SAMPLES, |shear_strength| {
                Groups { shear_strength, ..self.steady.groups }.resolve()
            })
        })
    }

    fn loads(&self) -> &Thresholds {
        self.loads.get_or_init(|| {
            thresholds(self.contact, &LOADS, SAMPLES, |normal_load| {
                Groups { normal_load, ..self.steady.groups }.resolve()
            })
        })
    }
}

/// The lowest of ascending roots; not a number where there is none.
fn lowest(roots: &[f64]) -> f64 {
    roots.first().copied().unwrap_or(f64::NAN)
}

/// The code of a word; not a number where it has none.
fn position(words: &[&str], word: Option<&str>) -> f64 {
    words.iter().position(|own| Some(*own) == word).map_or(f64::NAN, |code| code as f64)
}
