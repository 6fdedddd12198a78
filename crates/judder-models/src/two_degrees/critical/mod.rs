//! `critical`: the values of a parameter at which stability changes.

mod run;
pub(super) mod tables;

use super::Varying;
use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::read_sweep::{AxisKey, SWEEP};
use crate::sweep::{ParameterKey, Sweep};
use crate::swept_keys::ParameterKeys;
use crate::two_degrees::case::TwoDegreesCase;
use judder_store::{Declared, Results};
use judder_study::case::analysis::Kind;
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The values of one parameter at which stability changes.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterThresholds {
    /// The parameter, the range in which changes are sought, and the samples of the search.
    pub sweep: Sweep<ParameterKey>,
}

/// Where changes are sought.
const SAMPLES: AxisKey = SWEEP.of_points(400);

/// The kind.
pub(super) const KIND: Kind<ParameterKeys, Arc<dyn Varying>> = Kind {
    name: "critical",
    doc: "the values of a parameter at which stability changes",
    declared: || vec![SAMPLES.declaration::<ParameterKeys>()],
    read: |keys, section| Ok(Arc::new(ParameterThresholds { sweep: SAMPLES.read_alone(keys, section)? })),
    picture: None,
};

impl Analysis<TwoDegreesCase> for ParameterThresholds {
    fn summary_keys(&self) -> Vec<Declared> {
        run::ToldThresholds::declared()
    }

    fn run(&self, case: &&TwoDegreesCase, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(case, &self.sweep, task.progress)
    }

    fn memory(&self, _: &&str) -> Result<NeededMemory, ModelError> {
        Ok(memory_of_points(self.sweep.points as u128, point_bytes::SEARCHED, &["sweep.points"]))
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, ModelError> {
        let points = self.sweep.points;
        Ok(Estimate::of_points(name, points, points as f64 * cost::EIGENVALUES))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        SAMPLES.write::<ParameterKeys>(&self.sweep, json);
    }
}

impl Varying for ParameterThresholds {
    fn swept(&self) -> Vec<usize> {
        vec![self.sweep.key.index()]
    }
}
