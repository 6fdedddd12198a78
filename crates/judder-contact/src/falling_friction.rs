//! A friction coefficient that falls with the speed: the literature's law of masses on belts, and of contacts of assemblies.

#[cfg(feature = "keys")]
use judder_keys::{declared::Number, dimension::Dimension};

#[cfg(feature = "keys")]
const COEFFICIENT: Number = Number::non_negative(Dimension::NUMBER);

/// A friction coefficient that falls from rest: μ = μ_∞ + (μ_0 − μ_∞) exp(−|v|/v_d).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct FallingFriction {
    /// The friction coefficient at rest.
    #[cfg_attr(feature = "keys", key(rule = COEFFICIENT, symbol = "μ_0"))]
    pub at_rest: f64,
    /// That at high speed.
    #[cfg_attr(feature = "keys", key(rule = COEFFICIENT, symbol = "μ_∞"))]
    pub at_speed: f64,
    /// The speed over which it falls, m/s.
    #[cfg_attr(feature = "keys", key(rule = Number::positive(Dimension::SPEED), symbol = "v_d"))]
    pub decay_speed: f64,
}

impl FallingFriction {
    /// μ and dμ/d|v| at a speed |v|, in the unit of the decay speed: m/s, or that of a dimensionless model.
    #[must_use]
    pub fn at(&self, speed: f64) -> (f64, f64) {
        let falling = (self.at_rest - self.at_speed) * (-speed / self.decay_speed).exp();
        (self.at_speed + falling, -falling / self.decay_speed)
    }
}
