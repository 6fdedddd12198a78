//! `fit`: the three functions of the oscillator paper through a computed law.

mod run;

use super::check::ContactEstimate;
use super::law::figure;
use super::{Exciting, Subject};
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Refusal, Task};
use crate::models::contact::case::ContactCase;
use crate::models::contact::settings::FitSettings;
use crate::outcome::Outcome;
use judder_contact::law::sweep::SolvedPoint;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "fit",
    draw: figure::fit,
    caption: "Computed values (points) and the fitted functions (34), (36), (38) (curves); right, their difference over the largest value at \
        each indentation.",
};

/// The law that the functions are fitted to is refused, takes and excites what it does alone.
impl Analysis<ContactCase> for FitSettings {
    fn steps(&self) -> usize {
        self.law.steps()
    }

    fn fits(&self, of: &Subject<'_>) -> Result<Result<(), Refusal>, StudyError> {
        self.law.fits(of)
    }

    fn run(&self, of: &Subject<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        let known: Vec<SolvedPoint> = task.own.known();
        let keep = |point: &SolvedPoint| task.own.add(point);
        run::run(of.case, (&self.law, self.reading.velocity_scale), (&known, &keep), task.progress)
    }

    fn estimate(&self, of: &Subject<'_>) -> Result<ContactEstimate, StudyError> {
        self.law.estimate(of)
    }
}

impl Exciting for FitSettings {
    fn excited(&self, of: &Subject<'_>) -> Result<Vec<f64>, StudyError> {
        self.law.excited(of)
    }
}
