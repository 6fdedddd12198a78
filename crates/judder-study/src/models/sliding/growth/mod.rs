//! `growth`: the growth of a mode in a march with the contact held, against the eigenvalue there.

mod figure;
mod history;
mod run;

use super::system::{method, step};
use super::{Subject, blame, cost};
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Refusal, Task};
use crate::models::sliding::case::SlidingCase;
use crate::models::sliding::case::growth::Growth;
use crate::outcome::Outcome;
use crate::resolve::{Estimate, cost::FIGURE};
use std::f64::consts::TAU;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "growth",
    draw: figure::growth,
    caption: "The contact held, the pair started in one mode of 10^{−5} of the normal force: the largest deviation of the normal force in each period, and \
        how the eigenvalue says that it grows, from the same start. Nothing is fitted to the line; the shaded interval is where the march's own rate is \
        measured.",
};

impl Analysis<SlidingCase> for Growth {
    fn admit(&self, of: &Subject<'_>) -> Result<(), StudyError> {
        let (pair, motion) = (&of.system.pair, of.system.motion.held(self.position));
        pair.edge_point(self.position)?;
        step(pair, method(self.method()), self.step, motion)?;
        Ok(())
    }

    fn run(&self, of: &Subject<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        run::run((of.case, of.system), self, task.progress)
    }

    fn blame(&self, error: &StudyError) -> Option<Refusal> {
        blame::off_track(error, ("position", Some(self.position)))
    }

    fn estimate(&self, of: &Subject<'_>) -> Result<Estimate, StudyError> {
        let step = cost::step(of.system, self.method(), self.step, of.system.motion.held(self.position));
        let steps = cost::PERIODS * TAU / self.frequency / step;
        let seconds = steps * of.system.pair.modes() as f64 * cost::STEP_AND_MODE + FIGURE;
        Ok(Estimate { name: of.name.to_owned(), points: steps as usize, seconds, bytes: 0 })
    }
}
