//! The elastic contact of a paraboloid with a half-space, in closed form.

use crate::contact_law::{ContactLaw, ValidityConcern};
use crate::response::{ContactResponse, LawPoint, WithDerivatives};
use std::f64::consts::PI;

/// Hertz: F̃_k = 4/3 (E/E0) ŷ^{3/2}, Ã = π ŷ, μ_visc = 0 at every speed.
///
/// The limit of sliding on a viscoelastic substrate at v → 0 (E = E0) and v → ∞ (E = E∞).
/// Source: Hertz, J. reine angew. Math. 92 (1882); Johnson, *Contact Mechanics*, eqs. (4.22)–(4.24).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzLaw {
    /// E/E0, the modulus of the substrate over the rubbery modulus that makes F̃_k dimensionless.
    pub modulus_ratio: f64,
}

impl Default for HertzLaw {
    fn default() -> Self {
        Self { modulus_ratio: 1.0 }
    }
}

impl ContactLaw for HertzLaw {
    #[inline(always)]
    fn evaluate(&self, at: &LawPoint) -> ContactResponse {
        let stiffness = 2.0 * self.modulus_ratio * at.indentation.sqrt();
        ContactResponse {
            force: WithDerivatives {
                value: stiffness * at.indentation * (2.0 / 3.0),
                by_velocity: 0.0,
                by_indentation: stiffness,
            },
            area: WithDerivatives { value: PI * at.indentation, by_velocity: 0.0, by_indentation: PI },
            friction: WithDerivatives::default(),
        }
    }

    fn doubt(&self, _at: &LawPoint) -> Option<ContactResponse> {
        Some(ContactResponse::default())
    }

    /// Small slopes: beyond ŷ = 0.1 a sphere is no longer a paraboloid on a half-space (force 1 % off, area 3 %).
    fn concern(&self, _velocity: f64, indentation: f64) -> Option<ValidityConcern> {
        const DEEPEST: f64 = 0.1;
        (indentation > DEEPEST).then_some(ValidityConcern::TooDeep { indentation, limit: DEEPEST })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_textbook_numbers() {
        let r = HertzLaw::default().evaluate(&LawPoint::new(0.3, 0.04));
        assert!((r.force.value - 4.0 / 3.0 * 0.008).abs() < 1e-17);
        assert!((r.force.by_indentation - 2.0 * 0.2).abs() < 1e-15);
        assert!((r.area.value - PI * 0.04).abs() < 1e-17);
        assert_eq!(r.friction, WithDerivatives::default());
    }
}
