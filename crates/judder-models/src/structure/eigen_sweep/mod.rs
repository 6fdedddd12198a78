//! `eigen-sweep`: complex modes along a parameter.

pub(crate) mod branches;
pub(crate) mod figure;
pub(crate) mod kept_points;
pub(crate) mod onsets;
mod run;
pub mod settings;
pub(crate) mod tables;

use super::{StructureSubject, solved_size};
use crate::axis::keys_of_curves;
use crate::error::ModelError;
use crate::key_unit::in_unit;
use crate::structure::case::StructureCase;
use crate::structure::case::scope::StructureScope;
use branches::EigenvalueCurve;
use judder_store::{Declared, Results};
use judder_structure::eigen_sweep::SweepMethod;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use run::ToldEigenSweep;
use serde_json::{Map, Value as Json};
use settings::EigenSweep;
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<StructureScope, Arc<dyn Analysis<StructureCase>>> = Kind {
    name: "eigen-sweep",
    doc: "complex modes along a parameter, followed through where they meet",
    declared: settings::declarations,
    read: |scope, section| Ok(Arc::new(EigenSweep::read(scope, section)?)),
    picture: Some(Picture {
        draw: figure::eigen_sweep,
        caption: "Every branch is followed through the points where eigenvalues meet: where two frequencies lock in, growth rates part. Squares are \
        unstable; the axis of growth rates is logarithmic on both sides of zero. Among the damping ratios a bubble's area is the magnitude of the damping \
        ratio.",
    }),
};

impl Analysis<StructureCase> for EigenSweep {
    fn steps(&self) -> usize {
        self.sweep.values.len() * self.family.as_ref().map_or(1, |family| family.values.len())
    }

    fn run(&self, of: &StructureSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.structure, self, (task.own, task.progress))
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let mut keys = keys_of_curves(self.family.is_some(), EigenvalueCurve::declared());
        keys.extend(ToldEigenSweep::declared());
        in_unit(keys, "1", EigenvalueCurve::OF_KEY)
    }

    fn memory(&self, of: &StructureSubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(solved_size::complex_modes(of.structure))
    }

    fn estimate(&self, _: &StructureSubject<'_>) -> Result<String, ModelError> {
        let (count, path) = (self.sweep.values.len(), &self.sweep.path);
        let method = match self.method {
            SweepMethod::Full => "full".to_owned(),
            SweepMethod::Projected { tolerance } => format!("projected to {tolerance:e}"),
        };
        let curves = self.family.as_ref().map_or_else(String::new, |family| {
            format!(" for each of {} values of {}", family.values.len(), family.path)
        });
        Ok(format!("complex modes at {count} values of {path}{curves}, {method}"))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
