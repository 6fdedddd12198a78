//! The substrate of a computed law, in dimensionless numbers.

use crate::law::error::LawError;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// How far Σ C_k E0 may be from 1 − E0/E∞: a dozen digits of rounding on the way through other units.
const COMPLIANCE_TOLERANCE: f64 = 1e-9;

/// One retardation time of a substrate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawTerm {
    /// τ_k/τ, retardation time over the one in v̂ = v τ/R.
    pub retardation_time: f64,
    /// C_k E0, compliance over the rubbery one.
    pub compliance: f64,
}

/// A linear viscoelastic substrate: 1/E(ω) = 1/E∞ + Σ C_k/(1 + i ω τ_k), over 1/E0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawMaterial {
    /// E∞/E0.
    pub modulus_ratio: f64,
    /// The retardation times.
    pub terms: Vec<LawTerm>,
}

impl LawMaterial {
    /// One retardation time τ: C E0 = 1 − E0/E∞.
    ///
    /// # Errors
    /// E∞/E0 not finite or not above 1.
    pub fn one_time(modulus_ratio: f64) -> Result<Self, LawError> {
        let terms = vec![LawTerm { retardation_time: 1.0, compliance: 1.0 - 1.0 / modulus_ratio }];
        Self { modulus_ratio, terms }.checked()
    }

    /// The material, if it is one.
    ///
    /// # Errors
    /// E∞/E0 ≤ 1, a time or a compliance that is not positive and finite, Σ C_k E0 ≠ 1 − E0/E∞.
    pub fn checked(self) -> Result<Self, LawError> {
        let is_positive = |value: f64| value > 0.0 && value.is_finite();
        if !(self.modulus_ratio > 1.0 && self.modulus_ratio.is_finite()) {
            return Err(LawError::InvalidNumber {
                name: "modulus ratio E∞/E0",
                value: self.modulus_ratio,
                requirement: "finite and above 1",
            });
        }
        for term in &self.terms {
            for (name, value) in
                [("retardation time τ_k/τ", term.retardation_time), ("compliance C_k E0", term.compliance)]
            {
                if !is_positive(value) {
                    let requirement = "positive and finite";
                    return Err(LawError::InvalidNumber { name, value, requirement });
                }
            }
        }
        let sum: f64 = self.terms.iter().map(|term| term.compliance).sum();
        let expected = 1.0 - 1.0 / self.modulus_ratio;
        if (sum - expected).abs() > COMPLIANCE_TOLERANCE {
            return Err(LawError::ComplianceSum { sum, expected });
        }
        Ok(self)
    }

    /// The slope of the friction coefficient at rest: μ_visc → Σ C_k E0 (τ_k/τ) · v̂ for a paraboloid.
    ///
    /// To first order in the speed the pressure is the elastic one, shifted upstream by s = Σ C_k E0 v τ_k, and the slope of a
    /// paraboloid grows by 1/R a length. With one retardation time: (1 − E0/E∞) v τ/R.
    #[must_use]
    pub fn slow_friction(&self) -> f64 {
        self.moment(1)
    }

    /// Σ C_k E0 (τ_k/τ)ⁿ.
    pub(crate) fn moment(&self, power: i32) -> f64 {
        self.terms.iter().map(|term| term.compliance * term.retardation_time.powi(power)).sum()
    }

    /// The coefficient of the friction of fast sliding: μ_visc → 0.8 (E∞/E0) Σ C_k E0/(τ_k/τ) · ŷ/v̂ for a paraboloid.
    ///
    /// The pressure is that of the glassy contact; while it passes, the substrate creeps at the rate C_k/τ_k, and the work goes to
    /// friction: μ F = Σ C_k E∞/(v τ_k) ∫p u. With one retardation time: 0.8 (E∞/E0 − 1) δ/(v τ).
    #[must_use]
    pub fn fast_friction(&self) -> f64 {
        let rate: f64 = self.terms.iter().map(|term| term.compliance / term.retardation_time).sum();
        0.8 * self.modulus_ratio * rate
    }

    /// The slope of the area's logarithm over z = v̂/√ŷ at rest, for a paraboloid: ln(g/π) → −(2/π) s z with s = Σ C_k E0 τ_k/τ.
    ///
    /// To first order in the speed p is the elastic pressure, shifted upstream by s v, and q = J p, which moves the surface
    /// as it would an elastic one, is not shifted. The layers at the edges decide where contact ends: by the factors of Wiener and
    /// Hopf, J being free of zeros and poles in one half-plane, the leading edge is that of q, the trailing edge that of p. So the
    /// contact is shorter than the elastic one by the shift, its area smaller by 2 a s v τ.
    #[must_use]
    pub fn slow_area_slope(&self) -> f64 {
        -2.0 / PI * self.slow_friction()
    }

    /// The slope of the logarithm of μ/(s v̂) over z at rest, for a paraboloid: (2/π) (s − 2 m/s) with s = Σ C_k E0 τ_k/τ and
    /// m = Σ C_k E0 (τ_k/τ)².
    ///
    /// Under the layer of the trailing edge p ~ √d, so q is singular there in second order, as (s²/8 − m/4) d^{−3/2} at a distance d;
    /// the moment of that singularity about the lowest point, by reciprocity with a tilted punch, adds to the friction. The same
    /// singularity adds 3/8 (2 m − s²) z² to the force, relative.
    #[must_use]
    pub fn slow_friction_slope(&self) -> f64 {
        let slow = self.slow_friction();
        2.0 / PI * (slow - 2.0 * self.moment(2) / slow)
    }

    /// The shortest and the longest τ_k/τ; `None` without terms.
    pub(crate) fn time_span(&self) -> Option<(f64, f64)> {
        let times = || self.terms.iter().map(|term| term.retardation_time);
        Some((times().reduce(f64::min)?, times().reduce(f64::max)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_half_strength_equal_times_are_one() {
        let one = LawMaterial::one_time(10.0).unwrap();
        let half = LawTerm { retardation_time: 1.0, compliance: 0.45 };
        let two = LawMaterial { modulus_ratio: 10.0, terms: vec![half, half] }.checked().unwrap();
        assert!((one.slow_friction() - 0.9).abs() < 1e-15 && (two.slow_friction() - 0.9).abs() < 1e-15);
        // 0.8 (E∞/E0 − 1)
        assert!((one.fast_friction() - 7.2).abs() < 1e-14 && (two.fast_friction() - 7.2).abs() < 1e-14);
    }

    #[test]
    fn what_is_no_material_is_refused() {
        let term = |compliance| LawTerm { retardation_time: 1.0, compliance };
        let made = |modulus_ratio, terms| LawMaterial { modulus_ratio, terms }.checked();
        assert!(matches!(made(10.0, vec![term(-0.9)]), Err(LawError::InvalidNumber { .. })));
        assert!(matches!(made(f64::NAN, vec![term(0.9)]), Err(LawError::InvalidNumber { .. })));
        assert!(matches!(made(10.0, vec![term(0.8)]), Err(LawError::ComplianceSum { .. })));
        assert!(matches!(made(10.0, vec![]), Err(LawError::ComplianceSum { .. })));
    }
}
