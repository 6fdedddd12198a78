//! Means over the time of a sample: fewer samples of a signal that jumps.

use super::bits;
use super::decimate::Decimator;
use serde::{Deserialize, Serialize};

/// Means of some signals over as many samples as a [`Decimator`] takes for one of its own, about the times of its outputs.
///
/// x̄ₖ = 1/n Σ x over the n samples about the k-th output. A mean lies between the least and the largest of its samples, so what jumps does not
/// ring, as it does behind a low-pass filter; and n x̄ₖ summed is the sum of the samples: a force keeps its impulse. A line at the frequency
/// f comes through by sin(π f T)/(π f T), T the time between two means; what lies above 1/(2 T) is folded below it by as much.
///
/// ```
/// use judder_numerics::signal::{Decimation, decimate::Decimator, means::WindowMeans};
/// let filter = Decimator::new(&Decimation::new(1e6, 50e3, 4), &[0.0])?;
/// let mut means = WindowMeans::beside(&filter, 1);
/// (0..4000).for_each(|step| means.push(&[if step < 2000 { 0.0 } else { 1.0 }]));
/// let mut mean = [0.0];
/// means.take(&mut mean);
/// assert_eq!(mean, [0.0]);
/// # Ok::<(), judder_numerics::signal::SignalError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WindowMeans {
    factor: u64,
    /// Samples by which an output lies before the sample with which it comes.
    delay: u64,
    samples: u64,
    #[serde(with = "bits::many")]
    sums: Vec<f64>,
    /// Samples in the sums.
    summed: u64,
    /// Means that wait for their outputs, one after the other.
    #[serde(with = "bits::many")]
    waiting: Vec<f64>,
}

impl WindowMeans {
    /// Of so many signals, beside what a filter does with others.
    #[must_use]
    pub fn beside(filter: &Decimator, signals: usize) -> Self {
        Self {
            factor: filter.factor() as u64,
            delay: filter.delay_in_samples() as u64,
            samples: 0,
            sums: vec![0.0; signals],
            summed: 0,
            waiting: Vec::new(),
        }
    }

    /// How many signals there are.
    #[must_use]
    pub fn signals(&self) -> usize {
        self.sums.len()
    }

    /// Takes a sample of each signal in.
    pub fn push(&mut self, samples: &[f64]) {
        self.sums.iter_mut().zip(samples).for_each(|(sum, sample)| *sum += sample);
        self.summed += 1;
        // the window of the k-th output, which lies at k·factor − delay, begins as many samples before it
        let before = (self.factor - 1) / 2;
        let placed = self.samples + self.delay + before;
        self.samples += 1;
        if (placed + 1).is_multiple_of(self.factor) {
            let output = placed / self.factor * self.factor;
            // outputs before the first sample show the level from which the filter started
            if output >= self.delay {
                self.waiting.extend(self.sums.iter().map(|sum| sum / self.summed as f64));
            }
            self.sums.fill(0.0);
            self.summed = 0;
        }
    }

    /// Gives the mean of each signal for the next output that does not lie before the first sample; where the samples have ended amid its time,
    /// that of those there were.
    pub fn take(&mut self, means: &mut [f64]) {
        let signals = self.signals().min(means.len());
        if self.waiting.len() >= self.signals() {
            means[..signals].copy_from_slice(&self.waiting[..signals]);
            self.waiting.drain(..self.signals());
        } else {
            means.iter_mut().zip(&self.sums).for_each(|(mean, sum)| *mean = sum / self.summed.max(1) as f64);
        }
    }
}
