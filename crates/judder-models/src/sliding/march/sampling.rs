//! How the signals of a march are sampled.

use crate::sliding::case::signals::Sampling;
use judder_numerics::signal::Decimation;
use std::f64::consts::TAU;

/// Low-pass and decimation to at least the asked samples a second; every step is a sample where steps are longer than samples.
pub(super) fn decimation(sampling: &Sampling, step: f64) -> Decimation {
    let rate = 1.0 / step;
    let factor = Decimation::factor_to(rate, sampling.sample_rate.0);
    let asked = Decimation::new(rate, sampling.pass_band / TAU, factor);
    // what lies above the stop band is not folded onto the pass band
    let fold = (rate / factor as f64 - asked.pass_edge).min(0.5 * rate);
    Decimation { stop_edge: asked.stop_edge.min(fold), ..asked }
}
