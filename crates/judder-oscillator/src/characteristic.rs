//! The characteristic polynomial (21) and the Hurwitz determinants that decide stability.

use crate::linear_system::ReducedSystem;
use judder_numerics::verdict::Verdict;

/// Relative width of the band around a vanishing Hurwitz condition in which a point is called marginal: a condition is a
/// sum of terms, and below this share of their magnitudes its sign is rounding.
pub const MARGINAL_BAND: f64 = judder_numerics::cancellation::ROUNDING;

/// A number over the size of what it was summed from; 0 of nothing.
#[inline(always)]
fn share(value: f64, size: f64) -> f64 {
    if size > 0.0 { value / size } else { 0.0 }
}

/// det(λ² I + λ C + K) = λ⁴ + p3 λ³ + p2 λ² + p1 λ + p0, with the size of the terms that each coefficient sums.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Characteristic {
    /// p0 = det K.
    pub p0: f64,
    /// p1 = c11 k22 + c22 k11 − c12 k21 − c21 k12.
    pub p1: f64,
    /// p2 = k11 + k22 + det C.
    pub p2: f64,
    /// p3 = tr C.
    pub p3: f64,
    size: [f64; 3],
}

impl Characteristic {
    /// The polynomial of a system with unit mass matrix.
    #[inline(always)]
    #[must_use]
    pub fn new(system: &ReducedSystem) -> Self {
        let [[c11, c12], [c21, c22]] = system.damping;
        let [[k11, k12], [k21, k22]] = system.stiffness;
        Self {
            p0: k11 * k22 - k12 * k21,
            p1: (c11 * k22 + c22 * k11) - (c12 * k21 + c21 * k12),
            p2: (k11 + k22) + (c11 * c22 - c12 * c21),
            p3: c11 + c22,
            size: [
                (k11 * k22).abs() + (k12 * k21).abs(),
                (c11 * k22).abs() + (c22 * k11).abs() + (c12 * k21).abs() + (c21 * k12).abs(),
                c11.abs() + c22.abs(),
            ],
        }
    }

    /// The coefficients of 1, λ, …, λ⁴.
    #[must_use]
    pub fn coefficients(&self) -> [f64; 5] {
        [self.p0, self.p1, self.p2, self.p3, 1.0]
    }

    /// The third Hurwitz determinant H3 = p1 p2 p3 − p1² − p3² p0, which vanishes on a Hopf boundary.
    #[inline(always)]
    #[must_use]
    pub fn third_determinant(&self) -> f64 {
        self.p1 * self.p2 * self.p3 - self.p1 * self.p1 - self.p3 * self.p3 * self.p0
    }

    /// H3 over the magnitudes of its terms: between −1 and 1, with its sign; 0 where all vanish.
    #[inline(always)]
    #[must_use]
    pub fn third_determinant_share(&self) -> f64 {
        share(self.third_determinant(), self.third_determinant_size())
    }

    /// The magnitudes of the terms of H3, summed.
    #[inline(always)]
    fn third_determinant_size(&self) -> f64 {
        (self.p1 * self.p2 * self.p3).abs() + self.p1 * self.p1 + self.p3 * self.p3 * self.p0.abs()
    }

    /// Whether any term of p1 or p3 is there at all.
    #[inline(always)]
    fn is_damped(&self) -> bool {
        (self.size[2] > 0.0) | (self.size[1] > 0.0)
    }

    /// The smallest of the four conditions p0 > 0, p1 > 0, p3 > 0, H3 > 0, each over the magnitudes of its terms, so
    /// between −1 and 1: positive where the system is stable, negative where it is unstable.
    ///
    /// Without damping the conditions are those for real frequencies, p0 > 0, p2 > 0, p2² > 4 p0: negative is unstable still,
    /// but positive is marginal.
    #[inline(always)]
    #[must_use]
    pub fn margin(&self) -> f64 {
        let smaller = |a: f64, b: f64| if a < b { a } else { b };
        let square = self.p2 * self.p2;
        let undamped = smaller(
            share(self.p2, self.p2.abs()),
            share(square - 4.0 * self.p0, square + 4.0 * self.p0.abs()),
        );
        let damped = smaller(
            share(self.p1, self.size[1]),
            smaller(share(self.p3, self.size[2]), self.third_determinant_share()),
        );
        smaller(share(self.p0, self.size[0]), if self.is_damped() { damped } else { undamped })
    }

