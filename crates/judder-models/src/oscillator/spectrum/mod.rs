//! `spectrum`: the eigenvalues along one key.

mod run;
pub(crate) mod tables;

pub(crate) use run::{Spectra, SpectraWords, ToldSpectra, outcome};

use super::{KnownOscillator, Operated, OscillatorSubject, curves, ends_of_curves, points_of_curves};
use crate::axis::keys_of_curves;
use crate::error::ModelError;
use crate::estimate::{Estimate, cost, memory_of_points, point_bytes};
use crate::key_unit::{in_unit, unit_of};
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::curves::SpectrumLabels;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::settings::{self, SpectrumCurves};
use judder_store::{Declared, Results};
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Task};
use judder_study::outcome::Outcome;
use run::GROWTH_RATE;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// What stands at axes and heads.
pub(super) const LABELS: SpectrumLabels = SpectrumLabels {
    growth: "Growth rate Re $λ$/$ω_{nx}$ (−)",
    frequency: "Frequency Im $λ$/$ω_{nx}$ (−)",
};

/// The kind.
pub(crate) const KIND: Kind<OscillatorKeys, Arc<dyn Operated>> = Kind {
    name: "spectrum",
    doc: "the eigenvalues along one key",
    declared: settings::curves,
    read: |keys, section| Ok(Arc::new(SpectrumCurves::read(keys, section)?)),
    picture: Some(Picture {
        draw: |dataset| curves::spectrum(dataset, &LABELS),
        caption: "Growth rates and frequencies, in units of $ω_{nx}$, of a case that is written in SI in 1/s and Hz. Solid: full system, eq. (21). Dashed: without \
        damping, eqs. (24), (25).",
    }),
};

impl Analysis<OscillatorCase> for SpectrumCurves {
    fn steps(&self) -> usize {
        points_of_curves(&self.sweep, self.family.as_ref())
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let curve = [ToldSpectra::declared(), GROWTH_RATE.keys()].concat();
        let keys = keys_of_curves(self.family.is_some(), curve);
        in_unit(keys, &unit_of::<OscillatorKeys>(&self.sweep), &["value"])
    }

    fn run(&self, of: &OscillatorSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.contact, &self.sweep, self.family.as_ref(), task.progress)
    }

    fn memory(&self, _: &KnownOscillator<'_>) -> Result<NeededMemory, ModelError> {
        Ok(memory_of_points(self.steps() as u128, point_bytes::EIGENVALUES, &["sweep.points"]))
    }

    fn estimate(&self, &KnownOscillator { name, .. }: &KnownOscillator<'_>) -> Result<Estimate, ModelError> {
        let seconds = self.steps() as f64 * cost::EIGENVALUES;
        Ok(Estimate::of_points(name, self.steps(), seconds))
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}

impl Operated for SpectrumCurves {
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        ends_of_curves(inputs, &self.sweep, self.family.as_ref())
    }
}
