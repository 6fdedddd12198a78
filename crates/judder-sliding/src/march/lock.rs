//! Where a slider locks, and why.

use super::compliance::{ModalCompliance, in_frame};
use super::reaction::Locked;
use crate::SlidingError;
use crate::coupling::{Coupling, SteadyFriction};
use crate::edge::{EdgePoint, Touch};
use crate::pair::Pair;

/// Where forces that change their sign from step to step do not die out on a path, if anywhere: with these factors of all modes,
/// n·G(n ∓ μ t) must be positive.
pub(super) fn first_lock(
    pair: &Pair,
    [start, end]: [f64; 2],
    friction: f64,
    factors: &[f64],
) -> Option<SliderLock> {
    let compliance = ModalCompliance::new(pair, factors);
    let place = |position: f64| pair.edge_point(position).map_or(0, |at| at.segment);
    let (from, to) = (start.min(end), start.max(end));
    let places = (place(from)..=place(to))
        .flat_map(|segment| [0.0, 0.5, 1.0].map(|fraction| EdgePoint { segment, fraction }));
    let mut locks = places.filter_map(|at| {
        let (first, count) = (pair.edge().first_node(at.segment), pair.edge().stencil_nodes());
        let stencil = compliance.stencil(first, count);
        let touch = pair.edge().touch_at([0.0; 2], at, &pair.stencil(at.segment, |_| [0.0; 2]));
        let between = compliance.between(&stencil, &touch.weights.value);
        let [nn, nt, ..] = in_frame(&between, &touch);
        let opened = nn - friction * nt.abs();
        let ends = &pair.node_positions()[at.segment..at.segment + 2];
        let position = ends[0] + at.fraction * (ends[1] - ends[0]);
        let locked = Locked { compliance: opened, direction: nt.signum() };
        // a number that is none locks as well
        if opened > 0.0 { None } else { Some(SliderLock { touch, position, friction, locked }) }
    });
    locks.next()
}

/// A place where the slider locks.
pub(super) struct SliderLock {
    pub(super) touch: Touch,
    pub(super) position: f64,
    pub(super) friction: f64,
    pub(super) locked: Locked,
}

impl SliderLock {
    /// Why: because of c·M⁻¹e, or only because of the modes that yield at once.
    #[cold]
    pub(super) fn error(&self, pair: &Pair) -> SlidingError {
        let Self { ref touch, position, friction, locked: Locked { compliance, direction } } = *self;
        let coupling = Coupling::new(pair, touch, SteadyFriction { friction, slope: 0.0, direction });
        match coupling.check(position, friction) {
            Err(sprag_slip) => sprag_slip,
            Ok(()) => SlidingError::LocksAtOnce { position, compliance, friction },
        }
    }
}
