//! `critical-shear-strength`, `critical-load`: thresholds along one key.

mod found;
mod onsets;
mod run;
pub(super) mod tables;
mod within_law;

use super::{KnownOscillator, Operated, OscillatorSubject, curves, ends_of_curves, points_of_curves};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::settings::{CriticalThresholds, SoughtThresholds, thresholds};
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The figure.
const PICTURE: Picture = Picture {
    draw: curves::critical,
    caption: "All thresholds in the searched range. Dashed: without damping, eqs. (27), (28) made self-consistent. Solid: where the \
        full, damped system gains or loses stability. Where branches were followed: circles and squares tell super- from subcritical \
        thresholds, and the dash-dotted curve is the least fold over all motions that are known beside one; between it and the threshold \
        steady sliding is stable, but a knock may start one. Beyond it a search found none, which proves nothing of those that it \
        missed.",
};

/// The kind of critical shear strengths.
pub(crate) const OF_SHEAR_STRENGTH: Kind<OscillatorKeys, Arc<dyn Operated>> = Kind {
    name: SoughtThresholds::ShearStrength.kind(),
    doc: "the critical shear strengths along one key",
    declared: || thresholds(SoughtThresholds::ShearStrength),
    read: |keys, section| {
        Ok(Arc::new(CriticalThresholds::read(keys, section, SoughtThresholds::ShearStrength)?))
    },
    picture: Some(PICTURE),
};

/// The kind of critical loads.
pub(crate) const OF_LOAD: Kind<OscillatorKeys, Arc<dyn Operated>> = Kind {
    name: SoughtThresholds::Load.kind(),
    doc: "the critical loads along one key",
    declared: || thresholds(SoughtThresholds::Load),
    read: |keys, section| Ok(Arc::new(CriticalThresholds::read(keys, section, SoughtThresholds::Load)?)),
    picture: Some(PICTURE),
};

impl Analysis<OscillatorCase> for CriticalThresholds {
    fn steps(&self) -> usize {
        points_of_curves(&self.sweep, self.family.as_ref())
    }

    fn summary_keys(&self) -> Vec<Declared> {
        run::summary_keys(self)
    }

    fn run(&self, of: &OscillatorSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.contact, self, (task.own, task.progress))
    }

    fn memory(&self, _: &KnownOscillator<'_>) -> Result<NeededMemory, ModelError> {
        Ok(memory_of_points(self.steps() as u128, point_bytes::THRESHOLDS, &["sweep.points"]))
    }

    fn estimate(&self, &KnownOscillator { name, .. }: &KnownOscillator<'_>) -> Result<Estimate, ModelError> {
        let margin = if self.global_margin { cost::MARGIN } else { 0.0 };
        let (points, each) = (self.steps(), cost::THRESHOLDS + margin);
        Ok(Estimate::of_points(name, points, points as f64 * each))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Operated for CriticalThresholds {
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        ends_of_curves(inputs, &self.sweep, self.family.as_ref())
    }
}
