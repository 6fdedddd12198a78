//! `exp`, `ln` and `erf` as straight-line arithmetic.
//!
//! A stability map evaluates a contact law millions of times. These functions have no branches, tables or calls, so a
//! loop over points becomes vector code at any width; and they use no fused operations, so that the scalar path, every
//! vector width and every machine give the same bits. The polynomials are Chebyshev fits computed with 60 digits.

use std::f64::consts::{LN_2, LOG2_E};

/// 1.5·2^52: adding it rounds a double to an integer that then stands in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// The leading 32 bits of ln 2, so that a product with a small integer is exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
/// ln 2 − [`LN_2_HIGH`].
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// Sum of `coefficients[k] · x^k`: Horner in x² for the even and for the odd powers, two chains that do not wait for each
/// other.
#[inline(always)]
fn polynomial<const N: usize>(x: f64, coefficients: &[f64; N]) -> f64 {
    let square = x * x;
    let (mut sum, mut other) = (coefficients[N - 1], coefficients[N - 2]);
    let mut k = N - 2;
    while k > 1 {
        k -= 2;
        sum = sum * square + coefficients[k + 1];
        other = other * square + coefficients[k];
    }
    // for even N both chains are through, the odd one in `sum`; for odd N the even powers lack the constant
    if N.is_multiple_of(2) { sum * x + other } else { (sum * x + other) * x + coefficients[0] }
}

/// (e^r − 1 − r)/r² on |r| ≤ ln 2 / 2.
const EXP_TAIL: [f64; 10] = [
    0.5000000000000001,
    0.1666666666666667,
    0.04166666666662416,
    0.008333333333326141,
    0.0013888888917198588,
    0.00019841269874802173,
    2.4801521319879672e-05,
    2.755725542387984e-06,
    2.762007691611333e-07,
    2.510520706464424e-08,
];

/// e^x to 1 unit in the last place for −708 ≤ x ≤ 709; 0 below, e^709 above; NaN stays NaN.
#[inline(always)]
#[must_use]
pub fn exp(x: f64) -> f64 {
    // `max` and `min` would turn NaN into a bound; these comparisons keep it
    let clamped = if x < -708.0 { -708.0 } else { x };
    let clamped = if clamped > 709.0 { 709.0 } else { clamped };
    let shifted = clamped * LOG2_E + ROUND;
    let count = shifted - ROUND;
    let reduced = (clamped - count * LN_2_HIGH) - count * LN_2_LOW;
    let series = 1.0 + (reduced + reduced * reduced * polynomial(reduced, &EXP_TAIL));
    let power = f64::from_bits((shifted.to_bits() << 52).wrapping_add(1023 << 52));
    if x < -708.0 { 0.0 } else { series * power }
}

/// (2 artanh(√z)/√z − 2)/z on 0 ≤ z ≤ 0.0295.
const LN_TAIL: [f64; 8] = [
    0.6666666666666666,
    0.4000000000000088,
    0.2857142857080112,
    0.2222222239222216,
    0.18181795590761907,
    0.15386242164348365,
    0.13268712289333262,
    0.13087217031578988,
];

/// Natural logarithm of a positive normal number to 2 units in the last place.
///
/// Valid for `f64::MIN_POSITIVE` ≤ x < ∞; outside that the result means nothing (callers clamp).
#[inline(always)]
#[must_use]
pub fn ln(x: f64) -> f64 {
    /// The bits of √½: mantissas are taken from [√½, √2).
    const SQRT_HALF_BITS: u64 = 0x3FE6_A09E_667F_3BCD;
    /// 2^52 as bits and as a number: the trick that turns a small integer into a double without a conversion.
    const INTEGER: u64 = 0x4330_0000_0000_0000;
    const INTEGER_VALUE: f64 = 4_503_599_627_370_496.0;
    const BIAS: u64 = 1024;

    let offset = x.to_bits().wrapping_sub(SQRT_HALF_BITS);
    // an arithmetic shift of the biased difference, written without signed shifts, which have no vector form everywhere
    let exponent_plus_bias = offset.wrapping_add(BIAS << 52) >> 52;
    let exponent = f64::from_bits(INTEGER | exponent_plus_bias) - (INTEGER_VALUE + BIAS as f64);
    let mantissa = f64::from_bits(x.to_bits().wrapping_sub((exponent_plus_bias.wrapping_sub(BIAS)) << 52));
    let f = mantissa - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    // ln(1 + f) = f − s (f − z·tail), which is exact to first order in f
    let series = f - s * (f - z * polynomial(z, &LN_TAIL));
    exponent * LN_2_HIGH + (series + exponent * LN_2_LOW)
}

