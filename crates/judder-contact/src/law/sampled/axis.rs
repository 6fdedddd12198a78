//! Knots on a logarithmic axis, even or not, and the spline through values at them.

use crate::law::error::LawError;
use crate::law::knots::KnotPlace;
use judder_numerics::elementary::exp;

/// Logarithms of ascending knots.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct KnotAxis {
    logarithms: Vec<f64>,
}

impl KnotAxis {
    /// The logarithms of these knots.
    pub(super) fn new(knots: &[f64], axis: &'static str) -> Result<Self, LawError> {
        if knots.len() < 2 {
            return Err(LawError::TooFewKnots { axis, count: knots.len(), least: 2 });
        }
        let mut before = 0.0;
        for (index, &value) in knots.iter().enumerate() {
            let is_next = value > before && value.is_finite() && libm::log(value) > libm::log(before);
            if !is_next {
                return Err(LawError::KnotOrder { axis, index, value, before });
            }
            before = value;
        }
        Ok(Self { logarithms: knots.iter().map(|knot| libm::log(*knot)).collect() })
    }

    /// Of the knots, ascending.
    pub(super) fn logarithms(&self) -> &[f64] {
        &self.logarithms
    }

    pub(super) fn count(&self) -> usize {
        self.logarithms.len()
    }

    /// One piece below the first knot, one between every two, one above the last.
    pub(super) fn pieces(&self) -> usize {
        self.count() + 1
    }

    /// Where `x` lies, and the four functions of which a piece is a sum.
    ///
    /// With t the distance from the knot at its left, from the first and the last knot beyond them, a piece is c0 + c1 t + c2 t² + c3 t³
    /// between knots and c0 + e^{−|t|} (c1 + c2 t) beyond.
    #[inline]
    pub(super) fn place(&self, x: f64) -> KnotPlace {
        let piece = self.logarithms.partition_point(|knot| *knot <= x);
        let t = x - self.logarithms[piece.max(1) - 1];
        if piece == 0 || piece == self.count() {
            let rate = if piece == 0 { 1.0 } else { -1.0 };
            let w = exp(rate * t);
            return KnotPlace {
                piece,
                basis: [1.0, w, w * t, 0.0],
                slopes: [0.0, rate * w, rate * w * t + w, 0.0],
            };
        }
        let square = t * t;
        KnotPlace { piece, basis: [1.0, t, square, square * t], slopes: [0.0, 1.0, 2.0 * t, 3.0 * square] }
    }

    /// The pieces of the C² spline through `values`, one a knot.
    pub(super) fn spline(&self, values: &[f64]) -> Vec<[f64; 4]> {
        let last = self.count() - 1;
        let step = |k: usize| self.logarithms[k + 1] - self.logarithms[k];
        let curvatures = self.curvatures(values);
        let slope_after = |k: usize| {
            (values[k + 1] - values[k]) / step(k) - step(k) * (2.0 * curvatures[k] + curvatures[k + 1]) / 6.0
        };
        let last_slope =
            slope_after(last - 1) + 0.5 * step(last - 1) * (curvatures[last - 1] + curvatures[last]);
        let mut pieces = Vec::with_capacity(self.pieces());
        pieces.push(levelling(values[0], slope_after(0), curvatures[0], 1.0));
        for k in 0..last {
            let cubic = (curvatures[k + 1] - curvatures[k]) / (6.0 * step(k));
            pieces.push([values[k], slope_after(k), 0.5 * curvatures[k], cubic]);
        }
        pieces.push(levelling(values[last], last_slope, curvatures[last], -1.0));
        pieces
    }

