//! Steady sliding (15).
//!
//! Eliminating x̃ leaves one equation for the indentation: with s = (k22 − k12²/k11) k̃_x and β = k12/k11,
//!
//! G(ŷ) = s ŷ + β |F_μ|(ŷ)/(E0* R²) + F̃_k(ŷ) − F̃_n = 0.
//!
//! ŷ spans ten decades, so the unknown is ln ŷ. For k12 ≥ 0 all terms but the last grow from zero, the root lies below
//! F̃_n/s, and one root was found everywhere; for k12 < 0 friction pulls the indenter in, and the roots are counted.

use crate::error::OscillatorError;
use crate::friction::friction_force;
use crate::groups::Coefficients;
use crate::{Contact, FrictionLoad};
use judder_contact::{ContactLaw, ContactResponse, LawPoint};
use judder_numerics::elementary::ln;
use judder_numerics::root::all_roots;

/// The state of steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equilibrium {
    /// x̃_e.
    pub x: f64,
    /// ỹ_e.
    pub y: f64,
    /// ŷ_e = ỹ_e/R̃.
    pub indentation: f64,
    /// ln ŷ_e, the number that was iterated.
    pub ln_indentation: f64,
    /// The contact law there.
    pub response: ContactResponse,
}

/// The balance of (15) with x̃ eliminated, at one indentation.
#[derive(Clone, Copy)]
pub(crate) struct ForceBalance {
    /// G, over F̃_n.
    pub(crate) residual: f64,
    /// The forces that carry the load, G + F̃_n, over F̃_n.
    carried: f64,
    /// Their derivative by ln ŷ.
    slope: f64,
}

impl ForceBalance {
    #[inline(always)]
    pub(crate) fn new(
        load: FrictionLoad,
        c: &Coefficients,
        at: &LawPoint,
        response: &ContactResponse,
    ) -> Self {
        let friction = friction_force(load, c, response);
        let ratio = c.coupling_ratio;
        let spring = c.spring * c.stiffness;
        let carried = spring * at.indentation + ratio * friction.value + response.force.value;
        let slope = spring + ratio * friction.by_indentation + response.force.by_indentation;
        let per_load = 1.0 / c.normal_load;
        Self {
            residual: (carried - c.normal_load) * per_load,
            carried: carried * per_load,
            slope: slope * at.indentation * per_load,
        }
    }

    /// Newton's step in ln ŷ, on the logarithm of the forces that carry the load.
    ///
    /// They are sums of powers of ŷ with exponents near one, so in logarithms the equation is nearly a straight line: the
    /// steps are right from far away, and near the root the error falls faster than on the forces themselves.
    #[inline(always)]
    pub(crate) fn newton_step(&self) -> f64 {
        -ln(self.carried) * self.carried / self.slope
    }
}

/// The steady sliding state (15).
///
/// # Errors
/// No equilibrium with contact, several of them, or an iteration that did not settle (with the residual).
pub fn equilibrium(contact: &Contact, c: &Coefficients) -> Result<Equilibrium, OscillatorError> {
    Ok(equilibrium_at(contact, c, ln_indentation(contact, c)?))
}

/// Everything about the equilibrium whose ln ŷ is known.
#[must_use]
pub fn equilibrium_at(contact: &Contact, c: &Coefficients, ln_indentation: f64) -> Equilibrium {
    let start = LawPoint::new(c.velocity, 1.0);
    let at = LawPoint::at_ln_indentation(start.velocity, start.ln_velocity, ln_indentation);
    let response = contact.law.evaluate(&at);
    let friction = friction_force(contact.friction_load, c, &response).value / c.normal_load;
    let y = c.radius() * at.indentation;
    Equilibrium {
        x: (friction - c.k12 * y) / c.k11,
        y,
        indentation: at.indentation,
        ln_indentation,
        response,
    }
}

/// G as a function of ln ŷ alone.
struct Imbalance<'a> {
    contact: &'a Contact,
    coefficients: &'a Coefficients,
    start: LawPoint,
}

impl Imbalance<'_> {
    fn at(&self, ln_indentation: f64) -> ForceBalance {
        let at = LawPoint::at_ln_indentation(self.start.velocity, self.start.ln_velocity, ln_indentation);
        let response = self.contact.law.evaluate(&at);
        ForceBalance::new(self.contact.friction_load, self.coefficients, &at, &response)
    }
}

/// ln ŷ_e, from a bracket and Newton steps kept inside it.
pub(crate) fn ln_indentation(contact: &Contact, c: &Coefficients) -> Result<f64, OscillatorError> {
    let imbalance = Imbalance { contact, coefficients: c, start: LawPoint::new(c.velocity, 1.0) };
    let (lower, upper) = if c.k12 < 0.0 { only_sign_change(&imbalance)? } else { bracket(&imbalance)? };
    root_in_bracket(&imbalance, lower, upper)
}

/// ln ŷ between which a search for equilibria moves: ŷ from 1e-100 to 1e3.
const SEARCH: (f64, f64) = (-230.0, 7.0);

