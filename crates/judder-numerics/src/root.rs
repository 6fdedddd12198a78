//! Roots of scalar functions: one in a bracket, or all of them over an interval.

use crate::order::sort_numbers;
use thiserror::Error;

/// Why no root came out.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum RootError {
    /// The function has the same sign at both ends.
    #[error("no sign change between {lower} (value {at_lower}) and {upper} (value {at_upper})")]
    NotBracketed {
        /// Lower end of the interval.
        lower: f64,
        /// Upper end of the interval.
        upper: f64,
        /// Function value at the lower end.
        at_lower: f64,
        /// Function value at the upper end.
        at_upper: f64,
    },
    /// The function gave NaN or an infinity.
    #[error("the function is not finite at {at}")]
    NotFinite {
        /// Where it happened.
        at: f64,
    },
}

/// The root of a continuous `function` in `[lower, upper]`, whose ends have opposite signs, to the last bits.
///
/// Interpolation is tried, and truncated towards the midpoint so that the bracket halves as surely as in bisection
/// (the ITP method: Oliveira and Takahashi, ACM Trans. Math. Softw. 47, 2020). Stops when the bracket is two units in
/// the last place wide, or `tolerance` (absolute) if that is wider.
///
/// # Errors
/// [`RootError::NotBracketed`] if the ends agree in sign, [`RootError::NotFinite`] where the function fails.
pub fn bracketed_root(
    mut function: impl FnMut(f64) -> f64,
    lower: f64,
    upper: f64,
    tolerance: f64,
) -> Result<f64, RootError> {
    let mut evaluate = |at: f64| {
        let value = function(at);
        if value.is_finite() { Ok(value) } else { Err(RootError::NotFinite { at }) }
    };
    let (mut a, mut b) = (lower, upper);
    let (mut at_a, mut at_b) = (evaluate(a)?, evaluate(b)?);
    if at_a == 0.0 {
        return Ok(a);
    }
    if at_b == 0.0 {
        return Ok(b);
    }
    if (at_a > 0.0) == (at_b > 0.0) {
        return Err(RootError::NotBracketed { lower, upper, at_lower: at_a, at_upper: at_b });
    }
    let width = b - a;
    let floor = |a: f64, b: f64| tolerance.max(2.0 * f64::EPSILON * a.abs().max(b.abs()));
    // the projection radius allows one step more than bisection would need
    let mut radius = width;
    while b - a > floor(a, b) {
        let middle = 0.5 * (a + b);
        let secant = (at_b * a - at_a * b) / (at_b - at_a);
        let towards_middle = (middle - secant).signum();
        let truncation = 0.2 / width * (b - a) * (b - a);
        let truncated =
            if truncation <= (middle - secant).abs() { secant + towards_middle * truncation } else { middle };
        let allowed = (radius - 0.5 * (b - a)).max(0.0);
        let guess =
            if (truncated - middle).abs() <= allowed { truncated } else { middle - towards_middle * allowed };
        let guess = if guess > a && guess < b { guess } else { middle };
        if !(guess > a && guess < b) {
            break;
        }
        let value = evaluate(guess)?;
        if value == 0.0 {
            return Ok(guess);
        }
        if (value > 0.0) == (at_b > 0.0) {
            (b, at_b) = (guess, value);
        } else {
            (a, at_a) = (guess, value);
        }
        radius *= 0.5;
    }
    Ok(if at_a.abs() < at_b.abs() { a } else { b })
}

/// All roots that a search over samples can see, with what it could not see.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RootSearch {
    /// Roots, ascending.
    pub roots: Vec<f64>,
    /// Samples at which the function had no finite value; roots next to them may be missing.
    pub failures: Vec<f64>,
}

/// All roots of `function` between the first and the last of the ascending `samples`.
///
/// Finds every sign change between neighbouring samples, and pairs of roots that lie between samples wherever the
/// magnitude dips without a sign change (the dip is minimised by golden section). Two roots nearer than the dip search
/// resolves (a thousandth of a sample interval) may be missed; so may a pair whose dip no sample shows.
pub fn all_roots(mut function: impl FnMut(f64) -> f64, samples: &[f64]) -> RootSearch {
    let values: Vec<f64> = samples.iter().map(|&s| function(s)).collect();
    all_roots_from_values(function, samples, &values)
}

