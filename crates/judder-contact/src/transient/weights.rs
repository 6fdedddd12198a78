//! One step of one retardation time, exact for a pressure that is linear in the step.

/// The smallest ratio of step and time at which the closed forms do not cancel.
const NO_CANCELLATION: f64 = 0.5;
/// Terms of the series below: the last is below rounding.
const SERIES: u32 = 16;

/// p_k ← `keep` p_k + `old` p_n + `new` p_{n+1} solves ṗ_k = (p − p_k)/τ_k over a step Δt in which p is linear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StepWeights {
    /// e^{−z}, z = Δt/τ_k.
    pub(super) keep: f64,
    /// (1 − e^{−z})/z − e^{−z}.
    pub(super) old: f64,
    /// 1 − (1 − e^{−z})/z.
    pub(super) new: f64,
    /// z ∫₀¹ e^{−z(1−s)} s(1−s)/2 ds: what a curvature p″ of the pressure adds, over −p″ Δt².
    pub(super) curvature: f64,
}

impl StepWeights {
    /// The weights of a step that is `ratio` = Δt/τ_k retardation times long.
    pub(super) fn new(ratio: f64) -> Self {
        let z = ratio;
        let keep = libm::exp(-z);
        if z < NO_CANCELLATION {
            return Self {
                keep,
                old: z * series(z, |m| 1.0 / (m + 2.0)),
                new: z * series(z, |m| 1.0 / ((m + 1.0) * (m + 2.0))),
                curvature: z * series(z, |m| 0.5 / ((m + 2.0) * (m + 3.0))),
            };
        }
        let mean = -libm::expm1(-z) / z;
        let first = (mean - keep) / z;
        let second = (2.0 * first - keep) / z;
        Self { keep, old: mean - keep, new: 1.0 - mean, curvature: 0.5 * z * (first - second) }
    }
}

/// Σ (−z)^m/m! f(m).
fn series(z: f64, factor: impl Fn(f64) -> f64) -> f64 {
    let mut power = 1.0;
    let mut sum = 0.0;
    for m in 0..SERIES {
        sum += power * factor(f64::from(m));
        power *= -z / f64::from(m + 1);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_pressure_is_approached_exponentially() {
        for z in [1e-12, 1e-3, 0.49, 0.51, 3.0, 800.0] {
            let w = StepWeights::new(z);
            assert!((w.keep + w.old + w.new - 1.0).abs() < 1e-15, "{z}");
            assert!(w.old > 0.0 && w.new > 0.0 && w.curvature > 0.0);
        }
    }

    /// p = s² on a unit step ends at p_k = z ∫ e^{−z(1−s)} s² ds: linear weights less the curvature's (p″ = 2).
    #[test]
    fn the_curvature_is_what_a_parabola_lacks() {
        for z in [0.1_f64, 0.499, 0.501, 2.0, 7.0] {
            let w = StepWeights::new(z);
            let exact = (1.0 - 2.0 / z + 2.0 / (z * z)) - 2.0 * (-z).exp() / (z * z);
            assert!((w.new - 2.0 * w.curvature - exact).abs() < 1e-13 / (z * z), "{z}");
        }
    }

    #[test]
    fn series_and_closed_form_meet() {
        let (below, above) = (StepWeights::new(0.5 - 1e-13), StepWeights::new(0.5 + 1e-13));
        assert!((below.old / above.old - 1.0).abs() < 1e-12);
        assert!((below.new / above.new - 1.0).abs() < 1e-12);
        assert!((below.curvature / above.curvature - 1.0).abs() < 1e-12);
    }
}
