//! Pseudo-arclength continuation of a zero set in the unit square.

use super::field::{Field, Local};
use super::{End, Fold};

/// The longest and the shortest step, as shares of the side of the plane.
const LONGEST: f64 = 0.01;
const SHORTEST: f64 = 1e-7;
/// The turn of the tangent over one step, in rad, above which the step is halved and below which it grows.
const SHARP: f64 = 0.15;
const GENTLE: f64 = 0.05;
/// More points than this on one curve mean that something is wrong with it.
const MOST_POINTS: usize = 100_000;

/// A followed curve.
pub(super) struct Curve {
    pub(super) positions: Vec<[f64; 2]>,
    pub(super) ln_indentations: Vec<f64>,
    pub(super) folds: Vec<(usize, Fold)>,
    pub(super) end: End,
}

/// A point of the curve with its unit tangent.
#[derive(Clone, Copy)]
struct Station {
    position: [f64; 2],
    tangent: [f64; 2],
    ln_indentation: f64,
}

/// The unit tangent of the zero set, pointing along `direction`.
fn tangent(local: &Local, direction: [f64; 2]) -> [f64; 2] {
    let [a, b] = local.gradient;
    let length = a.hypot(b);
    let sign = if -b * direction[0] + a * direction[1] < 0.0 { -1.0 } else { 1.0 };
    [-sign * b / length, sign * a / length]
}

/// The point of the zero set on the line across `predicted` that is perpendicular to `along`.
fn correct(field: &Field<'_>, predicted: [f64; 2], along: [f64; 2], guess: f64) -> Option<Station> {
    const LIMIT: usize = 12;
    let (mut position, mut guess) = (predicted, guess);
    for _ in 0..LIMIT {
        let local = field.local(position, guess)?;
        guess = local.ln_indentation;
        // across = the direction perpendicular to `along`, so the arclength constraint holds by construction
        let across = [-along[1], along[0]];
        let slope = local.gradient[0] * across[0] + local.gradient[1] * across[1];
        let step = (-local.value / slope).clamp(-LONGEST, LONGEST);
        if !step.is_finite() {
            return None;
        }
        position = [position[0] + step * across[0], position[1] + step * across[1]];
        if step.abs() <= 1e-12 {
            return Some(Station { position, tangent: tangent(&local, along), ln_indentation: guess });
        }
    }
    None
}

fn is_inside(position: [f64; 2]) -> bool {
    position.iter().all(|s| (0.0..=1.0).contains(s))
}

/// One step of length `step` from a station.
fn advance(field: &Field<'_>, from: &Station, step: f64) -> Option<Station> {
    let predicted = [from.position[0] + step * from.tangent[0], from.position[1] + step * from.tangent[1]];
    correct(field, predicted, from.tangent, from.ln_indentation)
}

/// The step length at which a function of the station that follows changes sign, by bisection.
fn step_to(field: &Field<'_>, from: &Station, step: f64, sign: impl Fn(&Station) -> bool) -> Option<Station> {
    let (mut low, mut high) = (0.0, step);
    let mut found = None;
    for _ in 0..36 {
        let middle = 0.5 * (low + high);
        let station = advance(field, from, middle)?;
        if sign(&station) {
            high = middle;
        } else {
            low = middle;
        }
        found = Some(station);
    }
    found
}

/// Follows the curve through `start` both ways.
pub(super) fn follow(field: &Field<'_>, start: [f64; 2]) -> Curve {
    let stalled = |positions| Curve {
        positions,
        ln_indentations: vec![f64::NAN],
        folds: Vec::new(),
        end: End::Stalled,
    };
    let Some(local) = field.local(start, f64::NAN) else { return stalled(vec![start]) };
    let first = Station {
        position: start,
        tangent: tangent(&local, [1.0, 0.0]),
        ln_indentation: local.ln_indentation,
    };
    let (forward, end) = march(field, first);
    if end == End::Closed {
        return assemble(forward, end);
    }
    let reversed = Station { tangent: first.tangent.map(|t| -t), ..first };
    let (backward, other_end) = march(field, reversed);
    let turned = backward.into_iter().skip(1).rev().map(|s| Station { tangent: s.tangent.map(|t| -t), ..s });
    let stations: Vec<Station> = turned.chain(forward).collect();
    assemble(stations, if other_end == End::LeftPlane { end } else { other_end })
}

/// Steps along the curve from a station until it leaves the plane, closes, or stalls.
fn march(field: &Field<'_>, first: Station) -> (Vec<Station>, End) {
    let mut stations = vec![first];
    let mut here = first;
    let mut step = 0.1 * LONGEST;
    while stations.len() < MOST_POINTS {
        if step < SHORTEST {
            return (stations, End::Stalled);
        }
        let Some(next) = advance(field, &here, step) else {
            step *= 0.5;
            continue;
        };
        let turn = (here.tangent[0] * next.tangent[1] - here.tangent[1] * next.tangent[0]).abs();
        let forward = here.tangent[0] * next.tangent[0] + here.tangent[1] * next.tangent[1];
        if forward < 0.0 || turn > SHARP {
            step *= 0.5;
            continue;
        }
        if !is_inside(next.position) {
            stations.extend(step_to(field, &here, step, |s| !is_inside(s.position)).map(clamped));
            return (stations, End::LeftPlane);
        }
        if stations.len() > 4 && reaches(&here, &next, &first) {
            stations.push(first);
            return (stations, End::Closed);
        }
        for axis in [0, 1] {
            if here.tangent[axis] * next.tangent[axis] < 0.0 {
                let turned = |s: &Station| s.tangent[axis] * here.tangent[axis] < 0.0;
                stations.extend(step_to(field, &here, step, turned));
            }
        }
        stations.push(next);
        here = next;
        step = if turn < GENTLE { (1.5 * step).min(LONGEST) } else { step };
    }
    (stations, End::Stalled)
}

/// On the border to the last digit.
fn clamped(station: Station) -> Station {
    Station { position: station.position.map(|s| s.clamp(0.0, 1.0)), ..station }
}

/// Whether the start lies on the step from `here` to `next`, passed in the same direction.
fn reaches(here: &Station, next: &Station, start: &Station) -> bool {
    let along = [next.position[0] - here.position[0], next.position[1] - here.position[1]];
    let to = [start.position[0] - here.position[0], start.position[1] - here.position[1]];
    let length = along[0].hypot(along[1]);
    let ahead = (to[0] * along[0] + to[1] * along[1]) / length;
    let aside = (to[0] * along[1] - to[1] * along[0]).abs() / length;
    let same_way = start.tangent[0] * along[0] + start.tangent[1] * along[1] > 0.0;
    same_way && ahead >= 0.0 && ahead <= length && aside <= 0.2 * length
}

/// The curve with its folds: where a component of the tangent changes sign.
fn assemble(stations: Vec<Station>, end: End) -> Curve {
    let mut folds = Vec::new();
    for (k, pair) in stations.windows(2).enumerate() {
        for (axis, fold) in [(0, Fold::InX), (1, Fold::InY)] {
            if pair[0].tangent[axis] * pair[1].tangent[axis] < 0.0 {
                // the located fold is the one of the two whose tangent component is nearer to zero
                let nearer = usize::from(pair[1].tangent[axis].abs() < pair[0].tangent[axis].abs());
                folds.push((k + nearer, fold));
            }
        }
    }
    Curve {
        positions: stations.iter().map(|s| s.position).collect(),
        ln_indentations: stations.iter().map(|s| s.ln_indentation).collect(),
        folds,
        end,
    }
}
