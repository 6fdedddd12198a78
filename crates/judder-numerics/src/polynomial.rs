//! All roots of a small real polynomial.

use crate::complex::ElementaryComplex;
use crate::order::{sort_by_number, sort_by_numbers};
use crate::words::plain;
use num_complex::Complex64;
use thiserror::Error;

/// Why a polynomial has no roots to give.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum PolynomialError {
    /// A coefficient is NaN or infinite.
    #[error("coefficient of power {power} is not finite")]
    NotFinite {
        /// Power of the unknown that it multiplies.
        power: usize,
    },
    /// The leading coefficient vanishes.
    #[error("the leading coefficient is zero")]
    DegenerateDegree,
    /// The simultaneous iteration did not settle.
    #[error("no convergence after {iterations} iterations, largest relative change {change}", change = plain(*.change))]
    NotConverged {
        /// Iterations made.
        iterations: usize,
        /// Largest relative change of a root in the last one.
        change: f64,
    },
}

/// Value, derivative, and a bound of the rounding error of the value, at `z`.
fn evaluate(coefficients: &[f64], z: Complex64) -> (Complex64, Complex64, f64) {
    let radius = z.modulus();
    let mut value = Complex64::ZERO;
    let mut slope = Complex64::ZERO;
    let mut bound = 0.0;
    for &c in coefficients.iter().rev() {
        slope = slope * z + value;
        value = value * z + c;
        bound = bound * radius + c.abs();
    }
    (value, slope, 4.0 * f64::EPSILON * bound)
}

/// All roots of Σ `coefficients[k]` z^k, sorted by imaginary, then real part; conjugate pairs are exact conjugates.
///
/// Ehrlich–Aberth iteration from a ring that is deliberately not symmetric about the real axis, until each root is as
/// good as the coefficients allow: a simple root to a few units in the last place of its conditioning, a double root to
/// about the square root of it.
///
/// # Errors
/// Non-finite coefficients, a vanishing leading one, or no convergence (with the iteration count and the last change).
pub fn real_polynomial_roots(coefficients: &[f64]) -> Result<Vec<Complex64>, PolynomialError> {
    if let Some(power) = coefficients.iter().position(|c| !c.is_finite()) {
        return Err(PolynomialError::NotFinite { power });
    }
    let leading = match coefficients.last() {
        Some(leading) if *leading != 0.0 => *leading,
        _ => return Err(PolynomialError::DegenerateDegree),
    };
    let zeros = coefficients.iter().take_while(|c| **c == 0.0).count();
    let reduced: Vec<f64> = coefficients[zeros..].iter().map(|c| c / leading).collect();
    let mut roots = simultaneous_iteration(&reduced)?;
    roots.extend(std::iter::repeat_n(Complex64::ZERO, zeros));
    make_conjugates_exact(coefficients, &mut roots);
    sort_by_numbers(&mut roots, |own| [own.im, own.re]);
    Ok(roots)
}

/// Starting values on circles of the radii of the coefficients' Newton polygon (Bini's choice).
fn starting_values(coefficients: &[f64]) -> Vec<Complex64> {
    let degree = coefficients.len() - 1;
    let logs: Vec<f64> = coefficients.iter().map(|c| libm::log(c.abs())).collect();
    let mut hull: Vec<usize> = Vec::new();
    for k in (0..=degree).filter(|k| coefficients[*k] != 0.0) {
        while let [.., a, b] = hull[..] {
            let below = (logs[k] - logs[a]) * (b - a) as f64 >= (logs[b] - logs[a]) * (k - a) as f64;
            if !below {
                break;
            }
            hull.pop();
        }
        hull.push(k);
    }
    let mut starts = Vec::with_capacity(degree);
    for edge in hull.windows(2) {
        let count = edge[1] - edge[0];
        let radius = libm::exp((logs[edge[0]] - logs[edge[1]]) / count as f64);
        for j in 0..count {
            let angle = std::f64::consts::TAU * j as f64 / count as f64 + 0.7 + 0.3 * edge[0] as f64;
            starts.push(crate::complex::from_polar(radius, angle));
        }
    }
    starts
}

/// Ehrlich–Aberth on a monic polynomial without zero roots.
fn simultaneous_iteration(coefficients: &[f64]) -> Result<Vec<Complex64>, PolynomialError> {
    const LIMIT: usize = 200;
    let mut roots = starting_values(coefficients);
    let mut settled = vec![false; roots.len()];
    let mut change: f64 = 0.0;
    for _ in 0..LIMIT {
        change = 0.0;
        for i in 0..roots.len() {
            if settled[i] {
                continue;
            }
            let (value, slope, bound) = evaluate(coefficients, roots[i]);
            let crowd: Complex64 =
                (0..roots.len()).filter(|j| *j != i).map(|j| (roots[i] - roots[j]).inv()).sum();
            let step = value / (slope - value * crowd);
            if !step.is_finite() {
                // two iterates met: a nudge parts them, on a scale that the next step corrects
                roots[i] *= Complex64::new(1.0, 1e-8);
                change = 1.0;
                continue;
            }
            roots[i] -= step;
            let relative = step.modulus() / roots[i].modulus();
            settled[i] = value.modulus() <= bound || relative <= f64::EPSILON;
            if !settled[i] {
                change = change.max(relative);
            }
        }
        if settled.iter().all(|s| *s) {
            return Ok(roots);
        }
    }
    Err(PolynomialError::NotConverged { iterations: LIMIT, change })
}

