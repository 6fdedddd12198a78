//! A quantity along one step, as a polynomial of the fraction of the step.

use crate::root::bracketed_root;

/// Coefficients of 1, θ, …, θ⁴ on 0 ≤ θ ≤ 1.
pub type Quartic = [f64; 5];

/// The polynomial at θ.
#[inline]
#[must_use]
pub fn value(c: &Quartic, at: f64) -> f64 {
    c[0] + at * (c[1] + at * (c[2] + at * (c[3] + at * c[4])))
}

/// The quartic with a given value and slope at both ends and a given value in the middle.
#[must_use]
pub fn through(start: f64, start_slope: f64, middle: f64, end: f64, end_slope: f64) -> Quartic {
    let rise = end - start - start_slope;
    let bend = end_slope - start_slope;
    let c4 = 16.0 * (middle - start - 0.5 * start_slope) - 8.0 * rise + 2.0 * bend;
    [start, start_slope, 3.0 * rise - bend + c4, bend - 2.0 * rise - 2.0 * c4, c4]
}

/// The first θ in [0, 1] from which on the polynomial is negative; `None` where it never is.
///
/// A zero at θ = 0 is divided out, as often as it stands there: what starts on zero and rises has not crossed it, and
/// what starts on zero and falls crosses at once. A zero that is touched without a change of sign is none. Coefficients that are not finite, or whose
/// sums are not, are those of no polynomial, which never is negative.
#[must_use]
pub fn first_descent(c: &Quartic) -> Option<f64> {
    let leading_zeros = c.iter().take_while(|c| **c == 0.0).count();
    let mut deflated = [0.0; 5];
    for (to, from) in deflated.iter_mut().zip(c.iter().skip(leading_zeros)) {
        *to = *from;
    }
    if deflated[0] < 0.0 {
        return Some(0.0);
    }
    let b = bernstein(&deflated);
    // halving takes sums of two, and would go on to the narrowest interval everywhere where signs are unknown
    b.iter().all(|b| (2.0 * b).is_finite()).then(|| first_descent_between(&deflated, &b, 0.0, 1.0))?
}

/// The first θ in (0, 1] at which the polynomial passes from positive to negative, whatever its sign at the start.
#[must_use]
pub fn first_fall(c: &Quartic) -> Option<f64> {
    let falls = first_descent(c)?;
    if falls > 0.0 {
        return Some(falls);
    }
    let rises = first_descent(&c.map(|c| -c))?;
    let rest = 1.0 - rises;
    let mut after = after(c, rises, rest);
    after[0] = 0.0;
    first_descent(&after).map(|fraction| rises + fraction * rest)
}

/// The polynomial of the fraction of what is left behind `from`, a part of length `rest`.
fn after(c: &Quartic, from: f64, rest: f64) -> Quartic {
    let mut shifted = *c;
    for level in 0..4 {
        for k in (level..4).rev() {
            shifted[k] += from * shifted[k + 1];
        }
    }
    let mut power = 1.0;
    for c in &mut shifted {
        *c *= power;
        power *= rest;
    }
    shifted
}

/// The coefficients in Bernstein's basis on [0, 1]: the polynomial lies within their range, and changes sign at most as
/// often as they do.
fn bernstein(c: &Quartic) -> Quartic {
    [
        c[0],
        c[0] + 0.25 * c[1],
        c[0] + 0.5 * c[1] + c[2] / 6.0,
        c[0] + 0.75 * c[1] + 0.5 * c[2] + 0.25 * c[3],
        c[0] + c[1] + c[2] + c[3] + c[4],
    ]
}

/// The search on one interval, whose Bernstein coefficients are `b`: halved until one sign change is left.
fn first_descent_between(c: &Quartic, b: &Quartic, from: f64, to: f64) -> Option<f64> {
    /// Intervals below it hold no dip that the step's own error could resolve.
    const NARROWEST: f64 = 1e-12;
    if b.iter().all(|b| *b >= 0.0) {
        return None;
    }
    let falls_once = b[0] >= 0.0 && b[4] < 0.0 && b.windows(2).all(|w| w[0] >= 0.0 || w[1] < 0.0);
    if falls_once || to - from < NARROWEST {
        let at_ends = (value(c, from) >= 0.0, value(c, to) < 0.0);
        return match at_ends {
            (true, true) => Some(bracketed_root(|t| value(c, t), from, to, 0.0).unwrap_or(to)),
            // the ends of the interval differ from its coefficients by rounding alone
            (false, _) if b[0] >= 0.0 && b[4] < 0.0 => Some(from),
            _ if falls_once => Some(to),
            _ => None,
        };
    }
    let (left, right) = halves(b);
    let middle = 0.5 * (from + to);
    first_descent_between(c, &left, from, middle).or_else(|| first_descent_between(c, &right, middle, to))
}

