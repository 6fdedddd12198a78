//! The oscillator of the paper with stick, slip and lift-off as modes of their own.
//!
//! The friction force of (5) is set-valued at v_rel = 0. There μ_visc → 0, so what holds a sticking indenter is τ0·A alone:
//! it sticks while the force that the structure asks for stays below (τ̃0/F̃_n) Ã(v̂ → 0, ŷ), which moves with the depth. In
//! lift-off F̃_k, μ_visc and Ã vanish together, and (13) holds.

use super::ContactState;
use super::equations::{self, RelativeForces, balance, contact_forces, structure_forces};
use super::measures::{Measures, Powers};
use super::sliding_system::SlidingSystem;
use crate::equilibrium::equilibrium;
use crate::groups::Coefficients;
use crate::{Contact, OscillatorError};
use judder_contact::{ContactLaw, ContactResponse, ValidityConcern, WithDerivatives};
use judder_numerics::cancellation;
use judder_numerics::piecewise::tangent::{SquareMatrix, along_leg};
use judder_numerics::piecewise::{Advance, Leg, MarchError, PiecewiseMarch, PiecewiseSmooth};

/// Guards of a mode in contact: the depth, then the margin towards each change of slip.
const DEPTH: usize = 0;
const RELEASE_BEHIND: usize = 1;

/// The oscillator (12), (13) at one operating point; a state is x̃, ỹ, dx̃/dθ, dỹ/dθ.
#[derive(Debug, Clone)]
pub struct StickSlip {
    contact: Contact,
    coefficients: Coefficients,
    steady_sliding: [f64; 4],
}

impl StickSlip {
    /// The oscillator with its steady sliding.
    ///
    /// # Errors
    /// Steady sliding was not found.
    pub fn new(contact: Contact, coefficients: Coefficients) -> Result<Self, OscillatorError> {
        let e = equilibrium(&contact, &coefficients)?;
        Ok(Self { contact, coefficients, steady_sliding: [e.x, e.y, 0.0, 0.0] })
    }

    /// The numbers of its equations.
    #[must_use]
    pub fn coefficients(&self) -> &Coefficients {
        &self.coefficients
    }

    /// The contact law at a state in contact: the speed is that of the mode's own direction, and zero beyond it.
    #[must_use]
    pub fn response(&self, contact_state: ContactState, state: &[f64; 4]) -> ContactResponse {
        let c = &self.coefficients;
        let speed = equations::speed(c, contact_state, state);
        equations::response(&self.contact, c, speed, state[1].max(0.0))
    }

    /// Whether a state that slides as fast as in steady sliding, or faster, lies outside the law's range.
    ///
    /// Of slower ones nothing is told: every motion that sticks passes all speeds down to rest.
    #[must_use]
    pub fn concern(&self, state: &[f64; 4]) -> Option<ValidityConcern> {
        let (c, speed) = (&self.coefficients, self.relative_velocity(state).abs());
        let indentation = state[1] / c.radius();
        let is_told = indentation > 0.0 && speed >= c.belt_velocity();
        let velocity = speed * c.retardation_time / c.radius();
        is_told.then(|| self.contact.law.concern(velocity, indentation)).flatten()
    }

    fn forces(&self, contact_state: ContactState, state: &[f64; 4]) -> RelativeForces {
        if contact_state == ContactState::LiftOff {
            return RelativeForces::default();
        }
        let c = &self.coefficients;
        contact_forces(&self.contact, c, equations::speed(c, contact_state, state), state[1])
    }

    /// |F_μ|/F_n in a mode.
    pub(super) fn friction(&self, contact_state: ContactState, state: &[f64; 4]) -> WithDerivatives {
        self.forces(contact_state, state).friction
    }

    /// The derivatives of |F_μ|/F_n by ỹ and dx̃/dθ in a mode.
    pub(super) fn friction_gradient(&self, contact_state: ContactState, state: &[f64; 4]) -> [f64; 2] {
        let c = &self.coefficients;
        let friction = self.friction(contact_state, state);
        let per_speed = contact_state.direction() * c.retardation_time / c.radius();
        [friction.by_indentation / c.radius(), friction.by_velocity * per_speed]
    }