/// e^{x²} erfc(x) on 0 ≤ x ≤ 6.2 as a polynomial in s = 2.4516… − 15.532…/(x + 4.5).
const SCALED_ERFC: [f64; 19] = [
    0.2741647178160196,
    -0.31503302956731377,
    0.20810228770631364,
    -0.11596256061274478,
    0.05482205359853467,
    -0.021960429636060222,
    0.007387683703649136,
    -0.0020457342781413073,
    0.0004473118453509255,
    -6.990785530891211e-05,
    5.248124420011196e-06,
    6.998792022722159e-07,
    -2.5378440775498554e-07,
    1.724374471807149e-08,
    5.224367983773547e-09,
    -1.047076876608322e-09,
    -7.492025937783358e-11,
    3.357184549712616e-11,
    5.45024487767827e-13,
];

/// erf(w) and its derivative (2/√π) e^{−w²}, from one exponential; absolute error of erf below 2e-15.
///
/// The absolute error is what the contact law (34) needs: there erf stands beside a constant of order one.
#[inline(always)]
#[must_use]
pub fn erf_with_derivative(w: f64) -> (f64, f64) {
    /// Beyond it erfc is below 2e-18, which no sum with erf can see.
    const LARGEST: f64 = 6.2;
    const TWO_OVER_SQRT_PI: f64 = std::f64::consts::FRAC_2_SQRT_PI;
    let gaussian = exp(-(w * w));
    let magnitude = w.abs();
    let x = if magnitude > LARGEST { LARGEST } else { magnitude };
    let s = 2.4516129032258065 - 15.53225806451613 / (x + 4.5);
    let complement = gaussian * polynomial(s, &SCALED_ERFC);
    ((1.0 - complement).copysign(w), TWO_OVER_SQRT_PI * gaussian)
}

const _: () = assert!(LN_2_HIGH + LN_2_LOW == LN_2);

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ERF_ERROR: f64 = 2e-15;

    fn units_in_the_last_place(value: f64, reference: f64) -> f64 {
        (value - reference).abs() / (reference.abs() * f64::EPSILON).max(f64::MIN_POSITIVE)
    }

    #[test]
    fn exp_at_its_bounds() {
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(exp(-1e300), 0.0);
        assert_eq!(exp(f64::NEG_INFINITY), 0.0);
        assert!(exp(-707.9) > 0.0);
        assert!(exp(1e300).is_finite());
        assert!(exp(f64::NAN).is_nan());
    }

    #[test]
    fn ln_at_one_and_at_the_ends() {
        assert_eq!(ln(1.0), 0.0);
        assert!(units_in_the_last_place(ln(f64::MIN_POSITIVE), f64::MIN_POSITIVE.ln()) <= 2.0);
        assert!(units_in_the_last_place(ln(f64::MAX), f64::MAX.ln()) <= 2.0);
    }

    #[test]
    fn erf_at_zero_and_far_out() {
        let (value, slope) = erf_with_derivative(0.0);
        assert!(value.abs() < 1e-15);
        assert!((slope - std::f64::consts::FRAC_2_SQRT_PI).abs() < 1e-15);
        assert_eq!(erf_with_derivative(-1e5).0, -1.0);
        assert_eq!(erf_with_derivative(1e5), (1.0, 0.0));
    }

    #[test]
    fn erf_agrees_with_libm_on_a_dense_line() {
        for step in 0..1_000_000 {
            let w = 8e-6 * f64::from(step);
            assert!((erf_with_derivative(w).0 - libm::erf(w)).abs() <= ERF_ERROR, "{w}");
        }
    }

    proptest! {
        #[test]
        fn exp_agrees_with_libm(x in -700.0..700.0_f64) {
            prop_assert!(units_in_the_last_place(exp(x), libm::exp(x)) <= 1.5);
        }

        #[test]
        fn ln_agrees_with_libm(x in prop::num::f64::POSITIVE | prop::num::f64::NORMAL) {
            let x = x.abs();
            prop_assert!(units_in_the_last_place(ln(x), libm::log(x)) <= 2.0);
        }

        #[test]
        fn ln_near_one_agrees_with_libm(x in 0.5..2.0_f64) {
            prop_assert!(units_in_the_last_place(ln(x), libm::log(x)) <= 2.0);
        }

        #[test]
        fn erf_agrees_with_libm(w in -8.0..8.0_f64) {
            prop_assert!((erf_with_derivative(w).0 - libm::erf(w)).abs() <= ERF_ERROR);
        }
    }
}
