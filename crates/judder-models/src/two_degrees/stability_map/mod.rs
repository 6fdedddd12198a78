//! `stability-map`: stable and unstable points over two parameters.

mod run;

use super::Varying;
use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::oscillator::stability_map::{ONE_WAY, ToldStabilityMap, figure};
use crate::read_sweep::{map_declarations, read_map, write_map};
use crate::sweep::{ParameterKey, StabilityMapAnalysis};
use crate::swept_keys::ParameterKeys;
use crate::two_degrees::case::TwoDegreesCase;
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The kind.
pub(super) const KIND: Kind<ParameterKeys, Arc<dyn Varying>> = Kind {
    name: "stability-map",
    doc: "stable and unstable points over two parameters",
    declared: map_declarations::<ParameterKeys>,
    read: |keys, section| Ok(Arc::new(read_map(keys, section)?)),
    picture: Some(Picture {
        draw: figure::stability_map,
        caption: "Stability at the points of the map, coloured by what carries the instability. Curves are followed by continuation: \
        full system (solid black), without damping (dashed).",
    }),
};

impl Analysis<TwoDegreesCase> for StabilityMapAnalysis<ParameterKey> {
    fn summary_keys(&self) -> Vec<Declared> {
        ToldStabilityMap::keys(ONE_WAY)
    }

    fn run(&self, case: &&TwoDegreesCase, _: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(case, self)
    }

    fn memory(&self, _: &&str) -> Result<NeededMemory, ModelError> {
        Ok(memory_of_points(self.x.points as u128 * self.y.points as u128, point_bytes::MAP, &["x.points"]))
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, ModelError> {
        let points = self.x.points * self.y.points;
        Ok(Estimate::of_points(name, points, points as f64 * cost::EIGENVALUES))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        write_map::<ParameterKeys>(self, json);
    }
}

impl Varying for StabilityMapAnalysis<ParameterKey> {
    fn swept(&self) -> Vec<usize> {
        vec![self.x.key.index(), self.y.key.index()]
    }
}
