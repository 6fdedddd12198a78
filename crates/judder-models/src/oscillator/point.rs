//! Everything about one operating point: what `judder point` prints.

use crate::bridge::{self, CaseContact};
use crate::error::ModelError;
use crate::known_substrate::KnownSubstrate;
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::quasi_steady::QuasiSteadyCondition;
use crate::within_law::{MARGINAL, ranges_text};
use judder_contact::ContactLaw;
use judder_oscillator::critical::{ParameterRange, RangeScale, Thresholds, thresholds};
use judder_oscillator::equilibrium::{Equilibrium, equilibrium};
use judder_oscillator::growth::{EntryShares, growth_shares, sensitivities};
use judder_oscillator::linearisation::Linearisation;
use judder_oscillator::mechanism::StabilityClass;
use judder_oscillator::spectrum::{eigenvalues, growth_rate, leading, mode};
use judder_oscillator::undecided::{Ranges, undecided};
use judder_oscillator::within_law::WithinLaw;
use judder_oscillator::{Coefficients, Contact, Groups, OscillatorError};
use judder_study::Silent;
use judder_study::text::{columns, list, number, short};
use num_complex::Complex64;
use serde_json::{Value, json};

/// Where the critical shear strength is sought, as τ0/E0*.
pub const SHEAR_STRENGTHS: ParameterRange =
    ParameterRange { from: 1e-8, to: 1e3, scale: RangeScale::Logarithmic };
/// Where the critical load is sought, as F_n/(E0* R²).
pub const LOADS: ParameterRange = ParameterRange { from: 1e-14, to: 1e1, scale: RangeScale::Logarithmic };
/// Samples of those searches: 40 a decade.
pub(crate) const SAMPLES: usize = 601;

/// Steady sliding at one operating point, and what small motions about it do.
#[derive(Debug, Clone, Copy)]
pub struct SteadyPoint {
    /// The dimensionless groups.
    pub groups: Groups,
    /// Steady sliding.
    pub equilibrium: Equilibrium,
    /// C and K about it.
    pub linearisation: Linearisation,
    /// The four eigenvalues, sorted by imaginary, then real part.
    pub eigenvalues: [Complex64; 4],
    /// Verdict and mechanism.
    pub class: StabilityClass,
    /// What the errors of the law leave of them; `None` where that is not known.
    pub within_law: Option<WithinLaw>,
}

impl SteadyPoint {
    /// The steady sliding of an oscillator given by its groups, and its eigenvalues.
    ///
    /// # Errors
    /// A group out of range, no (or more than one) equilibrium.
    pub fn new(contact: &Contact, groups: Groups) -> Result<Self, OscillatorError> {
        let coefficients = groups.coefficients()?;
        let equilibrium = equilibrium(contact, &coefficients)?;
        let linearisation = Linearisation::new(contact.friction_load, &coefficients, &equilibrium.response);
        let reduced = linearisation.system().reduced()?;
        let eigenvalues = eigenvalues(&reduced)?;
        let class = StabilityClass::of(&reduced);
        let within_law = WithinLaw::new(contact, &coefficients, &equilibrium);
        Ok(Self { groups, equilibrium, linearisation, eigenvalues, class, within_law })
    }

    /// The growth rate, in units of ω_nx.
    #[must_use]
    pub fn growth_rate(&self) -> f64 {
        growth_rate(&self.eigenvalues)
    }

