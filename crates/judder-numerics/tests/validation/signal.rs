//! Signals of known content: sines, chirps, noise.

mod allocations;
mod bursts;
mod decimate;
mod means;
mod resample;
mod spectrogram;

use judder_numerics::counter::uniform;
use std::f64::consts::TAU;

/// Noise of unit variance, nearly normal: the sum of twelve even numbers.
fn noise(seed: u64, count: usize) -> impl Iterator<Item = f64> {
    (0..count as u64).map(move |n| (0..12).map(|k| uniform(seed, 12 * n + k)).sum::<f64>() - 6.0)
}

/// The amplitude of a signal at a frequency (in parts of its rate), by projection on sine and cosine over its length under Hann's window.
fn amplitude(signal: &[f64], frequency: f64) -> f64 {
    let length = signal.len() as f64;
    let (mut cosine, mut sine) = (0.0, 0.0);
    for (n, x) in signal.iter().enumerate() {
        let weight = (0.5 * TAU * (n as f64 + 0.5) / length).sin().powi(2);
        cosine += weight * x * (TAU * frequency * n as f64).cos();
        sine += weight * x * (TAU * frequency * n as f64).sin();
    }
    4.0 * cosine.hypot(sine) / length
}
