//! `critical-shear-strength`, `critical-load`: thresholds along one key.

mod onsets;
mod run;
mod within_law;

use super::{Operated, Subject, curves, ends_of_curves, points_of_curves};
use crate::error::StudyError;
use crate::model::{Analysis, Pictured, Task};
use crate::models::oscillator::case::OscillatorCase;
use crate::models::oscillator::inputs::OscillatorInputs;
use crate::models::oscillator::settings::CriticalThresholds;
use crate::outcome::Outcome;
use crate::resolve::{Estimate, cost};

/// The figure of critical shear strengths.
pub(crate) const OF_SHEAR_STRENGTH: Pictured = Pictured {
    kind: "critical-shear-strength",
    draw: curves::critical,
    caption: "All thresholds in the searched range. Dashed: without damping, eqs. (27), (28) made self-consistent. Solid: where the \
        full, damped system gains or loses stability. Where branches were followed: circles and squares tell super- from subcritical \
        thresholds, and the dash-dotted curve is the least fold over all motions that are known beside one; between it and the threshold \
        steady sliding is stable, but a knock may start one. Beyond it a search found none, which proves nothing of those that it \
        missed.",
};

/// The figure of critical loads.
pub(crate) const OF_LOAD: Pictured = Pictured { kind: "critical-load", ..OF_SHEAR_STRENGTH };

impl Analysis<OscillatorCase> for CriticalThresholds {
    fn steps(&self) -> usize {
        points_of_curves(&self.sweep, self.family.as_ref())
    }

    fn run(&self, of: &Subject<'_>, task: Task<'_>) -> Result<Outcome, StudyError> {
        run::run((of.case, of.contact), self, task.progress)
    }

    fn estimate(&self, name: &&str) -> Result<Estimate, StudyError> {
        let margin = if self.global_margin { cost::MARGIN } else { 0.0 };
        let (points, each) = (self.steps(), cost::THRESHOLDS + margin);
        Ok(Estimate::of_points(name, points, points as f64 * each))
    }
}

impl Operated for CriticalThresholds {
    fn corners(&self, inputs: &OscillatorInputs) -> Vec<OscillatorInputs> {
        ends_of_curves(inputs, &self.sweep, self.family.as_ref())
    }
}
