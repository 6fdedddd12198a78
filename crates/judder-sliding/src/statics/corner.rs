//! The state of rest about a node at which the normal of the edge jumps.
//!
//! Each of the two segments, continued beyond the node, has a state of rest of its own. If neither lies on its segment, the contact rests
//! on the node: the normal is then unknown between those of both, and C must be at the node, along the edge as across it.

use super::{ITERATIONS, Loaded, PairEquilibrium, place_change};
use crate::SlidingError;
use crate::edge::{EdgePoint, Touch};
use crate::plane::{PlaneVector, dot, minus, plus, turned};

/// The equilibrium about the node that a segment ends with.
pub(super) fn about(loaded: &Loaded<'_>, segment: usize) -> Result<PairEquilibrium, SlidingError> {
    let left = on_segment(loaded, EdgePoint { segment, fraction: 1.0 })?;
    if left.touch.at.fraction <= 1.0 {
        return Ok(left);
    }
    let right = on_segment(loaded, EdgePoint { segment: segment + 1, fraction: 0.0 })?;
    if right.touch.at.fraction >= 0.0 {
        return Ok(right);
    }
    on_node(
        loaded,
        segment,
        [left, right].map(|rest| libm::atan2(rest.touch.tangent[1], rest.touch.tangent[0])),
    )
}

/// The equilibrium on a segment that goes on straight beyond its ends.
fn on_segment(loaded: &Loaded<'_>, from: EdgePoint) -> Result<PairEquilibrium, SlidingError> {
    let pair = loaded.pair;
    let undeformed = pair.stencil(from.segment, |_| [0.0; 2]);
    let mut touch = pair.edge().touch_at(pair.rigid_place(loaded.position), from, &undeformed);
    let mut moved = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let (state, normal_force) = loaded.at(&touch)?;
        let (point, places) = displaced(loaded, from.segment, &state);
        let at = EdgePoint { fraction: pair.edge().nearest(point, touch.at, &places), ..from };
        let next = pair.edge().touch_at(point, at, &places);
        moved = place_change(&touch, &next);
        touch = next;
        if moved <= loaded.tolerance() {
            return Ok(PairEquilibrium { state, normal_force, touch });
        }
    }
    Err(SlidingError::NoConvergence { position: loaded.position, iterations: ITERATIONS, residual: moved })
}

/// The equilibrium on the node that a segment ends with, the angle of its tangent between those given: by false position (Illinois).
fn on_node(
    loaded: &Loaded<'_>,
    segment: usize,
    [mut low, mut high]: [f64; 2],
) -> Result<PairEquilibrium, SlidingError> {
    let (_, mut at_low) = turned_to(loaded, segment, low)?;
    let (_, mut at_high) = turned_to(loaded, segment, high)?;
    let mut residual = at_low.abs().min(at_high.abs());
    let mut last_side = 0.0;
    for _ in 0..ITERATIONS {
        let angle = if at_low == at_high { low } else { low - at_low * (high - low) / (at_high - at_low) };
        let (rest, away) = turned_to(loaded, segment, angle)?;
        residual = away.abs();
        if residual <= loaded.tolerance() {
            return Ok(rest);
        }
        let side = away.signum();
        // an end that stays twice counts half
        if side == at_low.signum() {
            (low, at_low) = (angle, away);
            at_high *= if side == last_side { 0.5 } else { 1.0 };
        } else {
            (high, at_high) = (angle, away);
            at_low *= if side == last_side { 0.5 } else { 1.0 };
        }
        last_side = side;
    }
    Err(SlidingError::NoConvergence { position: loaded.position, iterations: ITERATIONS, residual })
}

/// The state with the contact on the node that a segment ends with and the tangent at this angle, and how far C then lies from the node
/// along it, m.
fn turned_to(
    loaded: &Loaded<'_>,
    segment: usize,
    angle: f64,
) -> Result<(PairEquilibrium, f64), SlidingError> {
    let edge = loaded.pair.edge();
    let tangent = [libm::cos(angle), libm::sin(angle)];
    let normal = turned(tangent).map(|along| edge.side * along);
    let at = EdgePoint { segment, fraction: 1.0 };
    let (point, places) = displaced(loaded, segment, &vec![0.0; loaded.pair.modes()]);
    let touch = Touch { tangent, normal, ..edge.touch_at(point, at, &places) };
    let (state, normal_force) = loaded.at(&touch)?;
    let (point, places) = displaced(loaded, segment, &state);
    let away = minus(point, places[1]);
    let touch = Touch { tangent, normal, gap: dot(normal, away), ..edge.touch_at(point, at, &places) };
    Ok((PairEquilibrium { state, normal_force, touch }, dot(tangent, away)))
}

/// Where a state puts C and the nodes of a segment.
fn displaced(
    loaded: &Loaded<'_>,
    segment: usize,
    state: &[f64],
) -> (PlaneVector, [PlaneVector; crate::edge::STENCIL]) {
    let pair = loaded.pair;
    let (of_slider, of_track) = state.split_at(pair.slider().body.modes());
    let point = plus(pair.rigid_place(loaded.position), 1.0, pair.slider().contact.displacement(of_slider));
    (point, pair.stencil(segment, |node| pair.track().nodes[node].displacement(of_track)))
}