    /// Second derivatives at the knots: the tridiagonal system of a cubic spline, its outer two intervals one cubic at both ends.
    fn curvatures(&self, values: &[f64]) -> Vec<f64> {
        let (count, x) = (self.count(), &self.logarithms);
        let step = |k: usize| x[k + 1] - x[k];
        let bend = |k: usize| {
            6.0 * ((values[k + 1] - values[k]) / step(k) - (values[k] - values[k - 1]) / step(k - 1))
        };
        match count {
            2 => return vec![0.0; 2],
            // one parabola
            3 => return vec![bend(1) / (3.0 * (step(0) + step(1))); 3],
            _ => {}
        }
        let last = count - 1;
        // the curvature at an end is that of the line through the two inner ones, put into the row of the first inner knot
        let (low, high) = (step(0) / step(1), step(last - 1) / step(last - 2));
        let mut reduced: Vec<(f64, f64)> = Vec::with_capacity(count - 2);
        for k in 1..last {
            let (mut before, mut diagonal, mut after) = (step(k - 1), 2.0 * (step(k - 1) + step(k)), step(k));
            if k == 1 {
                diagonal += before * (1.0 + low);
                after -= before * low;
                before = 0.0;
            }
            if k == last - 1 {
                diagonal += step(k) * (1.0 + high);
                before -= step(k) * high;
                after = 0.0;
            }
            let (above, above_right) = reduced.last().copied().unwrap_or_default();
            let pivot = diagonal - before * above;
            reduced.push((after / pivot, (bend(k) - before * above_right) / pivot));
        }
        let mut curvatures = vec![0.0; count];
        for (k, (after, right)) in reduced.into_iter().enumerate().rev() {
            curvatures[k + 1] = right - after * curvatures[k + 2];
        }
        curvatures[0] = curvatures[1] + low * (curvatures[1] - curvatures[2]);
        curvatures[last] = curvatures[last - 1] + high * (curvatures[last - 1] - curvatures[last - 2]);
        curvatures
    }

    /// The largest deviation, at every second knot, of the spline through the others; zero where too few remain.
    pub(super) fn left_out(&self, values: &[f64]) -> f64 {
        let every_second = |list: &[f64]| list.iter().copied().step_by(2).collect::<Vec<_>>();
        let coarse = Self { logarithms: every_second(&self.logarithms) };
        if coarse.count() < 2 {
            return 0.0;
        }
        let pieces = coarse.spline(&every_second(values));
        let deviation = |index: usize| {
            let place = coarse.place(self.logarithms[index]);
            let predicted: f64 = pieces[place.piece].iter().zip(place.basis).map(|(c, b)| c * b).sum();
            (predicted - values[index]).abs()
        };
        // with an even number of knots the last is left out and has no neighbour behind it: it does not count
        (1..self.count() - 1).step_by(2).map(deviation).fold(0.0, f64::max)
    }
}

/// limit + e^{rate·t} (α + β t) with value, slope and curvature of the edge; `rate` is 1 below the first knot, −1 above the last.
fn levelling(value: f64, slope: f64, curvature: f64, rate: f64) -> [f64; 4] {
    let alpha = 2.0 * rate * slope - curvature;
    [value - alpha, alpha, slope - rate * alpha, 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_comes_back_on_uneven_knots() {
        let logarithms: Vec<f64> = vec![-3.0, -2.4, -1.0, 0.3, 0.5, 2.0];
        let axis = KnotAxis { logarithms: logarithms.clone() };
        let cubic = |x: f64| 1.0 - 2.0 * x + 0.5 * x * x + 0.3 * x * x * x;
        let values: Vec<f64> = logarithms.iter().map(|x| cubic(*x)).collect();
        let pieces = axis.spline(&values);
        for x in [-2.9, -1.7, 0.0, 0.4, 1.9] {
            let place = axis.place(x);
            let value: f64 = pieces[place.piece].iter().zip(place.basis).map(|(c, b)| c * b).sum();
            assert!((value - cubic(x)).abs() < 1e-12, "{x}: {value} {}", cubic(x));
        }
    }

    #[test]
    fn two_and_three_knots_are_a_line_and_a_parabola() {
        for knots in [vec![0.0, 1.5], vec![0.0, 0.5, 2.0]] {
            let power = knots.len() as i32 - 1;
            let values: Vec<f64> = knots.iter().map(|x: &f64| x.powi(power)).collect();
            let axis = KnotAxis { logarithms: knots };
            let (place, pieces) = (axis.place(0.9), axis.spline(&values));
            let value: f64 = pieces[place.piece].iter().zip(place.basis).map(|(c, b)| c * b).sum();
            assert!((value - 0.9_f64.powi(power)).abs() < 1e-14, "{value}");
        }
    }
}
