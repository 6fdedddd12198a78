//! Motion whose equations change from mode to mode, with every change a located event.
//!
//! - [`PiecewiseSmooth`]: what a system says of itself: its modes, fields, guards, and where it goes on from a guard.
//! - [`march`]: the motion step by step, explicit or, where it is stiff, implicit; no change of mode missed or repeated.
//! - [`leg`]: what it is made of: legs, crossings, and the plane on which it is looked at.
//! - [`quartic`]: a guard along one step, and where it first turns negative.
//! - [`tangent`]: how a small disturbance travels along a motion, through its events.
//!
//! The mathematics stands here apart from the physics of stick, slip and lift-off.

mod dormand_prince;
mod error;
pub mod leg;
pub mod march;
pub mod quartic;
mod radau;
mod stiffness;
pub mod tangent;

pub use error::MarchError;
pub use leg::{Advance, GuardCrossing, Leg, SectionPlane};
pub use march::{PiecewiseMarch, StepSettings};

use std::fmt::Debug;

/// An autonomous system u̇ = f_m(u) with modes m, each of which lasts while all its guards g are ≥ 0.
pub trait PiecewiseSmooth<const N: usize> {
    /// The name of a mode.
    type Mode: Copy + PartialEq + Debug;

    /// f_m(u). It is also asked a little beyond the guards, where any smooth continuation will do.
    fn field(&self, mode: Self::Mode, state: &[f64; N]) -> [f64; N];

    /// ∂f_m/∂u.
    fn jacobian(&self, mode: Self::Mode, state: &[f64; N]) -> [[f64; N]; N];

    /// The number of guards of a mode.
    fn guards(&self, mode: Self::Mode) -> usize;

    /// The guard's value: positive inside the mode, negative beyond it.
    fn guard(&self, mode: Self::Mode, guard: usize, state: &[f64; N]) -> f64;

    /// ∂g/∂u.
    fn guard_gradient(&self, mode: Self::Mode, guard: usize, state: &[f64; N]) -> [f64; N];

    /// Whether the fields on both sides of a guard meet there without a jump, and go on smoothly beyond it: where pieces of a force meet at a corner.
    fn is_corner(&self, _mode: Self::Mode, _guard: usize) -> bool {
        false
    }

    /// The mode in which the motion goes on from a state on a guard, and the state itself, moved onto the guard exactly
    /// (by rounding alone), so that a guard of the next mode that stands on the same surface is exactly zero.
    fn cross(&self, mode: Self::Mode, guard: usize, state: &[f64; N]) -> (Self::Mode, [f64; N]);
}

/// ∇g · f.
pub(crate) fn rate<const N: usize>(gradient: &[f64; N], field: &[f64; N]) -> f64 {
    gradient.iter().zip(field).fold(0.0, |sum, (g, f)| sum + g * f)
}
