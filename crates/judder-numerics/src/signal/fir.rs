//! Low-pass filters of finite impulse response and linear phase.

use super::error::{SignalError, positive, within};
use super::kaiser;
use crate::decade::power_of_ten;
use std::f64::consts::{PI, TAU};

/// The most taps of one filter.
const MOST_TAPS: usize = 1 << 16;

/// Tries at a quarter of a dB more each.
const MOST_QUARTERS: u32 = 200;

/// By how much less than allowed the ripples must be at the frequencies that are looked at: a crest between two of them is up to a hundredth higher.
const BETWEEN_FREQUENCIES: f64 = 0.98;

/// What a low-pass filter must do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LowPass {
    /// Samples a second (Hz).
    pub sample_rate: f64,
    /// Where the pass band ends (Hz).
    pub pass_edge: f64,
    /// Where the stop band begins (Hz).
    pub stop_edge: f64,
    /// How far the stop band lies below the pass band (dB); the ripple of the pass band is as small: ±10^(−A/20).
    pub attenuation: f64,
}

impl LowPass {
    /// The taps h: an odd number, symmetric, their sum 1, so that a constant passes unchanged.
    ///
    /// h_n = 2 (f_c/f_s) sinc(2 (f_c/f_s) m) w(m), m = n − (taps − 1)/2, with the cut-off f_c in the middle of the transition and
    /// w the window of [`kaiser`]. Kaiser's formulas are fits: they are asked for a quarter of a dB more, until the response beside both edges,
    /// where the ripples are highest, is computed to keep what was asked.
    ///
    /// # Errors
    /// Values that are not positive, an attenuation outside 20 to 180 dB, band edges out of order or above half the sample rate,
    /// [`SignalError::TooManyTaps`].
    pub fn taps(&self) -> Result<Vec<f64>, SignalError> {
        self.check()?;
        for quarters in 0..MOST_QUARTERS {
            let designed = Self { attenuation: self.attenuation + 0.25 * f64::from(quarters), ..*self };
            let half = (0.5 * (designed.cost() - 1.0)).ceil();
            if 2.0 * half > MOST_TAPS as f64 {
                return Err(self.too_many(2.0 * half));
            }
            let taps = designed.windowed(half as usize);
            if self.is_met(&taps) {
                return Ok(taps);
            }
        }
        // no bands within the limits came here yet; what would is as hopeless as a filter without end
        Err(self.too_many(f64::INFINITY))
    }

    /// Taps by Kaiser's formula, not rounded: what the filter costs, without designing it.
    pub(crate) fn cost(&self) -> f64 {
        kaiser::order(self.attenuation, self.transition()) + 1.0
    }

    /// The width of the transition, in radians a sample.
    fn transition(&self) -> f64 {
        TAU * (self.stop_edge - self.pass_edge) / self.sample_rate
    }

    fn check(&self) -> Result<(), SignalError> {
        positive("the sample rate", self.sample_rate)?;
        positive("the edge of the pass band", self.pass_edge)?;
        positive("the edge of the stop band", self.stop_edge)?;
        within("the attenuation in dB", self.attenuation, 20.0, 180.0)?;
        let limit = 0.5 * self.sample_rate;
        if self.pass_edge >= self.stop_edge || self.stop_edge > limit {
            let (pass_edge, stop_edge) = (self.pass_edge, self.stop_edge);
            return Err(SignalError::BandEdges { pass_edge, stop_edge, limit });
        }
        Ok(())
    }

    fn too_many(&self, taps: f64) -> SignalError {
        let Self { sample_rate, pass_edge, stop_edge, .. } = *self;
        SignalError::TooManyTaps { pass_edge, stop_edge, sample_rate, taps, most: MOST_TAPS }
    }

    /// The windowed impulse response with `half` taps on either side of the middle one.
    fn windowed(&self, half: usize) -> Vec<f64> {
        let cut = (self.pass_edge + self.stop_edge) / self.sample_rate;
        let shape = kaiser::shape(self.attenuation);
        let one = |place: usize| {
            let from_middle = place as f64 - half as f64;
            cut * sinc(cut * from_middle) * kaiser::window(shape, from_middle / (half as f64 + 1.0))
        };
        let mut taps: Vec<f64> = (0..=half).map(one).collect();
        let sum = 2.0 * taps[..half].iter().sum::<f64>() + taps[half];
        taps.iter_mut().for_each(|tap| *tap /= sum);
        taps.extend_from_within(..half);
        taps[half + 1..].reverse();
        taps
    }

