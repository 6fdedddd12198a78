//! A signal at another sample rate, any from any.

use super::error::{SignalError, finite, within};
use super::fir::sinc;
use super::kaiser;
use multiversion::multiversion;
use std::f64::consts::TAU;

/// The part of half the lower rate up to which a signal comes through: 20 kHz at 48 kHz.
const PASS_PART: f64 = 5.0 / 6.0;

/// By how much what lies above half the lower rate is suppressed (dB), with the margin of Kaiser's fit.
const ATTENUATION: f64 = 105.0;

/// Values of the filter's response between two of its zeros, at least; what lies between these is interpolated, with an error below −125 dB.
const FINENESS: f64 = 1024.0;

/// Terms that are added side by side: the order of a sum is the same at every vector width.
const LANES: usize = 16;

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
    let response = FilterResponse::new(from, to, signal.len());
    Ok((0..count as usize).map(|k| response.sum(signal, k as f64 * step)).collect())
}

/// The response of the filter at all samples around a place, for places on a fine grid between two samples.
struct FilterResponse {
    /// Row after row, each a place further by 1/`phases` of a sample than the one before; the last row is a whole sample away from the
    /// first.
    rows: Vec<f64>,
    /// Rows a sample.
    phases: usize,
    /// How many samples before the one at or before the place a row begins.
    reach: usize,
    /// Values a row, a multiple of [`LANES`].
    length: usize,
}

impl FilterResponse {
    /// The response for signals of at most `longest` samples.
    fn new(from: f64, to: f64, longest: usize) -> Self {
        // in parts of the signal's rate
        let stop = 0.5 * (to / from).min(1.0);
        let pass = PASS_PART * stop;
        let half = 0.5 * kaiser::order(ATTENUATION, TAU * (stop - pass));
        let cut = stop + pass;
        let shape = kaiser::shape(ATTENUATION);
        let response = |place: f64| {
            let inside = place.abs() <= half;
            if inside { cut * sinc(cut * place) * kaiser::window(shape, place / half) } else { 0.0 }
        };
        let phases = (FINENESS * cut).ceil() as usize;
        let reach = (half.ceil() as usize).min(longest);
        let length = (2 * reach + 2).next_multiple_of(LANES);
        let row = |phase: usize| {
            let place = reach as f64 + phase as f64 / phases as f64;
            (0..length).map(move |n| response(place - n as f64))
        };
        Self { rows: (0..=phases).flat_map(row).collect(), phases, reach, length }
    }

    /// Σ x_n g(`place` − n), linear between two rows.
    fn sum(&self, signal: &[f64], place: f64) -> f64 {
        let before = place.floor();
        let phase = (place - before) * self.phases as f64;
        let row = (phase as usize).min(self.phases - 1);
        let rows = &self.rows[row * self.length..][..2 * self.length];
        // the part of the row whose samples there are
        let before = before as usize;
        let skipped = self.reach.saturating_sub(before);
        let first = before.saturating_sub(self.reach).min(signal.len());
        let taken = &signal[first..(before + self.length - self.reach).min(signal.len())];
        let (here, next) = rows.split_at(self.length);
        let [here, next] = [here, next].map(|row| weighted(&row[skipped..], taken));
        here + (phase - row as f64) * (next - here)
    }
}

/// Σ w_n x_n over the values that there are, in partial sums.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2", "aarch64+neon"))]
fn weighted(weights: &[f64], values: &[f64]) -> f64 {
    let mut parts = [0.0; LANES];
    let (weights, values) = (weights.chunks(LANES), values.chunks(LANES));
    for (weights, values) in weights.zip(values) {
        for (part, (weight, value)) in parts.iter_mut().zip(weights.iter().zip(values)) {
            *part += weight * value;
        }
    }
    let mut width = LANES / 2;
    while width > 0 {
        for lane in 0..width {
            parts[lane] += parts[lane + width];
        }
        width /= 2;
    }
    parts[0]
}
