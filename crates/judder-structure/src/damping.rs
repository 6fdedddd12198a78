//! Damping as a real matrix C: proportional to mass and stiffness, or viscous in place of structural.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::statics::sum;
use std::f64::consts::TAU;

/// Rayleigh damping, C = α M + β K.
///
/// Of a mode with ω it takes the share ζ = α/(2ω) + β ω/2 of critical damping: between two frequencies at which ζ is given it is
/// smaller, beyond them larger, and of the highest frequencies of a mesh it can be overcritical.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayleighDamping {
    alpha: f64,
    beta: f64,
}

impl RayleighDamping {
    /// α in 1/s and β in s, neither negative.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`].
    pub fn new(alpha: f64, beta: f64) -> Result<Self, StructureError> {
        Ok(Self {
            alpha: not_negative("the damping by mass, α", alpha)?,
            beta: not_negative("the damping by stiffness, β", beta)?,
        })
    }

    /// The damping with these ratios ζ at two frequencies in Hz, each given as (frequency, ratio).
    ///
    /// β = 2 (ζ₂ω₂ − ζ₁ω₁)/(ω₂² − ω₁²), α = 2 ω₁ω₂ (ζ₁ω₂ − ζ₂ω₁)/(ω₂² − ω₁²).
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`] for a frequency or ratio that is not positive, or one frequency twice;
    /// [`StructureError::NoRayleighDamping`] for ratios further apart than the frequencies, which want a negative α or β.
    pub fn through(first: (f64, f64), second: (f64, f64)) -> Result<Self, StructureError> {
        for (frequency, ratio) in [first, second] {
            positive("the frequency of a damping ratio", frequency)?;
            not_negative("a damping ratio", ratio)?;
        }
        let ((low, at_low), (high, at_high)) =
            if first.0 < second.0 { (first, second) } else { (second, first) };
        positive("the distance of the two frequencies of damping ratios", high - low)?;
        let (w1, w2) = (TAU * low, TAU * high);
        let span = (w2 - w1) * (w2 + w1);
        let alpha = 2.0 * w1 * w2 * (at_low * w2 - at_high * w1) / span;
        let beta = 2.0 * (at_high * w2 - at_low * w1) / span;
        if alpha < 0.0 || beta < 0.0 {
            return Err(StructureError::NoRayleighDamping {
                ratios: [at_low, at_high],
                frequencies: [low, high],
            });
        }
        Self::new(alpha, beta)
    }

    /// α in 1/s.
    #[must_use]
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// β in s.
    #[must_use]
    pub fn beta(&self) -> f64 {
        self.beta
    }

    /// ζ = α/(2ω) + β ω/2 of a mode with this frequency in Hz, ω = 2π times it; infinite at zero where α is not.
    #[must_use]
    pub fn ratio(&self, frequency: f64) -> f64 {
        let omega = TAU * frequency;
        let by_mass = if self.alpha == 0.0 { 0.0 } else { self.alpha / (2.0 * omega) };
        by_mass + 0.5 * self.beta * omega
    }

    /// C = α M + β K in N s/m.
    ///
    /// # Errors
    /// [`StructureError::DifferentSizes`], [`StructureError::OutOfMemory`].
    pub fn matrix(&self, stiffness: &Sparse, mass: &Sparse) -> Result<Sparse, StructureError> {
        sum(self.beta, stiffness, self.alpha, mass)
    }
}

/// Structural (hysteretic) damping, K (1 + iη), by the viscous damping that takes the same energy from a vibration with ω_ref:
/// C = η K/ω_ref.
///
/// A complex stiffness belongs to one frequency at a time: in a motion over time it is no real matrix. C takes the right energy at
/// ω_ref and ω/ω_ref times too much at ω, so it holds for η ≪ 1 and for vibrations near the reference. Where each mode has its own
/// reference the ratio of all is η/2: in a modal form with M = I that is the diagonal C with η ω.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StructuralDamping {
    loss_factor: f64,
    reference: f64,
}

impl StructuralDamping {
    /// The loss factor η, zero or positive, and the reference frequency in Hz.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`].
    pub fn new(loss_factor: f64, reference: f64) -> Result<Self, StructureError> {
        Ok(Self {
            loss_factor: not_negative("the loss factor", loss_factor)?,
            reference: positive("the reference frequency of structural damping", reference)?,
        })
    }

    /// ζ = η ω/(2 ω_ref) of a mode with this frequency in Hz under C; η/2 at the reference.
    #[must_use]
    pub fn ratio(&self, frequency: f64) -> f64 {
        0.5 * self.loss_factor * frequency / self.reference
    }

    /// C = η K/ω_ref in N s/m.
    #[must_use]
    pub fn matrix(&self, stiffness: &Sparse) -> Sparse {
        let mut damping = stiffness.clone();
        let factor = self.loss_factor / (TAU * self.reference);
        for value in damping.val_mut() {
            *value *= factor;
        }
        damping
    }

    /// The entries of C for one mode after the other of a modal form (M = I) with these frequencies in Hz, each mode with its own
    /// reference: η ω in 1/s.
    #[must_use]
    pub fn modal(&self, frequencies: &[f64]) -> Vec<f64> {
        frequencies.iter().map(|frequency| self.loss_factor * TAU * frequency).collect()
    }
}

