//! What grows from a threshold of the oscillator, and how far beside it a knock starts a motion.

mod fold_check;
mod own_branch;
mod search;

pub(super) use fold_check::fold_check;
pub(super) use own_branch::OwnBranch;
pub(crate) use search::NOT_KNOWN;
pub(super) use search::{MotionSearch, TOLD, ToldSearch, ToldStarts};

use crate::bridge;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use judder_keys::numeric_key::{Form, Value};
use judder_numerics::piecewise::StepSettings;
use judder_oscillator::Contact;
use judder_oscillator::critical::{ParameterRange, RangeScale};
use judder_oscillator::cycle::shooting::Shooting;
use judder_oscillator::cycle::{Continuation, CycleError};
use judder_oscillator::hopf::{HopfPoint, growth_rate, growth_slope, hopf_point};
use judder_oscillator::motion::{SlidingSystem, StickSlip};
use judder_study::Progress;
use judder_study::kept::KeptResults;
use serde::{Deserialize, Serialize};

/// Local error of a step; smooth folds of the paper's law come out to 1e-6 with it.
const TOLERANCE: f64 = 1e-8;
/// The most steps of one flight around a cycle, its longest time, and the most cycles of one branch: what bounds the time that a
/// threshold can take.
const STEPS: usize = 100_000;
const LONGEST_PERIOD: f64 = 2000.0;
const CYCLES: usize = 400;
/// The first and the longest step along a branch, in the magnitudes of steady sliding: large cycles are thousands of them.
const STEP: (f64, f64) = (0.01, 8.0);

/// A quantity along which steady sliding gains or loses stability.
#[derive(Clone, Copy)]
pub(super) struct MarginCrossing<'a> {
    pub(super) contact: &'a Contact,
    /// All other inputs.
    pub(super) inputs: OscillatorInputs,
    /// The quantity.
    pub(super) key: OscillatorKey,
    pub(super) form: Form,
    /// Where cycles are followed.
    pub(super) range: ParameterRange,
}

/// A threshold with the mode that grows from it.
pub(super) struct MarginOnset {
    pub(super) threshold: f64,
    pub(super) hopf: HopfPoint<4>,
    /// +1 where steady sliding is stable above the threshold, −1 where it is below.
    pub(super) stable_side: f64,
    /// d(rms²)/d(quantity).
    pub(super) amplitude_factor: f64,
    /// How far a knock reaches; `None` where it was not asked for.
    pub(super) margin: Option<Margin>,
}

/// What is known of motions beside stable steady sliding, on the stable side of a threshold.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct Margin {
    /// The branch that begins at the threshold; `None` beside a supercritical one.
    pub(super) own: Option<OwnBranch>,
    /// What lies beyond it.
    pub(super) search: MotionSearch,
}

/// What is known beside the thresholds of many crossings, by the places of these.
pub(super) type KeptMargins<'a> = KeptResults<'a, Vec<Option<Margin>>>;

impl Margin {
    /// The least fold over all known branches; `None` where there is none, and where they reach to the end of the range or to another
    /// threshold.
    pub(super) fn fold(&self) -> Option<f64> {
        match self.search.moves {
            0 => self.branch_fold(),
            _ => Some(self.search.farthest).filter(|_| !self.search.is_at_end),
        }
    }

    /// The first turn of the threshold's own branch.
    pub(super) fn branch_fold(&self) -> Option<f64> {
        self.own.as_ref()?.fold
    }

    /// The value farthest from the threshold at which a motion beside steady sliding is known.
    pub(super) fn reaches(&self, stable_side: f64) -> Option<f64> {
        let found = Some(self.search.farthest).filter(|_| self.search.moves > 0);
        let own = self.own.as_ref().and_then(|own| own.reaches);
        own.into_iter().chain(found).max_by(|a, b| (stable_side * a).total_cmp(&(stable_side * b)))
    }
}

