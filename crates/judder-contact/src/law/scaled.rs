//! The bounded, smooth logarithms that a law is tabulated in, and the way back.
//!
//! With z = v̂/√ŷ, f = F̃/ŷ^{3/2}, g = Ã/ŷ, m = μ/√ŷ:
//!
//! - force: ln(f/(4/3)), from 0 to ln(E∞/E0) for a paraboloid;
//! - area: ln(g/π), 0 at both ends;
//! - friction: ln(m/m0), 0 at both ends, with m0 = s z/(1 + (s/r) z²), which has the exact slow (s z) and fast (r/z) limits.

use crate::law::knots::Knots;
use crate::law::material::LawMaterial;
use crate::law::quantities::{KnotValues, PerQuantity};
use crate::response::{ContactResponse, LawPoint, WithDerivatives};
use std::f64::consts::PI;

/// 4/3, Hertz's F̃/ŷ^{3/2}.
const HERTZ_FORCE: f64 = 4.0 / 3.0;

/// Powers of z with which a law approaches its limits, each times a logarithm: z² in slow sliding, after a term in z whose factor is
/// known ([`crate::law::limits`]); 1/z in fast sliding.
pub(crate) const SPEED_RATES: (f64, f64) = (2.0, -1.0);

/// A logarithm with its derivatives by ln z (at constant ŷ) and ln ŷ (at constant z).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ScaledLogarithm {
    pub(crate) value: f64,
    pub(crate) by_ln_speed: f64,
    pub(crate) by_ln_indentation: f64,
}

/// The reference friction m0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FrictionReference {
    /// s, slope at rest.
    slow: f64,
    /// s/r.
    ratio: f64,
}

impl FrictionReference {
    pub(crate) fn new(material: &LawMaterial) -> Self {
        let slow = material.slow_friction();
        Self { slow, ratio: slow / material.fast_friction() }
    }

    /// ln m0 at ln z, without overflow.
    fn logarithm(&self, ln_speed: f64) -> f64 {
        let z = ln_speed.exp();
        self.slow.ln() + ln_speed - (self.ratio * z * z).ln_1p()
    }

    /// The scaled logarithms of f, g, m at ln z.
    pub(crate) fn scale(&self, ln_speed: f64, values: PerQuantity<f64>) -> PerQuantity<f64> {
        PerQuantity {
            force: (values.force / HERTZ_FORCE).ln(),
            area: (values.area / PI).ln(),
            friction: values.friction.ln() - self.logarithm(ln_speed),
        }
    }

    /// F̃, Ã, μ and their derivatives from the scaled logarithms.
    #[inline(always)]
    pub(crate) fn response(&self, at: &LawPoint, scaled: PerQuantity<ScaledLogarithm>) -> ContactResponse {
        use judder_numerics::elementary::exp;
        let (v, y) = (at.velocity, at.indentation);
        let (per_v, per_y) = (1.0 / v, 1.0 / y);
        // at constant v̂, ln z falls by half of what ln ŷ gains
        let along = |q: &ScaledLogarithm| q.by_ln_indentation - 0.5 * q.by_ln_speed;
        let PerQuantity { force, area, friction } = scaled;
        let stiffness = HERTZ_FORCE * y.sqrt() * exp(force.value);
        let width = PI * exp(area.value);
        // s z²: in an order in which neither factor overflows before the product does
        let share = 1.0 / (1.0 + self.ratio * ((v * per_y) * v));
        let slope = self.slow * exp(friction.value) * share;
        ContactResponse {
            force: WithDerivatives {
                value: stiffness * y,
                by_velocity: stiffness * y * force.by_ln_speed * per_v,
                by_indentation: stiffness * (1.5 + along(&force)),
            },
            area: WithDerivatives {
                value: width * y,
                by_velocity: width * y * area.by_ln_speed * per_v,
                by_indentation: width * (1.0 + along(&area)),
            },
            friction: WithDerivatives {
                value: slope * v,
                by_velocity: slope * (2.0 * share - 1.0 + friction.by_ln_speed),
                by_indentation: slope * v * (along(&friction) + (1.0 - share)) * per_y,
            },
        }
    }
}

/// ln z of a point.
#[inline(always)]
pub(crate) fn ln_speed(at: &LawPoint) -> f64 {
    at.ln_velocity - 0.5 * at.ln_indentation
}

/// v̂ = z √ŷ.
pub(crate) fn velocity(ln_speed: f64, ln_indentation: f64) -> f64 {
    (ln_speed + 0.5 * ln_indentation).exp()
}

/// The names of the axes in errors.
pub(crate) const SPEED_AXIS: &str = "ln z, z = (v τ/R)/√(δ/R)";
pub(crate) const INDENTATION_AXIS: &str = "ln(δ/R)";

/// The scaled logarithms of values at all knots; the values are positive and as many as the knots.
pub(crate) fn logarithms(
    reference: &FrictionReference,
    speeds: &Knots,
    rows: usize,
    values: &KnotValues,
) -> KnotValues {
    let mut scaled = KnotValues::default();
    for row in 0..rows {
        for (column, ln_speed) in speeds.iter().enumerate() {
            let here = values.as_ref().map(|list| list[row * speeds.count() + column]);
            let logarithms = reference.scale(ln_speed, here);
            scaled.force.push(logarithms.force);
            scaled.area.push(logarithms.area);
            scaled.friction.push(logarithms.friction);
        }
    }
    scaled
}
