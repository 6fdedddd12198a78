//! The relaxation spectrum: how the stress decays under a strain that stays.

use super::error::{MaterialError, positive};
#[cfg(feature = "keys")]
use judder_keys::{declared::Number, dimension::Dimension};
use judder_numerics::order::sort_by_number;
use num_complex::Complex64;

/// A term of the relaxation modulus, E e^{−t/ρ}.
///
/// A Maxwell element.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings), settings(title = "a relaxation term"))]
pub struct RelaxationTerm {
    /// Relaxation time of a term.
    ///
    /// ρ_j \[s\]: not the retardation time.
    #[cfg_attr(feature = "keys", key(name = "time", rule = Number::positive(Dimension::TIME), symbol = "ρ_j"))]
    pub relaxation_time: f64,
    /// Modulus of a term.
    ///
    /// E_j \[Pa\], which is lost after its time.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::STRESS), symbol = "E_j"))]
    pub modulus: f64,
}

/// E(t) = E0 + Σ E_j e^{−t/ρ_j}, the generalised Maxwell solid: at once the glassy modulus E∞ = E0 + Σ E_j, in the end E0.
///
/// Terms stand in ascending order of time, no time twice; every E_j is positive.
#[derive(Debug, Clone, PartialEq)]
pub struct RelaxationSpectrum {
    rubbery_modulus: f64,
    terms: Vec<RelaxationTerm>,
}

impl RelaxationSpectrum {
    /// A spectrum from E0 \[Pa\] and its terms, in any order; terms of equal time are added up. No term: elastic.
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for E0 (a fluid, E0 = 0, carries no load at rest), [`MaterialError::Term`] for the first
    /// time or modulus that is not positive and finite, [`MaterialError::Sum`] when the moduli overflow.
    pub fn new(rubbery_modulus: f64, mut terms: Vec<RelaxationTerm>) -> Result<Self, MaterialError> {
        positive("the rubbery modulus E0 [Pa]", rubbery_modulus)?;
        for (index, term) in terms.iter().enumerate() {
            let parts = [("relaxation time", term.relaxation_time), ("modulus", term.modulus)];
            if let Some((name, value)) =
                parts.into_iter().find(|(name, value)| positive(name, *value).is_err())
            {
                return Err(MaterialError::Term { index: index + 1, name, value });
            }
        }
        sort_by_number(&mut terms, |own| own.relaxation_time);
        terms.dedup_by(|later, kept| {
            let equal = later.relaxation_time == kept.relaxation_time;
            kept.modulus += if equal { later.modulus } else { 0.0 };
            equal
        });
        let spectrum = Self { rubbery_modulus, terms };
        let sum = spectrum.glassy_modulus();
        if sum.is_finite() { Ok(spectrum) } else { Err(MaterialError::Sum { sum }) }
    }

    /// E0 \[Pa\], the modulus at rest.
    #[must_use]
    pub fn rubbery_modulus(&self) -> f64 {
        self.rubbery_modulus
    }

    /// E∞ = E0 + Σ E_j \[Pa\], the modulus at infinite frequency.
    #[must_use]
    pub fn glassy_modulus(&self) -> f64 {
        self.terms.iter().map(|term| term.modulus).sum::<f64>() + self.rubbery_modulus
    }

    /// The terms, ascending in relaxation time.
    #[must_use]
    pub fn terms(&self) -> &[RelaxationTerm] {
        &self.terms
    }

    /// E(t) = E0 + Σ E_j e^{−t/ρ_j} \[Pa\]: stress at time t \[s\] after a unit strain; 0 before.
    #[must_use]
    pub fn relaxation_modulus(&self, time: f64) -> f64 {
        if time < 0.0 {
            return 0.0;
        }
        let left = |term: &RelaxationTerm| term.modulus * libm::exp(-time / term.relaxation_time);
        self.terms.iter().map(left).sum::<f64>() + self.rubbery_modulus
    }

    /// E(ω) = E0 + Σ E_j iωρ_j/(1 + iωρ_j) \[Pa\] at ω \[rad/s\], for a motion e^{iωt}.
    #[must_use]
    pub fn complex_modulus(&self, angular_frequency: f64) -> Complex64 {
        let term = |term: &RelaxationTerm| maxwell(angular_frequency * term.relaxation_time) * term.modulus;
        self.terms.iter().map(term).sum::<Complex64>() + self.rubbery_modulus
    }
}

/// iz/(1 + iz), the response of a Maxwell element of unit modulus at z = ωρ, for any z up to infinity.
pub(super) fn maxwell(turn: f64) -> Complex64 {
    if turn.abs() > 1.0 {
        let inverse = 1.0 / turn;
        let real = 1.0 / (1.0 + inverse * inverse);
        Complex64::new(real, inverse * real)
    } else {
        let real = 1.0 / (1.0 + turn * turn);
        Complex64::new(turn * turn * real, turn * real)
    }
}