impl MarginCrossing<'_> {
    /// The value at a place `s` along the branch: s is the logarithm of the quantity over the threshold, or on a linear axis their
    /// difference over its length.
    pub(super) fn value(&self, threshold: f64, s: f64) -> f64 {
        match self.range.scale {
            RangeScale::Logarithmic => threshold * libm::exp(s),
            RangeScale::Linear => threshold + s * (self.range.to - self.range.from).abs(),
        }
    }

    /// The place of a value.
    pub(super) fn place(&self, threshold: f64, value: f64) -> f64 {
        match self.range.scale {
            RangeScale::Logarithmic => libm::log(value / threshold),
            RangeScale::Linear => (value - threshold) / (self.range.to - self.range.from).abs(),
        }
    }

    /// All inputs where the quantity has this value.
    pub(super) fn inputs_at(&self, value: f64) -> OscillatorInputs {
        let mut inputs = self.inputs;
        inputs.set(self.key, Value { number: value, form: self.form });
        inputs
    }

    fn system(&self, value: f64) -> Result<StickSlip, CycleError> {
        let coefficients = bridge::groups(&self.inputs_at(value)).coefficients()?;
        Ok(StickSlip::new(self.contact.clone(), coefficients)?)
    }

    /// The mode at a threshold; `None` where it cannot be had.
    pub(super) fn onset(&self, threshold: f64) -> Option<MarginOnset> {
        let hopf = hopf_point(&self.system(threshold).ok()?).ok()?;
        let growth = |s: f64| growth_rate(&self.system(self.value(threshold, s)).ok()?).ok();
        let slope = growth_slope(growth, 0.0, 1.0).filter(|slope| *slope != 0.0)?;
        let per_value = match self.range.scale {
            RangeScale::Logarithmic => threshold,
            RangeScale::Linear => (self.range.to - self.range.from).abs(),
        };
        let amplitude_factor = hopf.amplitude_factor(slope / per_value);
        Some(MarginOnset { threshold, hopf, stable_side: -slope.signum(), amplitude_factor, margin: None })
    }

    /// The mode at one of all `thresholds`, with its branch and what was found beyond it; what is interrupted ends early.
    fn onset_with_margin(
        &self,
        threshold: f64,
        thresholds: &[f64],
        progress: &dyn Progress,
    ) -> Option<MarginOnset> {
        let onset = self.onset(threshold)?;
        let own = onset.hopf.is_subcritical().then(|| self.own_branch(&onset, progress));
        let away = |other: &f64| (other - threshold) * onset.stable_side;
        let on_the_side = thresholds.iter().copied().filter(|other| away(other) > 0.0);
        let next = on_the_side.min_by(|a, b| away(a).total_cmp(&away(b)));
        let search = self.search(&onset, own.as_ref(), next, progress);
        Some(MarginOnset { margin: Some(Margin { own, search }), ..onset })
    }

    /// The modes at all `thresholds` of the crossing at a place of many, with what a knock does beside them: as an earlier run has kept it, or found and kept.
    pub(super) fn onsets_with_margins(
        &self,
        place: usize,
        thresholds: &[f64],
        (kept, progress): (&KeptMargins<'_>, &dyn Progress),
    ) -> Vec<Option<MarginOnset>> {
        if let Some(known) = kept.known(place as u64) {
            let onset = |(threshold, margin): (&f64, &Option<Margin>)| {
                Some(MarginOnset { margin: margin.clone(), ..self.onset(*threshold)? })
            };
            return thresholds.iter().zip(known).map(onset).collect();
        }
        let found = thresholds.iter().map(|own| self.onset_with_margin(*own, thresholds, progress));
        let found: Vec<Option<MarginOnset>> = found.collect();
        // what is interrupted has ended early
        if !progress.interrupted() {
            kept.keep(place as u64, &found.iter().map(|own| own.as_ref()?.margin.clone()).collect());
        }
        found
    }

    /// The places beside a threshold on its stable side, and how cycles are followed there: what lies beyond the threshold tells
    /// nothing of the margin.
    fn continuation(&self, onset: &MarginOnset) -> Result<Continuation<4>, CycleError> {
        let shooting = Self::shooting(&self.system(onset.threshold)?);
        let ends = [self.range.from, self.range.to].map(|end| self.place(onset.threshold, end));
        let range = match onset.stable_side > 0.0 {
            true => (0.0, ends[0].max(ends[1])),
            false => (ends[0].min(ends[1]), 0.0),
        };
        Ok(Continuation { shooting, range, steps: STEP, points: CYCLES, parameter_scale: 1.0 })
    }

    fn settings(system: &StickSlip) -> StepSettings<4> {
        let absolute = system.scales().map(|scale| TOLERANCE * scale);
        StepSettings { relative: TOLERANCE, absolute, longest_step: 1.0, steps: STEPS }
    }

    fn shooting(system: &StickSlip) -> Shooting<4> {
        let settings = Self::settings(system);
        Shooting { settings, tolerance: 100.0 * TOLERANCE, iterations: 12, longest: LONGEST_PERIOD }
    }
}

/// How many branches of thresholds have no known fold, and how many searches beyond did not close; `so` says what follows.
pub(super) fn open(margins: &[&Margin], so: &str) -> Vec<String> {
    let own: Vec<&OwnBranch> = margins.iter().filter_map(|margin| margin.own.as_ref()).collect();
    let without: Vec<&&OwnBranch> = own.iter().filter(|own| own.is_open).collect();
    let unclosed: Vec<String> = margins.iter().filter_map(|margin| margin.search.why_open()).collect();
    let mut warnings = Vec::new();
    if let Some(first) = without.first() {
        warnings.push(format!(
            "{} of {} branches of cycles have no fold, for one: {}; {so}",
            without.len(),
            own.len(),
            first.end
        ));
    }
    if let Some(first) = unclosed.first() {
        warnings.push(format!(
            "beyond {} of {} thresholds it is not known what a knock does, for one: {first}",
            unclosed.len(),
            margins.len()
        ));
    }
    warnings
}
