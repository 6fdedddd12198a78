//! The friction force (5).

use crate::groups::Coefficients;
use judder_contact::{ContactResponse, WithDerivatives};

/// Which load carries the viscoelastic friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Choice), choice(what = "friction load"))]
pub enum FrictionLoad {
    /// F_n μ_visc, as printed.
    ///
    /// The externally applied load, as (5) and (12) print it.
    #[default]
    NormalLoad,
    /// F_k μ_visc, the instantaneous contact force.
    ///
    /// Friction vanishes with the contact.
    ContactForce,
}

/// Magnitude of the friction force over E0* R², with its derivatives by v̂ and ŷ.
///
/// (5): |F_μ|/(E0* R²) = F̃_n μ_visc + τ̃0 Ã, or F̃_k μ_visc + τ̃0 Ã.
#[inline(always)]
#[must_use]
pub fn friction_force(load: FrictionLoad, c: &Coefficients, response: &ContactResponse) -> WithDerivatives {
    let ContactResponse { force, area, friction } = response;
    let viscoelastic = match load {
        FrictionLoad::NormalLoad => WithDerivatives {
            value: c.normal_load * friction.value,
            by_velocity: c.normal_load * friction.by_velocity,
            by_indentation: c.normal_load * friction.by_indentation,
        },
        FrictionLoad::ContactForce => WithDerivatives {
            value: force.value * friction.value,
            by_velocity: force.value * friction.by_velocity + force.by_velocity * friction.value,
            by_indentation: force.value * friction.by_indentation + force.by_indentation * friction.value,
        },
    };
    WithDerivatives {
        value: viscoelastic.value + c.shear_strength * area.value,
        by_velocity: viscoelastic.by_velocity + c.shear_strength * area.by_velocity,
        by_indentation: viscoelastic.by_indentation + c.shear_strength * area.by_indentation,
    }
}
