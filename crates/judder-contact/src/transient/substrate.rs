//! The substrate as an indenter sees it that moves on any path.

use super::error::TransientError;
use crate::kernel::substrate::{SlidingSubstrate, WakeTerm};
use crate::material::CreepSpectrum;
use num_complex::Complex64;

/// One retardation time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepingTerm {
    /// C_k E0, compliance of the term over that of the relaxed substrate.
    pub compliance: f64,
    /// τ_k, retardation time (not a relaxation time), in the problem's time unit.
    pub time: f64,
}

/// J(t) = E0/E∞ + Σ C_k E0 (1 − e^{−t/τ_k}), creep in units of 1/E0.
#[derive(Debug, Clone, PartialEq)]
pub struct CreepingSubstrate {
    /// E0/E∞.
    pub instantaneous: f64,
    /// The terms of the creep spectrum.
    pub terms: Vec<CreepingTerm>,
}

impl CreepingSubstrate {
    /// An elastic half-space of modulus E0.
    #[must_use]
    pub fn elastic() -> Self {
        Self { instantaneous: 1.0, terms: Vec::new() }
    }

    /// One retardation time: `contrast` is E∞/E0, `time` is τ.
    #[must_use]
    pub fn single(contrast: f64, time: f64) -> Self {
        let instantaneous = 1.0 / contrast;
        Self { instantaneous, terms: vec![CreepingTerm { compliance: 1.0 - instantaneous, time }] }
    }

    /// A material, its retardation times in seconds; its compliances lose their unit.
    #[must_use]
    pub fn of(material: &CreepSpectrum) -> Self {
        let (instantaneous, terms) = material.sliding_terms();
        let term = |(compliance, time): (f64, f64)| CreepingTerm { compliance, time };
        Self { instantaneous, terms: terms.into_iter().map(term).collect() }
    }

    /// The same substrate in steady sliding at `speed`: wakes of length ℓ_k = v τ_k.
    #[must_use]
    pub fn sliding_at(&self, speed: f64) -> SlidingSubstrate {
        let wake = |term: &CreepingTerm| WakeTerm { compliance: term.compliance, length: speed * term.time };
        SlidingSubstrate {
            instantaneous: self.instantaneous,
            terms: self.terms.iter().map(wake).collect(),
            layer: None,
        }
    }

    /// E(ω)/E0 = 1/(E0/E∞ + Σ C_k E0/(1 + i ω τ_k)), eq. (30) of the oscillator paper for a sum of terms.
    #[must_use]
    pub fn complex_modulus(&self, angular_frequency: f64) -> Complex64 {
        let instantaneous = Complex64::new(self.instantaneous, 0.0);
        let compliance = self.terms.iter().fold(instantaneous, |sum, term| {
            sum + term.compliance / Complex64::new(1.0, angular_frequency * term.time)
        });
        compliance.inv()
    }

    /// The longest retardation time; 0 for an elastic substrate.
    #[must_use]
    pub fn longest_time(&self) -> f64 {
        self.terms.iter().map(|term| term.time).fold(0.0, f64::max)
    }

    /// J(∞), the compliance when all has crept: 1 for a substrate measured by its own E0.
    #[must_use]
    pub fn relaxed(&self) -> f64 {
        self.instantaneous + self.terms.iter().map(|term| term.compliance).sum::<f64>()
    }

    /// Refuses a substrate that does not yield at once, and terms that are not positive numbers.
    ///
    /// # Errors
    /// [`TransientError::NotPositive`] with the name of what is wrong.
    pub fn check(&self) -> Result<(), TransientError> {
        positive("instantaneous compliance E0/E∞", self.instantaneous)?;
        for term in &self.terms {
            positive("compliance of a retardation time", term.compliance)?;
            positive("retardation time", term.time)?;
        }
        Ok(())
    }
}

/// Refuses what is not a positive number.
pub(super) fn positive(what: &'static str, value: f64) -> Result<(), TransientError> {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(TransientError::NotPositive { what, value }) }
}
