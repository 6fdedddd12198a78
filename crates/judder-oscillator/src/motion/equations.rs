//! The equations (12), (13) themselves: every engine and every check takes its forces from here.
//!
//! A state is x̃, ỹ, dx̃/dθ, dỹ/dθ: displacements in x0 = F_n/k_x, ỹ positive into the substrate, θ = ω_nx t.

use super::ContactState;
use crate::Contact;
use crate::friction::friction_force;
use crate::groups::Coefficients;
use judder_contact::{ContactLaw, ContactResponse, LawPoint, WithDerivatives};

/// The contact's forces on the oscillator over F_n, with derivatives by v̂ and ŷ.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RelativeForces {
    /// |F_μ|.
    pub(super) friction: WithDerivatives,
    /// F_k.
    pub(super) normal: WithDerivatives,
}

/// (12), and (13) where the indenter is off the substrate (ỹ ≤ 0): d²x̃/dθ² and d²ỹ/dθ².
///
/// The relative velocity ṽ_rel = x̃′ − ṽ_d has ṽ_d = v̂_d R̃/τ̃. At ṽ_rel = 0 exactly the slip force is taken as zero; stick
/// is a state of its own that these equations do not hold.
#[must_use]
pub fn accelerations(contact: &Contact, c: &Coefficients, state: &[f64; 4]) -> [f64; 2] {
    let relative = state[2] - c.belt_velocity();
    let direction = if relative == 0.0 { 0.0 } else { relative.signum() };
    let forces = contact_forces(contact, c, relative.abs(), state[1]);
    balance(c, direction, &forces, state)
}

/// What is left of the forces over F_n where the indenter slides in a direction, the sign of v_rel.
pub(super) fn balance(
    c: &Coefficients,
    direction: f64,
    forces: &RelativeForces,
    state: &[f64; 4],
) -> [f64; 2] {
    let structure = structure_forces(c, state);
    [-direction * forces.friction.value - structure[0], 1.0 - forces.normal.value - structure[1]]
}

/// The forces of springs and dampers against x and y.
pub(super) fn structure_forces(c: &Coefficients, [x, y, velocity_x, velocity_y]: &[f64; 4]) -> [f64; 2] {
    [c.damping_x * velocity_x + c.k11 * x + c.k12 * y, c.damping_y * velocity_y + c.k22 * y + c.k12 * x]
}

/// The contact law at a speed |ṽ_rel| and a depth ỹ, none of them negative.
pub(super) fn response(contact: &Contact, c: &Coefficients, speed: f64, depth: f64) -> ContactResponse {
    contact.law.evaluate(&LawPoint::new(speed * c.retardation_time / c.radius(), depth / c.radius()))
}

/// The contact's forces at a speed |ṽ_rel| and a depth ỹ: none off the substrate.
pub(super) fn contact_forces(contact: &Contact, c: &Coefficients, speed: f64, depth: f64) -> RelativeForces {
    if depth <= 0.0 {
        return RelativeForces::default();
    }
    let response = response(contact, c, speed, depth);
    let per_load = |q: WithDerivatives| WithDerivatives {
        value: q.value / c.normal_load,
        by_velocity: q.by_velocity / c.normal_load,
        by_indentation: q.by_indentation / c.normal_load,
    };
    RelativeForces {
        friction: per_load(friction_force(contact.friction_load, c, &response)),
        normal: per_load(response.force),
    }
}

/// |ṽ_rel| in the direction of a contact state, and zero beyond it.
pub(super) fn speed(c: &Coefficients, contact_state: ContactState, state: &[f64; 4]) -> f64 {
    (contact_state.direction() * (state[2] - c.belt_velocity())).max(0.0)
}
