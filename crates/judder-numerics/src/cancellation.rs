//! Sums whose terms cancel.

/// The share of the magnitudes of its terms below which a sum is their rounding.
pub const ROUNDING: f64 = 1e-12;

/// a + b, and zero where the two cancel but for rounding: the sign of what is left would say nothing.
#[inline(always)]
#[must_use]
pub fn sum(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if sum.abs() < ROUNDING * (a.abs() + b.abs()) { 0.0 } else { sum }
}

#[cfg(test)]
mod tests {
    use super::sum;

    #[test]
    fn what_rounding_leaves_of_a_sum_is_zero() {
        let left = 0.04 + 0.1 * (0.16 - 0.2) / 0.1;
        assert!(left != 0.0 && sum(0.04, 0.1 * (0.16 - 0.2) / 0.1).to_bits() == 0);
        assert_eq!((sum(0.04, -0.04 + 1e-12), sum(0.0, -1e-300)), (0.04 + (-0.04 + 1e-12), -1e-300));
        assert!(sum(f64::NAN, 1.0).is_nan() && sum(f64::INFINITY, 1.0) == f64::INFINITY);
    }
}
