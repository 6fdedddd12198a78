//! A cubic spline that goes over into its asymptotes without a jump in value, slope or curvature.
//!
//! Outside the knots the function follows a tail; the tail's curvature at the edge, which value and slope fix, is the end
//! condition of the spline. So the whole is C² on the real line, and linear in its data.

use crate::law::knots::Knots;

/// How a function continues beyond the last knot of an axis; ξ is the signed distance from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Tail {
    /// limit + γ e^{rate ξ/2} + e^{rate ξ} (α + β ξ), to a known limit: a power of the speed times its logarithm, and half that
    /// power where its factor is known.
    ToLimit {
        /// The power: positive below the first knot, negative above the last.
        rate: f64,
        /// The known limit.
        limit: f64,
        /// γ.
        half: f64,
    },
    /// edge + slope (e^{rate ξ} − 1)/rate, to a limit that value and slope at the edge decide.
    Relaxing {
        /// As above.
        rate: f64,
    },
    /// limit + e^{−ξ} (α + β ξ), above the last knot only, to a limit that value, slope and curvature at the edge decide; the
    /// last two intervals are one cubic ("not a knot").
    Levelling,
}

impl Tail {
    /// Curvature at the edge = `of_slope` · slope + `of_value` · value + `constant`.
    fn curvature(self) -> (f64, f64, f64) {
        match self {
            Self::ToLimit { rate, limit, half } => {
                (2.0 * rate, -rate * rate, rate * rate * (limit + 0.25 * half))
            }
            Self::Relaxing { rate } => (rate, 0.0, 0.0),
            Self::Levelling => (0.0, 0.0, 0.0),
        }
    }

    /// The coefficients of the tail's piece from value, slope and curvature at the edge.
    fn piece(self, value: f64, slope: f64, curvature: f64) -> [f64; 4] {
        match self {
            Self::ToLimit { rate, limit, half } => {
                let alpha = value - limit - half;
                [limit, alpha, slope - rate * (alpha + 0.5 * half), half]
            }
            Self::Relaxing { rate } => [value - slope / rate, slope / rate, 0.0, 0.0],
            Self::Levelling => {
                let alpha = -2.0 * slope - curvature;
                [value - alpha, alpha, -slope - curvature, 0.0]
            }
        }
    }
}

/// The pieces of the spline through `values` (one a knot), tails included, in the form of [`Knots::place`].
pub(crate) fn pieces(values: &[f64], knots: &Knots, low: Tail, high: Tail) -> Vec<[f64; 4]> {
    let step = knots.step();
    let curvatures = curvatures(values, step, low, high);
    let mut pieces = Vec::with_capacity(knots.pieces());
    let slope_after = |k: usize| {
        (values[k + 1] - values[k]) / step - step * (2.0 * curvatures[k] + curvatures[k + 1]) / 6.0
    };
    let last = values.len() - 1;
    let last_slope = slope_after(last - 1) + 0.5 * step * (curvatures[last - 1] + curvatures[last]);
    pieces.push(low.piece(values[0], slope_after(0), curvatures[0]));
    for k in 0..last {
        let cubic = (curvatures[k + 1] - curvatures[k]) / (6.0 * step);
        pieces.push([values[k], slope_after(k), 0.5 * curvatures[k], cubic]);
    }
    pieces.push(high.piece(values[last], last_slope, curvatures[last]));
    pieces
}

/// Second derivatives at the knots: the tridiagonal system of a C² cubic spline, with the tails' curvatures at its ends.
fn curvatures(values: &[f64], step: f64, low: Tail, high: Tail) -> Vec<f64> {
    let last = values.len() - 1;
    let secant = |k: usize| (values[k + 1] - values[k]) / step;
    let is_levelling = high == Tail::Levelling;
    // rows (before, diagonal, after, right), eliminated from the first knot on
    let row = |k: usize| {
        if k == 0 {
            let (of_slope, of_value, constant) = low.curvature();
            let right = of_slope * secant(0) + of_value * values[0] + constant;
            (0.0, 1.0 + of_slope * step / 3.0, of_slope * step / 6.0, right)
        } else if k == last && is_levelling {
            // with two knots the curvature is the same at both; with more it is extrapolated below
            (if last == 1 { -1.0 } else { 0.0 }, 1.0, 0.0, 0.0)
        } else if k + 1 == last && is_levelling {
            // the last curvature, 2 M(k) − M(k − 1), put into the row of an inner knot
            (0.0, 6.0, 0.0, 6.0 * (secant(k) - secant(k - 1)) / step)
        } else if k == last {
            let (of_slope, of_value, constant) = high.curvature();
            let right = of_slope * secant(last - 1) + of_value * values[last] + constant;
            (-of_slope * step / 6.0, 1.0 - of_slope * step / 3.0, 0.0, right)
        } else {
            (1.0, 4.0, 1.0, 6.0 * (secant(k) - secant(k - 1)) / step)
        }
    };
    let mut reduced: Vec<(f64, f64)> = Vec::with_capacity(values.len());
    for k in 0..=last {
        let (before, diagonal, after, right) = row(k);
        let (above, above_right) = if k == 0 { (0.0, 0.0) } else { reduced[k - 1] };
        let pivot = diagonal - before * above;
        reduced.push((after / pivot, (right - before * above_right) / pivot));
    }
    let mut curvatures = vec![0.0; values.len()];
    let mut following = 0.0;
    for (k, (after, right)) in reduced.into_iter().enumerate().rev() {
        following = right - after * following;
        curvatures[k] = following;
    }
    if is_levelling && last > 1 {
        curvatures[last] = 2.0 * curvatures[last - 1] - curvatures[last - 2];
    }
    curvatures
}

