//! The amplitude of a signal in a narrow band about a frequency.

use judder_numerics::signal::window::Window;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// How long the window is, s: it keeps out what lies further than twice its inverse from the frequency.
pub(super) const WINDOW: f64 = 10e-3;

/// A Hann window that is turned with a frequency.
pub(super) struct Band {
    weights: Vec<Complex64>,
}

impl Band {
    /// About a frequency in Hz, for samples at this interval in s.
    pub(super) fn new(frequency: f64, interval: f64) -> Self {
        let window = Window::Hann.weights((WINDOW / interval).round() as usize);
        let sum: f64 = window.iter().sum();
        let turned = |(k, weight): (usize, f64)| {
            Complex64::from_polar(2.0 * weight / sum, -TAU * frequency * k as f64 * interval)
        };
        Self { weights: window.into_iter().enumerate().map(turned).collect() }
    }

    /// |2 Σ w_k y_k e^{−iωt_k}|/Σ w_k about a sample: the amplitude of a sine of the frequency; NaN where the signal does not fill the window.
    pub(super) fn amplitude(&self, values: &[f64], middle: usize) -> f64 {
        let first = middle.checked_sub(self.weights.len() / 2);
        let piece = first.and_then(|first| values.get(first..first + self.weights.len()));
        let sum = |piece: &[f64]| piece.iter().zip(&self.weights).map(|(y, w)| y * w).sum::<Complex64>();
        piece.map_or(f64::NAN, |piece| sum(piece).norm())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sine has its amplitude, a click and a sine half a kilohertz away leave nothing of their own.
    #[test]
    fn it_hears_its_frequency_alone() {
        let interval = 2.4e-6;
        let at = |k: usize| k as f64 * interval;
        let sine = |frequency: f64| move |k: usize| 3.0 * (TAU * frequency * at(k)).cos();
        let own: Vec<f64> = (0..10_000).map(sine(3.5e3)).collect();
        let other: Vec<f64> = (0..10_000).map(sine(4e3)).collect();
        let band = Band::new(3.5e3, interval);
        assert!((band.amplitude(&own, 5000) - 3.0).abs() < 1e-3);
        assert!(band.amplitude(&other, 5000) < 0.03);
        let mut click = vec![0.0; 10_000];
        click[5000] = 3.0;
        assert!(band.amplitude(&click, 5000) < 0.01);
        assert!(band.amplitude(&own, 100).is_nan() && band.amplitude(&own, 9_999).is_nan());
    }
}
