//! `eigen-sweep`: complex modes along a parameter.

mod figure;
mod run;

use super::Subject;
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Task};
use crate::models::structure::case::StructureCase;
use crate::models::structure::case::analysis::{EigenMethod, EigenSweep};
use crate::outcome::Outcome;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "eigen-sweep",
    draw: figure::eigen_sweep,
    caption: "Every branch is followed through the points where eigenvalues meet: where two frequencies lock in, growth rates part. Squares are \
        unstable; the axis of growth rates is logarithmic on both sides of zero. Among the damping ratios a bubble's area is the magnitude of the damping \
        ratio.",
};

impl Analysis<StructureCase> for EigenSweep {
    fn steps(&self) -> usize {
        self.sweep.values.len() * self.family.as_ref().map_or(1, |family| family.values.len())
    }

    fn run(&self, of: &Subject<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        run::run((of.case, of.structure), self, task.progress)
    }

    fn estimate(&self, _: &Subject<'_>) -> Result<String, StudyError> {
        let (count, path) = (self.sweep.values.len(), &self.sweep.path);
        let method = match self.method {
            EigenMethod::Full => "full".to_owned(),
            EigenMethod::Projected { tolerance } => format!("projected to {tolerance:e}"),
        };
        let curves = self.family.as_ref().map_or_else(String::new, |family| {
            format!(" for each of {} values of {}", family.values.len(), family.path)
        });
        Ok(format!("complex modes at {count} values of {path}{curves}, {method}"))
    }
}
