//! What can be asked of one operating point of an oscillator, a number each.

use crate::bridge;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::point::{LOADS, SAMPLES, SHEAR_STRENGTHS, SteadyPoint};
use crate::oscillator::stability_map::ONE_WAY;
use crate::two_degrees::LABELS;
use judder_contact::{ContactLaw, ValidityConcern};
use judder_numerics::verdict::Verdict;
use judder_oscillator::critical::{Thresholds, thresholds};
use judder_oscillator::equilibrium::Equilibrium;
use judder_oscillator::mechanism::StabilityClass;
use judder_oscillator::spectrum::{eigenvalues, growth_rate, leading};
use judder_oscillator::{Contact, Groups, LinearSystem, OscillatorError};
use judder_study::model::OperatingQuantity;
use num_complex::Complex64;
use std::cell::OnceCell;

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

/// A quantity, and how it is found.
pub(crate) struct FoundQuantity {
    pub(super) quantity: OperatingQuantity,
    value: fn(&OperatingState<'_>) -> f64,
}

const fn number(
    name: &'static str,
    label: &'static str,
    long_name: &'static str,
    value: fn(&OperatingState<'_>) -> f64,
) -> FoundQuantity {
    let label = Some(label);
    let quantity = OperatingQuantity { name, units: "1", long_name, label, flags: &[], is_sought: false };
    FoundQuantity { quantity, value }
}

const fn root(
    name: &'static str,
    label: &'static str,
    long_name: &'static str,
    value: fn(&OperatingState<'_>) -> f64,
) -> FoundQuantity {
    let FoundQuantity { quantity, value } = number(name, label, long_name, value);
    FoundQuantity { quantity: OperatingQuantity { is_sought: true, ..quantity }, value }
}

const fn code(
    name: &'static str,
    long_name: &'static str,
    flags: &'static [&'static str],
    value: fn(&OperatingState<'_>) -> f64,
) -> FoundQuantity {
    let quantity = OperatingQuantity { name, units: "", long_name, label: None, flags, is_sought: false };
    FoundQuantity { quantity, value }
}

/// How many of [`FOUND`] any linear system has: the first.
const OF_LINEAR_SYSTEMS: usize = 4;

/// Those of an oscillator.
const FOUND: [FoundQuantity; 18] = [
    number("growth_rate", "Growth rate Re $λ$/$ω_{nx}$ (−)", "growth rate, Re λ/ω_nx", |p| {
        p.steady.growth_rate()
    }),
    number(
        "frequency",
        "Frequency Im $λ$/$ω_{nx}$ (−)",
        "frequency of the fastest growing mode, Im λ/ω_nx",
        |p| leading(&p.steady.eigenvalues).im,
    ),
    code("verdict", "verdict", &VERDICTS, |p| {
        position(&VERDICTS, p.steady.class.verdict().map(Verdict::name))
    }),
    code("mechanism", "mechanism", &MECHANISMS, |p| {
        position(&MECHANISMS, Some(p.steady.class.mechanism().name()))
    }),
    number(
        "equivalent_damping",
        "Equivalent damping $ξ_{eq}$ (−)",
        "equivalent damping ξ_eq, eq. (23)",
        |p| p.steady.linearisation.equivalent_damping(),
    ),
    number(
        "equivalent_damping_error",
        "Error of the equivalent damping $ξ_{eq}$ (−)",
        "error of ξ_eq by those of the contact law",
        |p| p.steady.equivalent_damping_error().unwrap_or(f64::NAN),
    ),
    number(
        "growth_rate_error",
        "Error of the growth rate Re $λ$/$ω_{nx}$ (−)",
        "error of the growth rate by those of the contact law, Re λ/ω_nx",
        |p| p.steady.growth_rate_error().unwrap_or(f64::NAN),
    ),
    code("marginal_within_law", "whether the law with its errors has other verdicts", &MARGINAL, |p| {
        p.steady.marginal_within_law().map_or(f64::NAN, |marginal| f64::from(u8::from(marginal)))
    }),
    number("equilibrium_x", "Displacement $x_{e}$/$x_{0}$ (−)", "displacement x_e/x_0", |p| {
        p.equilibrium().x
    }),
    number("equilibrium_y", "Displacement $y_{e}$/$x_{0}$ (−)", "displacement y_e/x_0", |p| {
        p.equilibrium().y
    }),
    number("indentation", "Indentation $y_{e}$/$R$ (−)", "indentation y_e/R", |p| {
        p.equilibrium().indentation
    }),
    number(
        "contact_force",
        "Contact force $F_{k}$/($E_{0}^{*}$ $R^{2}$) (−)",
        "contact force F_k/(E0* R²)",
        |p| p.equilibrium().response.force.value,
    ),
    number("contact_area", "Contact area $A$/$R^{2}$ (−)", "contact area A/R²", |p| {
        p.equilibrium().response.area.value
    }),
    number("viscoelastic_friction", "Friction $μ_{visc}$ (−)", "viscoelastic friction μ_visc", |p| {
        p.equilibrium().response.friction.value
    }),
    root(
        "critical_shear_strength",
        "Critical $τ̃_{0,crit}$, undamped (−)",
        "lowest τ0/E0* at which the undamped modes merge, eq. (27)",
        |p| lowest(&p.strengths().conservative),
    ),
    root(
        "critical_load",
        "Critical $F̃_{n,crit}$, undamped (−)",
        "lowest F_n/(E0* R²) at which the undamped modes merge, eq. (28)",
        |p| lowest(&p.loads().conservative),
    ),
    root(
        "threshold_shear_strength",
        "Threshold $τ̃_{0,crit}$ (−)",
        "lowest τ0/E0* at which stability of the damped system changes",
        |p| lowest(&p.strengths().full),
    ),
    root(
        "threshold_load",
        "Threshold $F̃_{n,crit}$ (−)",
        "lowest F_n/(E0* R²) at which stability of the damped system changes",
        |p| lowest(&p.loads().full),
    ),
];

/// What can be asked of an operating point.
pub(crate) const QUANTITIES: [OperatingQuantity; FOUND.len()] = {
    let mut all = [FOUND[0].quantity; FOUND.len()];
    let mut place = 1;
    while place < all.len() {
        all[place] = FOUND[place].quantity;
        place += 1;
    }
    all
};

/// What can be asked of any linear system.
pub(crate) const LINEAR_QUANTITIES: [OperatingQuantity; OF_LINEAR_SYSTEMS] = {
    let [growth_rate, frequency, verdict, mechanism, ..] = QUANTITIES;
    let growth_rate =
        OperatingQuantity { label: Some(LABELS.growth), long_name: "growth rate, Re λ", ..growth_rate };
    let frequency = OperatingQuantity {
        label: Some(LABELS.frequency),
        long_name: "frequency of the fastest growing mode, Im λ",
        ..frequency
    };
    let mechanism = OperatingQuantity { flags: &MECHANISMS_OF_LINEAR_SYSTEMS, ..mechanism };
    [growth_rate, frequency, verdict, mechanism]
};

/// The place of a quantity in [`FOUND`].
fn place(quantity: &OperatingQuantity) -> Option<usize> {
    FOUND.iter().position(|own| own.quantity.name == quantity.name)
}

/// These quantities of a linear system.
///
/// # Errors
/// Matrices that are not finite, or a mass matrix that is not positive definite.
pub(crate) fn linear_values(
    system: &LinearSystem,
    wanted: &[OperatingQuantity],
) -> Result<Vec<f64>, OscillatorError> {
    let (eigenvalues, class) = (eigenvalues(&system.reduced()?)?, StabilityClass::of_system(system)?);
    let verdict = position(&VERDICTS, class.verdict().map(Verdict::name));
    let mechanism = position(&MECHANISMS, Some(class.mechanism().name()));
    let values = [growth_rate(&eigenvalues), leading(&eigenvalues).im, verdict, mechanism];
    let value = |quantity| place(quantity).and_then(|place| values.get(place)).copied();
    Ok(wanted.iter().map(|quantity| value(quantity).unwrap_or(f64::NAN)).collect())
}

/// Steady sliding at one point with what is asked of it; thresholds are sought when the first quantity asks.
pub(super) struct OperatingState<'a> {
    contact: &'a Contact,
    steady: SteadyPoint,
    strengths: OnceCell<Thresholds>,
    loads: OnceCell<Thresholds>,
}

impl<'a> OperatingState<'a> {
    /// # Errors
    /// A group out of range, no steady sliding, no eigenvalues.
    pub(super) fn new(contact: &'a Contact, inputs: &OscillatorInputs) -> Result<Self, OscillatorError> {
        let steady = SteadyPoint::new(contact, bridge::groups(inputs))?;
        Ok(Self { contact, steady, strengths: OnceCell::new(), loads: OnceCell::new() })
    }

    /// These quantities.
    pub(super) fn values(&self, wanted: &[OperatingQuantity]) -> Vec<f64> {
        let value = |quantity| place(quantity).map_or(f64::NAN, |place| (FOUND[place].value)(self));
        wanted.iter().map(value).collect()
    }

    /// The four eigenvalues λ/ω_nx, sorted by imaginary, then real part.
    pub(super) fn eigenvalues(&self) -> [Complex64; 4] {
        self.steady.eigenvalues
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
