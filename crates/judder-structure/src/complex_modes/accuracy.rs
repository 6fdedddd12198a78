//! How far an eigenvalue may be from the true one.

use super::disc::Triple;
use super::refine::RefinedEigenvalue;
use super::vectors::assurances;
use super::{ComplexModeSettings, Eigenvalue};
use crate::quadratic::Quadratic;
use faer::c64;
use judder_numerics::complex::ElementaryComplex;

/// What is known of an eigenvalue beside others.
pub(crate) struct Accuracy<'a> {
    problem: &'a Quadratic,
    refined: &'a RefinedEigenvalue,
    /// How far the nearest eigenvalue with the same vector is: the two may be one that is defective.
    partner: Option<f64>,
}

impl<'a> Accuracy<'a> {
    /// What is known of some of all eigenvalues.
    pub(crate) fn among(problem: &'a Quadratic, all: &'a [RefinedEigenvalue], some: &[usize]) -> Vec<Self> {
        /// Vectors are parallel above it.
        const PARALLEL: f64 = 0.9;
        let vector = |k: usize| &all[k].triple.right[..];
        let of_some: Vec<&[c64]> = some.iter().map(|k| vector(*k)).collect();
        let of_all: Vec<&[c64]> = (0..all.len()).map(vector).collect();
        let alike = assurances(&of_some, &of_all);
        let known = |(row, k): (usize, &usize)| {
            let others = (0..all.len()).filter(|other| other != k && alike[(row, *other)] > PARALLEL);
            let apart = others.map(|other| (all[other].triple.value - all[*k].triple.value).modulus());
            Self { problem, refined: &all[*k], partner: apart.min_by(f64::total_cmp) }
        };
        some.iter().enumerate().map(known).collect()
    }

    /// The eigenvalue with its residuals, condition and error.
    ///
    /// First order: δ = (o + ε N(λ))/|d|, with what the method leaves open o, the precision ε of the matrices, N(λ) = |λ|² ‖M‖ +
    /// |λ| ‖C‖ + ‖K‖ and d = yᴴ Q′(λ) x of vectors of length one.
    pub(crate) fn eigenvalue(&self, left_open: f64, settings: &ComplexModeSettings) -> Eigenvalue {
        let value = self.refined.triple.value;
        let (scale, slope) = (self.problem.scale(value), self.refined.slope.modulus());
        let error = self.moved_by(left_open + (f64::EPSILON + settings.data_precision) * scale);
        Eigenvalue {
            value,
            residual: self.refined.residual,
            left_residual: self.refined.left_residual,
            condition: scale / (value.modulus() * slope),
            error,
            defective: self.partner.is_some_and(|gap| error >= 0.5 * gap),
        }
    }

    /// How far the eigenvalue may be by rounding alone, ε = n 2⁻⁵², where every entry keeps its own digits (D. J. Higham and N. J. Higham,
    /// 1998): δ = (o + ε |y|ᵀ (|λ|² |M| + |λ| |C| + |K|) |x|)/|d|. What is small beside the rest of a matrix keeps its place.
    pub(crate) fn rounding(&self, left_open: f64) -> f64 {
        let Triple { value, right, left } = &self.refined.triple;
        let open = left_open.min(along(left, &self.refined.rest) + along(right, &self.refined.left_rest));
        let precision = f64::EPSILON * self.problem.size() as f64;
        self.moved_by(open + precision * self.problem.scale_by_entries(*value, left, right))
    }

    /// How far the eigenvalue moves where something disturbs d times it.
    ///
    /// Two eigenvalues with one vector, a distance g apart, move as ±√(g²/4 ± δ g) instead of by δ; |d| is then no more than g ‖M‖,
    /// which bounds δ g from below where g is lost in rounding.
    fn moved_by(&self, disturbance: f64) -> f64 {
        let first_order = disturbance / self.refined.slope.modulus();
        self.partner
            .map_or(first_order, |gap| moved(first_order, gap, disturbance / self.problem.mass_norm()))
    }
}

/// |a|ᵀ |b|.
fn along(a: &[c64], b: &[c64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.modulus() * b.modulus()).sum()
}

/// η N(λ): what normalised residuals η leave open of d times the eigenvalue.
pub(crate) fn left_by_residuals(problem: &Quadratic, refined: &RefinedEigenvalue) -> f64 {
    refined.worse() * problem.scale(refined.triple.value)
}

/// How far one of two eigenvalues with one vector moves where a simple one would move by δ; δ g is no less than the last argument.
fn moved(first_order: f64, gap: f64, least: f64) -> f64 {
    let ratio = first_order / gap;
    if ratio < 0.25 {
        first_order / (0.5 + (0.25 - ratio).sqrt())
    } else {
        // an infinite δ belongs to a distance of zero
        let product = if first_order.is_finite() { first_order * gap } else { 0.0 };
        product.max(least).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The roots ±√(g²/4 + δ g) of two eigenvalues that a disturbance couples.
    #[test]
    fn close_eigenvalues_move_as_the_roots_of_their_quadratic() {
        let gap: f64 = 0.3;
        for first_order in [1e-6, 1e-3, 0.07, 0.2, 5.0] {
            let discriminant = gap * gap / 4.0 - first_order * gap;
            let expected = if discriminant >= 0.0 {
                gap / 2.0 - discriminant.sqrt()
            } else {
                (gap / 2.0).hypot((-discriminant).sqrt())
            };
            let found = moved(first_order, gap, 0.0);
            assert!((found / expected - 1.0).abs() < 1e-9, "{first_order}: {found} {expected}");
        }
    }

    #[test]
    fn two_eigenvalues_that_coincide_have_the_error_of_a_defective_one() {
        assert_eq!(moved(f64::INFINITY, 0.0, 4.0), 2.0);
        assert_eq!(moved(1e3, 0.0, 4.0), 2.0);
        assert!(moved(1e3, 1e-3, 1e-9) == 1.0);
    }
}