fn no_equilibrium() -> OscillatorError {
    OscillatorError::NoEquilibrium { searched_from: libm::exp(SEARCH.0), searched_to: libm::exp(SEARCH.1) }
}

/// A bracket for k12 ≥ 0: above, the springs alone carry the load; below, nothing does.
fn bracket(imbalance: &Imbalance<'_>) -> Result<(f64, f64), OscillatorError> {
    let c = imbalance.coefficients;
    let spring = c.spring * c.stiffness;
    // a hair above F̃_n/s, where rounding cannot turn the sign
    let upper = if spring > 0.0 { libm::log(c.normal_load / spring) + 1e-9 } else { SEARCH.1 };
    let upper = upper.clamp(SEARCH.0, SEARCH.1);
    let is_bracketed = imbalance.at(upper).residual >= 0.0 && imbalance.at(SEARCH.0).residual < 0.0;
    if is_bracketed { Ok((SEARCH.0, upper)) } else { Err(no_equilibrium()) }
}

/// A bracket for k12 < 0, where there may be none or several.
fn only_sign_change(imbalance: &Imbalance<'_>) -> Result<(f64, f64), OscillatorError> {
    const SAMPLES: usize = 1201;
    let samples: Vec<f64> =
        (0..SAMPLES).map(|k| SEARCH.0 + (SEARCH.1 - SEARCH.0) * k as f64 / (SAMPLES - 1) as f64).collect();
    let roots = all_roots(|u| imbalance.at(u).residual, &samples).roots;
    match roots[..] {
        [] => Err(no_equilibrium()),
        [root] => Ok((root - 1e-6, root + 1e-6)),
        _ => Err(OscillatorError::SeveralEquilibria {
            indentations: roots.iter().map(|u| libm::exp(*u)).collect(),
        }),
    }
}

/// Newton in ln ŷ, with bisection wherever a step leaves the bracket.
fn root_in_bracket(imbalance: &Imbalance<'_>, lower: f64, upper: f64) -> Result<f64, OscillatorError> {
    const LIMIT: usize = 100;
    let (mut lower, mut upper) = (lower, upper);
    let mut u = upper;
    let mut residual = f64::NAN;
    for _ in 0..LIMIT {
        let here = imbalance.at(u);
        residual = here.residual;
        if residual < 0.0 {
            lower = u;
        } else {
            upper = u;
        }
        let next = u + here.newton_step();
        let next = if next > lower && next < upper { next } else { 0.5 * (lower + upper) };
        if (next - u).abs() <= 2.0 * f64::EPSILON * u.abs().max(1.0) {
            return Ok(next);
        }
        u = next;
    }
    Err(OscillatorError::EquilibriumNotConverged { iterations: LIMIT, indentation: libm::exp(u), residual })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Groups;
    use judder_contact::{FittedLaw, HertzLaw, Law};

    #[test]
    fn without_coupling_hertz_is_a_cubic_in_the_root_of_the_depth() {
        // Ω² k̃_x s² + 4/3 s³ = F̃_n with s = √ŷ: chosen so that s = 0.01 solves it
        let s: f64 = 0.01;
        let groups = Groups {
            coupling: 0.0,
            normal_load: 0.00375 * s * s + 4.0 / 3.0 * s.powi(3),
            ..Groups::default()
        };
        let contact =
            Contact { law: Law::Hertz(HertzLaw::default()), friction_load: FrictionLoad::NormalLoad };
        let e = equilibrium(&contact, &groups.coefficients().unwrap()).unwrap();
        assert!((e.indentation - 1e-4).abs() < 1e-18, "{:e}", e.indentation);
    }

    #[test]
    fn both_rows_of_eq_15_hold() {
        let contact = Contact {
            law: Law::Fitted(FittedLaw::oscillator_paper()),
            friction_load: FrictionLoad::NormalLoad,
        };
        let groups = Groups { velocity: 1e-3, normal_load: 1e-3, shear_strength: 0.05, ..Groups::default() };
        let c = groups.coefficients().unwrap();
        let e = equilibrium(&contact, &c).unwrap();
        let right =
            e.response.friction.value + groups.shear_strength / groups.normal_load * e.response.area.value;
        assert!((c.k11 * e.x + c.k12 * e.y - right).abs() < 1e-13 * right);
        let right = 1.0 - e.response.force.value / groups.normal_load;
        assert!((c.k22 * e.y + c.k12 * e.x - right).abs() < 1e-13);
    }

    #[test]
    fn friction_that_pulls_in_is_counted_not_guessed() {
        // α = 135°: k12 < 0
        let contact = Contact {
            law: Law::Fitted(FittedLaw::oscillator_paper()),
            friction_load: FrictionLoad::NormalLoad,
        };
        let groups = Groups { coupling_angle: 2.356, shear_strength: 0.01, ..Groups::default() };
        assert!(equilibrium(&contact, &groups.coefficients().unwrap()).is_ok());
    }
}
