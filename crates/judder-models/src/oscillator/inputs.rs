//! The numbers and choices of one oscillator operating point.

use crate::motion::si::SiUnits;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::law_name::LawName;
use crate::oscillator::problem::OscillatorProblem;
use judder_keys::cause::Cause;
use judder_keys::keys::{Keys, Numbers};
use judder_keys::numeric_key::{Form, Value};
use judder_oscillator::groups::Scales;
use std::sync::LazyLock;

/// How the substrate's relaxation was given; the other quantities follow from what was given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TimeForm {
    /// `retardation_time` with `glassy_modulus`.
    Retardation,
    /// `relaxation_time` with `glassy_modulus`: τ = τ_r E∞/E0.
    Relaxation,
    /// One Prony term, whose time is τ: 1/E∞ = 1/E0 − compliance.
    Prony {
        /// The compliance of the term, 1/Pa.
        compliance: f64,
    },
}

impl TimeForm {
    /// The key of `[substrate]` that was given.
    pub fn name(self) -> &'static str {
        match self {
            Self::Retardation => "retardation_time",
            Self::Relaxation => "relaxation_time",
            Self::Prony { .. } => "prony",
        }
    }
}

/// The value of every numeric key at one operating point. Small and `Copy`: a sweep sets one key a point, and
/// the order in which several keys are set does not matter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OscillatorInputs {
    values: [Value; OscillatorKey::ALL.len()],
    /// Whether the relaxation time is the one that was given; the retardation time then follows.
    gives_relaxation: bool,
    /// The compliance of a Prony term, 1/Pa; the glassy modulus then follows.
    compliance: Option<f64>,
}

impl Default for OscillatorInputs {
    /// The oscillator paper's values.
    fn default() -> Self {
        static USUAL: LazyLock<[Value; OscillatorKey::ALL.len()]> = LazyLock::new(|| {
            std::array::from_fn(|k| OscillatorKey::ALL[k].usual_value().unwrap_or(Value::si(0.0)))
        });
        Self { values: *USUAL, gives_relaxation: false, compliance: None }
    }
}

impl OscillatorInputs {
    /// The value of a key. Retardation time, relaxation time and glassy modulus follow from what was given:
    /// τ_r = τ E0/E∞, and 1/E∞ = 1/E0 − compliance for a Prony term.
    pub fn get(&self, key: OscillatorKey) -> Value {
        let given = |key: OscillatorKey| self.values[key as usize];
        let rubbery = given(OscillatorKey::RubberyModulus).number;
        let glassy = match self.compliance {
            Some(compliance) => Value::si(1.0 / (1.0 / rubbery - compliance)),
            None => given(OscillatorKey::GlassyModulus),
        };
        match key {
            OscillatorKey::GlassyModulus => glassy,
            OscillatorKey::RetardationTime if self.gives_relaxation => {
                Value::si(given(OscillatorKey::RelaxationTime).number * glassy.number / rubbery)
            }
            OscillatorKey::RelaxationTime if !self.gives_relaxation => {
                Value::si(given(OscillatorKey::RetardationTime).number * rubbery / glassy.number)
            }
            _ => given(key),
        }
    }

    /// The number of a key, in the form that [`OscillatorInputs::get`] tells.
    pub fn number(&self, key: OscillatorKey) -> f64 {
        self.get(key).number
    }

    /// The three scales that turn groups into quantities: E0* = E0/(1 − ν²), R, ω_nx.
    #[must_use]
    pub fn scales(&self) -> Scales {
        let poisson_ratio = self.number(OscillatorKey::PoissonRatio);
        Scales {
            reduced_modulus: self.number(OscillatorKey::RubberyModulus)
                / (1.0 - poisson_ratio * poisson_ratio),
            radius: self.number(OscillatorKey::Radius),
            natural_frequency: self.number(OscillatorKey::NaturalFrequency),
        }
    }

    /// 1/ω_nx in s, x0 = F_n/k_x in m, k_x x0² in J and R² in m², where speed or load are given in SI.
    pub(crate) fn si_units(&self) -> Option<SiUnits> {
        let is_si = |key: OscillatorKey| self.get(key).form == Form::Si;
        let Scales { reduced_modulus, radius, natural_frequency } = self.scales();
        let load = self.get(OscillatorKey::NormalLoad);
        let newtons = match load.form {
            Form::Si => load.number,
            Form::Group => load.number * reduced_modulus * radius * radius,
        };
        let metre = newtons / self.number(OscillatorKey::StiffnessX);
        let units = SiUnits {
            second: 1.0 / natural_frequency,
            metre,
            joule: newtons * metre,
            square_metre: radius * radius,
        };
        (is_si(OscillatorKey::NormalLoad) || is_si(OscillatorKey::Velocity)).then_some(units)
    }

    /// How the relaxation of the substrate was given.
    pub fn time_form(&self) -> TimeForm {
        match self.compliance {
            Some(compliance) => TimeForm::Prony { compliance },
            None if self.gives_relaxation => TimeForm::Relaxation,
            None => TimeForm::Retardation,
        }
    }

