//! A march in blocks: after each its samples are stored with the state from which it goes on.

use crate::error::ModelError;
use crate::samples::Samples;
use judder_numerics::signal::Decimation;
use judder_sliding::march::{Checkpoint, March, Reached};
use judder_sliding::motion::Motion;
use judder_sliding::recorder::{Recorder, RecorderState};
use judder_store::StreamSlice;
use judder_study::Progress;
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// Steps between two looks at the progress: a fraction of a second.
const BETWEEN_LOOKS: u64 = 100_000;

/// Where and why a march ended before the end of its path.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct MarchStop {
    /// s.
    pub(super) time: f64,
    /// m.
    pub(super) position: f64,
    /// What stopped it.
    pub(super) reason: String,
}

/// A march on its way.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct OngoingMarch {
    march: Checkpoint,
    recorder: RecorderState,
    /// Wall time of the steps alone, s.
    pub(super) seconds: f64,
    /// Whether it is over.
    is_over: bool,
    /// Why before the end of the path.
    pub(super) ended: Option<MarchStop>,
}

/// What marches.
pub(super) struct Marching<'a, 'b> {
    pub(super) march: March<'a>,
    pub(super) recorder: Recorder,
    pub(super) samples: Samples<'b>,
    pub(super) decimation: Decimation,
    pub(super) motion: Motion,
    pub(super) step: f64,
    /// Steps between two checkpoints.
    pub(super) block: u64,
}

impl Marching<'_, '_> {
    /// Goes on from where an earlier run was interrupted, to the end or to an interruption.
    pub(super) fn march_on(&mut self, progress: &dyn Progress) -> Result<OngoingMarch, ModelError> {
        let mut way = self.taken_up()?;
        let left = self.march.all_steps().saturating_sub(self.march.steps());
        let looks = left / self.block * self.block.div_ceil(BETWEEN_LOOKS)
            + (left % self.block).div_ceil(BETWEEN_LOOKS);
        progress.expect(usize::try_from(looks).unwrap_or(usize::MAX));
        self.recorder.reserve(self.block);
        while !way.is_over {
            self.one_block(&mut way, progress);
            let is_interrupted = progress.interrupted() && !way.is_over;
            self.keep(&mut way)?;
            if is_interrupted {
                return Err(ModelError::Interrupted);
            }
        }
        Ok(way)
    }

    /// The state of an earlier run, or that of the start.
    fn taken_up(&mut self) -> Result<OngoingMarch, ModelError> {
        let start = OngoingMarch {
            march: self.march.checkpoint(),
            recorder: self.recorder.state(),
            seconds: 0.0,
            is_over: false,
            ended: None,
        };
        let Some(bytes) = self.samples.checkpoint() else { return Ok(start) };
        let way: OngoingMarch =
            serde_json::from_slice(bytes).map_err(|source| ModelError::Checkpoint { source })?;
        self.march.resume(&way.march)?;
        self.recorder.resume(&self.decimation, &way.recorder)?;
        Ok(way)
    }

    fn one_block(&mut self, way: &mut OngoingMarch, progress: &dyn Progress) {
        let target = self.march.steps() + self.block;
        while self.march.steps() < target && !way.is_over {
            let steps = BETWEEN_LOOKS.min(target - self.march.steps());
            let begun = Instant::now();
            let reached = self.march.advance(steps, &mut self.recorder);
            way.seconds += begun.elapsed().as_secs_f64();
            progress.advance();
            let reason = match reached {
                Ok(Reached::Steps) => {
                    if progress.interrupted() {
                        return;
                    }
                    continue;
                }
                Ok(Reached::End) => None,
                Ok(Reached::RunOff(end)) => Some(format!("the contact point has {end}")),
                Err(error) => Some(error.to_string()),
            };
            way.is_over = true;
            let time = self.march.steps() as f64 * self.step;
            let position = self.motion.at(time).position;
            way.ended = reason.map(|reason| MarchStop { time, position, reason });
            self.recorder.flush();
        }
    }

    /// Stores the samples of a block, and from where to go on.
    fn keep(&mut self, way: &mut OngoingMarch) -> Result<(), ModelError> {
        (way.march, way.recorder) = (self.march.checkpoint(), self.recorder.state());
        let bytes = serde_json::to_vec(way).map_err(|source| ModelError::Checkpoint { source })?;
        let (times, states) = self.recorder.states();
        let columns = self.recorder.columns().into_iter().map(StreamSlice::from);
        let slices: Vec<StreamSlice<'_>> = columns.chain([times.into(), states.into()]).collect();
        self.samples.append(&bytes, &slices)?;
        self.recorder.clear();
        Ok(())
    }
}