    /// `"stable"`, `"marginal"` or `"unstable"`; `"unresolved"` where there is no verdict.
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        self.class.verdict().map_or("unresolved", judder_oscillator::Verdict::name)
    }

    /// How far ξ_eq may be off by the errors of the law; `None` where that is not known.
    #[must_use]
    pub fn equivalent_damping_error(&self) -> Option<f64> {
        self.within_law.map(|within| within.equivalent_damping_error())
    }

    /// The smallest and the largest growth rate that the law has with its errors, in units of ω_nx; `None` where that is not known.
    #[must_use]
    pub fn growth_rate_within_law(&self) -> Option<[f64; 2]> {
        self.within_law?.growth_rates().ok().map(|(least, most)| [least, most])
    }

    /// How far the growth rate may be off by the errors of the law: the larger distance of the ends of
    /// [`growth_rate_within_law`](Self::growth_rate_within_law).
    #[must_use]
    pub fn growth_rate_error(&self) -> Option<f64> {
        let ([least, most], own) = (self.growth_rate_within_law()?, self.growth_rate());
        Some((most - own).max(own - least))
    }

    /// Whether the law with its errors has other verdicts too; `None` where that is not known.
    #[must_use]
    pub fn marginal_within_law(&self) -> Option<bool> {
        self.within_law.map(|within| !within.is_decided())
    }

    /// Verdict and mechanism in words: where the errors of the law decide, that comes first and the nominal verdict after it.
    #[must_use]
    pub fn verdict_in_words(&self) -> String {
        let by = match self.class.mechanism() {
            judder_oscillator::Mechanism::None => String::new(),
            mechanism => format!(", by {}", mechanism.name()),
        };
        let nominal = format!("{}{by}", self.verdict());
        match self.marginal_within_law() {
            Some(false) => nominal,
            Some(true) => format!("{MARGINAL}; nominally {nominal}"),
            None => format!("{nominal}; what the errors of the law leave of it is not known here"),
        }
    }
}

/// One operating point, analysed.
#[derive(Debug, Clone)]
pub struct AnalysedPoint {
    /// Steady sliding and its eigenvalues.
    pub steady: SteadyPoint,
    /// What each matrix entry feeds into the growth rate of the leading mode.
    pub shares: EntryShares,
    /// ∂λ by the entries of C and K, for the leading mode.
    pub sensitivities: judder_oscillator::growth::Sensitivities,
    /// All conservative thresholds of the shear strength at this speed and load, ascending.
    pub critical_shear_strength: Vec<f64>,
    /// The ranges of the shear strength in which the errors of the law leave these thresholds; `None` where the errors are not known.
    pub critical_shear_strength_within_law: Option<Ranges>,
    /// All conservative thresholds of the load at this speed and shear strength, ascending.
    pub critical_load: Vec<f64>,
    /// The same ranges of the load.
    pub critical_load_within_law: Option<Ranges>,
    /// Eq. (3); `None` for an elastic substrate, and where only groups are given.
    pub quasi_steady: Option<QuasiSteadyCondition>,
    /// What makes the law doubtful here.
    pub warnings: Vec<String>,
}

/// Analyses the operating point of a case.
///
/// # Errors
/// A group out of range, no (or more than one) equilibrium.
pub fn point(case: &OscillatorCase) -> Result<AnalysedPoint, ModelError> {
    let case = &bridge::with_material(case)?;
    point_with(case, &bridge::contact_of(case, &Silent)?)
}

/// Analyses the operating point of a case whose contact is known.
///
/// # Errors
/// As [`point`].
pub fn point_with(case: &OscillatorCase, contact: &CaseContact) -> Result<AnalysedPoint, ModelError> {
    let substrate = KnownSubstrate::of(case)?;
    let point = analyse(&contact.contact, bridge::groups(&case.inputs))?;
    Ok(point.in_contact(&case.inputs, contact, &substrate))
}

impl AnalysedPoint {
    /// The point with what is to be said of its contact and of its substrate.
    pub(crate) fn in_contact(
        mut self,
        inputs: &OscillatorInputs,
        contact: &CaseContact,
        substrate: &KnownSubstrate,
    ) -> Self {
        self.quasi_steady = QuasiSteadyCondition::at(inputs, Some(&contact.contact), &substrate.terms);
        let broken = self.quasi_steady.and_then(|condition| condition.warning(None));
        let of_band = substrate.band_warning(&contact.contact, [*inputs]);
        let of_temperature = substrate.temperature_warning.clone();
        self.warnings
            .extend(contact.warnings.iter().cloned().chain(of_temperature).chain(of_band).chain(broken));
        self
    }
}

