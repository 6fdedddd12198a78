//! What can be wrong with a signal or with what is asked of it.

use thiserror::Error;

/// Why a signal was not treated.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SignalError {
    /// A setting that must be positive and finite is not.
    #[error("{what} is {value}; it must be positive and finite")]
    NotPositive {
        /// The setting, with its article.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A setting lies outside its range.
    #[error("{what} is {value}; it must lie between {lower} and {upper}")]
    OutOfRange {
        /// The setting, with its article.
        what: &'static str,
        /// Its value.
        value: f64,
        /// The smallest that is taken.
        lower: f64,
        /// The largest that is taken.
        upper: f64,
    },
    /// The edges of a filter's bands are not in order.
    #[error(
        "the pass band ends at {pass_edge} Hz and the stop band begins at {stop_edge} Hz; the first must be below the second, and the second \
         not above {limit} Hz, so that nothing is folded into the pass band"
    )]
    BandEdges {
        /// Where the pass band ends (Hz).
        pass_edge: f64,
        /// Where the stop band begins (Hz).
        stop_edge: f64,
        /// The highest frequency at which the stop band may begin (Hz).
        limit: f64,
    },
    /// The bands lie so close together that the filter would be absurdly long.
    #[error(
        "a filter from {pass_edge} Hz to {stop_edge} Hz at {sample_rate} samples a second needs {taps} taps, {most} are made at most; \
         move its edges apart"
    )]
    TooManyTaps {
        /// Where the pass band ends (Hz).
        pass_edge: f64,
        /// Where the stop band begins (Hz).
        stop_edge: f64,
        /// Samples a second (Hz).
        sample_rate: f64,
        /// The taps that it would need.
        taps: f64,
        /// The most that are made.
        most: usize,
    },
    /// A sample is NaN or infinite.
    #[error("sample {index} (from 0) is {value}; signals are finite")]
    NotFinite {
        /// Its place in the signal, from 0.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A signal is too short for what is asked.
    #[error("the signal has {found} samples, at least {needed} are needed")]
    TooShort {
        /// Samples that there are.
        found: usize,
        /// Samples that are needed.
        needed: usize,
    },
    /// The answer would not fit into memory.
    #[error("{what} would have {values} values, {most} are made at most")]
    TooLarge {
        /// What, with its article.
        what: &'static str,
        /// Values that it would have.
        values: f64,
        /// The most that are made.
        most: usize,
    },
    /// No threshold was given.
    #[error("bursts need a threshold: below the peak, above the background, or absolute")]
    NoThreshold,
    /// A kept state belongs to another filter.
    #[error("the kept state of a filter does not belong to this one ({what}); start anew")]
    ForeignState {
        /// What differs.
        what: &'static str,
    },
}

/// Refuses what is not positive and finite.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<(), SignalError> {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(SignalError::NotPositive { what, value }) }
}

/// Refuses what lies outside a range, NaN too.
pub(crate) fn within(what: &'static str, value: f64, lower: f64, upper: f64) -> Result<(), SignalError> {
    if (lower..=upper).contains(&value) {
        Ok(())
    } else {
        Err(SignalError::OutOfRange { what, value, lower, upper })
    }
}

/// Refuses a signal with NaN or an infinity.
pub(crate) fn finite(signal: &[f64]) -> Result<(), SignalError> {
    match signal.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(SignalError::NotFinite { index, value: signal[index] }),
        None => Ok(()),
    }
}