    /// How far the contact at rest is from slipping behind and ahead: (τ̃0/F̃_n) Ã(0, ŷ) ∓ the force that sticking takes.
    fn stick_margins(&self, state: &[f64; 4]) -> [f64; 2] {
        let limit = self.forces(ContactState::Stick, state).friction.value;
        let needed = structure_forces(&self.coefficients, state)[0];
        [limit - needed, limit + needed]
    }

    /// The gradients of [`StickSlip::stick_margins`].
    fn stick_margin_gradients(&self, state: &[f64; 4]) -> [[f64; 4]; 2] {
        let c = &self.coefficients;
        let by_depth = self.forces(ContactState::Stick, state).friction.by_indentation / c.radius();
        [-1.0, 1.0].map(|s| [s * c.k11, by_depth + s * c.k12, s * c.damping_x, 0.0])
    }
}

impl PiecewiseSmooth<4> for StickSlip {
    type Mode = ContactState;

    fn field(&self, mode: ContactState, state: &[f64; 4]) -> [f64; 4] {
        let forces = self.forces(mode, state);
        let [acceleration_x, acceleration_y] = balance(&self.coefficients, mode.direction(), &forces, state);
        let held = mode == ContactState::Stick;
        [state[2], state[3], if held { 0.0 } else { acceleration_x }, acceleration_y]
    }

    fn jacobian(&self, mode: ContactState, state: &[f64; 4]) -> SquareMatrix<4> {
        let c = &self.coefficients;
        let RelativeForces { friction, normal } = self.forces(mode, state);
        let (per_depth, per_speed) = (1.0 / c.radius(), c.retardation_time / c.radius());
        let direction = mode.direction();
        let row_x = if mode == ContactState::Stick {
            [0.0; 4]
        } else {
            [
                -c.k11,
                -c.k12 - direction * friction.by_indentation * per_depth,
                -cancellation::sum(c.damping_x, direction * direction * friction.by_velocity * per_speed),
                0.0,
            ]
        };
        let row_y = [
            -c.k12,
            -c.k22 - normal.by_indentation * per_depth,
            -direction * normal.by_velocity * per_speed,
            -c.damping_y,
        ];
        [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], row_x, row_y]
    }

    fn guards(&self, mode: ContactState) -> usize {
        match mode {
            ContactState::Stick => 3,
            ContactState::SlipBehind | ContactState::SlipAhead => 2,
            ContactState::LiftOff => 1,
        }
    }

    fn guard(&self, mode: ContactState, guard: usize, state: &[f64; 4]) -> f64 {
        match (mode, guard) {
            (ContactState::LiftOff, _) => -state[1],
            (_, DEPTH) => state[1],
            (ContactState::Stick, margin) => self.stick_margins(state)[margin - RELEASE_BEHIND],
            _ => mode.direction() * self.relative_velocity(state),
        }
    }

    fn guard_gradient(&self, mode: ContactState, guard: usize, state: &[f64; 4]) -> [f64; 4] {
        match (mode, guard) {
            (ContactState::LiftOff, _) => [0.0, -1.0, 0.0, 0.0],
            (_, DEPTH) => [0.0, 1.0, 0.0, 0.0],
            (ContactState::Stick, margin) => self.stick_margin_gradients(state)[margin - RELEASE_BEHIND],
            _ => [0.0, 0.0, mode.direction(), 0.0],
        }
    }

    fn cross(&self, mode: ContactState, guard: usize, state: &[f64; 4]) -> (ContactState, [f64; 4]) {
        let [x, y, velocity_x, velocity_y] = *state;
        match (mode, guard) {
            (ContactState::LiftOff, _) | (_, DEPTH) => {
                let touching = [x, 0.0, velocity_x, velocity_y];
                (self.contact_state(&touching), touching)
            }
            (ContactState::Stick, RELEASE_BEHIND) => (ContactState::SlipBehind, *state),
            (ContactState::Stick, _) => (ContactState::SlipAhead, *state),
            _ => {
                let at_rest = [x, y, self.belt_velocity(), velocity_y];
                (self.contact_state_at_rest(&at_rest), at_rest)
            }
        }
    }
}

