//! The bounded, smooth logarithms that a law is tabulated in, and the way back.
//!
//! With z = v̂/√ŷ, f = F̃/ŷ^{3/2}, g = Ã/ŷ, m = μ/√ŷ (of a cylinder f = F̃/ŷ and g = Ã/√ŷ, per length):
//!
//! - force: ln(f/(4/3)), from 0 to ln(E∞/E0) for a paraboloid; ln f of a cylinder;
//! - area: ln(g/π), 0 at both ends; ln g of a cylinder;
//! - friction: ln(m/m0), 0 at both ends, with m0 = s z/(1 + (s/r) z²), which has the exact slow (s z) and fast (r/z) limits.

use crate::law::knots::Knots;
use crate::law::limits::LawIndenter;
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

/// What the logarithms are counted from: the units of force and area, and the reference friction m0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LawReference {
    /// f and g whose logarithms are 0.
    units: [f64; 2],
    /// The same times the length that a law per length is told for.
    told: [f64; 2],
    /// Whether it is a law per length.
    is_line: bool,
    /// s, slope at rest.
    slow: f64,
    /// s/r.
    ratio: f64,
}

impl LawReference {
    pub(crate) fn new(material: &LawMaterial, indenter: LawIndenter) -> Self {
        let slow = material.slow_friction();
        let is_line = indenter.is_line();
        let units = if is_line { [1.0; 2] } else { [HERTZ_FORCE, PI] };
        Self { units, told: units, is_line, slow, ratio: slow / material.fast_friction() }
    }

    /// Force and area for a length L/R, where the law is one per length.
    pub(crate) fn over(self, length: f64) -> Self {
        Self { told: self.units.map(|unit| length * unit), ..self }
    }

    /// Half the length along the sliding, over R, of a contact of this area: the radius of a circle, half the width of a line.
    pub(crate) fn half_length(&self, area: f64) -> f64 {
        if self.is_line { 0.5 * area / self.told[1] } else { (area / PI).sqrt() }
    }

    /// ln m0 at ln z, without overflow.
    fn logarithm(&self, ln_speed: f64) -> f64 {
        let z = libm::exp(ln_speed);
        libm::log(self.slow) + ln_speed - libm::log1p(self.ratio * z * z)
    }

    /// The scaled logarithms of f, g, m at ln z.
    pub(crate) fn scale(&self, ln_speed: f64, values: PerQuantity<f64>) -> PerQuantity<f64> {
        PerQuantity {
            force: libm::log(values.force / self.units[0]),
            area: libm::log(values.area / self.units[1]),
            friction: libm::log(values.friction) - self.logarithm(ln_speed),
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
        let [force_unit, area_unit] = self.told;
        let root = y.sqrt();
        // F̃/ŷ and Ã/ŷ, and the powers of ŷ of F̃ and Ã in units of f and g
        let (stiffness, force_power, width, area_power) = if self.is_line {
            (force_unit * exp(force.value), 1.0, area_unit * exp(area.value) / root, 0.5)
        } else {
            (force_unit * root * exp(force.value), 1.5, area_unit * exp(area.value), 1.0)
        };
        // s z²: in an order in which neither factor overflows before the product does
        let share = 1.0 / (1.0 + self.ratio * ((v * per_y) * v));
        let slope = self.slow * exp(friction.value) * share;
        ContactResponse {
            force: WithDerivatives {
                value: stiffness * y,
                by_velocity: stiffness * y * force.by_ln_speed * per_v,
                by_indentation: stiffness * (force_power + along(&force)),
            },
            area: WithDerivatives {
                value: width * y,
                by_velocity: width * y * area.by_ln_speed * per_v,
                by_indentation: width * (area_power + along(&area)),
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
    libm::exp(ln_speed + 0.5 * ln_indentation)
}

/// The names of the axes in errors.
pub(crate) const SPEED_AXIS: &str = "ln z, z = (v τ/R)/√(δ/R)";
pub(crate) const INDENTATION_AXIS: &str = "ln(δ/R)";

/// The scaled logarithms of values at all knots; the values are positive and as many as the knots.
pub(crate) fn logarithms(
    reference: &LawReference,
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
