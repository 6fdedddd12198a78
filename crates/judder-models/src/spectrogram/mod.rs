//! `spectrogram` of any model that marches: a signal over time and frequency, from what the march has stored.
//!
//! - [`settings`]: how the signal is cut into pieces, how levels are drawn, what they refer to.
//! - `levels`: the levels of a stored signal. `figure`: their map and waterfall.

pub(crate) mod figure;
pub(crate) mod levels;
pub mod settings;

use crate::told_quantities::ToldQuantity;

/// What its table tells.
pub(crate) const TOLD: &[ToldQuantity] = &[
    ("of", "march", ""),
    ("peak_level_db", "largest level", "dB"),
    ("reference", "over", ""),
    ("peak_frequency_hz", "at the frequency", "Hz"),
    ("peak_time_s", "at the time", "s"),
    ("peak_position_m", "at the position", "m"),
    ("resolution_hz", "resolution", "Hz"),
    ("windows", "pieces of time", ""),
];
