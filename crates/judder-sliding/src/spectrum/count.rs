//! How many zeros are missing: the turns of what is left of D along the border of a region.

use super::simultaneous::Regular;
use judder_numerics::complex::ElementaryComplex;
use num_complex::Complex64;
use std::f64::consts::PI;

/// The border turns by no more than this between neighbouring points, rad.
const TURN: f64 = 1.2;
/// How far the turn may be from what the slopes at both ends foretell, rad.
const AGREEMENT: f64 = 0.4;
/// How often a piece of the border is halved at most: a zero so near to the border is on it.
const HALVINGS: usize = 40;
/// The corners of the upper half of the border, by shares of the limit; denser where it crosses the imaginary axis.
const BORDER: [[f64; 2]; 12] = [
    [1.0, 0.0],
    [1.0, 0.5],
    [1.0, 1.0],
    [0.4, 1.0],
    [0.15, 1.0],
    [0.04, 1.0],
    [-0.04, 1.0],
    [-0.15, 1.0],
    [-0.4, 1.0],
    [-1.0, 1.0],
    [-1.0, 0.5],
    [-1.0, 0.0],
];

/// Zeros of D in |Re s| ≤ limit, |Im s| ≤ limit that are not among those known, less those known that are none.
///
/// By the argument principle; D is real on the real axis, so the upper half of the border makes half of the turns. `None` where a zero
/// stands on the border.
pub(super) fn missing(regular: &mut Regular<'_>, known: &[Complex64], limit: f64) -> Option<i64> {
    let mut at = |s: Complex64| {
        let (value, slope) = regular.divided(s, known);
        (value.is_finite() && slope.is_finite() && value != Complex64::ZERO).then_some(CountPoint {
            s,
            value,
            slope,
        })
    };
    let corner = |[re, im]: [f64; 2]| Complex64::new(re * limit, im * limit);
    let mut left = at(corner(BORDER[0]))?;
    let mut turns = 0.0;
    for end in &BORDER[1..] {
        let right = at(corner(*end))?;
        turns += turn(&mut at, (left, right), 0)?;
        left = right;
    }
    Some((turns / PI).round() as i64)
}

#[derive(Clone, Copy)]
struct CountPoint {
    s: Complex64,
    value: Complex64,
    /// Logarithmic.
    slope: Complex64,
}

/// The change of the argument between two points, halved until both ends foretell it.
fn turn(
    at: &mut impl FnMut(Complex64) -> Option<CountPoint>,
    (left, right): (CountPoint, CountPoint),
    depth: usize,
) -> Option<f64> {
    let found = (right.value * left.value.conj()).argument();
    let step = right.s - left.s;
    let foretold = [(left.slope * step).im, (right.slope * step).im];
    let mean = 0.5 * (foretold[0] + foretold[1]);
    let agrees = |turn: f64| (found - turn).abs() <= AGREEMENT;
    if found.abs() <= TURN && agrees(mean) && foretold.into_iter().all(|turn| turn.abs() <= 2.0 * TURN) {
        return Some(found);
    }
    if depth == HALVINGS {
        return None;
    }
    let middle = at(0.5 * (left.s + right.s))?;
    Some(turn(at, (left, middle), depth + 1)? + turn(at, (middle, right), depth + 1)?)
}
