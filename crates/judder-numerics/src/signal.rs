//! Signals: sampled histories on their way to the eye and the ear. Pure mathematics, no files.
//!
//! - [`kaiser`], [`fir`]: low-pass filters of linear phase from band edges and an attenuation.
//! - [`Decimation`], [`decimate`]: fewer samples of a signal while it is made, without aliases; its state goes into a checkpoint.
//! - [`means`]: fewer samples of a signal that jumps, which a filter would make ring.
//! - [`extremes`]: the smallest and the largest value of every step, with the step.
//! - [`resample`]: any sample rate from any other, for the ear.
//! - [`window`], [`spectrogram`]: levels over time and frequency.
//! - [`tone`]: the frequency of the strongest line. [`octave`]: the mean square in octave bands.
//! - [`envelope`], [`bursts`]: where a signal is loud, how loud, at which frequency.

mod bits;
pub mod bursts;
pub mod decimate;
mod decimation;
pub mod envelope;
mod error;
pub mod extremes;
pub mod fir;
pub mod kaiser;
mod line;
pub mod means;
pub mod octave;
mod plan;
pub mod resample;
pub mod spectrogram;
mod spectrum;
mod stage;
pub mod tone;
pub mod window;

pub use decimation::Decimation;
pub use error::SignalError;
