//! The rule of Gauss and Legendre.

use std::f64::consts::PI;

/// Nodes and weights of Gauss–Legendre quadrature on (0, 1), nodes ascending, by Newton's method on the polynomial.
///
/// Exact to rounding for polynomials of degree 2 N − 1. The weights sum to 1.
#[must_use]
pub fn gauss_legendre<const N: usize>() -> [(f64, f64); N] {
    std::array::from_fn(|index| {
        let mut x = libm::cos(PI * (index as f64 + 0.75) / (N as f64 + 0.5));
        let mut slope = 1.0;
        for _ in 0..8 {
            let (mut before, mut value) = (1.0, x);
            for degree in 2..=N {
                let k = degree as f64;
                (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
            }
            slope = N as f64 * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫_0^1 t^k dt = 1/(k + 1) up to k = 2 N − 1.
    #[test]
    fn powers_are_integrated_exactly_up_to_the_degree_of_the_rule() {
        let rule = gauss_legendre::<6>();
        for power in 0..12 {
            let sum: f64 = rule.iter().map(|(node, weight)| weight * node.powi(power)).sum();
            assert!((sum * f64::from(power + 1) - 1.0).abs() < 1e-14, "{power}: {sum}");
        }
        assert!(rule.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }
}