impl SlidingSystem<4> for StickSlip {
    fn belt_velocity(&self) -> f64 {
        self.coefficients.belt_velocity()
    }

    fn mode(&self, contact_state: ContactState, _state: &[f64; 4]) -> ContactState {
        contact_state
    }

    fn contact_state_at_rest(&self, state: &[f64; 4]) -> ContactState {
        let [behind, ahead] = self.stick_margins(state);
        if behind < 0.0 {
            return ContactState::SlipBehind;
        }
        if ahead < 0.0 {
            return ContactState::SlipAhead;
        }
        // on the limit itself the margin's own rate decides
        let field = self.field(ContactState::Stick, state);
        let rates = self
            .stick_margin_gradients(state)
            .map(|g| g.iter().zip(&field).fold(0.0, |sum, (g, f)| sum + g * f));
        if behind == 0.0 && rates[0] < 0.0 {
            ContactState::SlipBehind
        } else if ahead == 0.0 && rates[1] < 0.0 {
            ContactState::SlipAhead
        } else {
            ContactState::Stick
        }
    }

    fn is_in_contact(&self, state: &[f64; 4]) -> bool {
        let [_, y, _, velocity_y] = *state;
        if y != 0.0 {
            return y > 0.0;
        }
        if velocity_y != 0.0 {
            return velocity_y > 0.0;
        }
        1.0 - structure_forces(&self.coefficients, state)[1] > 0.0
    }

    fn steady_sliding(&self) -> [f64; 4] {
        self.steady_sliding
    }

    fn scales(&self) -> [f64; 4] {
        /// Of the depth: without friction and coupling steady sliding has x̃ = 0, which is no scale.
        const LEAST: f64 = 1e-3;
        let [x, y, _, _] = self.steady_sliding;
        let along = x.abs().max(LEAST * y.abs());
        [along, y.abs(), self.belt_velocity().min(along), y.abs()]
    }

    fn powers(&self, contact_state: ContactState, state: &[f64; 4]) -> Powers {
        let c = &self.coefficients;
        let [_, _, velocity_x, velocity_y] = *state;
        let forces = self.forces(contact_state, state);
        let friction = match contact_state {
            ContactState::Stick => structure_forces(&self.coefficients, state)[0],
            _ => -contact_state.direction() * forces.friction.value,
        };
        Powers {
            friction: friction * velocity_x,
            substrate: friction * self.belt_velocity(),
            normal: -forces.normal.value * velocity_y,
            damping: -c.damping_x * velocity_x * velocity_x - c.damping_y * velocity_y * velocity_y,
        }
    }

    fn energy(&self, state: &[f64; 4]) -> f64 {
        let c = &self.coefficients;
        let [x, y, velocity_x, velocity_y] = *state;
        0.5 * (velocity_x * velocity_x + velocity_y * velocity_y + c.k11 * x * x + c.k22 * y * y)
            + c.k12 * x * y
            - y
    }

    fn advance(
        &self,
        march: &mut PiecewiseMarch<'_, Self, 4>,
        until: f64,
    ) -> Result<Advance<ContactState, 4>, MarchError> {
        march.advance(until)
    }

    fn along_leg(&self, leg: &Leg<ContactState, 4>, disturbance: &SquareMatrix<4>) -> SquareMatrix<4> {
        along_leg(self, leg, disturbance)
    }

    fn measure(&self, leg: &Leg<ContactState, 4>, centre: f64, measures: &mut Measures) {
        measures.add(leg, centre, |state| self.powers(leg.mode, state));
    }
}
