//! Fewer samples of a signal while it is made: low-pass filters of linear phase, and every n-th sample of what they let through.

use super::bits;
use super::decimation::Decimation;
use super::error::SignalError;
use super::line::{LANES, SampleFrame};
use super::plan;
use super::stage::{FilterStage, StageState};
use serde::{Deserialize, Serialize};

/// A streaming filter of some signals from one rate to a lower one, of linear phase.
///
/// A row of filters, each at the rate that is left before it, the cheapest row that does what was asked. The signals pass side by side,
/// eight in a vector; each comes out to the bit as it would alone. The k-th output, counted from 0, comes with the input k·factor; it is
/// the signal [`delay`](Self::delay) before that input, so the first outputs lie before the first input and show the level from which
/// the filter started.
///
/// ```
/// use judder_numerics::signal::{Decimation, decimate::Decimator};
/// let mut filter = Decimator::new(&Decimation::new(1.0 / 3e-7, 50e3, 8), &[0.0, 1.0])?;
/// let mut outputs = 0;
/// for step in 0..8000 {
///     let signals = [f64::from(step % 5), 1.0];
///     outputs += filter.push(&signals).map_or(0, |passed| passed.len());
/// }
/// assert_eq!(outputs, 2 * 1000);
/// # Ok::<(), judder_numerics::signal::SignalError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Decimator {
    asked: Decimation,
    rows: Vec<StageRow>,
    signals: usize,
    /// Last inputs and last outputs, a frame a row.
    last: Vec<SampleFrame>,
    passed: Vec<SampleFrame>,
    is_started: bool,
}

/// The filters that eight signals pass one after the other.
type StageRow = Vec<FilterStage>;

/// What a [`Decimator`] remembers, for a checkpoint: kept by the bits of its numbers, so that a filter which takes it up goes on as if
/// it had never stopped.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DecimatorState {
    asked: Decimation,
    rows: Vec<Vec<StageState>>,
    #[serde(with = "bits::many")]
    last: Vec<f64>,
    is_started: bool,
}

impl Decimator {
    /// A filter of as many signals as there are levels, whose past is that level: 0, or whence the signal starts.
    ///
    /// # Errors
    /// Settings outside their ranges, band edges that fold onto the pass band, bands too close together.
    pub fn new(asked: &Decimation, levels: &[f64]) -> Result<Self, SignalError> {
        asked.check()?;
        let plans = plan::cheapest(asked);
        let rows = levels
            .chunks(LANES)
            .map(|levels| plans.iter().map(|plan| FilterStage::new(plan, frame(levels))).collect())
            .collect::<Result<_, _>>()?;
        let last: Vec<SampleFrame> = levels.chunks(LANES).map(frame).collect();
        Ok(Self { asked: *asked, rows, signals: levels.len(), passed: last.clone(), last, is_started: false })
    }

    /// A filter that goes on from a kept state.
    ///
    /// # Errors
    /// [`SignalError::ForeignState`] where the state is that of a filter with other settings, or damaged.
    pub fn resumed(asked: &Decimation, state: &DecimatorState) -> Result<Self, SignalError> {
        let mut filter = Self::new(asked, &state.last)?;
        if state.asked != *asked {
            return Err(SignalError::ForeignState { what: "it was made with other settings" });
        }
        let lengths = |row: &Vec<StageState>| row.len();
        if !state.rows.iter().map(lengths).eq(filter.rows.iter().map(Vec::len)) {
            return Err(SignalError::ForeignState { what: "it has another number of filters" });
        }
        for (stage, kept) in filter.rows.iter_mut().flatten().zip(state.rows.iter().flatten()) {
            stage.restore(kept)?;
        }
        filter.is_started = state.is_started;
        Ok(filter)
    }

    /// How many signals pass.
    #[must_use]
    pub fn signals(&self) -> usize {
        self.signals
    }

    /// Takes a sample of each signal in, as many as there are signals (more are ignored); gives one of each out at the first and then at
    /// every `factor`-th. Allocates nothing. A sample that is not finite comes out as such, in all outputs of its signal that it reaches.
    #[inline]
    pub fn push(&mut self, samples: &[f64]) -> Option<&[f64]> {
        self.is_started = true;
        let mut is_due = false;
        let ends = self.last.iter_mut().zip(&mut self.passed);
        for ((row, (last, passed)), samples) in self.rows.iter_mut().zip(ends).zip(samples.chunks(LANES)) {
            *last = frame(samples);
            if let Some(frame) = through(row, *last) {
                *passed = frame;
                is_due = true;
            }
        }
        is_due.then(|| &self.passed.as_flattened()[..self.signals])
    }

    /// The outputs of each signal up to the last input's time, as if the signals stayed at their last values; nothing where there was no
    /// input.
    #[must_use]
    pub fn finish(mut self) -> Vec<Vec<f64>> {
        let mut tails = vec![Vec::new(); self.signals()];
        let missing = if self.is_started { self.delay_in_samples() } else { 0 };
        let held = self.last.as_flattened()[..self.signals].to_vec();
        for _ in 0..missing {
            if let Some(passed) = self.push(&held) {
                for (tail, value) in tails.iter_mut().zip(passed) {
                    tail.push(*value);
                }
            }
        }
        tails
    }

    /// How far the output lags behind the input (s), at every frequency.
    #[must_use]
    pub fn delay(&self) -> f64 {
        self.delay_in_samples() as f64 / self.asked.sample_rate
    }

    /// The same in samples of the input.
    #[must_use]
    pub fn delay_in_samples(&self) -> usize {
        let mut inputs = 1;
        let mut delay = 0;
        for stage in self.stages() {
            delay += stage.delay() * inputs;
            inputs *= stage.factor();
        }
        delay
    }

    /// Samples a second of the output (Hz).
    #[must_use]
    pub fn output_rate(&self) -> f64 {
        self.asked.sample_rate / self.asked.factor as f64
    }

    /// Samples of the input a sample of the output.
    #[must_use]
    pub fn factor(&self) -> usize {
        self.asked.factor
    }

    /// Multiply-adds a sample of one input, on average.
    #[must_use]
    pub fn cost(&self) -> f64 {
        let mut inputs = 1;
        let mut cost = 0.0;
        for stage in self.stages() {
            inputs *= stage.factor();
            cost += stage.length() as f64 / inputs as f64;
        }
        cost
    }

    /// What it remembers.
    #[must_use]
    pub fn state(&self) -> DecimatorState {
        let rows = self.rows.iter().map(|row| row.iter().map(FilterStage::state).collect()).collect();
        DecimatorState {
            asked: self.asked,
            rows,
            last: self.last.as_flattened()[..self.signals].to_vec(),
            is_started: self.is_started,
        }
    }

    /// The filters of one row: all rows have the same.
    fn stages(&self) -> &[FilterStage] {
        self.rows.first().map_or(&[], Vec::as_slice)
    }
}

/// The frame of up to eight samples.
#[inline]
fn frame(samples: &[f64]) -> SampleFrame {
    let mut frame = [0.0; LANES];
    for (lane, sample) in frame.iter_mut().zip(samples) {
        *lane = *sample;
    }
    frame
}

/// What comes out at the end of a row of filters.
#[inline]
fn through(row: &mut [FilterStage], frame: SampleFrame) -> Option<SampleFrame> {
    row.iter_mut().try_fold(frame, |passed, stage| stage.push(passed))
}
