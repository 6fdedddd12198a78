//! Random numbers as a signal within a band of frequencies.

use crate::NonsmoothError;
use judder_numerics::counter::uniform;
use std::f64::consts::{PI, TAU};

/// Numbers to either side that make a value.
const REACH: usize = 32;

/// x(t) = Re (e^{i ω_m t} Σ c_n w(B t − n)), with ω_m amid the band, B its width in Hz, c_n complex numbers of a normal distribution, each drawn from its place
/// n alone, and w a cardinal sine in Blackman's window of 32 numbers to either side.
///
/// A function of time alone. Its spectral density is even within the band, a quarter of that at its edges, and next to none beyond a twentieth of the band's width outside of it.
#[derive(Debug, Clone, PartialEq)]
pub struct BandNoise {
    /// Root mean square.
    pub rms: f64,
    /// The band in rad/s.
    pub band: [f64; 2],
    /// Which numbers: the same seed gives the same signal.
    pub seed: u64,
    /// Numbers that were drawn, the place of the first.
    drawn: Vec<[f64; 2]>,
    first: u64,
    /// What the mean square of a value is for numbers of one.
    norm: f64,
}

impl BandNoise {
    /// Of this root mean square within a band in rad/s.
    #[must_use]
    pub fn new(rms: f64, band: [f64; 2], seed: u64) -> Self {
        let drawn = (0..2 * REACH as u64).map(|place| number(seed, place)).collect();
        Self { rms, band, seed, drawn, first: 0, norm: norm() }
    }

    pub(super) fn check(&self) -> Result<(), NonsmoothError> {
        let refused =
            |name, value, requirement| Err(NonsmoothError::InvalidNumber { name, value, requirement });
        let [from, to] = self.band;
        if !(self.rms.is_finite() && self.rms >= 0.0) {
            return refused("the root mean square of a random signal", self.rms, "finite and not negative");
        }
        if !(from.is_finite() && from >= 0.0) {
            return refused("the lowest frequency of a random signal", from / TAU, "finite and not negative");
        }
        if !(to.is_finite() && to > from) {
            return refused(
                "the highest frequency of a random signal",
                to / TAU,
                "above the lowest, and finite",
            );
        }
        Ok(())
    }

    /// Its value at a time in s.
    pub(super) fn at(&mut self, time: f64) -> f64 {
        let [from, to] = self.band;
        let place = time.max(0.0) * (to - from) / TAU;
        let (first, share) = (place.floor() as u64, place.fract());
        self.draw(first);
        let mut sums = [0.0; 2];
        each_weight(share, |k, weight| {
            sums[0] += weight * self.drawn[k][0];
            sums[1] += weight * self.drawn[k][1];
        });
        let (sine, cosine) = libm::sincos(0.5 * (from + to) * time);
        self.rms * (sums[0] * cosine - sums[1] * sine) / self.norm
    }

    /// Has the numbers from this place on.
    fn draw(&mut self, first: u64) {
        if first == self.first {
            return;
        }
        let known = 2 * REACH as u64;
        if first == self.first + 1 {
            self.drawn.rotate_left(1);
            self.drawn[2 * REACH - 1] = number(self.seed, first + known - 1);
        } else {
            self.drawn.iter_mut().zip(first..).for_each(|(own, place)| *own = number(self.seed, place));
        }
        self.first = first;
    }
}

/// A complex number whose parts have the variance 1, after G. E. P. Box and M. E. Muller, Ann. Math. Stat. 29 (1958).
fn number(seed: u64, place: u64) -> [f64; 2] {
    let (size, angle) = (1.0 - uniform(seed, 2 * place), TAU * uniform(seed, 2 * place + 1));
    let size = (-2.0 * libm::log(size)).sqrt();
    let (sine, cosine) = libm::sincos(angle);
    [size * cosine, size * sine]
}

/// The weight of each number for a value that lies by this share beyond the one amid them.
#[inline(always)]
fn each_weight(share: f64, mut take: impl FnMut(usize, f64)) {
    if share == 0.0 {
        return take(REACH - 1, 1.0);
    }
    let reach = REACH as f64;
    // sin π (s − j) and cos π (s − j)/R of the first number, j = 1 − R, and how these go on
    let mut sine = libm::sin(PI * share) * if REACH.is_multiple_of(2) { -1.0 } else { 1.0 };
    let (turn_sine, turn_cosine) = libm::sincos(PI / reach);
    let (mut window_sine, mut window) = libm::sincos(PI * (share + reach - 1.0) / reach);
    for k in 0..2 * REACH {
        // the share last: it may be less than the rounding of the others
        let distance = (reach - 1.0 - k as f64) + share;
        // 0.42 + 0.5 cos + 0.08 cos of the double angle
        let blackman = 0.34 + 0.5 * window + 0.16 * window * window;
        take(k, sine / (PI * distance) * blackman);
        sine = -sine;
        (window_sine, window) =
            (window_sine * turn_cosine - window * turn_sine, window * turn_cosine + window_sine * turn_sine);
    }
}

