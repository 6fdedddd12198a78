//! Continuation of a curve along which the stability changes, in the unit square.
//!
//! The next point lies at the distance of one step, so on a circle about the last one: a root in one angle, bracketed by the
//! change of stability between the two sides of the curve. Nothing is differentiated, so a boundary is followed where the
//! margin turns from one limit to the other within a hair, as it does where two Hopf curves run side by side.

use super::{BoundaryEnd, BoundaryFold};
use judder_numerics::root::bracketed_root;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The longest and the shortest step, as shares of the side of the plane.
const LONGEST: f64 = 0.01;
const SHORTEST: f64 = 1e-7;
/// How far to both sides of the last direction the curve is looked for, in rad.
const ASIDE: f64 = 1.2;
/// The turn over one step, in rad, above which the step is halved and below which it grows.
const SHARP: f64 = 0.15;
const GENTLE: f64 = 0.05;
/// More points than this on one curve mean that something is wrong with it.
const MOST_POINTS: usize = 100_000;

/// The stability margin over positions in the unit square: positive on one side of the curve, negative on the other.
pub(super) type BoundaryMargin<'a> = dyn Fn([f64; 2]) -> f64 + 'a;

/// A followed curve.
pub(super) struct FollowedCurve {
    pub(super) positions: Vec<[f64; 2]>,
    pub(super) folds: Vec<(usize, BoundaryFold)>,
    pub(super) end: BoundaryEnd,
}

/// The point at a distance and an angle from another.
fn at(from: [f64; 2], distance: f64, angle: f64) -> [f64; 2] {
    [from[0] + distance * libm::cos(angle), from[1] + distance * libm::sin(angle)]
}

/// The angle at which the curve crosses the circle about `from`, near `direction`.
fn advance(margin: &BoundaryMargin<'_>, from: [f64; 2], step: f64, direction: f64) -> Option<f64> {
    let around = |angle: f64| margin(at(from, step, angle));
    bracketed_root(around, direction - ASIDE, direction + ASIDE, 1e-13).ok()
}

/// The two directions in which the curve leaves a point of it: where a small circle changes stability.
fn directions(margin: &BoundaryMargin<'_>, start: [f64; 2]) -> Option<[f64; 2]> {
    const SECTORS: usize = 24;
    // turned off the axes, along which boundaries like to run
    let angle = |k: usize| 0.1 + TAU * k as f64 / SECTORS as f64;
    let mut radius = 0.1 * LONGEST;
    while radius > SHORTEST {
        let around = |angle: f64| margin(at(start, radius, angle));
        let changes: Vec<f64> =
            (0..SECTORS).filter_map(|k| bracketed_root(around, angle(k), angle(k + 1), 1e-9).ok()).collect();
        if let [a, b] = changes[..] {
            return Some([a, b]);
        }
        radius *= 0.25;
    }
    None
}

/// Follows the curve through `start` both ways.
pub(super) fn follow(margin: &BoundaryMargin<'_>, start: [f64; 2]) -> FollowedCurve {
    let Some([one_way, other_way]) = directions(margin, start) else {
        return FollowedCurve { positions: vec![start], folds: Vec::new(), end: BoundaryEnd::Stalled };
    };
    let (forward, end) = march(margin, start, one_way);
    if end == BoundaryEnd::Closed {
        return assemble(forward, end);
    }
    let (backward, other_end) = march(margin, start, other_way);
    let positions = backward.into_iter().skip(1).rev().chain(forward).collect();
    assemble(positions, if other_end == BoundaryEnd::LeftPlane { end } else { other_end })
}

fn is_inside(position: [f64; 2]) -> bool {
    position.iter().all(|s| (0.0..=1.0).contains(s))
}

/// The smallest turn from one angle to another.
fn turn(from: f64, to: f64) -> f64 {
    (to - from + PI).rem_euclid(TAU) - PI
}

