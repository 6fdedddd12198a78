//! Why a sound cannot be written.

use thiserror::Error;

/// Why a sound cannot be written.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SoundError {
    /// There are no channels or too many.
    #[error("a sound has one channel or two, not {found}")]
    Channels {
        /// Their number.
        found: usize,
    },
    /// The channels are not equally long.
    #[error("the left channel has {left} samples, the right one {right}; both need the same")]
    ChannelsDiffer {
        /// Samples of the first channel.
        left: usize,
        /// Samples of the second channel.
        right: usize,
    },
    /// A sample is NaN or infinite.
    #[error("sample {index} of channel {channel} (both from 0) is {value}; only finite numbers can be heard")]
    NotFinite {
        /// The channel, from 0.
        channel: usize,
        /// The sample, from 0.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A sample is larger than the stated full scale.
    #[error(
        "sample {index} of channel {channel} (both from 0) is {value}, beyond the full scale of {full_scale}; state a larger one"
    )]
    BeyondFullScale {
        /// The channel, from 0.
        channel: usize,
        /// The sample, from 0.
        index: usize,
        /// Its value.
        value: f64,
        /// What was stated.
        full_scale: f64,
    },
    /// The gain would be infinite or zero.
    #[error("{what} of {value} gives a gain of {gain}, which is none; it must be a number of ordinary size")]
    Gain {
        /// What the gain was to be made from.
        what: &'static str,
        /// Its value.
        value: f64,
        /// The gain.
        gain: f64,
    },
    /// The level of the peak is above full scale or no number.
    #[error("a peak at {level} dB of full scale cannot be; 0 is the highest, −1 the usual, −100 the lowest")]
    PeakLevel {
        /// What was asked for (dB).
        level: f64,
    },
    /// The sample rate is zero or absurd.
    #[error("{rate} samples a second cannot be played; resample it, say to 48000")]
    Rate {
        /// What was asked for (Hz).
        rate: u32,
    },
    /// The sound does not fit into a WAV file.
    #[error(
        "a WAV file holds up to {most} bytes, this sound has {bytes}; write less of it, or at a lower rate"
    )]
    TooLong {
        /// Bytes of its samples.
        bytes: u64,
        /// The most that fit.
        most: u64,
    },
}
