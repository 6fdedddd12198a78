//! The creep spectrum: how far a material yields to a stress that stays.

use super::error::{MaterialError, positive};
use crate::kernel::substrate::{SlidingSubstrate, WakeTerm};
#[cfg(feature = "keys")]
use judder_keys::{declared::Number, dimension::Dimension};
use judder_numerics::order::sort_by_number;
use num_complex::Complex64;

/// A term of the creep compliance, C (1 − e^{−t/τ}).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings), settings(title = "a prony term"))]
pub struct CreepTerm {
    /// Retardation (creep) time of a term.
    ///
    /// τ_k \[s\]: not the relaxation time.
    #[cfg_attr(feature = "keys", key(name = "time", rule = Number::positive(Dimension::TIME), symbol = "τ_k"))]
    pub retardation_time: f64,
    /// Creep compliance of a term.
    ///
    /// C_k [1/Pa], which appears after its time.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::COMPLIANCE), symbol = "C_k"))]
    pub compliance: f64,
}

/// J(t) = 1/E∞ + Σ C_k (1 − e^{−t/τ_k}): at once the glassy compliance, in the end the rubbery one 1/E0 = 1/E∞ + Σ C_k.
///
/// The discrete form of the oscillator paper's appendix A. Terms stand in ascending order of time, no time twice; every
/// C_k is positive, so E0 ≤ E∞, creep never recedes, E′ rises with frequency and E″ is positive.
#[derive(Debug, Clone, PartialEq)]
pub struct CreepSpectrum {
    glassy_modulus: f64,
    terms: Vec<CreepTerm>,
}

impl CreepSpectrum {
    /// A spectrum from E∞ \[Pa\] and its terms, in any order; terms of equal time are added up. No term: elastic.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for E∞, [`MaterialError::Term`] for the first time or compliance that is not
    /// positive and finite, [`MaterialError::Sum`] when the compliances overflow.
    pub fn new(glassy_modulus: f64, mut terms: Vec<CreepTerm>) -> Result<Self, MaterialError> {
        positive("the glassy modulus E∞ [Pa]", glassy_modulus)?;
        for (index, term) in terms.iter().enumerate() {
            let parts = [("retardation time", term.retardation_time), ("compliance", term.compliance)];
            if let Some((name, value)) =
                parts.into_iter().find(|(name, value)| positive(name, *value).is_err())
            {
                return Err(MaterialError::Term { index: index + 1, name, value });
            }
        }
        sort_by_number(&mut terms, |own| own.retardation_time);
        terms.dedup_by(|later, kept| {
            let equal = later.retardation_time == kept.retardation_time;
            kept.compliance += if equal { later.compliance } else { 0.0 };
            equal
        });
        let spectrum = Self { glassy_modulus, terms };
        let sum = spectrum.rubbery_compliance();
        if sum.is_finite() { Ok(spectrum) } else { Err(MaterialError::Sum { sum }) }
    }

    /// An elastic material: no term, E0 = E∞.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`].
    pub fn elastic(modulus: f64) -> Result<Self, MaterialError> {
        positive("the modulus E [Pa]", modulus)?;
        Ok(Self { glassy_modulus: modulus, terms: Vec::new() })
    }

    /// One retardation time τ \[s\] between E0 and E∞ \[Pa\], the material of the oscillator paper: C = 1/E0 − 1/E∞.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`], or [`MaterialError::RubberyNotBelowGlassy`] unless E0 < E∞.
    pub fn single(
        rubbery_modulus: f64,
        glassy_modulus: f64,
        retardation_time: f64,
    ) -> Result<Self, MaterialError> {
        let rubbery = positive("the rubbery modulus E0 [Pa]", rubbery_modulus)?;
        let glassy = positive("the glassy modulus E∞ [Pa]", glassy_modulus)?;
        let retardation_time = positive("the retardation time τ [s]", retardation_time)?;
        if rubbery >= glassy {
            return Err(MaterialError::RubberyNotBelowGlassy { rubbery, glassy });
        }
        let compliance = (glassy - rubbery) / glassy / rubbery;
        Self::new(glassy, vec![CreepTerm { retardation_time, compliance }])
    }

    /// E∞ \[Pa\], the modulus at infinite frequency.
    #[must_use]
    pub fn glassy_modulus(&self) -> f64 {
        self.glassy_modulus
    }