/// Steps along the curve from a point until it leaves the plane, closes, or stalls.
fn march(margin: &BoundaryMargin<'_>, first: [f64; 2], direction: f64) -> (Vec<[f64; 2]>, BoundaryEnd) {
    let mut positions = vec![first];
    let (mut here, mut heading) = (first, direction);
    let mut step = 0.1 * LONGEST;
    while positions.len() < MOST_POINTS {
        if step < SHORTEST {
            return (positions, BoundaryEnd::Stalled);
        }
        let Some(angle) = advance(margin, here, step, heading) else {
            step *= 0.5;
            continue;
        };
        let next = at(here, step, angle);
        if !is_inside(next) {
            positions.extend(border(margin, here, step, heading));
            return (positions, BoundaryEnd::LeftPlane);
        }
        let turned = turn(heading, angle).abs();
        if turned > SHARP {
            step *= 0.5;
            continue;
        }
        if positions.len() > 4 && reaches(here, next, first, direction) {
            positions.push(first);
            return (positions, BoundaryEnd::Closed);
        }
        positions.push(next);
        (here, heading) = (next, angle);
        step = if turned < GENTLE { (1.5 * step).min(LONGEST) } else { step };
    }
    (positions, BoundaryEnd::Stalled)
}

/// Where the curve crosses the border of the plane, within one step.
fn border(margin: &BoundaryMargin<'_>, here: [f64; 2], step: f64, heading: f64) -> Option<[f64; 2]> {
    let (mut inside, mut outside) = (0.0, step);
    let mut found = None;
    for _ in 0..40 {
        let middle = 0.5 * (inside + outside);
        let position = at(here, middle, advance(margin, here, middle, heading)?);
        if is_inside(position) {
            inside = middle;
        } else {
            outside = middle;
        }
        found = Some(position.map(|s| s.clamp(0.0, 1.0)));
    }
    found
}

/// Whether the start lies on the step from `here` to `next`, passed in the direction in which it was left.
fn reaches(here: [f64; 2], next: [f64; 2], start: [f64; 2], direction: f64) -> bool {
    let along = [next[0] - here[0], next[1] - here[1]];
    let to = [start[0] - here[0], start[1] - here[1]];
    let length = libm::hypot(along[0], along[1]);
    let ahead = (to[0] * along[0] + to[1] * along[1]) / length;
    let aside = (to[0] * along[1] - to[1] * along[0]).abs() / length;
    let same_way = turn(libm::atan2(along[1], along[0]), direction).abs() < FRAC_PI_2;
    same_way && ahead >= 0.0 && ahead <= length && aside <= 0.2 * length
}

/// The curve with its folds: the points beyond which a coordinate turns back.
fn assemble(positions: Vec<[f64; 2]>, end: BoundaryEnd) -> FollowedCurve {
    let mut folds: Vec<(usize, BoundaryFold)> = [(0, BoundaryFold::InX), (1, BoundaryFold::InY)]
        .into_iter()
        .flat_map(|(axis, fold)| turning_points(&positions, axis).into_iter().map(move |index| (index, fold)))
        .collect();
    folds.sort_by_key(|(index, _)| *index);
    FollowedCurve { positions, folds, end }
}

/// Indices of the points beyond which a coordinate turns back, by more than rounding can.
fn turning_points(positions: &[[f64; 2]], axis: usize) -> Vec<usize> {
    /// Shorter ways back are rounding on a stretch along the other axis.
    const LEAST: f64 = 1e-6;
    let mut turning = Vec::new();
    let (mut extreme, mut direction) = (0, 0.0);
    for (index, position) in positions.iter().enumerate() {
        let way = position[axis] - positions[extreme][axis];
        if way * direction > 0.0 || (direction == 0.0 && way.abs() > LEAST) {
            (extreme, direction) = (index, way.signum());
        } else if way.abs() > LEAST {
            turning.push(extreme);
            (extreme, direction) = (index, way.signum());
        }
    }
    turning
}
