//! Where a signal is loud.

use super::envelope::envelope;
use super::error::{SignalError, finite, positive, within};
use super::tone::strongest_frequency;
use crate::decade::power_of_ten;
use std::ops::Range;

/// How far on either side of a burst's peak its frequency is looked for (s).
const ABOUT_PEAK: f64 = 0.01;

/// The fewest samples that a frequency is taken from.
const FEWEST_SAMPLES: usize = 32;

/// What makes a burst.
///
/// The envelope is √2 times the rms over `window` about each sample. A burst is a stretch in which it reaches the threshold, and lasts as long
/// as it stays above the threshold less the hysteresis. The threshold is the highest of those that are given. The signal should swing about zero:
/// take the mean of one that does not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BurstSettings {
    /// Samples a second (Hz).
    pub sample_rate: f64,
    /// The time of the first sample (s).
    pub start: f64,
    /// The window of the envelope (s): a few periods, and shorter than the bursts.
    pub window: f64,
    /// A threshold this far below the peak of the envelope (dB).
    pub below_peak: Option<f64>,
    /// A threshold this far above the background (dB), which is the median of the envelope: right where the signal is loud for less than half
    /// of the time.
    pub above_background: Option<f64>,
    /// A threshold in the unit of the signal, an amplitude.
    pub absolute: Option<f64>,
    /// How far below the threshold a burst ends (dB).
    pub hysteresis: f64,
    /// Bursts with less than this between them are one (s).
    pub minimum_distance: f64,
    /// What is shorter is no burst (s).
    pub minimum_duration: f64,
}

impl BurstSettings {
    /// A window of 1 ms; 40 dB below the peak and 15 dB above the background, whichever is higher; 6 dB of hysteresis, 5 ms of distance, any
    /// duration.
    #[must_use]
    pub fn new(sample_rate: f64) -> Self {
        Self {
            sample_rate,
            start: 0.0,
            window: 1e-3,
            below_peak: Some(40.0),
            above_background: Some(15.0),
            absolute: None,
            hysteresis: 6.0,
            minimum_distance: 5e-3,
            minimum_duration: 0.0,
        }
    }

    fn check(&self) -> Result<(), SignalError> {
        positive("the sample rate", self.sample_rate)?;
        within("the time of the first sample", self.start, f64::MIN, f64::MAX)?;
        positive("the window of the envelope", self.window)?;
        within("the threshold below the peak in dB", self.below_peak.unwrap_or(0.0), 0.0, 300.0)?;
        within("the threshold above the background in dB", self.above_background.unwrap_or(0.0), 0.0, 300.0)?;
        positive("the absolute threshold", self.absolute.unwrap_or(1.0))?;
        within("the hysteresis in dB", self.hysteresis, 0.0, 300.0)?;
        within("the distance between bursts", self.minimum_distance, 0.0, f64::MAX)?;
        within("the shortest duration of a burst", self.minimum_duration, 0.0, f64::MAX)?;
        if self.below_peak.is_none() && self.above_background.is_none() && self.absolute.is_none() {
            return Err(SignalError::NoThreshold);
        }
        Ok(())
    }

    /// The highest of the thresholds.
    fn threshold(&self, envelope: &[f64]) -> f64 {
        let peak = envelope.iter().copied().fold(0.0, f64::max);
        let below_peak = self.below_peak.map(|below| peak / ratio(below));
        let above_background = self.above_background.map(|above| median(envelope) * ratio(above));
        [below_peak, above_background, self.absolute].into_iter().flatten().fold(0.0, f64::max)
    }

    fn time(&self, sample: usize) -> f64 {
        self.start + sample as f64 / self.sample_rate
    }
}

/// A stretch in which a signal is loud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Burst {
    /// The time of its first sample that reaches the threshold less the hysteresis (s).
    pub start: f64,
    /// The time of its last such sample (s).
    pub end: f64,
    /// From the first to the last (s).
    pub duration: f64,
    /// The time of its largest sample (s).
    pub peak_time: f64,
    /// The magnitude of that sample.
    pub peak: f64,
    /// The frequency of its strongest line within 10 ms of the peak (Hz); none where it does not swing.
    pub frequency: Option<f64>,
}

