//! Integrals against the fading memory of a wake, κ e^{−κ t}.

use judder_numerics::quadrature::gauss_legendre;
use std::sync::LazyLock;

/// Nodes of a panel.
const PANEL_NODES: usize = 12;
/// The Gauss–Legendre rule of a panel, on (0, 1).
static PANEL: LazyLock<[(f64, f64); PANEL_NODES]> = LazyLock::new(gauss_legendre);
/// Exponents beyond which e^{−z} is below rounding.
pub(crate) const SPENT: f64 = 40.0;
/// Exponents over which e^{−z} is resolved by one panel to rounding.
const PANEL_EXPONENT: f64 = 4.0;

/// ∫_from^to κ e^{−κ t} f(t) dt by one Gauss rule; exact where f and the exponential are smooth on the panel.
pub(crate) fn panel(rate: f64, from: f64, to: f64, function: impl Fn(f64) -> f64) -> f64 {
    let width = to - from;
    let sum: f64 = PANEL
        .iter()
        .map(|(node, weight)| {
            let t = from + width * node;
            weight * libm::exp(-t * rate) * function(t)
        })
        .sum();
    sum * width * rate
}

/// Splits a panel where the exponential falls by more than one rule resolves.
pub(crate) fn panels(rate: f64, from: f64, to: f64, function: impl Fn(f64) -> f64) -> f64 {
    let last = to.min(SPENT / rate);
    let mut sum = 0.0;
    let mut start = from;
    while start < last {
        let end = (start + PANEL_EXPONENT / rate).min(last);
        sum += panel(rate, start, end, &function);
        start = end;
    }
    sum
}

/// ∫_0^∞ κ e^{−κ t} f(t) dt for f that varies over the distance `start` + t, on panels that double with the distance.
pub(crate) fn tail(rate: f64, start: f64, function: impl Fn(f64) -> f64) -> f64 {
    let mut sum = 0.0;
    let mut from = 0.0;
    while from * rate < SPENT {
        let to = from + (start + from).min(PANEL_EXPONENT / rate);
        sum += panel(rate, from, to, &function);
        from = to;
    }
    sum
}

/// Weights w with Σ w_j f(t_j) = ∫_0^1 κ e^{−κ t} f(t) dt for every polynomial f that the nodes t_j determine.
pub(crate) fn product_weights<const N: usize>(nodes: &[f64; N], rate: f64) -> [f64; N] {
    std::array::from_fn(|index| {
        let others =
            || nodes.iter().enumerate().filter(move |(other, _)| *other != index).map(|(_, node)| node);
        let scale: f64 = others().map(|other| nodes[index] - other).product();
        panels(rate, 0.0, 1.0, |t| others().map(|other| t - other).product::<f64>() / scale)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn product_weights_integrate_a_cubic_against_any_exponential() {
        let nodes = [-1.0, 0.0, 1.0, 2.0];
        for rate in [1e-8, 1e-3, 0.7, 5.0, 80.0, 1e8] {
            let weights = product_weights(&nodes, rate);
            // ∫_0^1 κ e^{−κt} t³ dt, by parts; for small κ the first terms of its series.
            let exact = if rate < 0.01 {
                rate / 4.0 - rate * rate / 5.0 + rate.powi(3) / 12.0
            } else {
                let k: f64 = rate;
                6.0 / k.powi(3) - (-k).exp() * (1.0 + 3.0 / k + 6.0 / k.powi(2) + 6.0 / k.powi(3))
            };
            let cubic: f64 = nodes.iter().zip(weights).map(|(t, weight)| weight * t * t * t).sum();
            let scale = -(-rate).exp_m1();
            assert!((cubic - exact).abs() < 1e-10 * scale, "{rate}: {cubic} {exact}");
            assert!((weights.iter().sum::<f64>() / scale - 1.0).abs() < 1e-13, "{rate}");
        }
    }
}
