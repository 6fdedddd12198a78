//! `eigen`: complex modes in a region of the plane.

mod diagnosis;
pub(crate) mod figure;
pub(super) mod run;

use super::Subject;
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Task};
use crate::models::structure::case::StructureCase;
use crate::models::structure::case::analysis::Eigen;
use crate::outcome::Outcome;

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "eigen",
    draw: figure::eigen,
    caption: "All eigenvalues found in the region; the axis of growth rates is logarithmic on both sides of zero. Damping ratios $ζ = −$Re $λ/|λ|$: a \
        bubble's area is their magnitude. Shapes of the fastest growing modes, which swing on the page, and how alike any two shapes are.",
};

impl Analysis<StructureCase> for Eigen {
    fn run(&self, of: &Subject<'_>, _: Task<'_>) -> Result<Outcome, StudyError> {
        run::run((of.case, of.structure), of.name, &self.region)
    }

    fn estimate(&self, _: &Subject<'_>) -> Result<String, StudyError> {
        let ([from, to], [low, high]) = (self.region.re, self.region.im);
        Ok(format!("complex modes, Re from {from} to {to}, Im from {low} to {high}"))
    }
}
