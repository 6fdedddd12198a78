//! A signal at another sample rate, any from any.

use super::error::{SignalError, finite, within};
use super::fir::sinc;
use super::kaiser;
use std::f64::consts::TAU;

/// The part of half the lower rate up to which a signal comes through: 20 kHz at 48 kHz.
const PASS_PART: f64 = 5.0 / 6.0;

/// By how much what lies above half the lower rate is suppressed (dB), with the margin of Kaiser's fit.
const ATTENUATION: f64 = 105.0;

/// Values of the filter's response between two of its zeros; what lies between these is interpolated, with an error below −125 dB.
const FINENESS: f64 = 1024.0;

/// The highest and the lowest rate (Hz), and the most samples of an answer.
const RATES: (f64, f64) = (1.0, 1e9);
const MOST_SAMPLES: usize = 1 << 28;

/// The signal at another sample rate: from 0 to 5/6 of half the lower rate unchanged within 0.001 %, above half the lower rate suppressed by
/// 100 dB, without delay. At 48 kHz that is all up to 20 kHz, and nothing above 24 kHz folded onto it.
///
/// The k-th sample is the signal at the time k/`to` after its first, as far as the signal lasts. Before its first and after its last sample the
/// signal is taken as zero.
///
/// Band-limited interpolation: y(t) = Σ_n x_n g(t f − n), with the windowed response g of [`kaiser`] (J. O. Smith and P. Gossett, *A flexible
/// sampling-rate conversion method*, Proc. IEEE ICASSP 1984, 19.4.1–19.4.4).
///
/// # Errors
/// Rates outside 1 Hz to 1 GHz, a sample that is not finite, an answer that would not fit into memory.
pub fn resampled(signal: &[f64], from: f64, to: f64) -> Result<Vec<f64>, SignalError> {
    within("the rate of the signal", from, RATES.0, RATES.1)?;
    within("the rate asked for", to, RATES.0, RATES.1)?;
    finite(signal)?;
    let Some(last) = signal.len().checked_sub(1) else { return Ok(Vec::new()) };
    let step = from / to;
    let count = (last as f64 / step * (1.0 + f64::EPSILON)).floor() + 1.0;
    if count > MOST_SAMPLES as f64 {
        return Err(SignalError::TooLarge { what: "the signal", values: count, most: MOST_SAMPLES });
    }
    let response = Response::new(from, to);
    Ok((0..count as usize).map(|k| response.sum(signal, k as f64 * step)).collect())
}

/// The response of the filter, an even function, on a fine grid.
struct Response {
    values: Vec<f64>,
    /// Grid points a sample of the signal.
    fineness: f64,
    /// Half its length, in samples of the signal.
    half: f64,
}

impl Response {
    fn new(from: f64, to: f64) -> Self {
        // in parts of the signal's rate
        let stop = 0.5 * (to / from).min(1.0);
        let pass = PASS_PART * stop;
        let half = 0.5 * kaiser::order(ATTENUATION, TAU * (stop - pass));
        let cut = stop + pass;
        let fineness = FINENESS * cut;
        let shape = kaiser::shape(ATTENUATION);
        let at = |n: usize| {
            let place = n as f64 / fineness;
            cut * sinc(cut * place) * kaiser::window(shape, place / half)
        };
        // two more for the interpolation beyond the end, where the window is zero
        let values = (0..(half * fineness) as usize + 3).map(at).collect();
        Self { values, fineness, half }
    }

    /// Σ x_n g(`place` − n).
    fn sum(&self, signal: &[f64], place: f64) -> f64 {
        let first = (place - self.half).ceil().max(0.0) as usize;
        let behind = ((place + self.half).floor() as usize + 1).min(signal.len());
        let term = |(n, x): (usize, &f64)| {
            let at = (place - (first + n) as f64).abs() * self.fineness;
            let whole = at as usize;
            let [here, next] = [self.values[whole], self.values[whole + 1]];
            x * (here + (at - whole as f64) * (next - here))
        };
        signal[first.min(behind)..behind].iter().enumerate().map(term).sum()
    }
}