/// Analyses an oscillator given by its groups.
///
/// # Errors
/// As [`point`].
pub fn analyse(contact: &Contact, groups: Groups) -> Result<AnalysedPoint, ModelError> {
    let steady = SteadyPoint::new(contact, groups)?;
    let system = steady.linearisation.system();
    let leading_mode = mode(&system, leading(&steady.eigenvalues));
    let at_strength = |shear_strength: f64| Groups { shear_strength, ..groups }.resolve();
    let at_load = |normal_load: f64| Groups { normal_load, ..groups }.resolve();
    let strengths = thresholds(contact, &SHEAR_STRENGTHS, SAMPLES, at_strength);
    let loads = thresholds(contact, &LOADS, SAMPLES, at_load);
    let is_known = contact.law.knows_its_errors();
    let open = |range: &ParameterRange, roots: &Thresholds, at: &dyn Fn(f64) -> Coefficients| {
        let roots = [roots.full.as_slice(), roots.conservative.as_slice()];
        is_known.then(|| undecided(contact, range, SAMPLES, roots, at).conservative)
    };
    let mut warnings: Vec<String> = contact
        .law
        .concern(groups.velocity, steady.equilibrium.indentation)
        .iter()
        .map(ToString::to_string)
        .collect();
    warnings.extend(told_marginal(&steady));
    for (what, found) in [("shear strengths", &strengths), ("loads", &loads)] {
        if let (Some(first), Some(last)) = (found.failures.first(), found.failures.last()) {
            warnings.push(format!(
                "no single steady sliding state at {} of {SAMPLES} {what} searched, between {} and {}: thresholds there are missing",
                found.failures.len(),
                short(*first),
                short(*last)
            ));
        }
    }
    Ok(AnalysedPoint {
        steady,
        shares: growth_shares(&system, &leading_mode),
        sensitivities: sensitivities(&system, &leading_mode),
        critical_shear_strength_within_law: open(&SHEAR_STRENGTHS, &strengths, &at_strength),
        critical_shear_strength: strengths.conservative,
        critical_load_within_law: open(&LOADS, &loads, &at_load),
        critical_load: loads.conservative,
        quasi_steady: None,
        warnings,
    })
}

/// That the errors of the law decide at a point, in words.
fn told_marginal(steady: &SteadyPoint) -> Option<String> {
    if steady.marginal_within_law() != Some(true) {
        return None;
    }
    let unknown = || "unknown".to_owned();
    let off = steady.equivalent_damping_error().map_or_else(unknown, short);
    let rates = steady.growth_rate_within_law();
    let rates =
        rates.map_or_else(unknown, |[least, most]| format!("from {} to {}", short(least), short(most)));
    Some(format!(
        "the errors of the law decide here: ξ_eq = {} ± {off}, growth rate {rates}; a law of a finer accuracy has smaller errors",
        short(steady.linearisation.equivalent_damping()),
    ))
}

/// A complex number as `[re, im]`.
fn pair(value: Complex64) -> Value {
    json!([value.re, value.im])
}

impl AnalysedPoint {
    /// The document of `judder point --json`.
    #[must_use]
    pub fn json(&self) -> Value {
        let steady = &self.steady;
        let response = &steady.equilibrium.response;
        let sensitivity = |entries: [[Complex64; 2]; 2]| entries.map(|row| row.map(pair));
        json!({
            "groups": {
                "stiffness": steady.groups.stiffness,
                "retardation_time": steady.groups.retardation_time,
                "radius": steady.groups.radius(),
                "velocity": steady.groups.velocity,
                "normal_load": steady.groups.normal_load,
                "shear_strength": steady.groups.shear_strength,
            },
            "equilibrium": {
                "x": steady.equilibrium.x,
                "y": steady.equilibrium.y,
                "indentation": steady.equilibrium.indentation,
            },
            "contact": {
                "force": response.force.value,
                "area": response.area.value,
                "viscoelastic_friction": response.friction.value,
            },
            "damping": steady.linearisation.damping(),
            "stiffness": steady.linearisation.stiffness(),
            "eigenvalues": steady.eigenvalues.map(pair),
            "growth_rate": steady.growth_rate(),
            "growth_rate_error": steady.growth_rate_error(),
            "growth_rate_within_law": steady.growth_rate_within_law(),
            "verdict": steady.verdict(),
            "mechanism": steady.class.mechanism().name(),
            "marginal_within_law": steady.marginal_within_law(),
            "equivalent_damping": steady.linearisation.equivalent_damping(),
            "equivalent_damping_error": steady.equivalent_damping_error(),
            "critical_shear_strength": self.critical_shear_strength,
            "critical_shear_strength_within_law": self.critical_shear_strength_within_law,
            "critical_load": self.critical_load,
            "critical_load_within_law": self.critical_load_within_law,
            "growth_shares": { "damping": self.shares.damping, "stiffness": self.shares.stiffness },
            "sensitivities": {
                "damping": sensitivity(self.sensitivities.damping),
                "stiffness": sensitivity(self.sensitivities.stiffness),
            },
            "quasi_steady": self.quasi_steady.as_ref().map(QuasiSteadyCondition::json),
            "warnings": self.warnings,
        })
    }
}