fn not_negative(name: &'static str, value: f64) -> Result<f64, StructureError> {
    match value.is_finite() && value >= 0.0 {
        true => Ok(value),
        false => Err(StructureError::InvalidNumber { name, value, requirement: "zero or positive" }),
    }
}

fn positive(name: &'static str, value: f64) -> Result<f64, StructureError> {
    match value.is_finite() && value > 0.0 {
        true => Ok(value),
        false => Err(StructureError::InvalidNumber { name, value, requirement: "positive" }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_met_at_both_frequencies_and_smaller_between_them() {
        for (first, second) in [((50.0, 0.01), (2000.0, 0.03)), ((2000.0, 0.03), (50.0, 0.01))] {
            let damping = RayleighDamping::through(first, second).unwrap();
            for (frequency, ratio) in [first, second] {
                assert!((damping.ratio(frequency) / ratio - 1.0).abs() < 1e-14);
            }
            assert!(damping.ratio(300.0) < 0.01 && damping.ratio(1e5) > 1.0 && damping.ratio(0.1) > 1.0);
        }
        let by_stiffness = RayleighDamping::through((100.0, 0.01), (200.0, 0.02)).unwrap();
        assert!(
            by_stiffness.alpha().abs() < 1e-15
                && (by_stiffness.beta() - 0.01 / (100.0 * std::f64::consts::PI)).abs() < 1e-18
        );
        assert_eq!(RayleighDamping::new(0.0, 1e-5).unwrap().ratio(0.0), 0.0);
    }

    #[test]
    fn ratios_that_no_positive_coefficients_meet_are_refused() {
        let error = RayleighDamping::through((100.0, 0.01), (200.0, 0.03)).unwrap_err();
        assert!(matches!(error, StructureError::NoRayleighDamping { .. }), "{error}");
        assert!(error.to_string().contains("0.005 and 0.02"), "{error}");
        for pairs in [
            ((1.0, 0.1), (1.0, 0.1)),
            ((0.0, 0.1), (1.0, 0.1)),
            ((1.0, f64::NAN), (2.0, 0.1)),
            ((1.0, -0.1), (2.0, 0.1)),
        ] {
            assert!(matches!(
                RayleighDamping::through(pairs.0, pairs.1),
                Err(StructureError::InvalidNumber { .. })
            ));
        }
        assert!(
            RayleighDamping::new(-1.0, 0.0).is_err() && RayleighDamping::new(0.0, f64::INFINITY).is_err()
        );
        assert!(StructuralDamping::new(-0.1, 1.0).is_err() && StructuralDamping::new(0.1, 0.0).is_err());
    }

    #[test]
    fn structural_damping_takes_half_the_loss_factor_at_its_reference() {
        let damping = StructuralDamping::new(0.02, 440.0).unwrap();
        assert!((damping.ratio(440.0) - 0.01).abs() < 1e-17);
        let [at_resonance] = damping.modal(&[440.0])[..] else { panic!() };
        assert!((at_resonance / (2.0 * 0.01 * TAU * 440.0) - 1.0).abs() < 1e-15);
    }
}
