//! The amplitude of a signal in a narrow band about a frequency, and by how much a mode grows in a zone.

use judder_numerics::complex::ElementaryComplex;
use judder_numerics::signal::window::Window;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// How long the window is, s: it keeps out what lies further than twice its inverse from the frequency.
pub(crate) const WINDOW: f64 = 10e-3;

/// A Hann window that is turned with a frequency.
pub struct Band {
    weights: Vec<Complex64>,
}

impl Band {
    /// About a frequency in Hz, for samples at this interval in s.
    pub fn new(frequency: f64, interval: f64) -> Self {
        let window = Window::Hann.weights((WINDOW / interval).round() as usize);
        let sum: f64 = window.iter().sum();
        let turned = |(k, weight): (usize, f64)| {
            judder_numerics::complex::from_polar(2.0 * weight / sum, -TAU * frequency * k as f64 * interval)
        };
        Self { weights: window.into_iter().enumerate().map(turned).collect() }
    }

    /// |2 Σ w_k y_k e^{−iωt_k}|/Σ w_k about a sample: the amplitude of a sine of the frequency; NaN where the signal does not fill
    /// the window, or no sample lies in it.
    pub fn amplitude(&self, values: &[f64], middle: usize) -> f64 {
        let first = middle.checked_sub(self.weights.len() / 2);
        let piece = first.and_then(|first| values.get(first..first + self.weights.len()));
        let sum = |piece: &[f64]| piece.iter().zip(&self.weights).map(|(y, w)| y * w).sum::<Complex64>();
        piece.filter(|piece| !piece.is_empty()).map_or(f64::NAN, |piece| sum(piece).modulus())
    }
}

/// A signal of a march, sampled evenly.
#[derive(Debug, Clone, Copy)]
pub struct Sampled<'a> {
    /// s.
    pub time: &'a [f64],
    /// Of the contact, m; it rises or falls.
    pub position: &'a [f64],
    /// What is sampled at those times.
    pub values: &'a [f64],
}

impl Sampled<'_> {
    /// The first sample at which the contact has come to a place.
    pub fn sample(&self, place: f64) -> usize {
        let is_rising = self.position.first() <= self.position.last();
        self.position.partition_point(|own| if is_rising { *own < place } else { *own > place })
    }

    /// A band for its samples about a frequency in Hz; `None` for fewer than two.
    pub fn band(&self, frequency: f64) -> Option<Band> {
        Some(Band::new(frequency, self.time.get(1)? - self.time.first()?))
    }

    /// The amplitudes of a frequency in Hz where the contact enters a stretch and where it leaves it; `None` where the signal does not
    /// reach half a window beyond both.
    pub fn passage(&self, frequency: f64, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
        let band = self.band(frequency)?;
        let mut ends = [self.sample(from), self.sample(to)];
        ends.sort_unstable();
        let amplitudes = ends.map(|sample| band.amplitude(self.values, sample));
        amplitudes.iter().all(|own| own.is_finite()).then_some(amplitudes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mode that grows e²-fold in a stretch has done so for a contact that goes either way; a stretch at the edge of the signal is not told.
    #[test]
    fn a_mode_grows_in_a_stretch() {
        let interval = 5e-6;
        let time: Vec<f64> = (0..40_000).map(|k| f64::from(k) * interval).collect();
        let ahead: Vec<f64> = time.iter().map(|t| 0.03 * t).collect();
        let back: Vec<f64> = time.iter().map(|t| 6e-3 - 0.03 * t).collect();
        // e² in 67 ms, from 67 ms on
        let grown = |t: &f64| (2.0 * ((t - 0.0667) / 0.0667).clamp(0.0, 1.0)).exp();
        let values: Vec<f64> = time.iter().map(|t| grown(t) * (TAU * 3.5e3 * t).cos()).collect();
        for (position, stretch) in [(&ahead, [2e-3, 4e-3]), (&back, [2e-3, 4e-3])] {
            let sampled = Sampled { time: &time, position, values: &values };
            let [before, after] = sampled.passage(3.5e3, stretch).unwrap();
            assert!(((after / before).ln() - 2.0).abs() < 0.1, "{before} {after}");
            assert_eq!(sampled.passage(3.5e3, [0.1e-3, 4e-3]), None);
        }
    }

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
        assert!(Band::new(3.5, 0.1).amplitude(&own, 5000).is_nan(), "no sample in the window");
        assert!(band.amplitude(&own, 100).is_nan() && band.amplitude(&own, 9_999).is_nan());
    }
}