/// The largest deviation, at every second knot, of the spline through the others; zero where too few remain.
pub(crate) fn left_out(values: &[f64], knots: &Knots, low: Tail, high: Tail, rates: (f64, f64)) -> f64 {
    let Some(coarse) = knots.coarsened() else { return 0.0 };
    let kept: Vec<f64> = values.iter().copied().step_by(2).collect();
    let pieces = pieces(&kept, &coarse, low, high);
    let deviation = |index: usize| {
        let place = coarse.place(knots.at(index), rates);
        let predicted: f64 = pieces[place.piece].iter().zip(place.basis).map(|(c, b)| c * b).sum();
        (predicted - values[index]).abs()
    };
    // with an even number of knots the last is left out and has no neighbour behind it: it does not count
    (1..values.len() - 1).step_by(2).map(deviation).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(pieces: &[[f64; 4]], knots: &Knots, rates: (f64, f64), x: f64) -> (f64, f64) {
        let place = knots.place(x, rates);
        let dot = |basis: [f64; 4]| pieces[place.piece].iter().zip(basis).map(|(c, b)| c * b).sum();
        (dot(place.basis), dot(place.slopes))
    }

    fn to_limit(rate: f64, limit: f64, half: f64) -> Tail {
        Tail::ToLimit { rate, limit, half }
    }

    /// 1/(1 + e^{2x}) and tails that are not those of the spline, so that nothing is exact.
    fn bump(x: f64) -> f64 {
        (2.0 * x).exp() / (1.0 + (3.0 * x).exp())
    }

    #[test]
    fn smooth_to_the_curvature_everywhere_and_at_its_limits() {
        let knots = Knots::new("x", -3.0, 4.0, 8).unwrap();
        let values: Vec<f64> = knots.iter().map(bump).collect();
        for (low, high, rates) in [
            (to_limit(2.0, 0.0, -0.2), to_limit(-1.0, 0.0, 0.0), (2.0, -1.0)),
            (Tail::Relaxing { rate: 1.0 }, Tail::Relaxing { rate: -1.0 }, (1.0, -1.0)),
            (Tail::Relaxing { rate: 1.0 }, Tail::Levelling, (1.0, -1.0)),
        ] {
            let pieces = pieces(&values, &knots, low, high);
            for knot in knots.iter() {
                let e = 1e-6;
                let (below, above) =
                    (at(&pieces, &knots, rates, knot - e), at(&pieces, &knots, rates, knot + e));
                let here = at(&pieces, &knots, rates, knot);
                assert!((here.0 - bump(knot)).abs() < 1e-14);
                assert!((above.1 - below.1).abs() < 1e-5);
                let (left, right) = ((here.1 - below.1) / e, (above.1 - here.1) / e);
                assert!((left - right).abs() < 1e-4, "{knot}: {left} {right}");
            }
            for x in [-1e3, 1e3] {
                assert!(at(&pieces, &knots, rates, x).0.is_finite());
                assert_eq!(at(&pieces, &knots, rates, x).1, 0.0);
            }
        }
    }

    #[test]
    fn fourth_order() {
        let ends = (to_limit(2.0, 0.0, 0.0), to_limit(-1.0, 0.0, 0.0));
        let error = |count| {
            let knots = Knots::new("x", -8.0, 12.0, count).unwrap();
            let values: Vec<f64> = knots.iter().map(bump).collect();
            left_out(&values, &knots, ends.0, ends.1, (2.0, -1.0))
        };
        let order = (error(129) / error(257)).log2();
        assert!((3.5..4.5).contains(&order), "{order}");
    }

    #[test]
    fn what_grows_as_the_depth_needs_few_knots() {
        // e^x, up to the deepest knot, where it is steepest
        let error = |count| {
            let knots = Knots::new("x", -8.0, -1.0, count).unwrap();
            let values: Vec<f64> = knots.iter().map(f64::exp).collect();
            left_out(&values, &knots, Tail::Relaxing { rate: 1.0 }, Tail::Levelling, (1.0, -1.0))
        };
        assert!(
            error(9) < 0.02 && error(17) < 3e-3 && error(33) < 3e-4,
            "{} {} {}",
            error(9),
            error(17),
            error(33)
        );
    }

    #[test]
    fn a_tail_of_the_assumed_form_is_exact() {
        // to the limit 3, from a table that covers a part of it
        let tail = |x: f64| 3.0 + (-x).exp() * (1.0 + x) + 0.7 * (-0.5 * x).exp();
        let knots = Knots::new("x", 0.0, 4.0, 65).unwrap();
        let values: Vec<f64> = knots.iter().map(tail).collect();
        // γ is counted from the last knot
        let high = to_limit(-1.0, 3.0, 0.7 * (-2.0_f64).exp());
        let pieces = pieces(&values, &knots, Tail::Relaxing { rate: 1.0 }, high);
        for x in [5.0, 7.0, 20.0] {
            assert!((at(&pieces, &knots, (1.0, -1.0), x).0 - tail(x)).abs() < 1e-6);
        }
    }
}
