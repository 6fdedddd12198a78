//! The mass on a belt: one degree of freedom, friction against the speed of sliding. The literature's benchmarks speak of it.

use super::ContactState;
use super::measures::{Measures, Powers};
use super::sliding_system::SlidingSystem;
use crate::OscillatorError;
pub use judder_contact::friction::{BeyondSpeeds, FallingFriction, Friction};
use judder_numerics::cancellation;
use judder_numerics::piecewise::tangent::{SquareMatrix, along_leg};
use judder_numerics::piecewise::{Advance, Leg, MarchError, PiecewiseMarch, PiecewiseSmooth};
use judder_numerics::verdict::Verdict;

/// x″ + 2ξ x′ + x + κ x³ = −sgn(x′ − v) N μ(|x′ − v|), in units of the mass and the natural frequency; a state is x, x′.
#[derive(Debug, Clone, PartialEq)]
pub struct BeltOscillator {
    damping: f64,
    cubic_stiffness: f64,
    normal_force: f64,
    belt_velocity: f64,
    friction: Friction,
}

/// A mode of the mass on a belt: a contact state, and the piece of a friction table on which it slides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BeltMode {
    /// Stick or slip.
    pub contact_state: ContactState,
    /// The number of the piece, 0 in stick.
    pub piece: usize,
}

impl From<BeltMode> for ContactState {
    fn from(mode: BeltMode) -> Self {
        mode.contact_state
    }
}

/// Guards of a slip: the lower and the upper end of its piece of friction, rest below the lowest.
const LOWER: usize = 0;

impl BeltOscillator {
    /// ξ, N, v > 0 and the friction coefficient.
    ///
    /// # Errors
    /// [`OscillatorError::InvalidGroup`] names the first number out of its range; [`OscillatorError::Friction`].
    pub fn new(
        damping: f64,
        normal_force: f64,
        belt_velocity: f64,
        friction: impl Into<Friction>,
    ) -> Result<Self, OscillatorError> {
        let mut numbers = [
            ("damping ξ", damping, false),
            ("normal force N", normal_force, true),
            ("belt velocity v", belt_velocity, true),
        ]
        .into_iter();
        let is_wrong =
            |value: f64, is_positive: bool| !value.is_finite() || value < 0.0 || is_positive && value == 0.0;
        let friction = friction.into();
        friction.check()?;
        match numbers.find(|(_, value, is_positive)| is_wrong(*value, *is_positive)) {
            Some((name, value, is_positive)) => {
                let requirement = if is_positive { "positive" } else { "zero or positive" };
                Err(OscillatorError::InvalidGroup { name, value, requirement })
            }
            None => Ok(Self { damping, cubic_stiffness: 0.0, normal_force, belt_velocity, friction }),
        }
    }

    /// The same with a spring that stiffens: κ ≥ 0, per squared length.
    ///
    /// # Errors
    /// [`OscillatorError::InvalidGroup`].
    pub fn with_cubic_stiffness(self, cubic_stiffness: f64) -> Result<Self, OscillatorError> {
        if cubic_stiffness.is_finite() && cubic_stiffness >= 0.0 {
            return Ok(Self { cubic_stiffness, ..self });
        }
        let (name, requirement) = ("cubic stiffness κ", "zero or positive");
        Err(OscillatorError::InvalidGroup { name, value: cubic_stiffness, requirement })
    }

    /// ξ + N μ′(v)/2, at which steady sliding loses stability as it passes zero; zero where the two cancel but for rounding.
    #[must_use]
    pub fn equivalent_damping(&self) -> f64 {
        let slope = self.friction.at(self.belt_velocity).slope;
        cancellation::sum(self.damping, 0.5 * self.normal_force * slope)
    }

    /// Whether steady sliding is stable, as its equivalent damping says.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let damping = self.equivalent_damping();
        if damping > 0.0 {
            Verdict::Stable
        } else if damping < 0.0 {
            Verdict::Unstable
        } else {
            Verdict::Marginal
        }
    }

    /// Whether the mass slips on its belt, or sticks to it, at a speed beyond those of its table of friction.
    #[must_use]
    pub fn beyond(&self, state: &[f64; 2]) -> Option<BeyondSpeeds> {
        self.friction.beyond(self.relative_velocity(state).abs())
    }

    fn speed(&self, contact_state: ContactState, state: &[f64; 2]) -> f64 {
        (contact_state.direction() * self.relative_velocity(state)).max(0.0)
    }

    fn structure(&self, [x, velocity]: &[f64; 2]) -> f64 {
        2.0 * self.damping * velocity + x * (1.0 + self.cubic_stiffness * x * x)
    }

    /// The stiffness about a displacement.
    fn stiffness(&self, x: f64) -> f64 {
        1.0 + 3.0 * self.cubic_stiffness * x * x
    }

    /// Where the spring alone bears a force ≥ 0: the root of a convex function that rises, which Newton's method comes down to.
    fn displacement(&self, force: f64) -> f64 {
        let mut x = force;
        loop {
            let next = x - (self.structure(&[x, 0.0]) - force) / self.stiffness(x);
            if next.is_nan() || next >= x {
                return x;
            }
            x = next;
        }
    }

    fn stick_limit(&self) -> f64 {
        self.normal_force * self.friction.at(0.0).coefficient
    }

    /// The velocity of the mass at which it slides with a speed: always the same bits.
    fn velocity_at(&self, contact_state: ContactState, speed: f64) -> f64 {
        self.belt_velocity + contact_state.direction() * speed
    }

    /// The mass's velocity at an end of the piece of friction on which it slides; its lower end is rest where there is no other.
    fn end(&self, mode: BeltMode, guard: usize) -> f64 {
        let [lower, upper] = self.friction.ends(mode.piece);
        let speed = if guard == LOWER { lower.unwrap_or(0.0) } else { upper.unwrap_or(f64::INFINITY) };
        self.velocity_at(mode.contact_state, speed)
    }
}

