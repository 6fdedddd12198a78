//! A motion in blocks: after each its samples are stored with the state from which it goes on.

use super::content::SoughtContent;
use super::recorded::{Recorded, RecordedState};
use crate::error::ModelError;
use crate::samples::Samples;
use judder_nonsmooth::NonsmoothError;
use judder_nonsmooth::march::{MarchCheckpoint, NonsmoothMarch, Works};
use judder_nonsmooth::mode_share::ModalSums;
use judder_nonsmooth::statistics::Statistics;
use judder_study::Progress;
use serde::{Deserialize, Serialize};
use std::time::{Duration, Instant};

/// Steps between two that progress is told of.
const LOOK: u64 = 2000;
/// How long it takes until a run hears that it shall stop, at most, but for a step.
const PATIENCE: Duration = Duration::from_millis(100);
/// What is lost when a run is killed, at most.
const LOST: Duration = Duration::from_secs(10);
/// Bytes of samples that wait to be stored, at most: memory does not grow with the motion.
const WAITING: usize = 32 << 20;

/// When and why a motion ended before its duration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct MotionStop {
    /// s.
    pub(super) time: f64,
    /// What stopped it.
    pub(super) reason: String,
}

/// A motion on its way.
pub(super) struct OngoingMotion<'a, 'b> {
    pub(super) march: NonsmoothMarch<'a>,
    pub(super) recorded: Recorded,
    pub(super) samples: Samples<'b>,
    /// The modes in it, or why they are not known.
    pub(super) content: Result<SoughtContent, ModelError>,
    pub(super) statistics: Statistics,
    /// Works when the transient was over, in J.
    pub(super) settled: Works,
    /// The energy at the start, in J.
    pub(super) first_energy: f64,
    /// Wall time of the steps alone, in s.
    pub(super) seconds: f64,
    /// Why it goes no farther, before all steps.
    pub(super) ended: Option<MotionStop>,
    /// Steps in all, and those of the transient.
    pub(super) steps: [u64; 2],
    /// Steps between two checkpoints, at most.
    pub(super) block: u64,
}

/// Where a motion is.
#[derive(Serialize, Deserialize)]
struct MotionCheckpoint {
    march: MarchCheckpoint,
    recorded: RecordedState,
    statistics: Statistics,
    content: Option<ModalSums>,
    settled: Works,
    seconds: f64,
    ended: Option<MotionStop>,
}

impl OngoingMotion<'_, '_> {
    /// Goes on from where an earlier run was interrupted, to the end or to an interruption.
    pub(super) fn march_on(&mut self, progress: &dyn Progress) -> Result<(), ModelError> {
        self.take_up()?;
        let [all, _] = self.steps;
        progress.expect((all.saturating_sub(self.march.steps()) / LOOK) as usize);
        while !self.is_over() {
            let begun = Instant::now();
            let is_interrupted = self.one_block(progress)?;
            self.seconds += begun.elapsed().as_secs_f64();
            let is_over = self.is_over();
            if is_over {
                self.recorded.flush();
            }
            self.keep()?;
            if is_interrupted && !is_over {
                return Err(ModelError::Interrupted);
            }
        }
        Ok(())
    }

    fn is_over(&self) -> bool {
        self.ended.is_some() || self.march.steps() == self.steps[0]
    }

    /// The state of an earlier run, if there was one.
    fn take_up(&mut self) -> Result<(), ModelError> {
        let Some(bytes) = self.samples.checkpoint() else { return Ok(()) };
        let kept: MotionCheckpoint =
            serde_json::from_slice(bytes).map_err(|source| ModelError::Checkpoint { source })?;
        self.march.resume(&kept.march)?;
        self.recorded.resume(&kept.recorded)?;
        self.statistics.resume(&kept.statistics)?;
        match (&mut self.content, &kept.content) {
            (Ok(content), Some(kept)) => content.resume(kept)?,
            (Err(_), None) => (),
            _ => return Err(NonsmoothError::ForeignCheckpoint.into()),
        }
        (self.settled, self.seconds, self.ended) = (kept.settled, kept.seconds, kept.ended);
        Ok(())
    }

    /// Steps until a state is to be kept; whether that is because the run is to stop.
    fn one_block(&mut self, progress: &dyn Progress) -> Result<bool, ModelError> {
        let begun = Instant::now();
        let mut looked = begun;
        let last = self.steps[0].min(self.march.steps() + self.block);
        while self.march.steps() < last {
            if let Err(error) = self.step() {
                self.ended = Some(MotionStop { time: self.march.time(), reason: error.to_string() });
                break;
            }
            let is_told = self.march.steps().is_multiple_of(LOOK);
            if is_told {
                progress.advance();
            }
            if is_told || looked.elapsed() >= PATIENCE {
                if progress.interrupted() {
                    return Ok(true);
                }
                looked = Instant::now();
                if looked.duration_since(begun) >= LOST {
                    break;
                }
            }
            if self.recorded.waiting() >= WAITING {
                break;
            }
        }
        Ok(false)
    }

    fn step(&mut self) -> Result<(), NonsmoothError> {
        self.march.advance()?;
        self.recorded.take(&self.march);
        let (taken, [_, transient]) = (self.march.steps(), self.steps);
        if taken > transient {
            self.statistics.take(&self.march);
            if let Ok(content) = &mut self.content {
                content.take(&self.march, taken);
            }
        } else if taken == transient {
            self.settled = self.march.works();
        }
        Ok(())
    }

    /// Stores the samples of a block, and from where to go on.
    fn keep(&mut self) -> Result<(), ModelError> {
        let kept = MotionCheckpoint {
            march: self.march.checkpoint(),
            recorded: self.recorded.state(),
            statistics: self.statistics.clone(),
            content: self.content.as_ref().ok().map(|content| content.so_far().clone()),
            settled: self.settled,
            seconds: self.seconds,
            ended: self.ended.clone(),
        };
        let bytes = serde_json::to_vec(&kept).map_err(|source| ModelError::Checkpoint { source })?;
        self.samples.append(&bytes, &self.recorded.slices())?;
        self.recorded.clear();
        Ok(())
    }
}