/// The bursts of a signal, in their order; none where nothing stands out.
///
/// # Errors
/// Settings outside their ranges, no threshold, a sample that is not finite, a window of the envelope that is shorter than a sample or longer
/// than the signal.
pub fn bursts(signal: &[f64], settings: &BurstSettings) -> Result<Vec<Burst>, SignalError> {
    settings.check()?;
    finite(signal)?;
    let window = (settings.window * settings.sample_rate).round();
    let needed = FEWEST_SAMPLES.max(window as usize);
    if signal.len() < needed {
        return Err(SignalError::TooShort { found: signal.len(), needed });
    }
    within("the window of the envelope in samples", window, 1.0, signal.len() as f64)?;
    let envelope = envelope(signal, window as usize);
    let threshold = settings.threshold(&envelope);
    if threshold <= 0.0 {
        return Ok(Vec::new());
    }
    let lower = threshold / ratio(settings.hysteresis);
    let mut loud: Vec<Range<usize>> = loud_stretches(&envelope, threshold, lower)
        .into_iter()
        .map(|stretch| tightened(signal, stretch, lower))
        .collect();
    loud.dedup_by(|next, before| {
        let is_near = settings.time(next.start) - settings.time(before.end - 1) < settings.minimum_distance;
        if is_near {
            before.end = next.end;
        }
        is_near
    });
    let all = loud.into_iter().map(|stretch| burst(signal, stretch, needed, settings));
    Ok(all.filter(|burst| burst.duration >= settings.minimum_duration).collect())
}

/// The ratio of amplitudes that a level difference in dB means.
fn ratio(decibels: f64) -> f64 {
    power_of_ten(decibels / 20.0)
}

/// The middle value, the upper one of two.
fn median(values: &[f64]) -> f64 {
    let mut values = values.to_vec();
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Stretches of at least the lower value in which the threshold is reached.
fn loud_stretches(envelope: &[f64], threshold: f64, lower: f64) -> Vec<Range<usize>> {
    let mut stretches = Vec::new();
    let mut from = 0;
    for stretch in envelope.chunk_by(|before, after| (*before >= lower) == (*after >= lower)) {
        if stretch.iter().any(|value| *value >= threshold) {
            stretches.push(from..from + stretch.len());
        }
        from += stretch.len();
    }
    stretches
}

/// Without what the window of the envelope added on either side: from the first to the last sample that is loud itself.
fn tightened(signal: &[f64], stretch: Range<usize>, lower: f64) -> Range<usize> {
    let is_loud = |n: &usize| signal[*n].abs() >= lower;
    match (stretch.clone().find(is_loud), stretch.clone().rev().find(is_loud)) {
        (Some(first), Some(last)) => first..last + 1,
        _ => stretch,
    }
}

/// What is said of a stretch.
fn burst(signal: &[f64], stretch: Range<usize>, shortest: usize, settings: &BurstSettings) -> Burst {
    let larger = |best: usize, n: usize| if signal[n].abs() > signal[best].abs() { n } else { best };
    let peak = stretch.clone().fold(stretch.start, larger);
    let about = (ABOUT_PEAK * settings.sample_rate) as usize;
    let near = stretch.start.max(peak.saturating_sub(about))..stretch.end.min(peak.saturating_add(about));
    let piece = &signal[widened(near, shortest, signal.len())];
    let (start, end) = (settings.time(stretch.start), settings.time(stretch.end - 1));
    Burst {
        start,
        end,
        duration: end - start,
        peak_time: settings.time(peak),
        peak: signal[peak].abs(),
        frequency: strongest_frequency(piece, settings.sample_rate),
    }
}

/// A range of at least `shortest` about the same middle, within a signal of `length` that is not shorter.
fn widened(range: Range<usize>, shortest: usize, length: usize) -> Range<usize> {
    let missing = shortest.saturating_sub(range.len());
    let start = range.start.saturating_sub(missing / 2).min(length - shortest.min(length));
    start..(start + range.len() + missing).min(length)
}