/// [`all_roots`] with the values at the samples known already (`values[k]` belongs to `samples[k]`).
pub fn all_roots_from_values(
    mut function: impl FnMut(f64) -> f64,
    samples: &[f64],
    values: &[f64],
) -> RootSearch {
    let mut search = RootSearch::default();
    search.failures.extend(samples.iter().zip(values).filter(|(_, v)| !v.is_finite()).map(|(s, _)| *s));
    let refine = |function: &mut dyn FnMut(f64) -> f64, a: f64, b: f64, roots: &mut Vec<f64>| {
        // the ends were seen to differ in sign; a failure inside leaves the interval without a root
        if let Ok(root) = bracketed_root(function, a, b, 0.0) {
            roots.push(root);
        }
    };
    for k in 0..samples.len() {
        if values[k] == 0.0 {
            search.roots.push(samples[k]);
        }
        if k + 1 < samples.len() && values[k] * values[k + 1] < 0.0 {
            refine(&mut function, samples[k], samples[k + 1], &mut search.roots);
        }
        if k >= 1 && k + 1 < samples.len() && dips(values[k - 1], values[k], values[k + 1]) {
            let sign = values[k].signum();
            if let Some(crossing) = crossing_in_dip(&mut function, samples[k - 1], samples[k + 1], sign) {
                refine(&mut function, samples[k - 1], crossing, &mut search.roots);
                refine(&mut function, crossing, samples[k + 1], &mut search.roots);
            }
        }
    }
    sort_numbers(&mut search.roots);
    search.roots.dedup();
    search
}

/// Whether three values of one sign may hide two roots: the middle one is the nearest to zero, and either far below its
/// neighbours or above the vertex of the parabola through all three.
fn dips(left: f64, middle: f64, right: f64) -> bool {
    let one_sign = left * middle > 0.0 && right * middle > 0.0;
    let [left, middle, right] = [left, middle, right].map(f64::abs);
    let slope = 0.5 * (right - left);
    let curvature = right - 2.0 * middle + left;
    let vertex = middle - 0.5 * slope * slope / curvature;
    let lowest = middle < left && middle < right;
    one_sign && lowest && (middle < 0.5 * left.min(right) || vertex < 0.5 * middle)
}

/// A point of `[a, b]` where `sign · function` is negative, if its minimum there is (golden section).
fn crossing_in_dip(function: &mut impl FnMut(f64) -> f64, a: f64, b: f64, sign: f64) -> Option<f64> {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let (mut a, mut b) = (a, b);
    let (mut left, mut right) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut at_left, mut at_right) = (sign * function(left), sign * function(right));
    for _ in 0..16 {
        if at_left < 0.0 {
            return Some(left);
        }
        if at_right < 0.0 {
            return Some(right);
        }
        if at_left < at_right {
            (b, right, at_right) = (right, left, at_left);
            left = b - GOLDEN * (b - a);
            at_left = sign * function(left);
        } else {
            (a, left, at_left) = (left, right, at_right);
            right = a + GOLDEN * (b - a);
            at_right = sign * function(right);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn grid(from: f64, to: f64, points: usize) -> Vec<f64> {
        (0..points).map(|k| from + (to - from) * k as f64 / (points - 1) as f64).collect()
    }

    #[test]
    fn a_root_to_the_last_bits_in_few_evaluations() {
        let mut calls = 0;
        let root = bracketed_root(
            |x| {
                calls += 1;
                x * x - 2.0
            },
            0.0,
            2.0,
            0.0,
        )
        .unwrap();
        assert!((root - std::f64::consts::SQRT_2).abs() <= 4.0 * f64::EPSILON, "{root}");
        assert!(calls < 60, "{calls} evaluations");
    }

    #[test]
    fn no_sign_change_is_said_with_the_values() {
        let error = bracketed_root(|x| x + 3.0, 0.0, 1.0, 0.0).unwrap_err();
        assert_eq!(error, RootError::NotBracketed { lower: 0.0, upper: 1.0, at_lower: 3.0, at_upper: 4.0 });
    }

    #[test]
    fn a_pair_between_two_samples_is_found() {
        let search = all_roots(|x| (x - 0.501) * (x - 0.502), &grid(0.0, 1.0, 11));
        assert_eq!(search.roots.len(), 2);
        assert!((search.roots[0] - 0.501).abs() < 1e-12 && (search.roots[1] - 0.502).abs() < 1e-12);
    }

    #[test]
    fn failures_are_reported() {
        let search = all_roots(|x| if x < 0.35 { f64::NAN } else { x - 0.5 }, &grid(0.0, 1.0, 10));
        assert_eq!(search.failures.len(), 4);
        assert_eq!(search.roots.len(), 1);
    }

    proptest! {
        #[test]
        fn every_root_of_a_cubic_is_found(mut roots in prop::array::uniform3(-0.99..0.99_f64)) {
            roots.sort_by(f64::total_cmp);
            prop_assume!(roots[1] - roots[0] > 1e-3 && roots[2] - roots[1] > 1e-3);
            let found = all_roots(|x| (x - roots[0]) * (x - roots[1]) * (x - roots[2]), &grid(-1.0, 1.0, 401)).roots;
            prop_assert_eq!(found.len(), 3);
            for (f, r) in found.iter().zip(roots) {
                prop_assert!((f - r).abs() < 1e-9);
            }
        }
    }
}