    /// Sets a key. Setting one of the two times makes the other follow; setting the glassy modulus replaces the
    /// compliance of a Prony term. Neither range nor form is checked here: that is the reader's part.
    pub fn set(&mut self, key: OscillatorKey, value: Value) {
        match key {
            OscillatorKey::RetardationTime => self.gives_relaxation = false,
            OscillatorKey::RelaxationTime => self.gives_relaxation = true,
            OscillatorKey::GlassyModulus => self.compliance = None,
            _ => (),
        }
        self.values[key as usize] = value;
    }

    /// Sets what a section gives, in the order of the keys.
    pub(crate) fn set_all(&mut self, Numbers(given): &Numbers<OscillatorKey>) {
        given.iter().for_each(|(key, value)| self.set(*key, *value));
    }

    /// The values in use of the keys of a section that `is_taken`.
    pub(crate) fn numbers(
        &self,
        section: &str,
        is_taken: impl Fn(OscillatorKey) -> bool,
    ) -> Numbers<OscillatorKey> {
        let own = OscillatorKey::of_section(section).map(|entry| entry.key).filter(|key| is_taken(*key));
        Numbers(own.map(|key| (key, self.get(key))).collect())
    }

    /// Makes one Prony term the form in which the relaxation is given: creep time in s, compliance in 1/Pa.
    pub fn set_prony(&mut self, time: f64, compliance: f64) {
        self.set(OscillatorKey::RetardationTime, Value::si(time));
        self.compliance = Some(compliance);
    }

    /// Checks the conditions that tie keys together: E∞ > E0 (for `hertz`, E∞ ≥ E0), and for a Prony term
    /// compliance < 1/E0.
    ///
    /// # Errors
    /// [`OscillatorProblem::PronyCompliance`] or [`OscillatorProblem::GlassyBelowRubbery`].
    pub fn check(&self, law: LawName) -> Result<(), Cause> {
        let rubbery = self.number(OscillatorKey::RubberyModulus);
        if let Some(compliance) = self.compliance
            && compliance >= 1.0 / rubbery
        {
            return Err(OscillatorProblem::PronyCompliance { compliance, limit: 1.0 / rubbery }.into());
        }
        let glassy = self.number(OscillatorKey::GlassyModulus);
        if glassy > rubbery || (law == LawName::Hertz && glassy == rubbery) {
            Ok(())
        } else {
            Err(OscillatorProblem::GlassyBelowRubbery { rubbery, glassy, law }.into())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The kind of problem that was found.
    fn kind(checked: Result<(), Cause>) -> &'static str {
        match checked {
            Err(Cause::Problem(problem)) => problem.kind(),
            _ => "",
        }
    }
    use OscillatorKey::{GlassyModulus, RelaxationTime, RetardationTime, RubberyModulus};

    #[test]
    fn relaxation_and_retardation_follow_from_each_other() {
        let mut inputs = OscillatorInputs::default();
        assert_eq!(inputs.number(RelaxationTime), 1e-3);
        inputs.set(RelaxationTime, Value::si(2e-3));
        assert_eq!((inputs.number(RetardationTime), inputs.time_form()), (0.02, TimeForm::Relaxation));
        inputs.set(GlassyModulus, Value::si(2e7));
        assert_eq!(inputs.number(RetardationTime), 0.04);
        inputs.set(RetardationTime, Value::si(0.01));
        assert_eq!((inputs.number(RelaxationTime), inputs.time_form()), (5e-4, TimeForm::Retardation));
    }

    #[test]
    fn a_prony_term_gives_the_glassy_modulus_until_that_is_set() {
        let mut inputs = OscillatorInputs::default();
        inputs.set_prony(0.01, 0.9e-6);
        assert!((inputs.number(GlassyModulus) / 1e7 - 1.0).abs() < 1e-12);
        assert!((inputs.number(RelaxationTime) / 1e-3 - 1.0).abs() < 1e-12);
        inputs.set(RubberyModulus, Value::si(2e6));
        assert_eq!(kind(inputs.check(LawName::Hertz)), "PronyCompliance");
        inputs.set(GlassyModulus, Value::si(2e7));
        assert_eq!((inputs.number(RetardationTime), inputs.time_form()), (0.01, TimeForm::Retardation));
        assert!(inputs.check(LawName::OscillatorPaper).is_ok());
    }

    #[test]
    fn the_order_of_setting_does_not_matter() {
        let settings = [RubberyModulus, RelaxationTime].map(|key| (key, Value::si(0.5)));
        let mut forward = OscillatorInputs::default();
        forward.set_prony(0.01, 0.9e-6);
        let mut backward = forward;
        settings.iter().for_each(|(key, value)| forward.set(*key, *value));
        settings.iter().rev().for_each(|(key, value)| backward.set(*key, *value));
        assert_eq!(forward, backward);
    }

    #[test]
    fn equal_moduli_are_for_hertz_alone() {
        let mut inputs = OscillatorInputs::default();
        inputs.set(GlassyModulus, Value::si(1e6));
        assert!(inputs.check(LawName::Hertz).is_ok());
        assert_eq!(kind(inputs.check(LawName::OscillatorPaper)), "GlassyBelowRubbery");
    }
}
