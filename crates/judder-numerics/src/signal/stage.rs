//! One filter of a row, with the frames that it remembers.

use super::bits;
use super::error::SignalError;
use super::line::{DelayLine, LANES, SampleFrame, padded, weighted_sum};
use super::plan::StagePlan;
use serde::{Deserialize, Serialize};

/// A filter of a few signals side by side that computes only the outputs that are kept.
#[derive(Debug, Clone)]
pub(crate) struct FilterStage {
    weights: Vec<f64>,
    /// A line for each of the frames that a spread filter takes in turn.
    lines: Vec<DelayLine>,
    next_line: usize,
    /// Frames to be taken in before the next output.
    until_output: usize,
    factor: usize,
    /// Half the length of the response, in samples of the input.
    delay: usize,
}

/// What a filter remembers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct StageState {
    lines: Vec<LineWindow>,
    next_line: usize,
    until_output: usize,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
struct LineWindow {
    #[serde(with = "bits::many")]
    values: Vec<f64>,
}

impl FilterStage {
    /// The filter that was planned, after a past of one level.
    pub(crate) fn new(plan: &StagePlan, level: SampleFrame) -> Result<Self, SignalError> {
        let taps = plan.low_pass.taps()?;
        let delay = taps.len() / 2 * plan.spread;
        let weights = padded(taps);
        let lines = vec![DelayLine::level(weights.len(), level); plan.spread];
        Ok(Self { weights, lines, next_line: 0, until_output: 0, factor: plan.factor, delay })
    }

    /// Takes a frame in; gives one at the first and then at every `factor`-th.
    #[inline]
    pub(crate) fn push(&mut self, frame: SampleFrame) -> Option<SampleFrame> {
        let line = &mut self.lines[self.next_line];
        line.push(frame);
        let is_due = self.until_output == 0;
        let output = is_due.then(|| weighted_sum(&self.weights, line.window()));
        self.next_line = if self.next_line + 1 == self.lines.len() { 0 } else { self.next_line + 1 };
        self.until_output = if is_due { self.factor - 1 } else { self.until_output - 1 };
        output
    }

    /// Samples an output.
    pub(crate) fn factor(&self) -> usize {
        self.factor
    }

    /// By how many samples of the input the output lags.
    pub(crate) fn delay(&self) -> usize {
        self.delay
    }

    /// Multiply-adds an output.
    pub(crate) fn length(&self) -> usize {
        self.weights.len()
    }

    pub(crate) fn state(&self) -> StageState {
        let lines = self
            .lines
            .iter()
            .map(|line| LineWindow { values: line.window().as_flattened().to_vec() })
            .collect();
        StageState { lines, next_line: self.next_line, until_output: self.until_output }
    }

    /// Takes up what the same filter remembered.
    pub(crate) fn restore(&mut self, state: &StageState) -> Result<(), SignalError> {
        let fits = state.lines.len() == self.lines.len()
            && state.lines.iter().all(|line| line.values.len() == LANES * self.weights.len())
            && state.next_line < self.lines.len()
            && state.until_output < self.factor;
        if !fits {
            return Err(SignalError::ForeignState { what: "its filters have other lengths" });
        }
        self.lines = state.lines.iter().map(|line| DelayLine::holding(line.values.as_chunks().0)).collect();
        self.next_line = state.next_line;
        self.until_output = state.until_output;
        Ok(())
    }
}
