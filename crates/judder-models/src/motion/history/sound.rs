//! The velocity along x of a motion as sound.

use crate::error::ModelError;
use crate::motion::si::SiUnits;
use crate::sliding::march::sound::{SoundFile, ToldSound, sound_of};
use judder_keys::problem::Problem;
use judder_oscillator::motion::history::{MotionHistory, TimeWindow};
use judder_store::Results;
use thiserror::Error;

/// A sound is asked of a motion without seconds.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("`sound` is asked of a motion in groups, which has no seconds")]
pub(super) struct SoundInGroups {
    /// What would give it some.
    pub(super) seconds: &'static str,
}

impl Problem for SoundInGroups {
    fn kind(&self) -> &'static str {
        "SoundInGroups"
    }

    fn label(&self) -> &'static str {
        "in groups"
    }

    fn help(&self) -> Option<String> {
        Some(self.seconds.to_owned())
    }
}

/// A file for the ear.
pub(super) struct SoundOfMotion {
    pub(super) name: String,
    pub(super) bytes: Vec<u8>,
    pub(super) told: ToldSounds,
}

/// What is told of sounds.
#[derive(Results)]
pub(super) struct ToldSounds {
    /// the velocity along x
    sound: Vec<ToldSound>,
}

/// The velocity along x after the transient as sound.
pub(super) fn sound<const N: usize>(
    analysis: &str,
    units: SiUnits,
    history: &MotionHistory<N>,
    window: &TimeWindow,
) -> Result<SoundOfMotion, ModelError> {
    let late = history.samples.iter().filter(|sample| sample.time >= window.transient);
    let values = late.map(|sample| sample.state[N / 2] * units.metre / units.second).collect();
    let sample_rate = (window.points - 1) as f64 / (window.duration * units.second);
    let SoundFile { name, bytes, told } = sound_of(analysis, "velocity_x", "m/s", values, sample_rate)?;
    Ok(SoundOfMotion { name, bytes, told: ToldSounds { sound: vec![told] } })
}
