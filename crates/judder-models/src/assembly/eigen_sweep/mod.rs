//! `eigen-sweep`: complex modes about steady sliding along any key.

mod run;
pub(super) mod solved;

use super::AssemblySubject;
use super::linear_size::of_sweep;
use super::swept::{SWEPT, SoughtRegion};
use crate::assembly::case::AssemblyCase;
use crate::error::ModelError;
use crate::key_sweep::KeySweep;
use crate::key_unit::{in_unit, unit_of_any};
use crate::structure::eigen_sweep::branches::EigenvalueCurve;
use crate::structure::eigen_sweep::figure;
use crate::structure::eigen_sweep::settings::MethodKeys;
use judder_keys::Settings;
use judder_keys::declared::Settings;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use run::ToldSweep;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// Complex modes about steady sliding along any key.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct AssemblySweep {
    /// Any number of `structure`, `contact`, `spring`, `load` or `parameters` over a range; each value is a case of its own.
    #[key(rule = SWEPT, example = "…, `{ key, from, to, points, scale }`, or `{ key, values }`")]
    pub sweep: KeySweep,
    /// Where modes are sought.
    #[key(flatten)]
    pub sought: SoughtRegion,
    /// Whether structures are damped, and friction follows the velocity; without, what is found is where frequencies lock in.
    #[key(default = true)]
    pub damping: bool,
    /// How each value is solved.
    #[key(flatten)]
    pub(crate) method: MethodKeys,
}

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "eigen-sweep",
    doc: "complex modes about steady sliding along any key, and where they begin to grow",
    declared: AssemblySweep::declarations,
    read: |case, section| {
        let own = AssemblySweep::read_table(section)?;
        if let (Some(case), Some(node)) = (case, section.get("sweep")) {
            own.sweep.admit(node, |value| case.at(&[(&own.sweep, value)]))?;
        }
        Ok(Arc::new(own))
    },
    picture: Some(Picture {
        draw: figure::eigen_sweep,
        caption: "Complex modes about steady sliding. Every branch is followed through the points where eigenvalues meet: where two frequencies lock in, \
        growth rates part. Squares are unstable; the axis of growth rates is logarithmic on both sides of zero. Among the damping ratios a bubble's area \
        is the magnitude of the damping ratio.",
    }),
};

impl Analysis<AssemblyCase> for AssemblySweep {
    fn steps(&self) -> usize {
        self.sweep.values.len()
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        Ok(of_sweep(of, self.sweep.values.len(), &["sweep"]))
    }

    fn run(&self, of: &AssemblySubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self, (task.own, task.progress))
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let keys = [EigenvalueCurve::declared(), ToldSweep::declared()].concat();
        in_unit(keys, &unit_of_any(&self.sweep), EigenvalueCurve::OF_KEY)
    }

    fn estimate(&self, _: &AssemblySubject<'_>) -> Result<String, ModelError> {
        let (count, path) = (self.sweep.values.len(), &self.sweep.path);
        Ok(format!("complex modes at {count} values of {path}, {}", self.method.method()))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
