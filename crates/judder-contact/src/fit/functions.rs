//! The functions of appendix B without their powers of ŷ, and their gradients by the coefficients.

use judder_numerics::elementary::erf_with_derivative;

/// (34) over ŷ^{3/2}: a₁ ½ [a₂ + erf(a₃ log₁₀ v̂ + a₄ log₁₀ ŷ + a₅)], and its gradient by a₁ … a₅.
pub(super) fn force(a: &[f64; 5], log10_velocity: f64, log10_indentation: f64) -> (f64, [f64; 5]) {
    let (error_function, slope) =
        erf_with_derivative(a[2] * log10_velocity + (a[3] * log10_indentation + a[4]));
    let half = 0.5 * a[0];
    let bracket = 0.5 * (a[1] + error_function);
    let inner = half * slope;
    (a[0] * bracket, [bracket, half, inner * log10_velocity, inner * log10_indentation, inner])
}

/// exp(−(log₁₀ v̂ − (slope log₁₀ ŷ + centre))²/2 width²), and its gradient by slope, centre, width.
fn bell(slope: f64, centre: f64, width: f64, log10_velocity: f64, log10_indentation: f64) -> (f64, [f64; 3]) {
    let distance = (log10_velocity - (slope * log10_indentation + centre)) / width;
    let value = libm::exp(-0.5 * distance * distance);
    let by_centre = value * distance / width;
    (value, [by_centre * log10_indentation, by_centre, by_centre * distance])
}

/// (36) over ŷ: b₁ [b₂ − exp(…)], and its gradient by b₁ … b₅.
pub(super) fn area(b: &[f64; 5], log10_velocity: f64, log10_indentation: f64) -> (f64, [f64; 5]) {
    let (dip, by) = bell(b[2], b[3], b[4], log10_velocity, log10_indentation);
    let bracket = b[1] - dip;
    (b[0] * bracket, [bracket, b[0], -b[0] * by[0], -b[0] * by[1], -b[0] * by[2]])
}

/// (38) over ŷ^{1/2}: c₁ exp(…), and its gradient by c₁ … c₄.
pub(super) fn friction(c: &[f64; 4], log10_velocity: f64, log10_indentation: f64) -> (f64, [f64; 4]) {
    let (peak, by) = bell(c[1], c[2], c[3], log10_velocity, log10_indentation);
    (c[0] * peak, [peak, c[0] * by[0], c[0] * by[1], c[0] * by[2]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::least_squares::GradientFunction;
    use crate::{ContactLaw, FittedLaw, LawPoint};

    fn assert_gradient<const N: usize>(function: GradientFunction<N>, c: [f64; N], at: (f64, f64)) {
        const STEP: f64 = 1e-6;
        let (_, gradient) = function(&c, at.0, at.1);
        for k in 0..N {
            let shifted = |sign: f64| {
                let mut c = c;
                c[k] += sign * STEP;
                function(&c, at.0, at.1).0
            };
            let difference = (shifted(1.0) - shifted(-1.0)) / (2.0 * STEP);
            assert!((gradient[k] - difference).abs() < 1e-8, "{k} at {at:?}: {} {difference}", gradient[k]);
        }
    }

    #[test]
    fn gradients_are_exact_and_values_are_those_of_the_law() {
        let law = FittedLaw::oscillator_paper();
        for (log10_velocity, log10_indentation) in [(-3.0, -2.0), (-1.5, -1.0), (0.3, -3.0), (-2.4, -2.2)] {
            let at = (log10_velocity, log10_indentation);
            assert_gradient(force, law.force, at);
            assert_gradient(area, law.area, at);
            assert_gradient(friction, law.friction, at);
            let (v, y) = (10_f64.powf(at.0), 10_f64.powf(at.1));
            let expected = law.evaluate(&LawPoint::new(v, y));
            let (f, g, m) = (
                force(&law.force, at.0, at.1).0 * y.powf(1.5),
                area(&law.area, at.0, at.1).0 * y,
                friction(&law.friction, at.0, at.1).0 * y.sqrt(),
            );
            assert!((f / expected.force.value - 1.0).abs() < 1e-12);
            assert!((g / expected.area.value - 1.0).abs() < 1e-12);
            assert!((m / expected.friction.value - 1.0).abs() < 1e-12);
        }
    }
}
