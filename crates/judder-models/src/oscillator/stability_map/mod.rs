//! `stability-map`: verdict and mechanism over two keys.

mod arrays;
pub(crate) mod figure;
mod knock;
mod overlays;
mod run;
pub(crate) mod tables;
mod within_law;

pub(crate) use arrays::{MapArrays, MapWords, ONE_WAY, ToldStabilityMap, class_name};
pub(crate) use knock::{NONE_MOVED, STARTS_IT, UNKNOWN};
pub use overlays::{BoundaryCurves, BoundaryKind, boundary_curves};
pub(crate) use overlays::{Overlay, incomplete};
pub(crate) use run::{checked_points, unresolved_warning};
pub use within_law::STANDINGS;
pub(crate) use within_law::WITHIN_LAW;

use super::{KnownOscillator, Operated, OscillatorSubject, ends};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::settings;
use crate::sweep::StabilityMapAnalysis;
use arrays::NORMAL_FORCE;
use judder_oscillator::map::DecisionMethod;
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use knock::ToldKnock;
use serde_json::{Map, Value as Json};
use std::sync::Arc;
use within_law::ToldWithin;

/// The kind.
pub(crate) const KIND: Kind<OscillatorKeys, Arc<dyn Operated>> = Kind {
    name: "stability-map",
    doc: "stable and unstable points over two keys",
    declared: settings::map_keys,
    read: |keys, section| Ok(Arc::new(StabilityMapAnalysis::<OscillatorKey>::read(keys, section)?)),
    picture: Some(Picture {
        draw: figure::stability_map,
        caption: "Stability of steady sliding, coloured by what carries the instability. Curves are followed by continuation: \
        full system (solid black), without damping (dashed), full system with $η = 0$ (red). Where it is hatched, steady sliding is \
        stable, but a motion lives beside it, which a knock can start; where it is dotted, what a knock does is not known.",
    }),
};

impl Analysis<OscillatorCase> for StabilityMapAnalysis<OscillatorKey> {
    /// The decisions and the boundaries are a step each, the growth rates one a row.
    fn steps(&self) -> usize {
        if self.options.method == DecisionMethod::EveryPoint { 2 + self.y.points } else { 2 }
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let mut keys = ToldStabilityMap::keys(NORMAL_FORCE);
        keys.extend(Option::<ToldWithin>::declared());
        if self.global_margin {
            keys.extend(ToldKnock::declared());
        }
        keys
    }

    fn run(&self, of: &OscillatorSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.contact, self, (task.own, task.progress))
    }

    fn memory(&self, _: &KnownOscillator<'_>) -> Result<NeededMemory, ModelError> {
        let each = match self.options.method {
            DecisionMethod::EveryPoint => point_bytes::GROWTH_MAP,
            DecisionMethod::Adaptive => point_bytes::MAP,
        };
        Ok(memory_of_points(self.x.points as u128 * self.y.points as u128, each, &["x.points"]))
    }

    fn estimate(&self, &KnownOscillator { name, .. }: &KnownOscillator<'_>) -> Result<Estimate, ModelError> {
        let points = self.x.points * self.y.points;
        let decisions = match self.options.method {
            DecisionMethod::EveryPoint => points as f64 * (cost::DECISION + cost::EIGENVALUES),
            // about two dozen decisions along each unit of the sides
            DecisionMethod::Adaptive => {
                (24 * (self.x.points + self.y.points)).min(2 * points) as f64 * 2.0 * cost::DECISION
            }
        };
        let lines = self.x.points.max(self.y.points).min(cost::MARGIN_LINES);
        let margins = if self.global_margin { lines as f64 * cost::MARGIN } else { 0.0 };
        let boundaries = if self.options.boundaries { cost::BOUNDARIES } else { 0.0 };
        Ok(Estimate::of_points(name, points, decisions + margins + boundaries))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Operated for StabilityMapAnalysis<OscillatorKey> {
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        ends(&self.y, ends(&self.x, vec![*inputs]))
    }
}
