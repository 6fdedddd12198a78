//! Where a march is, to the bit, and how it goes on from there.

use super::{ContactRecord, NonsmoothMarch, Works};
use crate::NonsmoothError;
use crate::contact_problem::{ContactSolution, PointMotion};
use crate::newton::Slopes;
use crate::travel::{Travel, TravelledPoint};
use serde::{Deserialize, Serialize};

/// Where a march is, to the bit: what it goes on from after an interruption.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MarchCheckpoint {
    steps: u64,
    z: Vec<f64>,
    v: Vec<f64>,
    /// Velocities before the last step.
    before: Vec<f64>,
    relative: Vec<f64>,
    impulse: Vec<f64>,
    motion: Vec<PointMotion>,
    /// What Newton's method has eliminated, which decides where it begins.
    eliminated: Option<Slopes>,
    travelling: Vec<TravelledPoint>,
    rounding: f64,
    scale: f64,
    works: Works,
    record: ContactRecord,
}

impl NonsmoothMarch<'_> {
    /// Where the march is.
    #[must_use]
    pub fn checkpoint(&self) -> MarchCheckpoint {
        MarchCheckpoint {
            steps: self.steps,
            z: self.z.clone(),
            v: self.v.clone(),
            before: self.next.clone(),
            relative: self.relative.clone(),
            impulse: self.solution.impulse.clone(),
            motion: self.solution.motion.clone(),
            eliminated: self.solution.memory.as_ref().and_then(|memory| memory.eliminated().cloned()),
            travelling: self.travel.as_ref().map_or_else(Vec::new, Travel::kept),
            rounding: self.rounding,
            scale: self.scale,
            works: self.works,
            record: self.record,
        }
    }

    /// Goes back or on to where a march of the same assembly, observed rows and settings was, to the bit.
    ///
    /// # Errors
    /// [`NonsmoothError::ForeignCheckpoint`]; the march is then what it was.
    pub fn resume(&mut self, checkpoint: &MarchCheckpoint) -> Result<(), NonsmoothError> {
        let MarchCheckpoint { z, v, before, relative, impulse, motion, eliminated, travelling, .. } =
            checkpoint;
        let (size, components) = (self.z.len(), self.relative.len());
        let fits = [z, v, before].iter().all(|own| own.len() == size)
            && [relative, impulse].iter().all(|own| own.len() == components)
            && motion.len() == self.gap.len()
            && self.travel.as_ref().map_or(travelling.is_empty(), |travel| travel.fits(travelling))
            && eliminated.as_ref().is_none_or(|slopes| slopes.are_of(components));
        if !fits {
            return Err(NonsmoothError::ForeignCheckpoint);
        }
        self.z.copy_from_slice(z);
        self.v.copy_from_slice(v);
        self.next.copy_from_slice(before);
        self.relative.copy_from_slice(relative);
        self.before_step.copy_from_slice(relative);
        self.solution = ContactSolution::none(&self.delassus);
        self.solution.impulse.copy_from_slice(impulse);
        self.solution.motion.copy_from_slice(motion);
        if let Some(travel) = &mut self.travel {
            travel.resume(travelling, &mut self.delassus);
        }
        if let Some(slopes) = eliminated {
            let mut memory = self.solution.take_memory(&self.delassus);
            memory.recall(&self.delassus, slopes);
            self.solution.memory = Some(memory);
        }
        (self.steps, self.rounding, self.scale) = (checkpoint.steps, checkpoint.rounding, checkpoint.scale);
        (self.works, self.record) = (checkpoint.works, checkpoint.record);
        self.look();
        Ok(())
    }
}