    /// Whether p1 < 0 or H3 < 0: all that can make a system unstable that is not so without damping and has no negative dampers.
    #[inline(always)]
    #[must_use]
    pub fn is_destabilised(&self) -> bool {
        let below = |value: f64, size: f64| value < -MARGINAL_BAND * size;
        below(self.p1, self.size[1]) | below(self.third_determinant(), self.third_determinant_size())
    }

    /// 1 where the system is stable, −1 where it is unstable, 0 where it is marginal: by Routh and Hurwitz, and without
    /// any damping by the roots of λ⁴ + p2 λ² + p0. The sign of [`Characteristic::margin`] with its band, without dividing.
    #[inline(always)]
    #[must_use]
    pub fn stability_sign(&self) -> f64 {
        let [size_0, size_1, size_3] = self.size;
        let square = self.p2 * self.p2;
        let above = |value: f64, size: f64| value > MARGINAL_BAND * size;
        let below = |value: f64, size: f64| value < -MARGINAL_BAND * size;
        let (h3, size_h3) = (self.third_determinant(), self.third_determinant_size());
        let damped = self.is_damped();
        let stable = damped
            & above(self.p0, size_0)
            & above(self.p1, size_1)
            & above(self.p3, size_3)
            & above(h3, size_h3);
        let damped_unstable = below(self.p3, size_3) | self.is_destabilised();
        let undamped_unstable =
            below(self.p2, self.p2.abs()) | below(square - 4.0 * self.p0, square + 4.0 * self.p0.abs());
        let unstable = below(self.p0, size_0) | (damped & damped_unstable) | (!damped & undamped_unstable);
        let not_stable = if unstable { -1.0 } else { 0.0 };
        if stable { 1.0 } else { not_stable }
    }

    /// [`Characteristic::stability_sign`] in words.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let sign = self.stability_sign();
        if sign > 0.0 {
            Verdict::Stable
        } else if sign < 0.0 {
            Verdict::Unstable
        } else {
            Verdict::Marginal
        }
    }

    /// ω of the oscillation on a Hopf boundary: ω² = p1/p3; without damping that of the merged modes, ω² = p2/2. NaN where it is
    /// negative.
    #[must_use]
    pub fn hopf_frequency(&self) -> f64 {
        if self.is_damped() { (self.p1 / self.p3).sqrt() } else { (0.5 * self.p2).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(damping: [[f64; 2]; 2], stiffness: [[f64; 2]; 2]) -> Characteristic {
        Characteristic::new(&ReducedSystem { damping, stiffness })
    }

    #[test]
    fn a_negatively_damped_degree_of_freedom_is_unstable() {
        let k = [[1.0, 0.0], [0.0, 2.0]];
        assert_eq!(of([[0.1, 0.0], [0.0, 0.1]], k).verdict(), Verdict::Stable);
        assert_eq!(of([[-0.1, 0.0], [0.0, 0.3]], k).verdict(), Verdict::Unstable);
    }

    #[test]
    fn without_damping_it_is_marginal_or_flutter_or_divergence() {
        let none = [[0.0; 2]; 2];
        assert_eq!(of(none, [[2.0, 0.5], [0.5, 1.0]]).verdict(), Verdict::Marginal);
        assert_eq!(of(none, [[2.0, -2.0], [1.0, 2.0]]).verdict(), Verdict::Unstable);
        assert_eq!(of(none, [[1.0, 2.0], [2.0, 1.0]]).verdict(), Verdict::Unstable);
    }

    #[test]
    fn the_hopf_frequency_of_proportional_damping() {
        // K = [[2, 1 − 4μ/3], [1, 2]] at μ = 3/4 has k12 = 0: a double root at ω² = 2
        let c = of([[0.02, 0.0], [0.0, 0.02]], [[2.0, 0.0], [1.0, 2.0]]);
        assert!((c.hopf_frequency() - 2_f64.sqrt()).abs() < 1e-14);
    }
}
