//! `spectrum`: the eigenvalues along one parameter.

mod run;

use super::{LABELS, Varying};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::oscillator::curves;
use crate::oscillator::spectrum::ToldSpectra;
use crate::read_sweep::SWEEP;
use crate::sweep::{ParameterKey, Sweep};
use crate::swept_keys::ParameterKeys;
use crate::two_degrees::case::TwoDegreesCase;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The eigenvalues along one parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterSpectrum {
    /// The swept parameter.
    pub sweep: Sweep<ParameterKey>,
}

/// The kind.
pub(super) const KIND: Kind<ParameterKeys, Arc<dyn Varying>> = Kind {
    name: "spectrum",
    doc: "the eigenvalues along one parameter",
    declared: || vec![SWEEP.declaration::<ParameterKeys>()],
    read: |keys, section| Ok(Arc::new(ParameterSpectrum { sweep: SWEEP.read_alone(keys, section)? })),
    picture: Some(Picture {
        draw: |dataset| curves::spectrum(dataset, &LABELS),
        caption: "Eigenvalues of the matrices, growth rates and frequencies, per unit of time of the matrices: in 1/s and rad/s where these are in SI units. Solid: full system. Dashed: without \
        damping, $C$ = 0.",
    }),
};

impl Analysis<TwoDegreesCase> for ParameterSpectrum {
    fn summary_keys(&self) -> Vec<Declared> {
        ToldSpectra::declared()
    }

    fn run(&self, case: &&TwoDegreesCase, _: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(case, &self.sweep)
    }

    fn memory(&self, _: &&str) -> Result<NeededMemory, ModelError> {
        Ok(memory_of_points(self.sweep.points as u128, point_bytes::EIGENVALUES, &["sweep.points"]))
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, ModelError> {
        let points = self.sweep.points;
        Ok(Estimate::of_points(name, points, points as f64 * cost::EIGENVALUES))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        SWEEP.write::<ParameterKeys>(&self.sweep, json);
    }
}

impl Varying for ParameterSpectrum {
    fn swept(&self) -> Vec<usize> {
        vec![self.sweep.key.index()]
    }
}
