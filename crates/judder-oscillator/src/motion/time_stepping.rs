//! The same motion by another engine: Moreau's time-stepping, which knows no events.
//!
//! J. J. Moreau, *Unilateral contact and dry friction in finite freedom dynamics*, CISM 302 (1988): displacements go half a
//! step, forces are taken there, and the velocity at the step's end solves the set-valued friction law, so that stick comes
//! out of the inclusion and not of a mode. First order in the step.

use super::ContactState;
use super::equations::{RelativeForces, contact_forces};
use crate::groups::Coefficients;
use crate::{Contact, OscillatorError};

/// The oscillator of the paper under time-stepping; a state is x̃, ỹ, dx̃/dθ, dỹ/dθ.
#[derive(Debug, Clone)]
pub struct TimeStepping {
    contact: Contact,
    coefficients: Coefficients,
    belt_velocity: f64,
    step: f64,
}

impl TimeStepping {
    /// The engine with a fixed step.
    ///
    /// # Errors
    /// [`OscillatorError::InvalidGroup`] where the step is not positive.
    pub fn new(contact: Contact, coefficients: Coefficients, step: f64) -> Result<Self, OscillatorError> {
        if step.is_finite() && step > 0.0 {
            let belt_velocity = coefficients.belt_velocity();
            return Ok(Self { contact, coefficients, belt_velocity, step });
        }
        Err(OscillatorError::InvalidGroup { name: "time step", value: step, requirement: "positive" })
    }

    /// The step.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The state a step later, and what the contact did in it.
    #[must_use]
    pub fn advance(&self, state: &[f64; 4]) -> ([f64; 4], ContactState) {
        let (c, h) = (&self.coefficients, self.step);
        let [x, y, velocity_x, velocity_y] = *state;
        let (x, y) = (x + 0.5 * h * velocity_x, y + 0.5 * h * velocity_y);
        let free_x = velocity_x - h * (c.damping_x * velocity_x + c.k11 * x + c.k12 * y);
        let free_y = velocity_y + h * (1.0 - c.damping_y * velocity_y - c.k22 * y - c.k12 * x);
        if y <= 0.0 {
            return (Self::moved(x, y, free_x, free_y, h), ContactState::LiftOff);
        }
        let sticks = velocity_x == self.belt_velocity;
        let (relative, contact_state) = self.slip(free_x - self.belt_velocity, y, sticks);
        let force = self.forces(relative.abs(), y).normal.value;
        let velocity = (self.belt_velocity + relative, free_y - h * force);
        (Self::moved(x, y, velocity.0, velocity.1, h), contact_state)
    }

    fn moved(x: f64, y: f64, velocity_x: f64, velocity_y: f64, h: f64) -> [f64; 4] {
        [x + 0.5 * h * velocity_x, y + 0.5 * h * velocity_y, velocity_x, velocity_y]
    }

    fn forces(&self, speed: f64, y: f64) -> RelativeForces {
        contact_forces(&self.contact, &self.coefficients, speed, y)
    }

    /// v_rel at the end of the step: the solution of v_rel + h Sgn(v_rel) |F_μ|(|v_rel|) ∋ free.
    ///
    /// Where friction falls so steeply with speed that there are several, what was goes on: stick, or from sliding the one of
    /// largest speed.
    fn slip(&self, free: f64, y: f64, sticks: bool) -> (f64, ContactState) {
        let h = self.step;
        let direction = free.signum();
        let excess = |speed: f64| speed + h * self.forces(speed, y).friction.value - free.abs();
        let is_stuck = excess(0.0) >= 0.0;
        if sticks && is_stuck {
            return (0.0, ContactState::Stick);
        }
        // the excess is positive at the free speed itself: halve towards the last sign change below it
        let mut upper = free.abs();
        let mut lower = upper;
        while lower > 1e-12 * free.abs() && excess(lower) >= 0.0 {
            upper = lower;
            lower *= 0.5;
        }
        if excess(lower) >= 0.0 && is_stuck {
            return (0.0, ContactState::Stick);
        }
        for _ in 0..60 {
            let middle = 0.5 * (lower + upper);
            if excess(middle) >= 0.0 {
                upper = middle;
            } else {
                lower = middle;
            }
        }
        let state = if direction < 0.0 { ContactState::SlipBehind } else { ContactState::SlipAhead };
        (direction * 0.5 * (lower + upper), state)
    }
}
