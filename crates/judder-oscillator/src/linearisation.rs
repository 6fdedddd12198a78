//! Damping and stiffness about steady sliding (16)–(20), and the equivalent damping (23).
//!
//! The sliding speed that the laws see is |v_rel| = v_d − ẋ: it falls when the oscillator moves with the substrate, so
//! ∂/∂ẋ = −(τ̃/R̃) ∂/∂v̂. That fixes the signs: c11 = 2ξ_x + …, and c21 is *negative* where F̃_k grows with speed. (Section 4.1 of
//! the paper says positive; the Jacobian of (12) decides.)

use crate::FrictionLoad;
use crate::friction::friction_force;
use crate::groups::Coefficients;
use crate::linear_system::LinearSystem;
use judder_contact::ContactResponse;
use judder_numerics::cancellation;

/// The entries of C and K in (20).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linearisation {
    /// c11 = 2ξ_x + (τ̃/k̃_x) ∂|F̃_μ|/∂v̂; zero where the two cancel but for rounding.
    pub c11: f64,
    /// c21 = −(τ̃/k̃_x) ∂F̃_k/∂v̂.
    pub c21: f64,
    /// c22 = 2 ξ_y Ω.
    pub c22: f64,
    /// k11 = 1 + η² cos² α.
    pub k11: f64,
    /// k12 = k21 = η² sin α cos α, of the structure.
    pub k12: f64,
    /// k12c = −(1/k̃_x) ∂|F̃_μ|/∂ŷ, of the contact.
    pub k12c: f64,
    /// k22 = Ω² + η² sin² α + (1/k̃_x) ∂F̃_k/∂ŷ.
    pub k22: f64,
}

impl Linearisation {
    /// C and K (20) from the law's response at the equilibrium.
    ///
    /// With R̃ = k̃_x/F̃_n the paper's factors τ̃/R̃ and 1/(R̃ F̃_n) become τ̃ F̃_n/k̃_x and 1/k̃_x.
    #[inline(always)]
    #[must_use]
    pub fn new(load: FrictionLoad, c: &Coefficients, response: &ContactResponse) -> Self {
        let friction = friction_force(load, c, response);
        let per_indentation = 1.0 / c.stiffness;
        let per_velocity = c.retardation_time * per_indentation;
        Self {
            c11: cancellation::sum(c.damping_x, per_velocity * friction.by_velocity),
            c21: -per_velocity * response.force.by_velocity,
            c22: c.damping_y,
            k11: c.k11,
            k12: c.k12,
            k12c: -per_indentation * friction.by_indentation,
            k22: c.k22 + per_indentation * response.force.by_indentation,
        }
    }

    /// ξ_eq = c11/2 (23), the damping that the oscillator feels along the sliding direction.
    #[inline(always)]
    #[must_use]
    pub fn equivalent_damping(&self) -> f64 {
        0.5 * self.c11
    }

    /// C of (19).
    #[inline(always)]
    #[must_use]
    pub fn damping(&self) -> [[f64; 2]; 2] {
        [[self.c11, 0.0], [self.c21, self.c22]]
    }

    /// K of (19), with k12c in place.
    #[inline(always)]
    #[must_use]
    pub fn stiffness(&self) -> [[f64; 2]; 2] {
        [[self.k11, self.k12 + self.k12c], [self.k12, self.k22]]
    }

    /// M q̈ + C q̇ + K q = 0 of (18).
    #[must_use]
    pub fn system(&self) -> LinearSystem {
        LinearSystem { mass: [[1.0, 0.0], [0.0, 1.0]], damping: self.damping(), stiffness: self.stiffness() }
    }
}
