//! `modes`: undamped modes.

pub(super) mod figure;
mod run;

pub(crate) use run::run;

use super::Subject;
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Task};
use crate::models::structure::case::StructureCase;
use crate::models::structure::case::analysis::Modes;
use crate::outcome::Outcome;
use crate::text::short;
use std::f64::consts::TAU;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "modes",
    draw: figure::modes,
    caption: "Shapes over the body at rest (grey), displacements enlarged alike; on the page they swing. Last, how alike any two shapes are: the \
        modal assurance criterion, $|φ_{i}^{T}φ_{j}|^{2}$ over both lengths squared.",
};

impl Analysis<StructureCase> for Modes {
    fn run(&self, of: &Subject<'_>, _: Task<'_>) -> Result<Outcome, StudyError> {
        run((of.case, of.structure), of.name, *self, None)
    }

    fn estimate(&self, _: &Subject<'_>) -> Result<String, StudyError> {
        Ok(match self {
            Modes::Count(count) => format!("the lowest {count} modes"),
            Modes::Band([from, to]) => {
                format!("the modes from {} to {} Hz", short(from / TAU), short(to / TAU))
            }
        })
    }
}
