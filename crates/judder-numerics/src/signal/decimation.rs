//! What is asked of a filter that goes from one rate to a lower one.

use super::bits;
use super::error::{SignalError, positive, within};
use serde::{Deserialize, Serialize};

/// The largest factor between two rates.
const LARGEST_FACTOR: usize = 4096;

/// What a [`Decimator`](super::decimate::Decimator) must do: what lies below the pass edge comes through within the ripple; what lies above the stop edge, with all that
/// would be folded below it, is suppressed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Decimation {
    /// Samples a second of the input (Hz).
    #[serde(with = "bits")]
    pub sample_rate: f64,
    /// Samples of the input a sample of the output, 1 to 4096.
    pub factor: usize,
    /// Where the pass band ends (Hz).
    #[serde(with = "bits")]
    pub pass_edge: f64,
    /// Where the stop band begins (Hz), at most the output's rate less the pass edge.
    #[serde(with = "bits")]
    pub stop_edge: f64,
    /// How far the stop band is suppressed (dB), 20 to 150.
    #[serde(with = "bits")]
    pub attenuation: f64,
    /// The largest deviation of the gain from 1 in the pass band, 1e-7 to 0.01.
    #[serde(with = "bits")]
    pub ripple: f64,
}

impl Decimation {
    /// 80 dB of suppression above 1.24 times the pass edge, a gain of 1 to a hundredth of a per cent below the pass edge.
    #[must_use]
    pub fn new(sample_rate: f64, pass_edge: f64, factor: usize) -> Self {
        Self { sample_rate, factor, pass_edge, stop_edge: 1.24 * pass_edge, attenuation: 80.0, ripple: 1e-4 }
    }

    /// The largest factor that leaves at least `output_rate` samples a second; 1 where there is none.
    #[must_use]
    pub fn factor_to(sample_rate: f64, output_rate: f64) -> usize {
        // a rate that is met up to rounding is met
        let factor = (sample_rate / output_rate * (1.0 + 1e-9)).floor();
        if factor >= 1.0 { (factor as usize).min(LARGEST_FACTOR) } else { 1 }
    }

    pub(super) fn check(&self) -> Result<(), SignalError> {
        positive("the sample rate", self.sample_rate)?;
        positive("the edge of the pass band", self.pass_edge)?;
        within("the factor between the rates", self.factor as f64, 1.0, LARGEST_FACTOR as f64)?;
        within("the attenuation in dB", self.attenuation, 20.0, 150.0)?;
        within("the ripple of the pass band", self.ripple, 1e-7, 0.01)?;
        let output_rate = self.sample_rate / self.factor as f64;
        let limit = (output_rate - self.pass_edge).min(0.5 * self.sample_rate);
        if self.stop_edge > self.pass_edge && self.stop_edge <= limit {
            Ok(())
        } else {
            Err(SignalError::BandEdges { pass_edge: self.pass_edge, stop_edge: self.stop_edge, limit })
        }
    }
}
