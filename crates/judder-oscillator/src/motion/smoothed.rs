//! The same motion with a smoothed sign, which knows no stick: what most codes do.
//!
//! sgn(v_rel) becomes tanh(v_rel/ε). A sticking indenter creeps, so the motion is off by O(ε), and the equations are stiff.

use super::ContactState;
use super::SlidingSystem;
use super::stick_slip::StickSlip;
use judder_numerics::piecewise::PiecewiseSmooth;
use judder_numerics::piecewise::tangent::SquareMatrix;

/// The oscillator of the paper with tanh(v_rel/ε) for the sign, in contact or in the air.
#[derive(Debug, Clone)]
pub struct Smoothed {
    oscillator: StickSlip,
    /// ε, in the units of the oscillator's velocities.
    width: f64,
}

impl Smoothed {
    /// The oscillator with a sign as wide as ε > 0.
    #[must_use]
    pub fn new(oscillator: StickSlip, width: f64) -> Self {
        Self { oscillator, width }
    }

    /// The mode of the sharp oscillator whose forces hold in a state.
    fn side(&self, state: &[f64; 4]) -> ContactState {
        if self.oscillator.relative_velocity(state) < 0.0 {
            ContactState::SlipBehind
        } else {
            ContactState::SlipAhead
        }
    }

    /// Whether the indenter touches, as the mode of this system: [`ContactState::SlipBehind`] stands for contact.
    #[must_use]
    pub fn contact_state(&self, state: &[f64; 4]) -> ContactState {
        match self.oscillator.contact_state(state) {
            ContactState::LiftOff => ContactState::LiftOff,
            _ => ContactState::SlipBehind,
        }
    }

    fn smooth_sign(&self, state: &[f64; 4]) -> f64 {
        libm::tanh(self.oscillator.relative_velocity(state).abs() / self.width)
    }
}

impl PiecewiseSmooth<4> for Smoothed {
    type Mode = ContactState;

    fn field(&self, mode: ContactState, state: &[f64; 4]) -> [f64; 4] {
        if mode == ContactState::LiftOff {
            return self.oscillator.field(mode, state);
        }
        let side = self.side(state);
        let mut field = self.oscillator.field(side, state);
        let friction = side.direction() * self.oscillator.friction(side, state).value;
        field[2] += friction * (1.0 - self.smooth_sign(state));
        field
    }

    fn jacobian(&self, mode: ContactState, state: &[f64; 4]) -> SquareMatrix<4> {
        if mode == ContactState::LiftOff {
            return self.oscillator.jacobian(mode, state);
        }
        let side = self.side(state);
        let mut jacobian = self.oscillator.jacobian(side, state);
        let (sign, friction) = (self.smooth_sign(state), self.oscillator.friction(side, state));
        let [by_depth, by_velocity] = self.oscillator.friction_gradient(side, state);
        let slope = (1.0 - sign * sign) / self.width;
        jacobian[2][1] += side.direction() * by_depth * (1.0 - sign);
        jacobian[2][2] += side.direction() * by_velocity * (1.0 - sign) - friction.value * slope;
        jacobian
    }

    fn guards(&self, _mode: ContactState) -> usize {
        1
    }

    fn guard(&self, mode: ContactState, _guard: usize, state: &[f64; 4]) -> f64 {
        if mode == ContactState::LiftOff { -state[1] } else { state[1] }
    }

    fn guard_gradient(&self, mode: ContactState, _guard: usize, _state: &[f64; 4]) -> [f64; 4] {
        [0.0, if mode == ContactState::LiftOff { -1.0 } else { 1.0 }, 0.0, 0.0]
    }

    fn cross(&self, _mode: ContactState, _guard: usize, state: &[f64; 4]) -> (ContactState, [f64; 4]) {
        let touching = [state[0], 0.0, state[2], state[3]];
        (self.contact_state(&touching), touching)
    }
}
