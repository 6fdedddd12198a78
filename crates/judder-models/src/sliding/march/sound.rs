//! The signals of a march as sound.

use super::signals::{unit, variable_name};
use crate::error::ModelError;
use crate::samples::Samples;
use crate::sliding::case::observe::{ObservedPoint, Signal};
use judder_exchange::wav::{Loudness, WavFormat, wav_bytes};
use judder_numerics::signal::resample::resampled;
use judder_store::Results;

/// Samples a second of what is heard.
pub(crate) const AUDIO_RATE: u32 = 48_000;

/// A file for the ear.
pub(crate) struct SoundFile {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
    /// What the summary says of it.
    pub(crate) told: ToldSound,
}

/// What the summary says of a sound.
#[derive(Results)]
pub(crate) struct ToldSound {
    file: String,
    signal: String,
    /// full scale over the signal
    gain: f64,
    gain_unit: String,
    sample_rate: u32,
}

/// Sounds of the signals that are to be heard, each as loud as it can be.
pub(super) fn sounds(
    analysis: &str,
    samples: &Samples<'_>,
    heard: &[Signal],
    points: &[ObservedPoint],
    sample_rate: f64,
) -> Result<Vec<SoundFile>, ModelError> {
    heard.iter().map(|signal| sound(analysis, samples, *signal, points, sample_rate)).collect()
}

fn sound(
    analysis: &str,
    samples: &Samples<'_>,
    signal: Signal,
    points: &[ObservedPoint],
    sample_rate: f64,
) -> Result<SoundFile, ModelError> {
    let values = samples.values(&variable_name(signal, points))?;
    sound_of(analysis, &signal.name(points), unit(signal), values, sample_rate)
}

/// The sound of the values of a signal in this unit.
pub(crate) fn sound_of(
    analysis: &str,
    signal: &str,
    unit: &str,
    mut values: Vec<f64>,
    sample_rate: f64,
) -> Result<SoundFile, ModelError> {
    /// What can still be filtered, and made a sample of by a gain.
    const LARGEST: f64 = 1e100;
    // a march that has grown without bound ends in what cannot be heard
    let heard = |value: &f64| value.abs() <= LARGEST;
    values.truncate(values.iter().position(|value| !heard(value)).unwrap_or(values.len()));
    let heard = resampled(&values, sample_rate, f64::from(AUDIO_RATE))?;
    let (bytes, gain) = wav_bytes(&[&heard], AUDIO_RATE, WavFormat::Integer24, Loudness::default())
        .map_err(|source| ModelError::Sound { source })?;
    let name = format!("{analysis}-{signal}.wav");
    let told = ToldSound {
        file: name.clone(),
        signal: signal.to_owned(),
        gain,
        gain_unit: format!("1/({unit})"),
        sample_rate: AUDIO_RATE,
    };
    Ok(SoundFile { name, bytes, told })
}
