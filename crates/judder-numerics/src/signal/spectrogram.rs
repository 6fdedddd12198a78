//! Levels over time and frequency: the short-time Fourier transform.

use super::error::{SignalError, finite, positive, within};
use super::spectrum::Transform;
use super::window::Window;
use num_complex::Complex64;

/// The most levels of one spectrogram: a gibibyte of them.
const MOST_LEVELS: usize = 1 << 27;

/// The shortest piece, in samples.
pub const SHORTEST_PIECE: usize = 8;

/// The longest piece.
const LONGEST_PIECE: usize = 1 << 24;

/// What the levels are levels of; spectra are one-sided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LevelKind {
    /// 20 log10(a/a_0), a the amplitude (peak, not rms): a sine of amplitude a shows it at its frequency, whatever the window. Noise rises
    /// with the width of the window's lines.
    #[default]
    Amplitude,
    /// 10 log10(S/S_0), S the power density (unit squared over Hz), S_0 = a_0² over 1 Hz: noise shows it, whatever the window. A sine rises
    /// with the length of the window. ∫ S df is the mean square.
    PowerDensity,
}

/// How a spectrogram is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectrogramSettings {
    /// Samples a second (Hz).
    pub sample_rate: f64,
    /// The time of the first sample (s).
    pub start: f64,
    /// The window over each piece.
    pub window: Window,
    /// Samples in a piece, at least 8.
    pub length: usize,
    /// Which part of a piece the next one shares with it: 0 to 0.99.
    pub overlap: f64,
    /// What the levels are levels of.
    pub kind: LevelKind,
    /// The reference a_0 of the levels, in the unit of the signal.
    pub reference: f64,
    /// The lowest level shown (dB); what is lower, or nothing at all, is shown as this.
    pub floor: f64,
}

impl SpectrogramSettings {
    /// Hann's window over 1024 samples, three quarters shared, amplitudes in dB of 1 down to −200 dB, from the time 0.
    #[must_use]
    pub fn new(sample_rate: f64) -> Self {
        Self {
            sample_rate,
            start: 0.0,
            window: Window::Hann,
            length: 1024,
            overlap: 0.75,
            kind: LevelKind::Amplitude,
            reference: 1.0,
            floor: -200.0,
        }
    }

    fn check(&self) -> Result<(), SignalError> {
        positive("the sample rate", self.sample_rate)?;
        positive("the reference of the levels", self.reference)?;
        within("the time of the first sample", self.start, f64::MIN, f64::MAX)?;
        let [shortest, longest] = [SHORTEST_PIECE, LONGEST_PIECE].map(|samples| samples as f64);
        within("the length of a piece in samples", self.length as f64, shortest, longest)?;
        within("the overlap", self.overlap, 0.0, 0.99)?;
        within("the floor in dB", self.floor, -1000.0, 1000.0)
    }

    /// Samples from one piece to the next.
    fn hop(&self) -> usize {
        ((self.length as f64 * (1.0 - self.overlap)).round() as usize).max(1)
    }
}

/// Levels over time and frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrogram {
    /// The time of the middle of each piece (s).
    pub times: Vec<f64>,
    /// From 0 to half the sample rate (Hz), a sample rate over length apart.
    pub frequencies: Vec<f64>,
    /// Levels (dB), a row a time.
    pub levels: Vec<f64>,
}

/// The spectrogram of a signal: pieces of it, each weighted by the window and transformed. What is left at the end and fills no piece is left out.
///
/// With X_k = Σ w_n x_n exp(−2πi k n/N), the amplitude is a_k = 2 |X_k|/Σ w_n and the power density S_k = 2 |X_k|²/(f_s Σ w_n²), without the
/// factor 2 at 0 and at half the sample rate, which have no mirror image.
///
/// # Errors
/// Settings outside their ranges, a sample that is not finite, a signal shorter than one piece, more levels than fit into memory.
pub fn spectrogram(signal: &[f64], settings: &SpectrogramSettings) -> Result<Spectrogram, SignalError> {
    settings.check()?;
    finite(signal)?;
    let length = settings.length;
    if signal.len() < length {
        return Err(SignalError::TooShort { found: signal.len(), needed: length });
    }
    let hop = settings.hop();
    let pieces = (signal.len() - length) / hop + 1;
    let lines = length / 2 + 1;
    let values = pieces as f64 * lines as f64;
    if values > MOST_LEVELS as f64 {
        return Err(SignalError::TooLarge { what: "the spectrogram", values, most: MOST_LEVELS });
    }
    let weights = settings.window.weights(length);
    let scale = LevelScale::new(settings, &weights);
    let mut transform = Transform::new(length);
    let mut levels = Vec::with_capacity(pieces * lines);
    for piece in signal.windows(length).step_by(hop) {
        let spectrum = transform.of(piece.iter().zip(&weights).map(|(x, w)| x * w));
        levels.extend(spectrum.iter().enumerate().map(|(k, line)| scale.level(k, line)));
    }
    let middle = |piece: usize| {
        settings.start + (piece as f64 * hop as f64 + 0.5 * length as f64) / settings.sample_rate
    };
    let times = (0..pieces).map(middle).collect();
    let frequencies = (0..lines).map(|k| k as f64 * settings.sample_rate / length as f64).collect();
    Ok(Spectrogram { times, frequencies, levels })
}

/// From a line of the spectrum to its level.
struct LevelScale {
    /// Squared amplitude or power density over the squared reference, a unit of |X|², at lines without a mirror image.
    single: f64,
    /// The same at all others.
    paired: f64,
    /// The last line, where it is half the sample rate.
    half_rate: Option<usize>,
    floor: f64,
}

impl LevelScale {
    fn new(settings: &SpectrogramSettings, weights: &[f64]) -> Self {
        let reference = settings.reference;
        let (single, paired) = match settings.kind {
            LevelKind::Amplitude => {
                let single = (1.0 / (weights.iter().sum::<f64>() * reference)).powi(2);
                (single, 4.0 * single)
            }
            LevelKind::PowerDensity => {
                let squares: f64 = weights.iter().map(|w| w * w).sum();
                let single = 1.0 / (settings.sample_rate * squares * reference * reference);
                (single, 2.0 * single)
            }
        };
        let half_rate = weights.len().is_multiple_of(2).then_some(weights.len() / 2);
        Self { single, paired, half_rate, floor: settings.floor }
    }

    fn level(&self, k: usize, line: &Complex64) -> f64 {
        let scale = if k == 0 || Some(k) == self.half_rate { self.single } else { self.paired };
        let ratio = scale * line.norm_sqr();
        // the logarithm of nothing would be −∞
        if ratio > 0.0 { (10.0 * libm::log10(ratio)).max(self.floor) } else { self.floor }
    }
}