    /// Whether the response keeps both bands, at 32 frequencies a ripple over thirty ripples beside the edges.
    fn is_met(&self, taps: &[f64]) -> bool {
        let ripple = power_of_ten(-self.attenuation / 20.0) * BETWEEN_FREQUENCIES;
        // a ripple is f_s/taps wide
        let fine = self.sample_rate / (32.0 * taps.len() as f64);
        let nyquist = 0.5 * self.sample_rate;
        (0..960).map(|k| f64::from(k) * fine).all(|off| {
            let passed = response(taps, (self.pass_edge - off).max(0.0) / self.sample_rate);
            let stopped = response(taps, (self.stop_edge + off).min(nyquist) / self.sample_rate);
            (passed - 1.0).abs() <= ripple && stopped.abs() <= ripple
        })
    }
}

/// sin(πx)/(πx).
pub(crate) fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { libm::sin(PI * x) / (PI * x) }
}

/// The response of symmetric taps, an odd number of them, at a `frequency` in parts of the sample rate; real, once the delay of
/// (taps − 1)/2 samples is taken off.
#[must_use]
pub fn response(taps: &[f64], frequency: f64) -> f64 {
    let half = taps.len() / 2;
    let pairs = taps[..half].iter().rev().zip(1..);
    let sum: f64 = pairs.map(|(tap, k)| 2.0 * tap * libm::cos(TAU * frequency * f64::from(k))).sum();
    sum + taps.get(half).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]
        /// The response over both bands, on a grid of its own.
        #[test]
        fn both_bands_keep_what_was_asked(pass in 0.01..0.3_f64, width in 0.02..0.15_f64, attenuation in 40.0..130.0_f64) {
            let asked = LowPass { sample_rate: 1.0, pass_edge: pass, stop_edge: pass + width, attenuation };
            let taps = asked.taps().unwrap();
            let ripple = 10_f64.powf(-attenuation / 20.0);
            prop_assert_eq!(taps.len() % 2, 1);
            prop_assert!((taps.iter().sum::<f64>() - 1.0).abs() < 1e-13);
            for k in 0..=1000 {
                let part = f64::from(k) / 1000.0;
                let passed = response(&taps, pass * part);
                let stopped = response(&taps, pass + width + (0.5 - pass - width) * part);
                prop_assert!((passed - 1.0).abs() < 1.001 * ripple, "{passed} at {}", pass * part);
                prop_assert!(stopped.abs() < 1.001 * ripple, "{stopped} at {part} of the stop band");
            }
            // Kaiser's length, and more of it where the pass band is narrower than the transition
            prop_assert!((taps.len() as f64) < 1.3 * asked.cost() + 8.0, "{} {}", taps.len(), asked.cost());
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// Bands as odd as they come end in a filter.
        #[test]
        fn any_bands_end_in_a_filter(pass in -5.0..-0.31_f64, part in 0.01..1.0_f64, attenuation in 20.0..180.0_f64) {
            let pass_edge = 10_f64.powf(pass);
            let stop_edge = pass_edge + part * (0.5 - pass_edge);
            prop_assume!(stop_edge - pass_edge > 1e-3);
            let taps = LowPass { sample_rate: 1.0, pass_edge, stop_edge, attenuation }.taps();
            prop_assert!(taps.is_ok(), "{taps:?}");
        }
    }

    #[test]
    fn nonsense_is_refused() {
        let good = LowPass { sample_rate: 1000.0, pass_edge: 100.0, stop_edge: 150.0, attenuation: 80.0 };
        let refused = |bad: LowPass| bad.taps().unwrap_err();
        assert!(matches!(
            refused(LowPass { sample_rate: f64::NAN, ..good }),
            SignalError::NotPositive { .. }
        ));
        assert!(matches!(refused(LowPass { stop_edge: 100.0, ..good }), SignalError::BandEdges { .. }));
        assert!(matches!(refused(LowPass { stop_edge: 501.0, ..good }), SignalError::BandEdges { .. }));
        assert!(matches!(refused(LowPass { attenuation: 0.0, ..good }), SignalError::OutOfRange { .. }));
        let close = LowPass { stop_edge: 100.000_01, ..good };
        assert!(matches!(refused(close), SignalError::TooManyTaps { .. }));
    }
}
