//! What the nonsmooth engine and everything built on it ask of an oscillator.

use super::ContactState;
use super::measures::{Measures, Powers};
use judder_numerics::piecewise::tangent::SquareMatrix;
use judder_numerics::piecewise::{
    Advance, GuardCrossing, Leg, MarchError, PiecewiseMarch, PiecewiseSmooth, SectionPlane,
};

/// An oscillator in sliding contact, as a system that changes between stick, slip and lift-off.
///
/// A state holds N/2 displacements and then their velocities; the first displacement is x, along the sliding direction.
pub trait SlidingSystem<const N: usize>: PiecewiseSmooth<N, Mode: Into<ContactState>> + Sync {
    /// The velocity of the substrate, in the units of the state.
    fn belt_velocity(&self) -> f64;

    /// The mode of a contact state at a state: where its equations change within a contact state too, those of the state's place.
    fn mode(&self, contact_state: ContactState, state: &[f64; N]) -> Self::Mode;

    /// What follows where the indenter is in contact and moves with the substrate.
    fn contact_state_at_rest(&self, state: &[f64; N]) -> ContactState;

    /// The state of steady sliding.
    fn steady_sliding(&self) -> [f64; N];

    /// The magnitude of each component of the state that a motion about steady sliding has, for tolerances.
    fn scales(&self) -> [f64; N];

    /// The power that the friction force and the contact's normal force feed into the oscillator, and the power that its
    /// own dampers take out, in a state.
    fn powers(&self, contact_state: ContactState, state: &[f64; N]) -> Powers;

    /// The energy of the oscillator's masses and springs, less the work of the constant load.
    fn energy(&self, state: &[f64; N]) -> f64;

    /// [`PiecewiseMarch::advance`] for a motion of this oscillator.
    ///
    /// All that is built on the engine is generic and compiled where it is called; the time goes into these three, which
    /// each oscillator has compiled with itself.
    ///
    /// # Errors
    /// As that.
    fn advance(
        &self,
        march: &mut PiecewiseMarch<'_, Self, N>,
        until: f64,
    ) -> Result<Advance<Self::Mode, N>, MarchError>
    where
        Self: Sized;

    /// [`tangent::along_leg`](judder_numerics::piecewise::tangent::along_leg) for a motion of this oscillator.
    fn along_leg(&self, leg: &Leg<Self::Mode, N>, disturbance: &SquareMatrix<N>) -> SquareMatrix<N>;

    /// [`Measures::add`] for a motion of this oscillator.
    fn measure(&self, leg: &Leg<Self::Mode, N>, centre: f64, measures: &mut Measures);

    /// Whether the indenter presses on the substrate, or is about to.
    fn is_in_contact(&self, _state: &[f64; N]) -> bool {
        true
    }

    /// v_rel, the velocity of the indenter less that of the substrate, in the units of the state.
    fn relative_velocity(&self, state: &[f64; N]) -> f64 {
        state[N / 2] - self.belt_velocity()
    }

    /// The contact state in which a motion goes on from any state, one on a boundary between states too.
    fn contact_state(&self, state: &[f64; N]) -> ContactState {
        if !self.is_in_contact(state) {
            return ContactState::LiftOff;
        }
        let relative = self.relative_velocity(state);
        if relative < 0.0 {
            ContactState::SlipBehind
        } else if relative > 0.0 {
            ContactState::SlipAhead
        } else {
            self.contact_state_at_rest(state)
        }
    }

    /// The mode in which a motion goes on from any state.
    fn starting_mode(&self, state: &[f64; N]) -> Self::Mode {
        self.mode(self.contact_state(state), state)
    }

    /// The plane ẋ = 0, crossed where x is largest.
    fn section(&self) -> SectionPlane<N> {
        let mut normal = [0.0; N];
        normal[N / 2] = 1.0;
        SectionPlane { normal, offset: 0.0 }
    }
}

/// A crossing as a change of the contact state; `None` where this stays, whatever else changes.
pub(crate) fn contact_change<M: Copy + Into<ContactState>, const N: usize>(
    crossing: &GuardCrossing<M, N>,
) -> Option<GuardCrossing<ContactState, N>> {
    let GuardCrossing { time, from, to, guard, state } = *crossing;
    let (from, to) = (from.into(), to.into());
    (from != to).then_some(GuardCrossing { time, from, to, guard, state })
}
