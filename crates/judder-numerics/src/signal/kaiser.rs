//! The window of Kaiser: the shortest main lobe for side lobes of a given height, nearly.
//!
//! J. F. Kaiser, *Nonrecursive digital filter design using the I₀-sinh window function*, Proc. IEEE Int. Symp. Circuits and
//! Systems, 1974, 20–23; the formulas also in A. V. Oppenheim and R. W. Schafer, *Discrete-time signal processing*, 3rd ed.,
//! section 7.6.

/// The shape parameter β for a filter whose stop band lies `attenuation` dB below its pass band.
///
/// β = 0.1102 (A − 8.7) for A > 50 dB; 0.5842 (A − 21)^0.4 + 0.07886 (A − 21) for 21 ≤ A ≤ 50 dB; 0 below.
#[must_use]
pub fn shape(attenuation: f64) -> f64 {
    if attenuation > 50.0 {
        0.1102 * (attenuation - 8.7)
    } else if attenuation >= 21.0 {
        0.5842 * libm::pow(attenuation - 21.0, 0.4) + 0.07886 * (attenuation - 21.0)
    } else {
        0.0
    }
}

/// The order (taps less one) of such a filter: (A − 7.95)/(2.285 Δω), Δω the width of the transition in radians a sample; not rounded.
#[must_use]
pub fn order(attenuation: f64, transition: f64) -> f64 {
    ((attenuation - 7.95) / (2.285 * transition)).max(0.0)
}

/// The window at `place`, −1 and 1 being its ends and 0 its middle: I₀(β √(1 − x²))/I₀(β); 0 outside.
#[must_use]
pub fn window(shape: f64, place: f64) -> f64 {
    let under = 1.0 - place * place;
    if under < 0.0 { 0.0 } else { bessel_i0(shape * under.sqrt()) / bessel_i0(shape) }
}

/// The modified Bessel function I₀ by its power series Σ ((x/2)^k/k!)², whose terms are all positive.
#[must_use]
pub fn bessel_i0(x: f64) -> f64 {
    let quarter = 0.25 * x * x;
    let (mut term, mut sum, mut k) = (1.0, 1.0, 1.0);
    while term > sum * f64::EPSILON {
        term *= quarter / (k * k);
        sum += term;
        k += 1.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun, table 9.8: e^−x I₀(x), and example 9.8.
    #[test]
    fn the_bessel_function_is_that_of_the_tables() {
        for (x, scaled) in
            [(0.0, 1.0), (1.0, 0.465_759_607_6), (5.0, 0.183_540_812_6), (10.0, 0.127_833_337_2)]
        {
            let x: f64 = x;
            assert!((bessel_i0(x) * (-x).exp() - scaled).abs() < 1e-10, "{x}");
        }
        assert!(bessel_i0(f64::NAN).is_nan());
    }

    #[test]
    fn the_window_is_one_in_the_middle_and_nothing_outside() {
        let beta = shape(80.0);
        assert!((beta - 7.857_26).abs() < 1e-12);
        assert!((window(beta, 0.0) - 1.0).abs() < 1e-15);
        assert!((window(beta, 1.0) * bessel_i0(beta) - 1.0).abs() < 1e-12);
        assert_eq!(window(beta, 1.1), 0.0);
        assert!((shape(30.0) - 2.116_625).abs() < 1e-5 && shape(10.0) == 0.0);
    }
}
