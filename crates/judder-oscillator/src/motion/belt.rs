//! The mass on a belt: one degree of freedom, friction that falls with speed. The literature's benchmarks speak of it.

use super::ContactState;
use super::measures::{Measures, Powers};
use super::sliding_system::SlidingSystem;
use crate::OscillatorError;
pub use judder_contact::FallingFriction;
use judder_numerics::piecewise::tangent::{SquareMatrix, along_leg};
use judder_numerics::piecewise::{Advance, Leg, MarchError, PiecewiseMarch, PiecewiseSmooth};

/// x″ + 2ξ x′ + x = −sgn(x′ − v) N μ(|x′ − v|), in units of the mass and the natural frequency; a state is x, x′.
#[derive(Debug, Clone, PartialEq)]
pub struct BeltOscillator {
    damping: f64,
    normal_force: f64,
    belt_velocity: f64,
    friction: FallingFriction,
}

impl BeltOscillator {
    /// ξ, N, v > 0 and the friction coefficient.
    ///
    /// # Errors
    /// [`OscillatorError::InvalidGroup`] names the first number out of its range.
    pub fn new(
        damping: f64,
        normal_force: f64,
        belt_velocity: f64,
        friction: FallingFriction,
    ) -> Result<Self, OscillatorError> {
        let mut numbers = [
            ("damping ξ", damping, false),
            ("normal force N", normal_force, true),
            ("belt velocity v", belt_velocity, true),
            ("friction at rest μ_0", friction.at_rest, false),
            ("friction at speed μ_∞", friction.at_speed, false),
            ("decay speed v_0", friction.decay_speed, true),
        ]
        .into_iter();
        let is_wrong =
            |value: f64, is_positive: bool| !value.is_finite() || value < 0.0 || is_positive && value == 0.0;
        match numbers.find(|(_, value, is_positive)| is_wrong(*value, *is_positive)) {
            Some((name, value, is_positive)) => {
                let requirement = if is_positive { "positive" } else { "zero or positive" };
                Err(OscillatorError::InvalidGroup { name, value, requirement })
            }
            None => Ok(Self { damping, normal_force, belt_velocity, friction }),
        }
    }

    /// ξ − N |μ′(v)|/2, at which steady sliding loses stability as it passes zero.
    #[must_use]
    pub fn equivalent_damping(&self) -> f64 {
        self.damping + 0.5 * self.normal_force * self.friction.at(self.belt_velocity).1
    }

    fn speed(&self, mode: ContactState, state: &[f64; 2]) -> f64 {
        (mode.direction() * self.relative_velocity(state)).max(0.0)
    }

    fn structure(&self, [x, velocity]: &[f64; 2]) -> f64 {
        2.0 * self.damping * velocity + x
    }

    fn stick_limit(&self) -> f64 {
        self.normal_force * self.friction.at_rest
    }
}

impl PiecewiseSmooth<2> for BeltOscillator {
    type Mode = ContactState;

    fn field(&self, mode: ContactState, state: &[f64; 2]) -> [f64; 2] {
        let friction = self.normal_force * self.friction.at(self.speed(mode, state)).0;
        match mode {
            ContactState::Stick => [state[1], 0.0],
            _ => [state[1], -mode.direction() * friction - self.structure(state)],
        }
    }

    fn jacobian(&self, mode: ContactState, state: &[f64; 2]) -> [[f64; 2]; 2] {
        if mode == ContactState::Stick {
            return [[0.0, 1.0], [0.0, 0.0]];
        }
        let slope = self.normal_force * self.friction.at(self.speed(mode, state)).1;
        [[0.0, 1.0], [-1.0, -2.0 * self.damping - mode.direction() * mode.direction() * slope]]
    }

    fn guards(&self, mode: ContactState) -> usize {
        if mode == ContactState::Stick { 2 } else { 1 }
    }

    fn guard(&self, mode: ContactState, guard: usize, state: &[f64; 2]) -> f64 {
        match (mode, guard) {
            (ContactState::Stick, 0) => self.stick_limit() - self.structure(state),
            (ContactState::Stick, _) => self.stick_limit() + self.structure(state),
            _ => mode.direction() * self.relative_velocity(state),
        }
    }

    fn guard_gradient(&self, mode: ContactState, guard: usize, _state: &[f64; 2]) -> [f64; 2] {
        match (mode, guard) {
            (ContactState::Stick, 0) => [-1.0, -2.0 * self.damping],
            (ContactState::Stick, _) => [1.0, 2.0 * self.damping],
            _ => [0.0, mode.direction()],
        }
    }

    fn cross(&self, mode: ContactState, guard: usize, state: &[f64; 2]) -> (ContactState, [f64; 2]) {
        match (mode, guard) {
            (ContactState::Stick, 0) => (ContactState::SlipBehind, *state),
            (ContactState::Stick, _) => (ContactState::SlipAhead, *state),
            _ => {
                let at_rest = [state[0], self.belt_velocity];
                (self.contact_state_at_rest(&at_rest), at_rest)
            }
        }
    }
}

impl SlidingSystem<2> for BeltOscillator {
    fn belt_velocity(&self) -> f64 {
        self.belt_velocity
    }

    fn contact_state_at_rest(&self, state: &[f64; 2]) -> ContactState {
        let (needed, limit) = (self.structure(state), self.stick_limit());
        // a sticking mass is carried forward, so on the forward limit it slips at once
        if needed >= limit {
            ContactState::SlipBehind
        } else if needed < -limit {
            ContactState::SlipAhead
        } else {
            ContactState::Stick
        }
    }

    fn steady_sliding(&self) -> [f64; 2] {
        [self.normal_force * self.friction.at(self.belt_velocity).0, 0.0]
    }

    fn scales(&self) -> [f64; 2] {
        [self.stick_limit().max(self.belt_velocity), self.belt_velocity]
    }

    fn powers(&self, contact_state: ContactState, state: &[f64; 2]) -> Powers {
        let friction = match contact_state {
            ContactState::Stick => self.structure(state),
            _ => {
                let speed = self.speed(contact_state, state);
                -contact_state.direction() * self.normal_force * self.friction.at(speed).0
            }
        };
        Powers {
            friction: friction * state[1],
            substrate: friction * self.belt_velocity,
            normal: 0.0,
            damping: -2.0 * self.damping * state[1] * state[1],
        }
    }

    fn energy(&self, state: &[f64; 2]) -> f64 {
        0.5 * (state[0] * state[0] + state[1] * state[1])
    }

    fn advance(
        &self,
        march: &mut PiecewiseMarch<'_, Self, 2>,
        until: f64,
    ) -> Result<Advance<ContactState, 2>, MarchError> {
        march.advance(until)
    }

    fn along_leg(&self, leg: &Leg<ContactState, 2>, disturbance: &SquareMatrix<2>) -> SquareMatrix<2> {
        along_leg(self, leg, disturbance)
    }

    fn measure(&self, leg: &Leg<ContactState, 2>, centre: f64, measures: &mut Measures) {
        measures.add(leg, centre, |state| self.powers(leg.mode, state));
    }
}
