//! Where a march is, to the bit, and how it goes on from there.

use super::March;
use super::view::MarchView;
use crate::SlidingError;
use crate::edge::{EdgePoint, STENCIL};
use crate::plane::PlaneVector;
use serde::{Deserialize, Serialize};

/// Where a march is, to the bit: what it goes on from after an interruption.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    steps: u64,
    at: EdgePoint,
    segment: usize,
    slider: [Vec<f64>; 3],
    track: [Vec<f64>; 3],
    contact: PlaneVector,
    nodes: [PlaneVector; STENCIL],
    observed: Vec<[f64; 2]>,
    velocity: f64,
    forces: [PlaneVector; 2],
    tuned: f64,
}

impl March<'_> {
    /// Where the march is.
    #[must_use]
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            steps: self.steps,
            at: self.at,
            segment: self.view.segment,
            slider: self.slider.memory(),
            track: self.track.memory(),
            contact: self.contact[0],
            nodes: self.view.now,
            observed: self.observed.iter().map(|own| [own[0], own[1]]).collect(),
            velocity: self.velocity,
            forces: [self.force, self.force_before],
            tuned: self.tuned,
        }
    }

    /// Goes back or on to where a march of the same pair and settings was, to the bit.
    ///
    /// # Errors
    /// [`SlidingError::ForeignCheckpoint`]; the march is then what it was.
    pub fn resume(&mut self, checkpoint: &Checkpoint) -> Result<(), SlidingError> {
        let fits = checkpoint.observed.len() == self.observed.len()
            && checkpoint.segment + 1 < self.pair.track().nodes.len()
            && self.slider.fits(&checkpoint.slider)
            && self.track.fits(&checkpoint.track);
        if !fits {
            return Err(SlidingError::ForeignCheckpoint);
        }
        self.slider.recall(&checkpoint.slider);
        self.track.recall(&checkpoint.track);
        self.set_recurrences(checkpoint.tuned);
        self.steps = checkpoint.steps;
        self.at = checkpoint.at;
        self.drive = self.settings.motion.at(checkpoint.steps as f64 * self.settings.step);
        self.set_push(&self.drive.clone());
        self.view = MarchView::new(self.pair, &mut self.track, &self.compliance, checkpoint.segment);
        self.view.now = checkpoint.nodes;
        let [_, of_slider] = self.slider.seen();
        let [_, of_track] = self.track.seen();
        self.contact = [checkpoint.contact, self.with_yielding(&of_slider)];
        self.predict_observed(&of_slider, &of_track);
        for (own, kept) in self.observed.iter_mut().zip(&checkpoint.observed) {
            own[..2].copy_from_slice(kept);
        }
        self.velocity = checkpoint.velocity;
        [self.force, self.force_before] = checkpoint.forces;
        Ok(())
    }
}
