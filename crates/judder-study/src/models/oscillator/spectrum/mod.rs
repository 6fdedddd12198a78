//! `spectrum`: the eigenvalues along one key.

mod run;

pub(crate) use run::{Spectra, outcome};

use super::{Operated, Subject, curves, ends_of_curves, points_of_curves};
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Task};
use crate::models::oscillator::case::OscillatorCase;
use crate::models::oscillator::inputs::OscillatorInputs;
use crate::models::oscillator::settings::SpectrumCurves;
use crate::outcome::Outcome;
use crate::resolve::{Estimate, cost};

/// The figure.
pub(crate) const PICTURED: Pictured = Pictured {
    kind: "spectrum",
    draw: curves::spectrum,
    caption: "Eigenvalues in units of $ω_{nx}$: growth rates and frequencies. Solid: full system, eq. (21). Dashed: without \
        damping, eqs. (24), (25).",
};

impl Analysis<OscillatorCase> for SpectrumCurves {
    fn steps(&self) -> usize {
        points_of_curves(&self.sweep, self.family.as_ref())
    }

    fn run(&self, of: &Subject<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        run::run((of.case, of.contact), &self.sweep, self.family.as_ref(), task.progress)
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, StudyError> {
        Ok(Estimate::of_points(name, self.steps(), self.steps() as f64 * cost::EIGENVALUES))
    }
}

impl Operated for SpectrumCurves {
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        ends_of_curves(inputs, &self.sweep, self.family.as_ref())
    }
}