/// Makes real roots real and pairs the others exactly: the coefficients are real, so the true roots are so.
fn make_conjugates_exact(coefficients: &[f64], roots: &mut [Complex64]) {
    let mut paired = vec![false; roots.len()];
    let mut by_height: Vec<usize> = (0..roots.len()).collect();
    sort_by_number(&mut by_height, |own| -roots[*own].im.abs());
    for &i in &by_height {
        if paired[i] {
            continue;
        }
        let (_, slope, bound) = evaluate(coefficients, roots[i]);
        let uncertainty = 8.0 * bound / slope.modulus();
        let partner = (0..roots.len())
            .filter(|j| *j != i && !paired[*j] && (roots[*j].im * roots[i].im < 0.0))
            .min_by(|a, b| {
                (roots[*a] - roots[i].conj()).modulus().total_cmp(&(roots[*b] - roots[i].conj()).modulus())
            });
        paired[i] = true;
        let gap = partner.map_or(f64::INFINITY, |j| (roots[j] - roots[i].conj()).modulus());
        if roots[i].im == 0.0 || (roots[i].im.abs() <= uncertainty && gap > roots[i].im.abs()) {
            roots[i].im = 0.0;
        } else if let Some(j) = partner {
            paired[j] = true;
            let mean = 0.5 * (roots[i] + roots[j].conj());
            (roots[i], roots[j]) = (mean, mean.conj());
        } else {
            roots[i].im = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Coefficients of the monic polynomial with these two conjugate pairs.
    fn from_pairs(pairs: [(f64, f64); 2]) -> [f64; 5] {
        let quadratic = |(re, im): (f64, f64)| [re * re + im * im, -2.0 * re, 1.0];
        let (a, b) = (quadratic(pairs[0]), quadratic(pairs[1]));
        let mut product = [0.0; 5];
        for i in 0..3 {
            for j in 0..3 {
                product[i + j] += a[i] * b[j];
            }
        }
        product
    }

    #[test]
    fn real_roots_come_out_real() {
        // (z − 1)(z + 2)(z − 3)(z + 4) = z⁴ + 2z³ − 13z² − 14z + 24
        let roots = real_polynomial_roots(&[24.0, -14.0, -13.0, 2.0, 1.0]).unwrap();
        let expected = [-4.0, -2.0, 1.0, 3.0];
        for (root, e) in roots.iter().zip(expected) {
            assert_eq!(root.im, 0.0);
            assert!((root.re - e).abs() < 1e-13);
        }
    }

    #[test]
    fn a_double_pair_is_good_to_the_square_root_of_rounding() {
        let roots = real_polynomial_roots(&from_pairs([(0.0, 1.5), (0.0, 1.5)])).unwrap();
        for root in &roots {
            assert!((root.im.abs() - 1.5).abs() < 1e-7 && root.re.abs() < 1e-7, "{root}");
        }
        let sum: f64 = roots.iter().map(|r| r.im).sum();
        assert_eq!(sum, 0.0);
    }

    #[test]
    fn widely_separated_scales_keep_their_digits() {
        // (z + 5000)(z + 2e-4)(z² + 2·0.01z + 2)
        let mut expected = [
            Complex64::new(-5e3, 0.0),
            Complex64::new(-2e-4, 0.0),
            Complex64::new(-0.01, 1.999_9_f64.sqrt()),
        ];
        let (a, b) = ([2.0, 0.02, 1.0], [5e3 * 2e-4, 5e3 + 2e-4, 1.0]);
        let mut product = [0.0; 5];
        for i in 0..3 {
            for j in 0..3 {
                product[i + j] += a[i] * b[j];
            }
        }
        let roots = real_polynomial_roots(&product).unwrap();
        expected.sort_by(|a, b| a.im.total_cmp(&b.im));
        for e in expected {
            let nearest = roots.iter().map(|r| (r - e).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest <= 1e-11 * e.norm(), "{e}: {nearest:e} off");
        }
    }

    #[test]
    fn zero_roots_and_bad_input() {
        let roots = real_polynomial_roots(&[0.0, 0.0, 2.0, 0.0, 1.0]).unwrap();
        assert_eq!(roots.iter().filter(|r| r.norm() == 0.0).count(), 2);
        assert_eq!(
            real_polynomial_roots(&[1.0, f64::NAN, 1.0]),
            Err(PolynomialError::NotFinite { power: 1 })
        );
        assert_eq!(real_polynomial_roots(&[1.0, 1.0, 0.0]), Err(PolynomialError::DegenerateDegree));
    }

    proptest! {
        #[test]
        fn two_conjugate_pairs(
            a in (-2.0..2.0_f64, 0.01..30.0_f64), b in (-2.0..2.0_f64, 0.01..30.0_f64),
        ) {
            let separation = ((a.0 - b.0).powi(2) + (a.1 - b.1).powi(2)).sqrt();
            prop_assume!(separation > 1e-3);
            let roots = real_polynomial_roots(&from_pairs([a, b])).unwrap();
            prop_assert_eq!(roots.len(), 4);
            prop_assert_eq!(roots[0], roots.iter().copied().find(|r| r.im == -roots[0].im && r.re == roots[0].re).unwrap().conj());
            for (re, im) in [a, b] {
                let nearest = roots.iter().map(|r| (r - Complex64::new(re, im)).norm()).fold(f64::INFINITY, f64::min);
                let size = (re.hypot(im)).max(1.0) + a.1.max(b.1);
                prop_assert!(nearest < 1e-11 * size.powi(4) / (separation * im).min(1.0), "{} off by {:e}", im, nearest);
            }
        }
    }
}
