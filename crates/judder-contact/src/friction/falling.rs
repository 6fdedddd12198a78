//! A friction coefficient that falls from rest and may rise again: the law that Stribeck's curve is mostly given by.

use super::FrictionAt;
#[cfg(feature = "keys")]
use judder_keys::{declared::Number, dimension::Dimension, numeric_key::Range};

#[cfg(feature = "keys")]
const COEFFICIENT: Number = Number::non_negative(Dimension::NUMBER);
/// Of what is divided by a speed.
#[cfg(feature = "keys")]
const VISCOUS: Number = Number::non_negative(Dimension::new(-1, 0, 1, 0));
/// Below one the slope at rest would have no bound.
#[cfg(feature = "keys")]
const EXPONENT: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Closed { from: 1.0, to: LARGEST_EXPONENT } };

/// Beyond it the coefficient falls in what is all but a jump.
pub const LARGEST_EXPONENT: f64 = 10.0;

/// A friction coefficient that falls from rest, and may rise again with the speed: μ = μ_∞ + (μ_0 − μ_∞) exp(−(|v|/v_d)^n) + c |v|.
///
/// Of n = 1 (Tustin) and n = 2 (Gauss) the literature is full: B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994)
/// 1083, eq. (6).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct FallingFriction {
    /// The friction coefficient at rest.
    #[cfg_attr(feature = "keys", key(rule = COEFFICIENT, symbol = "μ_0"))]
    pub at_rest: f64,
    /// That at high speed, without what is viscous.
    #[cfg_attr(feature = "keys", key(rule = COEFFICIENT, symbol = "μ_∞"))]
    pub at_speed: f64,
    /// The speed over which it falls.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::SPEED), symbol = "v_d"))]
    pub decay_speed: f64,
    /// By how much it rises with the speed, per speed.
    #[cfg_attr(feature = "keys", key(rule = VISCOUS, symbol = "c", default = 0.0))]
    pub viscous: f64,
    /// The exponent with which it falls: 1 as an exponential, 2 as Gauss's curve.
    #[cfg_attr(feature = "keys", key(rule = EXPONENT, symbol = "n", default = 1.0))]
    pub exponent: f64,
}

impl FallingFriction {
    /// One that falls from rest exponentially and does not rise: μ = μ_∞ + (μ_0 − μ_∞) exp(−|v|/v_d), of μ_0, μ_∞ and v_d.
    #[must_use]
    pub const fn exponential([at_rest, at_speed]: [f64; 2], decay_speed: f64) -> Self {
        Self { at_rest, at_speed, decay_speed, viscous: 0.0, exponent: 1.0 }
    }

    /// μ and dμ/d|v| at a speed |v| ≥ 0, in the unit of the decay speed: m/s, or that of a dimensionless model.
    #[must_use]
    pub fn at(&self, speed: f64) -> FrictionAt {
        let Self { at_rest, at_speed, decay_speed, viscous, exponent } = *self;
        if exponent == 1.0 {
            let falling = (at_rest - at_speed) * libm::exp(-speed / decay_speed);
            let (coefficient, slope) = (at_speed + falling, -falling / decay_speed);
            return FrictionAt { coefficient: coefficient + viscous * speed, slope: slope + viscous };
        }
        let share = speed / decay_speed;
        // one power less than the exponent, so that the slope at rest is no 0/0
        let power = libm::pow(share, exponent - 1.0);
        let falling = (at_rest - at_speed) * libm::exp(-power * share);
        FrictionAt {
            coefficient: at_speed + falling + viscous * speed,
            slope: viscous - falling * exponent * power / decay_speed,
        }
    }
}
