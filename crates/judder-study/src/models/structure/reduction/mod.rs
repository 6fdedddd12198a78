//! `reduction`: the reduced structure against the full one.

mod figure;
mod files;
mod run;

use super::Subject;
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Task};
use crate::models::structure::case::StructureCase;
use crate::models::structure::case::analysis::Compared;
use crate::outcome::Outcome;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "reduction",
    draw: figure::reduction,
    caption: "How far the frequencies of the reduced structure lie above those of the full one, and what the reduction alone says that this is at most. Below \
        its limit it says that every frequency is within 10^{−4}, the dotted level.",
};

impl Analysis<StructureCase> for Compared {
    fn run(&self, of: &Subject<'_>, _: Task<'_>) -> Result<Outcome, StudyError> {
        run::run((of.case, of.structure), of.name, self.count)
    }

    fn estimate(&self, _: &Subject<'_>) -> Result<String, StudyError> {
        Ok(format!("{} frequencies, reduced against full", self.count))
    }
}