/// √ of the mean over all shares of the sum of squared weights.
fn norm() -> f64 {
    const SHARES: u32 = 64;
    let mut sum = 0.0;
    for k in 0..SHARES {
        each_weight(f64::from(k) / f64::from(SHARES), |_, weight| sum += weight * weight);
    }
    (sum / f64::from(SHARES)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(seed: u64) -> BandNoise {
        BandNoise::new(0.5, [100.0, 200.0].map(|frequency| TAU * frequency), seed)
    }

    /// Over 40000 independent numbers the root mean square is known to a third of a percent.
    #[test]
    fn it_has_its_root_mean_square() {
        let mut own = noise(7);
        let count = 400_000;
        let square = (0..count).map(|k| own.at(1e-3 * f64::from(k)).powi(2)).sum::<f64>() / f64::from(count);
        assert!((square.sqrt() / 0.5 - 1.0).abs() < 0.01, "{}", square.sqrt());
        assert_eq!(BandNoise::new(0.0, own.band, 1).at(0.1), 0.0);
        // beside a number itself by less than rounding
        assert!((own.at(f64::EPSILON) - own.at(0.0)).abs() < 1e-9 && own.at(1e-300).is_finite());
    }

    /// Power at frequencies, by a sum over samples in Hann's window, which leaks less than is looked for.
    #[test]
    fn it_has_its_band() {
        let (mut own, count, rate) = (noise(3), 8192, 1000.0);
        let window = |k: usize| 0.5 - 0.5 * (TAU * k as f64 / count as f64).cos();
        let samples: Vec<f64> = (0..count).map(|k| window(k) * own.at(k as f64 / rate)).collect();
        let power = |frequency: f64| {
            let turned = |k: usize| TAU * frequency * k as f64 / rate;
            let sums = samples.iter().enumerate().fold([0.0; 2], |[re, im], (k, value)| {
                [re + value * turned(k).cos(), im + value * turned(k).sin()]
            });
            sums[0] * sums[0] + sums[1] * sums[1]
        };
        let mean = |from: f64, to: f64| {
            (0..60).map(|k| power(from + (to - from) * f64::from(k) / 60.0)).sum::<f64>() / 60.0
        };
        let within = [mean(105.0, 125.0), mean(140.0, 160.0), mean(175.0, 195.0)];
        assert!(within.iter().all(|own| (own / within[1] - 1.0).abs() < 0.6), "{within:?}");
        for (from, to) in [(0.0, 94.0), (206.0, 500.0)] {
            assert!(mean(from, to) < 1e-6 * within[1], "{from}: {} of {}", mean(from, to), within[1]);
        }
    }

    /// In any order, with any steps: a value depends on its time alone.
    #[test]
    fn it_is_a_function_of_time_alone() {
        let values = |step: usize| -> Vec<u64> {
            let mut own = noise(11);
            (0..6000).step_by(step).map(|k| own.at(1e-4 * f64::from(k)).to_bits()).collect()
        };
        let every = values(1);
        for step in [2, 3, 500, 5999] {
            assert!(values(step).iter().zip(every.iter().step_by(step)).all(|(a, b)| a == b), "{step}");
        }
        let mut back = noise(11);
        assert!((0..6000).rev().all(|k| back.at(1e-4 * k as f64).to_bits() == every[k as usize]));
        assert_ne!(noise(12).at(0.1), noise(11).at(0.1));
    }

    #[test]
    fn bands_that_are_none_are_refused() {
        let refused = |rms: f64, band: [f64; 2]| {
            BandNoise::new(rms, band.map(|frequency| TAU * frequency), 1).check().unwrap_err().to_string()
        };
        assert!(refused(-1.0, [1.0, 2.0]).contains("the root mean square of a random signal is -1"));
        assert!(refused(1.0, [-1.0, 2.0]).contains("the lowest frequency of a random signal is -1"));
        assert!(
            refused(1.0, [2.0, 2.0])
                .contains("the highest frequency of a random signal is 2: it must be above the lowest")
        );
    }
}
