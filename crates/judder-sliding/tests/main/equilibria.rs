//! States of rest on and about the nodes of a track, where the normal of a straight edge jumps.

use crate::common;
use judder_contact::friction::Friction;
use judder_sliding::coupling::SteadyFriction;
use judder_sliding::edge::{Interpolation, Touch};
use judder_sliding::pair::{Pair, TrackBody};
use judder_sliding::plane::PlaneVector;
use judder_sliding::statics::PairEquilibrium;
use proptest::prelude::*;
use std::sync::LazyLock;

/// What may be left, as a share of the track's length.
const TOLERANCE: f64 = 1e-14;
/// The paper's track and one of every tenth of its nodes, straight between nodes and curved.
static PAIRS: LazyLock<Vec<Pair>> = LazyLock::new(|| {
    let kinds = [Interpolation::Linear, Interpolation::Hermite];
    kinds.into_iter().flat_map(|interpolation| [1, 10].map(|every| pair(interpolation, every))).collect()
});

fn pair(interpolation: Interpolation, every: usize) -> Pair {
    let whole = common::pair_with(interpolation, Friction::Constant(common::FRICTION), 20);
    let nodes = whole.track().nodes.iter().step_by(every).cloned().collect();
    let track = TrackBody { body: whole.track().body.clone(), nodes };
    let friction = whole.friction().clone();
    Pair::new(whole.slider().clone(), track, interpolation, true, friction, Vec::new()).unwrap()
}

/// C and the nodes of a segment where a state has moved them.
fn places(pair: &Pair, position: f64, state: &[f64], segment: usize) -> (PlaneVector, [PlaneVector; 2]) {
    let (of_slider, of_track) = state.split_at(pair.slider().body.modes());
    let sum = |a: PlaneVector, b: PlaneVector| [a[0] + b[0], a[1] + b[1]];
    let node = |k: usize| {
        let node = &pair.track().nodes[k];
        sum(node.place, node.displacement(of_track))
    };
    let point = sum(pair.rigid_place(position), pair.slider().contact.displacement(of_slider));
    (point, [node(segment), node(segment + 1)])
}

/// By how much a state is off rest, as a share of the track's length: C from the place that it touches, and the normal from the edge's
/// own there, or from the cone of a corner.
fn residual(pair: &Pair, position: f64, rest: &PairEquilibrium) -> f64 {
    let Touch { at, tangent, weights, stretch, .. } = rest.touch;
    let (point, [first, second]) = places(pair, position, &rest.state, at.segment);
    let angle = |[x, y]: PlaneVector| y.atan2(x);
    let of_chord = |a: PlaneVector, b: PlaneVector| angle([b[0] - a[0], b[1] - a[1]]);
    if pair.edge().interpolation == Interpolation::Hermite {
        let found = pair.deformed(position, &rest.state).unwrap();
        let along = (found.at.segment as f64 + found.at.fraction) - (at.segment as f64 + at.fraction);
        return (along.abs() * stretch + found.gap.abs()) / pair.length();
    }
    let share = weights.value[1];
    let touched = [0, 1].map(|k| first[k] + share * (second[k] - first[k]));
    let away = (point[0] - touched[0]).hypot(point[1] - touched[1]);
    let own = of_chord(first, second);
    let turned = if at.fraction == 1.0 && at.segment + 2 < pair.track().nodes.len() {
        let (_, [node, next]) = places(pair, position, &rest.state, at.segment + 1);
        let next = of_chord(node, next);
        let (low, high) = (own.min(next), own.max(next));
        (low - angle(tangent)).max(angle(tangent) - high).max(0.0)
    } else {
        (angle(tangent) - own).abs()
    };
    (away + turned * stretch) / pair.length()
}

/// Where C must be, undeformed, for its deformed contact to lie at a node, to a rounding or a hair beside it.
fn meeting(pair: &Pair, node: f64, load: f64, sliding: SteadyFriction) -> f64 {
    let arc = pair.node_positions();
    (0..6).fold(node, |position, _| {
        let at = PairEquilibrium::new(pair, position, load, sliding).unwrap().touch.at;
        position + node - (arc[at.segment] + at.fraction * (arc[at.segment + 1] - arc[at.segment]))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    /// C lies where it touches, the gap is closed, and the normal is the edge's own or within the corner's cone: to 1e-14 of the track's
    /// length, on nodes and a hair beside them, whichever way it slides.
    #[test]
    fn the_contact_rests_where_it_touches(
        of in 0..4_usize,
        place in 0.02..0.98_f64,
        beside in prop::sample::select(vec![None, Some(0.0), Some(1e-12), Some(-1e-12), Some(1e-10), Some(-1e-10)]),
        deformed in any::<bool>(),
        backwards in any::<bool>(),
        friction in prop::sample::select(vec![0.0, 0.3, 1.0]),
        load in prop::sample::select(vec![0.02, 0.2, 2.0]),
    ) {
        let pair = &PAIRS[of];
        let sliding = SteadyFriction { friction, slope: 0.0, direction: if backwards { -1.0 } else { 1.0 } };
        let nodes = pair.node_positions();
        let last = nodes.len() - 1;
        let node = nodes[((place * last as f64) as usize).clamp(1, last - 1)];
        let position = match beside {
            None => place * pair.length(),
            Some(aside) if deformed => meeting(pair, node, -load, sliding) + aside,
            Some(aside) => node + aside,
        };
        let rest = PairEquilibrium::new(pair, position, -load, sliding).unwrap();
        let left = residual(pair, position, &rest);
        prop_assert!(left <= 2.0 * TOLERANCE, "{position} {:?}: {left:e}", rest.touch);
    }
}
