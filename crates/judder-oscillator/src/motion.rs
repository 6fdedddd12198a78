//! Motion: the equations (12), (13), and what comes of them beyond small disturbances.
//!
//! - here: the accelerations of (12), (13), as one formula.
//! - [`contact_state`]: stick, slip, lift-off.
//! - [`sliding_system`]: what the nonsmooth engine and everything built on it ask of an oscillator.
//! - [`stick_slip`]: the oscillator of the paper as such a system.
//! - [`belt`]: the mass on a belt, with one degree of freedom, of the literature's benchmarks.
//! - [`measures`]: averages, fractions of the time, work along a motion.
//! - [`history`]: a motion over a given time.
//! - [`attractor`]: where a motion settles.
//! - [`time_stepping`], [`smoothed`]: two other engines for the same motion, to hold the first against.

pub mod attractor;
pub mod belt;
pub mod contact_state;
pub mod history;
pub mod measures;
pub mod sliding_system;
pub mod smoothed;
pub mod stick_slip;
pub mod time_stepping;

pub use belt::{BeltOscillator, FallingFriction};
pub use contact_state::ContactState;
pub use sliding_system::{Powers, SlidingSystem};
pub use smoothed::Smoothed;
pub use stick_slip::StickSlip;
pub use time_stepping::TimeStepping;

use crate::Contact;
use crate::friction::friction_force;
use crate::groups::Coefficients;
use judder_contact::{ContactLaw, ContactPoint};

/// Displacements and velocities of the oscillator in the units x0 = F_n/k_x and 1/ω_nx.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionState {
    /// x̃.
    pub x: f64,
    /// ỹ, positive into the substrate.
    pub y: f64,
    /// dx̃/dθ.
    pub velocity_x: f64,
    /// dỹ/dθ.
    pub velocity_y: f64,
}

/// (12), and (13) where the indenter is off the substrate (ỹ ≤ 0): d²x̃/dθ² and d²ỹ/dθ².
///
/// The relative velocity ṽ_rel = x̃′ − ṽ_d has ṽ_d = v̂_d R̃/τ̃. At ṽ_rel = 0 exactly the slip force is taken as zero; stick
/// is a state of its own that these equations do not hold.
#[must_use]
pub fn accelerations(contact: &Contact, c: &Coefficients, state: &MotionState) -> [f64; 2] {
    let indentation = state.y / c.radius();
    let structure_x = c.damping_x * state.velocity_x + c.k11 * state.x + c.k12 * state.y;
    let structure_y = c.damping_y * state.velocity_y + c.k22 * state.y + c.k12 * state.x;
    if indentation <= 0.0 {
        return [-structure_x, 1.0 - structure_y];
    }
    let relative = (state.velocity_x - c.belt_velocity()) * c.retardation_time / c.radius();
    let response = contact.law.evaluate(&ContactPoint::new(relative.abs(), indentation));
    let friction = friction_force(contact.friction_load, c, &response).value / c.normal_load;
    let direction = if relative == 0.0 { 0.0 } else { -relative.signum() };
    [direction * friction - structure_x, 1.0 - response.force.value / c.normal_load - structure_y]
}
