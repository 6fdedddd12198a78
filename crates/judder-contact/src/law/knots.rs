//! Evenly spaced knots on a logarithmic axis, and where a point lies among them.

use crate::law::error::LawError;
use judder_numerics::elementary::exp;

/// How far, in spacings, a listed knot may be from its even place.
const UNIFORMITY: f64 = 1e-9;

/// Evenly spaced values of a logarithm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Knots {
    first: f64,
    last: f64,
    count: usize,
    step: f64,
    per_step: f64,
}

impl Knots {
    /// `count` knots from `first` to `last`; `axis` is the name in errors.
    ///
    /// # Errors
    /// Fewer than two knots; ends that are not finite or do not ascend.
    pub fn new(axis: &'static str, first: f64, last: f64, count: usize) -> Result<Self, LawError> {
        if count < 2 {
            return Err(LawError::TooFewKnots { axis, count, least: 2 });
        }
        if !(first.is_finite() && last.is_finite() && first < last && (last - first).is_finite()) {
            return Err(LawError::NotAscending { axis, first, last });
        }
        Ok(Self::spaced(first, last, count))
    }

    fn spaced(first: f64, last: f64, count: usize) -> Self {
        let (intervals, length) = ((count - 1) as f64, last - first);
        Self { first, last, count, step: length / intervals, per_step: intervals / length }
    }

    /// The knots of a list, if they are evenly spaced.
    ///
    /// # Errors
    /// As [`new`](Self::new), or [`LawError::NotUniform`].
    pub fn from_list(axis: &'static str, list: &[f64]) -> Result<Self, LawError> {
        let (Some(first), Some(last)) = (list.first(), list.last()) else {
            return Err(LawError::TooFewKnots { axis, count: 0, least: 2 });
        };
        let knots = Self::new(axis, *first, *last, list.len())?;
        for (index, (&found, expected)) in list.iter().zip(knots.iter()).enumerate() {
            let is_close = (found - expected).abs() <= UNIFORMITY * knots.step();
            if !is_close {
                return Err(LawError::NotUniform { axis, index, found, expected });
            }
        }
        Ok(knots)
    }

    /// Number of knots.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The first knot.
    #[must_use]
    pub fn first(&self) -> f64 {
        self.first
    }

    /// The last knot.
    #[must_use]
    pub fn last(&self) -> f64 {
        self.last
    }

    /// The spacing.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// A knot; the same bits whenever the same place is a knot of a grid twice as fine.
    #[must_use]
    pub fn at(&self, index: usize) -> f64 {
        if index + 1 >= self.count {
            return self.last;
        }
        self.first + (self.last - self.first) * (index as f64 / (self.count - 1) as f64)
    }

    /// All knots, ascending.
    pub fn iter(&self) -> impl Iterator<Item = f64> + use<> {
        let knots = *self;
        (0..self.count).map(move |index| knots.at(index))
    }

    /// The knots with one more between every two.
    #[must_use]
    pub(crate) fn refined(&self) -> Self {
        Self::spaced(self.first, self.last, 2 * self.count - 1)
    }

    /// Every second knot from the first; `None` if fewer than two remain.
    pub(crate) fn coarsened(&self) -> Option<Self> {
        let count = self.count.div_ceil(2);
        let last = self.at(2 * (count - 1));
        (count >= 2).then(|| Self::spaced(self.first, last, count))
    }

    /// Pieces of a spline with tails: one below the first knot, one between every two knots, one above the last.
    pub(crate) fn pieces(&self) -> usize {
        self.count + 1
    }

    /// Where `x` lies, and the four functions of which a piece is a sum; `rates` are those of the tails.
    ///
    /// With t the distance from the knot at its left, from the first and the last knot in the tails, a piece is
    /// c0 + c1 t + c2 t² + c3 t³ between knots and c0 + e^{rate·t} (c1 + c2 t) + c3 e^{rate·t/2} in the tails.
    #[inline(always)]
    pub(crate) fn place(&self, x: f64, rates: (f64, f64)) -> KnotPlace {
        let position = (x - self.first) * self.per_step + 1.0;
        // a conversion from floating point saturates: everything below the first knot is piece 0
        let piece = (position as usize).min(self.count);
        let knot = piece.max(1) - 1;
        let t = x - (self.first + self.step * knot as f64);
        if piece == 0 || piece == self.count {
            let rate = if piece == 0 { rates.0 } else { rates.1 };
            let root = exp(0.5 * rate * t);
            let (w, slope) = (root * root, rate * root * root);
            return KnotPlace {
                piece,
                basis: [1.0, w, w * t, root],
                slopes: [0.0, slope, slope * t + w, 0.5 * rate * root],
            };
        }
        let square = t * t;
        KnotPlace { piece, basis: [1.0, t, square, square * t], slopes: [0.0, 1.0, 2.0 * t, 3.0 * square] }
    }
}

/// A place among knots.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KnotPlace {
    /// The piece of the spline.
    pub(crate) piece: usize,
    /// The four functions.
    pub(crate) basis: [f64; 4],
    /// Their derivatives.
    pub(crate) slopes: [f64; 4],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn knots_of_a_finer_grid_have_the_same_bits() {
        let coarse = Knots::new("x", -6.9, 9.21, 9).unwrap();
        let fine = coarse.refined();
        for index in 0..coarse.count() {
            assert_eq!(coarse.at(index).to_bits(), fine.at(2 * index).to_bits());
        }
        assert_eq!(fine.coarsened().map(|k| k.iter().collect::<Vec<_>>()), Some(coarse.iter().collect()));
    }

    #[test]
    fn what_is_no_axis_is_refused() {
        assert!(matches!(Knots::new("x", 0.0, 1.0, 1), Err(LawError::TooFewKnots { .. })));
        assert!(matches!(Knots::new("x", 0.0, f64::NAN, 4), Err(LawError::NotAscending { .. })));
        assert!(matches!(Knots::new("x", 1.0, 0.0, 4), Err(LawError::NotAscending { .. })));
        assert!(matches!(
            Knots::from_list("x", &[0.0, 1.0, 2.1, 3.0]),
            Err(LawError::NotUniform { index: 2, .. })
        ));
        assert!(matches!(Knots::from_list("x", &[0.0, f64::NAN, 2.0]), Err(LawError::NotUniform { .. })));
        assert!(Knots::from_list("x", &[]).is_err());
    }
}
