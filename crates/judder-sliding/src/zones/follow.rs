//! One unstable eigenvalue followed by itself, beyond where the search over parts has it, to where it turns stable.

use super::branch::EigenvaluePath;
use super::highest::highest;
use super::meeting::alone;
use super::{PairFamily, ZoneEnd};
use crate::spectrum::polished;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::root::bracketed_root;
use num_complex::Complex64;

/// The first step, as a share of the piece.
const FIRST: f64 = 1e-3;
/// The longest step, likewise.
const LONGEST: f64 = 1.0 / 64.0;
/// Where so short a step does not find the branch again, it is lost.
const SHORTEST: f64 = 1e-9;
/// An eigenvalue is the one foretold where it is off by this share of itself at most.
const NEAR: f64 = 1e-3;
/// Where it is off by less than this, the next step is longer.
const EASY: f64 = 1e-4;
/// Roots are located to this share of a piece.
const ROOT: f64 = 1e-12;
/// What has met on the real axis is sought so far beside it, as a share of itself.
const ASIDE: f64 = 0.01;
/// Two branches whose eigenvalues differ by less than this share are one.
const SAME: f64 = 1e-6;

/// From a place where the eigenvalue is unstable, up (`sign` 1) or down (−1) to where it turns stable, the pieces end or it is lost.
///
/// The last point is the end; points are in the order in which they were met.
pub(super) fn onward(
    family: &dyn PairFamily,
    pieces: &[[f64; 2]],
    start: (f64, Complex64),
    sign: f64,
) -> (EigenvaluePath, ZoneEnd) {
    let mut path = vec![start];
    loop {
        let (at, value) = path[path.len() - 1];
        // the piece that goes on from here
        let ahead = |[from, to]: &&[f64; 2]| {
            at >= *from && at <= *to && (if sign > 0.0 { at < *to } else { at > *from })
        };
        if let Some(piece) = pieces.iter().find(ahead) {
            if let Some(end) = through(family, *piece, sign, &mut path) {
                return (path, end);
            }
            continue;
        }
        let near = |[from, to]: &[f64; 2]| if sign > 0.0 { *from } else { *to };
        let beyond = pieces.iter().map(near).filter(|other| sign * other > sign * at);
        let Some(next) = beyond.min_by(|a, b| (sign * a).total_cmp(&(sign * b))) else {
            return (path, ZoneEnd::Range);
        };
        // the pair is not smooth between the pieces: it goes on where it does so unchanged
        match found(family, next, value) {
            Some((value, margin)) if margin > 0.0 => path.push((next, value)),
            _ => return (path, ZoneEnd::Jump),
        }
    }
}

/// To the end of a piece, `None`, or to where the branch ends before.
fn through(
    family: &dyn PairFamily,
    [from, to]: [f64; 2],
    sign: f64,
    path: &mut EigenvaluePath,
) -> Option<ZoneEnd> {
    let width = to - from;
    let border = if sign > 0.0 { to } else { from };
    let mut step = FIRST * width;
    let mut slope = Complex64::ZERO;
    loop {
        let (at, value) = path[path.len() - 1];
        let left = (border - at).abs();
        let next = if step >= left { border } else { at + sign * step };
        let foretold = value + slope * (next - at);
        // a pair that has met on the real axis goes on as two, either of which may be near
        let found = found(family, next, foretold).filter(|(met, _)| (met.im == 0.0) == (value.im == 0.0));
        let Some((met, margin)) = found else {
            step = 0.25 * step.min(left);
            if step < SHORTEST * width {
                return Some(ended(family, next, value));
            }
            continue;
        };
        if margin <= 0.0 {
            return Some(root(family, (at, value), (next, met), path, ROOT * width));
        }
        path.push((next, met));
        if next == border {
            return None;
        }
        slope = (met - value) / (next - at);
        if (met - foretold).modulus() <= EASY * met.modulus() {
            step = (2.0 * step).min(LONGEST * width);
        }
    }
}