impl PiecewiseSmooth<2> for BeltOscillator {
    type Mode = BeltMode;

    fn field(&self, mode: BeltMode, state: &[f64; 2]) -> [f64; 2] {
        if mode.contact_state == ContactState::Stick {
            return [state[1], 0.0];
        }
        let friction = self.friction.on_piece(mode.piece, self.speed(mode.contact_state, state)).coefficient;
        let direction = mode.contact_state.direction();
        [state[1], -direction * (self.normal_force * friction) - self.structure(state)]
    }

    fn jacobian(&self, mode: BeltMode, state: &[f64; 2]) -> [[f64; 2]; 2] {
        if mode.contact_state == ContactState::Stick {
            return [[0.0, 1.0], [0.0, 0.0]];
        }
        let slope = self.friction.on_piece(mode.piece, self.speed(mode.contact_state, state)).slope;
        let direction = mode.contact_state.direction();
        [
            [0.0, 1.0],
            [
                -self.stiffness(state[0]),
                -cancellation::sum(2.0 * self.damping, direction * direction * (self.normal_force * slope)),
            ],
        ]
    }

    fn guards(&self, mode: BeltMode) -> usize {
        if mode.contact_state == ContactState::Stick || self.friction.ends(mode.piece)[1].is_some() {
            2
        } else {
            1
        }
    }

    fn guard(&self, mode: BeltMode, guard: usize, state: &[f64; 2]) -> f64 {
        match (mode.contact_state, guard) {
            (ContactState::Stick, 0) => self.stick_limit() - self.structure(state),
            (ContactState::Stick, _) => self.stick_limit() + self.structure(state),
            (slip, LOWER) => slip.direction() * (state[1] - self.end(mode, LOWER)),
            (slip, upper) => slip.direction() * (self.end(mode, upper) - state[1]),
        }
    }

    fn guard_gradient(&self, mode: BeltMode, guard: usize, state: &[f64; 2]) -> [f64; 2] {
        match (mode.contact_state, guard) {
            (ContactState::Stick, 0) => [-self.stiffness(state[0]), -2.0 * self.damping],
            (ContactState::Stick, _) => [self.stiffness(state[0]), 2.0 * self.damping],
            (slip, LOWER) => [0.0, slip.direction()],
            (slip, _) => [0.0, -slip.direction()],
        }
    }

    fn is_corner(&self, mode: BeltMode, guard: usize) -> bool {
        let is_rest = guard == LOWER && self.friction.ends(mode.piece)[LOWER].is_none();
        mode.contact_state != ContactState::Stick && !is_rest
    }

    fn cross(&self, mode: BeltMode, guard: usize, state: &[f64; 2]) -> (BeltMode, [f64; 2]) {
        match (mode.contact_state, guard, self.friction.ends(mode.piece)[LOWER]) {
            (ContactState::Stick, 0, _) => (self.mode(ContactState::SlipBehind, state), *state),
            (ContactState::Stick, _, _) => (self.mode(ContactState::SlipAhead, state), *state),
            (_, LOWER, None) => {
                let at_rest = [state[0], self.belt_velocity];
                (self.mode(self.contact_state_at_rest(&at_rest), &at_rest), at_rest)
            }
            (contact_state, LOWER, Some(_)) => {
                let at_corner = [state[0], self.end(mode, LOWER)];
                (BeltMode { contact_state, piece: mode.piece - 1 }, at_corner)
            }
            (contact_state, upper, _) => {
                let at_corner = [state[0], self.end(mode, upper)];
                (BeltMode { contact_state, piece: mode.piece + 1 }, at_corner)
            }
        }
    }
}

impl SlidingSystem<2> for BeltOscillator {
    fn belt_velocity(&self) -> f64 {
        self.belt_velocity
    }

    fn mode(&self, contact_state: ContactState, state: &[f64; 2]) -> BeltMode {
        let piece = match contact_state {
            ContactState::Stick => 0,
            slip => self.friction.piece(self.speed(slip, state)),
        };
        BeltMode { contact_state, piece }
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
        let force = self.normal_force * self.friction.at(self.belt_velocity).coefficient;
        [self.displacement(force), 0.0]
    }

    fn scales(&self) -> [f64; 2] {
        let held = self.displacement(self.stick_limit()).max(self.steady_sliding()[0]);
        [held.max(self.belt_velocity), self.belt_velocity]
    }

    fn powers(&self, contact_state: ContactState, state: &[f64; 2]) -> Powers {
        let friction = match contact_state {
            ContactState::Stick => self.structure(state),
            _ => {
                let speed = self.speed(contact_state, state);
                -contact_state.direction() * self.normal_force * self.friction.at(speed).coefficient
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
        let square = state[0] * state[0];
        0.5 * (square + state[1] * state[1]) + 0.25 * self.cubic_stiffness * square * square
    }

    fn advance(
        &self,
        march: &mut PiecewiseMarch<'_, Self, 2>,
        until: f64,
    ) -> Result<Advance<BeltMode, 2>, MarchError> {
        march.advance(until)
    }

    fn along_leg(&self, leg: &Leg<BeltMode, 2>, disturbance: &SquareMatrix<2>) -> SquareMatrix<2> {
        along_leg(self, leg, disturbance)
    }

    fn measure(&self, leg: &Leg<BeltMode, 2>, centre: f64, measures: &mut Measures) {
        measures.add(leg, centre, |state| self.powers(leg.mode.contact_state, state));
    }
}
