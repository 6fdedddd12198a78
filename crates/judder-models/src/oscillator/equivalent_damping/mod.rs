//! `equivalent-damping`: ξ_eq along one key.

mod run;
pub(super) mod tables;

use super::{KnownOscillator, Operated, OscillatorSubject, curves, ends_of_curves, points_of_curves};
use crate::axis::keys_of_curves;
use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::key_unit::{in_unit, unit_of};
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::settings::{self, DampingCurves};
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use run::{EQUIVALENT_DAMPING, ToldDamping};
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// The kind.
pub(crate) const KIND: Kind<OscillatorKeys, Arc<dyn Operated>> = Kind {
    name: "equivalent-damping",
    doc: "the equivalent damping ratio along one key",
    declared: settings::curves,
    read: |keys, section| Ok(Arc::new(DampingCurves::read(keys, section)?)),
    picture: Some(Picture {
        draw: curves::equivalent_damping,
        caption: "Equivalent damping $ξ_{eq} = c_{11}/2$, eq. (23). The vertical axis is logarithmic on both sides of zero. \
        Below zero, friction that falls with speed feeds the motion.",
    }),
};

impl Analysis<OscillatorCase> for DampingCurves {
    fn steps(&self) -> usize {
        points_of_curves(&self.sweep, self.family.as_ref())
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let curve = [ToldDamping::declared(), EQUIVALENT_DAMPING.keys()].concat();
        let keys = keys_of_curves(self.family.is_some(), curve);
        in_unit(keys, &unit_of::<OscillatorKeys>(&self.sweep), &["value"])
    }

    fn run(&self, of: &OscillatorSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.contact, &self.sweep, self.family.as_ref(), task.progress)
    }

    fn memory(&self, _: &KnownOscillator<'_>) -> Result<NeededMemory, ModelError> {
        Ok(memory_of_points(self.steps() as u128, point_bytes::DAMPING, &["sweep.points"]))
    }

    fn estimate(&self, &KnownOscillator { name, .. }: &KnownOscillator<'_>) -> Result<Estimate, ModelError> {
        let seconds = self.steps() as f64 * cost::EIGENVALUES;
        Ok(Estimate::of_points(name, self.steps(), seconds))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Operated for DampingCurves {
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        ends_of_curves(inputs, &self.sweep, self.family.as_ref())
    }
}
