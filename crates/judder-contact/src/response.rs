//! Where a contact law is evaluated, and what it gives.

use judder_numerics::elementary::{exp, ln};

/// The smallest speed or depth whose logarithm a law takes; below it a law has reached its limit to every digit.
const SMALLEST: f64 = 1e-300;

/// A speed and a depth, with the logarithms in which the laws are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawPoint {
    /// v̂ = |v| τ/R, sliding speed (≥ 0, floored at 1e-300).
    pub velocity: f64,
    /// ln v̂.
    pub ln_velocity: f64,
    /// ŷ = y/R, indentation (≥ 0, floored at 1e-300).
    pub indentation: f64,
    /// ln ŷ.
    pub ln_indentation: f64,
}

impl LawPoint {
    /// The point at speed v̂ and indentation ŷ; zeros stand for the limits v̂ → 0, ŷ → 0.
    #[inline(always)]
    #[must_use]
    pub fn new(velocity: f64, indentation: f64) -> Self {
        let velocity = if velocity < SMALLEST { SMALLEST } else { velocity };
        let indentation = if indentation < SMALLEST { SMALLEST } else { indentation };
        Self { velocity, ln_velocity: ln(velocity), indentation, ln_indentation: ln(indentation) }
    }

    /// The point at a speed whose logarithm is known already, and at the indentation e^`ln_indentation`.
    ///
    /// This is how an iteration in ln ŷ moves without taking a logarithm at every step.
    #[inline(always)]
    #[must_use]
    pub fn at_ln_indentation(velocity: f64, ln_velocity: f64, ln_indentation: f64) -> Self {
        Self { velocity, ln_velocity, indentation: exp(ln_indentation), ln_indentation }
    }
}

/// One quantity with its exact first derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WithDerivatives {
    /// The quantity.
    pub value: f64,
    /// Its derivative by v̂ (by the magnitude of the speed).
    pub by_velocity: f64,
    /// Its derivative by ŷ.
    pub by_indentation: f64,
}

/// What a contact law gives at one point, all from one evaluation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactResponse {
    /// F̃_k = F_k/(E0* R²), normal force.
    pub force: WithDerivatives,
    /// Ã = A/R², contact area.
    pub area: WithDerivatives,
    /// μ_visc, viscoelastic friction coefficient.
    pub friction: WithDerivatives,
}
