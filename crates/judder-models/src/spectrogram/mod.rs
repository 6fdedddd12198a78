//! `spectrogram` of any model that marches: a signal over time and frequency, from what the march has stored.
//!
//! - [`settings`]: how the signal is cut into pieces, how levels are drawn, what they refer to.
//! - `levels`: the levels of a stored signal. `figure`: their map and waterfall.

pub(crate) mod figure;
pub(crate) mod levels;
pub mod settings;
