//! What is found at one value of the swept key.

use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::margins::MarginOnset;
use judder_oscillator::critical::Thresholds;
use judder_oscillator::undecided::Undecided;

/// The thresholds at one value of the swept key.
pub(super) struct FoundThresholds {
    pub(super) inputs: OscillatorInputs,
    pub(super) thresholds: Thresholds,
    /// One for each threshold of the full system.
    pub(super) onsets: Vec<Option<MarginOnset>>,
    /// Where the errors of the law leave the thresholds; `None` where they are not known.
    pub(super) within_law: Option<Undecided>,
}