/// The end of a branch between a place where it is unstable and one where it is not.
fn root(
    family: &dyn PairFamily,
    unstable: (f64, Complex64),
    stable: (f64, Complex64),
    path: &mut EigenvaluePath,
    tolerance: f64,
) -> ZoneEnd {
    let ((at, value), (next, met)) = (unstable, stable);
    let between = |place: f64| found(family, place, value + (met - value) * ((place - at) / (next - at)));
    let margin = |place: f64| match place {
        _ if place == at => found(family, at, value).map_or(f64::NAN, |found| found.1),
        _ => between(place).map_or(f64::NAN, |found| found.1),
    };
    let located = bracketed_root(margin, at.min(next), at.max(next), tolerance).ok();
    match located.and_then(|root| Some((root, between(root)?.0))) {
        Some(end) => {
            path.push(end);
            ZoneEnd::Root
        }
        None => ZoneEnd::Lost,
    }
}

/// The eigenvalue near one that is foretold, with what decides on its stability.
fn found(family: &dyn PairFamily, at: f64, foretold: Complex64) -> Option<(Complex64, f64)> {
    let function = family.at(at).ok()?;
    let [found] = polished(&function, [foretold])?;
    let is_near = (found - foretold).modulus() <= NEAR * foretold.modulus();
    is_near.then(|| (found, alone(found, function.is_conservative()).value))
}

/// Why a branch is not found again a thousand-millionth of the piece farther on.
///
/// So near, even two eigenvalues that meet are where they are foretold: where the pair is there and the eigenvalue is not, it has jumped.
fn ended(family: &dyn PairFamily, next: f64, value: Complex64) -> ZoneEnd {
    match family.at(next) {
        Ok(_) if is_meeting(family, next, value) => ZoneEnd::Meeting,
        Ok(_) => ZoneEnd::Jump,
        Err(_) => ZoneEnd::Lost,
    }
}

/// Whether beyond a place a real eigenvalue goes on as a conjugate pair, or a pair as two real ones.
fn is_meeting(family: &dyn PairFamily, next: f64, value: Complex64) -> bool {
    let aside = if value.im == 0.0 { ASIDE * value.modulus() } else { 0.0 };
    let Ok(function) = family.at(next) else { return false };
    polished(&function, [Complex64::new(value.re, aside)]).is_some_and(|[other]| {
        (other.im == 0.0) != (value.im == 0.0) && (other - value).modulus() <= 2.0 * ASIDE * value.modulus()
    })
}

/// Whether an eigenvalue at a place is that of a branch there.
pub(super) fn is_on(family: &dyn PairFamily, path: &EigenvaluePath, at: f64, value: Complex64) -> bool {
    on_path(family, path, at).is_some_and(|found| (found - value).modulus() <= SAME * value.modulus())
}

/// The eigenvalue of a branch at a place on its path.
pub(super) fn on_path(family: &dyn PairFamily, path: &[(f64, Complex64)], at: f64) -> Option<Complex64> {
    found(family, at, foretold(path, at)?).map(|(found, _)| found)
}

/// The same as the places beside it have it.
pub(super) fn foretold(path: &[(f64, Complex64)], at: f64) -> Option<Complex64> {
    let next = path.partition_point(|point| point.0 < at);
    let right = path.get(next)?;
    let left = path[next.saturating_sub(1)];
    if left.0 > at {
        return None;
    }
    let share = if right.0 > left.0 { (at - left.0) / (right.0 - left.0) } else { 1.0 };
    Some(left.1 + (right.1 - left.1) * share)
}

/// Where a branch grows fastest, by the eigenvalue itself.
pub(super) fn peak(family: &dyn PairFamily, path: &EigenvaluePath) -> (f64, Complex64) {
    let best = (0..path.len()).fold(0, |best, k| if path[k].1.re > path[best].1.re { k } else { best });
    let (left, right) = (path[best.saturating_sub(1)], path[(best + 1).min(path.len() - 1)]);
    let middle = path[best];
    let itself = |at: f64| {
        let (a, b) = if at < middle.0 { (left, middle) } else { (middle, right) };
        let share = if b.0 > a.0 { (at - a.0) / (b.0 - a.0) } else { 0.0 };
        found(family, at, a.1 + (b.1 - a.1) * share).map(|found| found.0)
    };
    let at = highest(|at| itself(at).map_or(f64::NEG_INFINITY, |value| value.re), [left.0, right.0]);
    itself(at).filter(|value| value.re > middle.1.re).map_or(middle, |value| (at, value))
}