impl AnalysedPoint {
    /// What `judder point` prints on a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.steady.verdict_in_words());
        text.push_str(&columns(&self.state_rows()));
        text.push_str("\neigenvalues λ/ω_nx\n");
        let eigenvalues = self.steady.eigenvalues.map(|l| vec![number(l.re), format!("{} i", number(l.im))]);
        text.push_str(&columns(&eigenvalues));
        text.push_str("\ngrowth rate fed by each entry of C and K\n");
        text.push_str(&columns(&self.share_rows()));
        text.push_str("\nthresholds without damping (eqs. 27, 28)\n");
        text.push_str(&columns(&self.threshold_rows()));
        if let Some(condition) = &self.quasi_steady {
            text.push_str("\nthe law of steady sliding in motion\n");
            text.push_str(&columns(&condition.rows()));
        }
        for warning in &self.warnings {
            text.push_str("\nwarning: ");
            text.push_str(warning);
            text.push('\n');
        }
        text
    }

    fn state_rows(&self) -> Vec<Vec<String>> {
        let steady = &self.steady;
        let response = &steady.equilibrium.response;
        let damping_error = match steady.equivalent_damping_error() {
            None => "± unknown".to_owned(),
            Some(0.0) => String::new(),
            Some(error) => format!("± {}", short(error)),
        };
        let growth_rates = match steady.growth_rate_within_law() {
            None => "within the law: unknown".to_owned(),
            Some([least, most]) if least == most => String::new(),
            Some([least, most]) => format!("within the law: {} to {}", short(least), short(most)),
        };
        let certain = String::new;
        [
            ("speed v τ/R", steady.groups.velocity, certain()),
            ("load F_n/(E0* R²)", steady.groups.normal_load, certain()),
            ("shear strength τ0/E0*", steady.groups.shear_strength, certain()),
            ("indentation y/R", steady.equilibrium.indentation, certain()),
            ("displacement x/x0", steady.equilibrium.x, certain()),
            ("displacement y/x0", steady.equilibrium.y, certain()),
            ("contact force F_k/(E0* R²)", response.force.value, certain()),
            ("contact area A/R²", response.area.value, certain()),
            ("viscoelastic friction μ_visc", response.friction.value, certain()),
            ("equivalent damping ξ_eq", steady.linearisation.equivalent_damping(), damping_error),
            ("growth rate", steady.growth_rate(), growth_rates),
        ]
        .into_iter()
        .map(|(name, value, error)| vec![name.to_owned(), number(value), error])
        .collect()
    }

    /// The thresholds without damping, and where the errors of the law leave them.
    pub(crate) fn threshold_rows(&self) -> Vec<Vec<String>> {
        let rows = |name: &str, found: &[f64], open: &Option<Ranges>| {
            let own = vec![name.to_owned(), list(found)];
            let open = ranges_text(open).map(|open| vec!["  within the law".to_owned(), open]);
            [Some(own), open].into_iter().flatten()
        };
        let strengths = (&self.critical_shear_strength, &self.critical_shear_strength_within_law);
        let loads = (&self.critical_load, &self.critical_load_within_law);
        rows("critical shear strength τ0/E0*", strengths.0, strengths.1)
            .chain(rows("critical load F_n/(E0* R²)", loads.0, loads.1))
            .collect()
    }

    fn share_rows(&self) -> Vec<Vec<String>> {
        let (c, k) = (&self.shares.damping, &self.shares.stiffness);
        [("c11", c[0][0]), ("c21", c[1][0]), ("c22", c[1][1]), ("k12 + k12c", k[0][1]), ("k21", k[1][0])]
            .into_iter()
            .map(|(name, value)| vec![name.to_owned(), number(value)])
            .collect()
    }
}