/// De Casteljau's subdivision at the middle.
fn halves(b: &Quartic) -> (Quartic, Quartic) {
    let mut row = *b;
    let (mut left, mut right) = (*b, *b);
    for level in 0..5 {
        left[level] = row[0];
        right[4 - level] = row[4 - level];
        for k in 0..4 - level {
            row[k] = 0.5 * (row[k] + row[k + 1]);
        }
    }
    (left, right)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(roots: [f64; 4]) -> Quartic {
        let mut c = [1.0, 0.0, 0.0, 0.0, 0.0];
        for r in roots {
            let before = c;
            for k in 0..5 {
                c[k] = -r * before[k] + if k > 0 { before[k - 1] } else { 0.0 };
            }
        }
        c
    }

    #[test]
    fn the_first_of_four_roots_is_found_and_only_where_it_falls() {
        // (θ−0.2)(θ−0.21)(θ−0.6)(θ−2) is positive at 0 and falls through 0.2
        let found = first_descent(&product([0.2, 0.21, 0.6, 2.0])).unwrap();
        assert!((found - 0.2).abs() < 1e-12, "{found}");
        // one more root before: starts negative
        assert_eq!(first_descent(&product([0.1, 0.2, 0.3, -1.0])), Some(0.0));
    }

    #[test]
    fn a_dip_of_1e_minus_12_is_seen_and_a_touch_is_none() {
        let dip = |depth: f64| [0.09 - depth, -0.6, 1.0, 0.0, 0.0];
        let found = first_descent(&dip(1e-12)).unwrap();
        assert!((found - (0.3 - 1e-6)).abs() < 1e-8, "{found}");
        assert_eq!(first_descent(&dip(-1e-12)), None);
    }

    #[test]
    fn a_zero_at_the_start_is_no_descent_unless_it_falls() {
        assert_eq!(first_descent(&[0.0, 1.0, 0.0, 0.0, 0.0]), None);
        assert_eq!(first_descent(&[0.0, 0.0, 2.0, 0.0, 0.0]), None);
        assert_eq!(first_descent(&[0.0, 0.0, -2.0, 0.0, 0.0]), Some(0.0));
        assert_eq!(first_descent(&[0.0; 5]), None);
        let later = first_descent(&[0.0, 1.0, -4.0, 0.0, 0.0]).unwrap();
        assert!((later - 0.25).abs() < 1e-15);
    }

    #[test]
    fn what_is_no_polynomial_is_seen_at_once() {
        for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
            for place in 0..5 {
                let mut c = [0.5, -1.0, 0.3, -0.1, 0.2];
                c[place] = bad;
                assert!(first_descent(&c).is_none_or(|at| at == 0.0), "{c:?}");
            }
        }
        // finite coefficients whose sums are not
        let large = f64::MAX;
        let _ = first_descent(&[1.0, -large, large, large, -large]);
        assert_eq!(first_descent(&[large, large, -large, large, large]), None);
    }

    #[test]
    fn a_fall_is_found_behind_a_rise_too() {
        // −(θ−0.2)(θ−0.7)·(…): negative, rises at 0.2, falls at 0.7
        let c = product([0.2, 0.7, -1.0, -2.0]).map(|c| -c);
        assert!((first_fall(&c).unwrap() - 0.7).abs() < 1e-13, "{:?}", first_fall(&c));
        assert_eq!(first_fall(&[-1.0, 0.5, 0.0, 0.0, 0.0]), None);
        assert_eq!(first_fall(&[-1.0, 2.0, 0.0, 0.0, 0.0]), None);
        assert_eq!(first_fall(&[0.0, -1.0, 0.5, 0.0, 0.0]), None);
        assert!((first_fall(&[0.5, -1.0, 0.0, 0.0, 0.0]).unwrap() - 0.5).abs() < 1e-15);
    }

    #[test]
    fn ends_and_middle_determine_it() {
        let c = [0.3, -1.0, 2.5, 0.7, -3.0];
        let slope = |t: f64| c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * 4.0 * c[4]));
        let again = through(value(&c, 0.0), slope(0.0), value(&c, 0.5), value(&c, 1.0), slope(1.0));
        for (a, b) in again.iter().zip(&c) {
            assert!((a - b).abs() < 1e-13, "{again:?}");
        }
    }
}
