//! Time and temperature: a warmer material does the same things faster.

use super::creep::CreepSpectrum;
use super::error::{MaterialError, positive};
use std::f64::consts::LN_10;

/// Gas constant [J/(mol K)], exact in the SI since 2019.
const GAS_CONSTANT: f64 = 8.314_462_618_153_24;

/// How all retardation and relaxation times scale with temperature: τ(T) = a_T τ(T_ref), with temperatures in kelvin.
///
/// Only times scale. The moduli stay, so the small vertical shift T ρ(T) / (T_ref ρ(T_ref)) of rubbers is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TemperatureShift {
    /// log10 a_T = −C1 (T − T_ref)/(C2 + T − T_ref): Williams, Landel and Ferry, J. Am. Chem. Soc. 77 (1955) 3701.
    ///
    /// Meant for T_ref − 50 K to T_ref + 100 K about a T_ref near the glass transition; undefined at T_ref − C2.
    WilliamsLandelFerry {
        /// C1, in decades.
        first_constant: f64,
        /// C2 \[K\].
        second_constant: f64,
        /// T_ref \[K\].
        reference: f64,
    },
    /// ln a_T = E_a/R_gas (1/T − 1/T_ref), for one activated process, such as flow below the glass transition.
    Arrhenius {
        /// E_a [J/mol].
        activation_energy: f64,
        /// T_ref \[K\].
        reference: f64,
    },
}

impl TemperatureShift {
    /// Temperature at which a_T = 1, T_ref \[K\].
    #[must_use]
    pub fn reference(&self) -> f64 {
        match *self {
            Self::WilliamsLandelFerry { reference, .. } | Self::Arrhenius { reference, .. } => reference,
        }
    }

    /// a_T at temperature T \[K\].
    ///
    /// # Errors
    /// [`MaterialError::NotPositive`] for a temperature or a constant, [`MaterialError::BelowVogel`] for T ≤ T_ref − C2,
    /// [`MaterialError::ShiftTooLarge`] when a_T leaves the numbers.
    pub fn factor(&self, temperature: f64) -> Result<f64, MaterialError> {
        let temperature = positive("the temperature T [K]", temperature)?;
        let reference = positive("the reference temperature T_ref [K]", self.reference())?;
        let exponent = match *self {
            Self::WilliamsLandelFerry { first_constant, second_constant, .. } => {
                let first = positive("the WLF constant C1", first_constant)?;
                let second = positive("the WLF constant C2 [K]", second_constant)?;
                let above = temperature - reference;
                if second + above <= 0.0 {
                    return Err(MaterialError::BelowVogel { temperature, lowest: reference - second });
                }
                -LN_10 * first * above / (second + above)
            }
            Self::Arrhenius { activation_energy, .. } => {
                let energy = positive("the activation energy E_a [J/mol]", activation_energy)?;
                energy / GAS_CONSTANT * (reference - temperature) / (temperature * reference)
            }
        };
        let factor = libm::exp(exponent);
        if factor.is_normal() {
            Ok(factor)
        } else {
            Err(MaterialError::ShiftTooLarge { temperature, decades: exponent / LN_10 })
        }
    }

    /// A material known at T_ref, at temperature T \[K\]: every retardation time times a_T.
    ///
    /// # Errors
    /// As [`TemperatureShift::factor`], and [`MaterialError::Term`] for a time that leaves the numbers.
    pub fn material_at(
        &self,
        temperature: f64,
        at_reference: &CreepSpectrum,
    ) -> Result<CreepSpectrum, MaterialError> {
        at_reference.with_times_multiplied(self.factor(temperature)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIVERSAL: TemperatureShift = TemperatureShift::WilliamsLandelFerry {
        first_constant: 17.44,
        second_constant: 51.6,
        reference: 203.15,
    };

    #[test]
    fn the_universal_constants_at_fifty_kelvin_above_the_transition() {
        let decades = UNIVERSAL.factor(253.15).unwrap().log10();
        assert!((decades + 17.44 * 50.0 / 101.6).abs() < 1e-12);
        assert!((UNIVERSAL.factor(203.15).unwrap() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn moving_the_reference_of_an_activated_process_changes_nothing() {
        let at = |reference| TemperatureShift::Arrhenius { activation_energy: 8e4, reference };
        let direct = at(300.0).factor(340.0).unwrap();
        let by_steps = at(300.0).factor(320.0).unwrap() * at(320.0).factor(340.0).unwrap();
        assert!((direct / by_steps - 1.0).abs() < 1e-13 && direct < 1.0);
    }

    #[test]
    fn a_warmer_material_is_the_same_material_faster() {
        let cold = CreepSpectrum::single(1e6, 1e9, 10.0).unwrap();
        let warm = UNIVERSAL.material_at(230.0, &cold).unwrap();
        let factor = UNIVERSAL.factor(230.0).unwrap();
        let difference = warm.complex_modulus(3.0 / factor) - cold.complex_modulus(3.0);
        assert!(difference.norm() < 1e-12 * cold.complex_modulus(3.0).norm());
    }

    #[test]
    fn too_cold_for_the_formula_is_refused() {
        let error = UNIVERSAL.factor(151.0).unwrap_err();
        assert!(matches!(error, MaterialError::BelowVogel { lowest, .. } if (lowest - 151.55).abs() < 1e-9));
        assert!(matches!(UNIVERSAL.factor(151.6), Err(MaterialError::ShiftTooLarge { .. })));
        assert!(matches!(UNIVERSAL.factor(f64::NAN), Err(MaterialError::NotPositive { .. })));
    }
}