    /// E0 = 1/(1/E∞ + Σ C_k) \[Pa\], the modulus at rest.
    #[must_use]
    pub fn rubbery_modulus(&self) -> f64 {
        1.0 / self.rubbery_compliance()
    }

    /// E∞/E0.
    #[must_use]
    pub fn contrast(&self) -> f64 {
        1.0 + self.delayed_compliance() * self.glassy_modulus
    }

    /// The terms, ascending in retardation time.
    #[must_use]
    pub fn terms(&self) -> &[CreepTerm] {
        &self.terms
    }

    /// J(t) = 1/E∞ + Σ C_k (1 − e^{−t/τ_k}) \[1/Pa\]: strain at time t \[s\] after a unit stress; 0 before.
    #[must_use]
    pub fn creep_compliance(&self, time: f64) -> f64 {
        if time < 0.0 {
            return 0.0;
        }
        let delayed = |term: &CreepTerm| -term.compliance * libm::expm1(-time / term.retardation_time);
        self.terms.iter().map(delayed).sum::<f64>() + 1.0 / self.glassy_modulus
    }

    /// 1/E(ω) = 1/E∞ + Σ C_k/(1 + iωτ_k) [1/Pa] at ω [rad/s], for a motion e^{iωt} (30).
    #[must_use]
    pub fn complex_compliance(&self, angular_frequency: f64) -> Complex64 {
        let term = |term: &CreepTerm| {
            let turn = angular_frequency * term.retardation_time;
            // written so that ωτ may be anything up to infinity
            let real = 1.0 / (1.0 + turn * turn);
            let imaginary = if turn.abs() > 1.0 { -1.0 / (turn + 1.0 / turn) } else { -turn * real };
            Complex64::new(term.compliance * real, term.compliance * imaginary)
        };
        self.terms.iter().map(term).sum::<Complex64>() + 1.0 / self.glassy_modulus
    }

    /// E(ω) = E′ + iE″ \[Pa\] at ω \[rad/s\] (30).
    #[must_use]
    pub fn complex_modulus(&self, angular_frequency: f64) -> Complex64 {
        // scaled by E0, as the squares of compliances in 1/Pa could underflow
        let rubbery = self.rubbery_modulus();
        (self.complex_compliance(angular_frequency) * rubbery).inv() * rubbery
    }

    /// E″/E′ at ω [rad/s].
    #[must_use]
    pub fn loss_tangent(&self, angular_frequency: f64) -> f64 {
        let compliance = self.complex_compliance(angular_frequency);
        -compliance.im / compliance.re
    }

    /// What the contact computation needs of the material, free of units: E0/E∞, and for every term (C_k E0, τ_k \[s\]).
    #[must_use]
    pub fn sliding_terms(&self) -> (f64, Vec<(f64, f64)>) {
        let rubbery = self.rubbery_modulus();
        let term = |term: &CreepTerm| (term.compliance * rubbery, term.retardation_time);
        (1.0 / self.contrast(), self.terms.iter().map(term).collect())
    }

    /// The substrate under an indenter that slides at `speed` [lengths/s], with lengths as the contact computation counts
    /// them (in R): ℓ_k = v τ_k.
    #[must_use]
    pub fn sliding_at(&self, speed: f64) -> SlidingSubstrate {
        let (instantaneous, terms) = self.sliding_terms();
        let term = |(compliance, time): (f64, f64)| WakeTerm { compliance, length: speed * time };
        SlidingSubstrate { instantaneous, terms: terms.into_iter().map(term).collect(), layer: None }
    }

    /// The same material with every retardation time multiplied by `factor`, as a change of temperature does.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for the factor, [`MaterialError::Term`] for a time that leaves the numbers.
    pub fn with_times_multiplied(&self, factor: f64) -> Result<Self, MaterialError> {
        positive("the shift factor a_T", factor)?;
        let shifted =
            |term: &CreepTerm| CreepTerm { retardation_time: term.retardation_time * factor, ..*term };
        Self::new(self.glassy_modulus, self.terms.iter().map(shifted).collect())
    }

    /// Σ C_k [1/Pa].
    fn delayed_compliance(&self) -> f64 {
        self.terms.iter().map(|term| term.compliance).sum()
    }

    /// 1/E0 = 1/E∞ + Σ C_k [1/Pa].
    fn rubbery_compliance(&self) -> f64 {
        self.delayed_compliance() + 1.0 / self.glassy_modulus
    }
}
