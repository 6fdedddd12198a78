//! What grows from a threshold of the oscillator, and how far beside it a knock starts a motion.

use crate::bridge;
use crate::outcome::{CheckRecord, Disagreement};
use crate::progress::Progress;
use judder_case::{Form, OscillatorInputs, OscillatorKey, Value};
use judder_numerics::piecewise::Settings;
use judder_oscillator::Contact;
use judder_oscillator::critical::{Range, Scale};
use judder_oscillator::cycle::shooting::Shooting;
use judder_oscillator::cycle::{
    Branch, BranchEnd, BranchPoint, Continuation, CycleError, GlobalMargin, global_margin, shoot,
};
use judder_oscillator::hopf::{HopfPoint, growth_rate, growth_slope, hopf_point};
use judder_oscillator::motion::attractor::{Attractor, Patience, Settled, settle};
use judder_oscillator::motion::{Interrupted, SlidingSystem, StickSlip};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Local error of a step; smooth folds of the paper's law come out to 1e-6 with it.
const TOLERANCE: f64 = 1e-8;
/// The most steps of one flight around a cycle, its longest time, and the most flights and cycles of one branch: what bounds the time
/// that a threshold can take. Most branches turn within a few hundred flights.
const STEPS: usize = 100_000;
const LONGEST_PERIOD: f64 = 2000.0;
const FLIGHTS: usize = 4000;
const CYCLES: usize = 400;
/// The first and the longest step along a branch, in the magnitudes of steady sliding: large cycles are thousands of them.
const STEP: (f64, f64) = (0.01, 8.0);

/// A quantity along which steady sliding gains or loses stability.
#[derive(Clone, Copy)]
pub(super) struct Crossing<'a> {
    pub(super) contact: &'a Contact,
    /// All other inputs.
    pub(super) inputs: OscillatorInputs,
    /// The quantity.
    pub(super) key: OscillatorKey,
    pub(super) form: Form,
    /// Where cycles are followed.
    pub(super) range: Range,
}

/// A threshold with the mode that grows from it.
pub(super) struct Onset {
    pub(super) threshold: f64,
    pub(super) hopf: HopfPoint<4>,
    /// +1 where steady sliding is stable above the threshold, −1 where it is below.
    pub(super) stable_side: f64,
    /// d(rms²)/d(quantity).
    pub(super) amplitude_factor: f64,
    /// How far a knock reaches; `None` beside a supercritical threshold, and where it was not asked for.
    pub(super) margin: Option<Margin>,
}

/// The branch of cycles beside a subcritical threshold.
pub(super) struct Margin {
    /// Its first turn.
    pub(super) fold: Option<f64>,
    /// The value farthest from the threshold at which a cycle of it is known.
    pub(super) reaches: Option<f64>,
    /// Whether it is not known where it turns.
    pub(super) is_open: bool,
    /// Where it ends, in words.
    pub(super) end: String,
    /// A stable cycle behind the fold.
    large: Option<[f64; 4]>,
}

impl Crossing<'_> {
    /// The value at a place `s` along the branch: s is the logarithm of the quantity over the threshold, or on a linear axis their
    /// difference over its length.
    pub(super) fn value(&self, threshold: f64, s: f64) -> f64 {
        match self.range.scale {
            Scale::Logarithmic => threshold * s.exp(),
            Scale::Linear => threshold + s * (self.range.to - self.range.from).abs(),
        }
    }

    /// The place of a value.
    pub(super) fn place(&self, threshold: f64, value: f64) -> f64 {
        match self.range.scale {
            Scale::Logarithmic => (value / threshold).ln(),
            Scale::Linear => (value - threshold) / (self.range.to - self.range.from).abs(),
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
    pub(super) fn onset(&self, threshold: f64) -> Option<Onset> {
        let hopf = hopf_point(&self.system(threshold).ok()?).ok()?;
        let growth = |s: f64| growth_rate(&self.system(self.value(threshold, s)).ok()?).ok();
        let slope = growth_slope(growth, 0.0, 1.0).filter(|slope| *slope != 0.0)?;
        let per_value = match self.range.scale {
            Scale::Logarithmic => threshold,
            Scale::Linear => (self.range.to - self.range.from).abs(),
        };
        let amplitude_factor = hopf.amplitude_factor(slope / per_value);
        Some(Onset { threshold, hopf, stable_side: -slope.signum(), amplitude_factor, margin: None })
    }

    /// The mode at a threshold with its branch; one that is interrupted ends early.
    pub(super) fn onset_with_margin(&self, threshold: f64, progress: &dyn Progress) -> Option<Onset> {
        let onset = self.onset(threshold)?;
        if !onset.hopf.is_subcritical() {
            return Some(onset);
        }
        let margin = match self.follow(&onset, progress) {
            Ok(followed) => self.margin(&onset, &followed),
            Err(error) => Margin::unknown(format!("not started: {error}")),
        };
        Some(Onset { margin: Some(margin), ..onset })
    }

    /// Whether a branch turns only because its cycles shrink to steady sliding, at another threshold: a step over that lands on the
    /// branch again.
    fn meets_threshold(&self, onset: &Onset, branch: &Branch<4>, turn: f64) -> bool {
        /// Of the largest amplitude; and of the place.
        const SMALL: f64 = 0.1;
        const NEAR: f64 = 0.01;
        let Some(after) = branch.folds.first().map(|fold| fold.after) else { return false };
        let amplitude = |point: &BranchPoint<4>| point.cycle.around.measures.amplitude();
        let largest = branch.points.iter().take(after).map(amplitude).fold(0.0, f64::max);
        let nearest = branch.points.iter().skip(after).take(2).map(amplitude).fold(f64::INFINITY, f64::min);
        let growth = |s: f64| {
            let system = self.system(self.value(onset.threshold, s));
            system.and_then(|system| growth_rate(&system)).unwrap_or(f64::NAN)
        };
        nearest < SMALL * largest && growth(turn - NEAR) * growth(turn + NEAR) < 0.0
    }

    /// What becomes of the stable large cycle a little inside of a fold, and of the same start as much outside; `None` where there is
    /// no such cycle.
    fn fates_about(
        &self,
        threshold: f64,
        fold: f64,
        start: [f64; 4],
        progress: &dyn Progress,
    ) -> Option<[Fate; 2]> {
        let within = inside(fold);
        let fate = |s: f64, start: [f64; 4]| {
            let system = self.system(self.value(threshold, s));
            system.map_or(Fate::Lost, |system| Fate::of(&system, start, &|| progress.interrupted()))
        };
        let system = self.system(self.value(threshold, within)).ok()?;
        let large = shoot(&system, start, 1, &Self::shooting(&system)).ok()?;
        large.is_stable().then(|| [fate(within, large.start), fate(2.0 * fold - within, large.start)])
    }

    fn settings(system: &StickSlip) -> Settings<4> {
        let absolute = system.scales().map(|scale| TOLERANCE * scale);
        Settings { relative: TOLERANCE, absolute, longest_step: 1.0, steps: STEPS }
    }

    fn shooting(system: &StickSlip) -> Shooting<4> {
        let settings = Self::settings(system);
        Shooting { settings, tolerance: 100.0 * TOLERANCE, iterations: 12, longest: LONGEST_PERIOD }
    }

    fn follow(&self, onset: &Onset, progress: &dyn Progress) -> Result<GlobalMargin<4>, CycleError> {
        let flights = AtomicUsize::new(0);
        let system_at = |s: f64| {
            let flights = flights.fetch_add(1, Ordering::Relaxed);
            if flights >= FLIGHTS || progress.interrupted() {
                return Err(CycleError::Stopped { flights });
            }
            self.system(self.value(onset.threshold, s))
        };
        let shooting = Self::shooting(&self.system(onset.threshold)?);
        let ends = [self.range.from, self.range.to].map(|end| self.place(onset.threshold, end));
        // behind the fold the branch comes back; beyond the threshold it tells nothing of the margin
        let range = match onset.stable_side > 0.0 {
            true => (0.0, ends[0].max(ends[1])),
            false => (ends[0].min(ends[1]), 0.0),
        };
        let options = Continuation { shooting, range, steps: STEP, points: CYCLES, parameter_scale: 1.0 };
        global_margin(&system_at, 0.0, onset.stable_side, &options)
    }

    fn margin(&self, onset: &Onset, followed: &GlobalMargin<4>) -> Margin {
        let Some(branch) = &followed.branch else { return Margin::unknown(String::new()) };
        let turn = followed.fold.filter(|_| !is_unfinished(branch));
        let meets_threshold = turn.is_some_and(|turn| self.meets_threshold(onset, branch, turn));
        let fold = turn.filter(|_| !meets_threshold);
        let value = |s: f64| self.value(onset.threshold, s);
        // a branch that is back at the threshold has turned where its steps were too long to see it
        let is_away = branch.points.last().is_some_and(|point| point.parameter * onset.stable_side > 0.0);
        let ends_well =
            meets_threshold || (is_away && matches!(branch.end, BranchEnd::Range | BranchEnd::SteadySliding));
        let (from, to) = (self.range.from.min(self.range.to), self.range.from.max(self.range.to));
        let end = match (fold, is_away) {
            (Some(_), _) => "fold".to_owned(),
            (None, _) if meets_threshold => "another threshold".to_owned(),
            (None, true) => branch.end.to_string(),
            (None, false) => "comes back to the threshold, and its turn was not seen".to_owned(),
        };
        Margin {
            fold: fold.map(value),
            reaches: turn
                .filter(|_| meets_threshold)
                .or_else(|| followed.reaches(0.0))
                .map(|s| value(s).clamp(from, to)),
            is_open: fold.is_none() && !ends_well,
            end,
            large: fold.and_then(|fold| large_cycle(branch, inside(fold))),
        }
    }
}

/// Whether a branch was stopped while its last turn was being located.
fn is_unfinished(branch: &Branch<4>) -> bool {
    let stopped = matches!(branch.end, BranchEnd::Lost(CycleError::Stopped { .. }));
    stopped && branch.folds.first().is_some_and(|fold| fold.after + 2 >= branch.points.len())
}

/// A place a little before a fold: a hundredth, less where the threshold is near.
fn inside(fold: f64) -> f64 {
    fold - fold.signum() * (0.3 * fold.abs()).min(0.01)
}

/// The start of the stable cycle behind the first fold that is nearest to a place; `None` where that is far from it.
fn large_cycle(branch: &Branch<4>, place: f64) -> Option<[f64; 4]> {
    const FAR: f64 = 0.1;
    let first = branch.folds.first()?.after + 1;
    let last = branch.folds.get(1).map_or(branch.points.len(), |fold| fold.after + 1);
    let away = |parameter: f64| (parameter - place).abs();
    let behind = branch.points.get(first..last)?.iter();
    let stable = behind.filter(|point| point.cycle.is_stable() && away(point.parameter) < FAR);
    stable.min_by(|a, b| away(a.parameter).total_cmp(&away(b.parameter))).map(|point| point.cycle.start)
}

impl Margin {
    fn unknown(end: String) -> Self {
        Self { fold: None, reaches: None, is_open: true, end, large: None }
    }
}

/// Folds of a result that are looked at by simulation, at most.
const LOOKED_AT: usize = 6;

/// What has become of a motion near a fold: nothing known, at rest, or the rms and whether it is a cycle of one oscillation.
#[derive(Clone, Copy, PartialEq)]
enum Fate {
    Lost,
    AtRest,
    Moving { rms: f64, is_simple: bool },
}

impl Fate {
    fn of(system: &StickSlip, start: [f64; 4], interrupted: Interrupted<'_>) -> Self {
        let settings = Settings { steps: 100 * STEPS, ..Crossing::settings(system) };
        match settle(system, start, settings, &Patience::default(), interrupted) {
            Err(_) => Self::Lost,
            Ok(Attractor { settled: Settled::SteadySliding, .. }) => Self::AtRest,
            Ok(attractor) => Self::Moving {
                rms: attractor.measures.rms(),
                is_simple: attractor.settled == Settled::Cycle { oscillations: 1 },
            },
        }
    }

    /// Whether two motions are on one branch a hundredth or two apart.
    fn is_like(self, other: Self) -> bool {
        const RMS: f64 = 0.1;
        match (self, other) {
            (Self::Moving { rms: a, is_simple: true }, Self::Moving { rms: b, is_simple: true }) => {
                (a / b - 1.0).abs() < RMS
            }
            _ => false,
        }
    }
}

/// Motions from large cycles, a little inside of some folds and as much outside: inside they must go on, outside they must not stay
/// on a cycle of the branch. With a warning where they do not die out there either.
pub(super) fn fold_check(
    onsets: &[(Crossing<'_>, &Onset)],
    progress: &dyn Progress,
) -> (Option<CheckRecord>, Option<String>) {
    let known: Vec<_> = onsets
        .iter()
        .filter_map(|(crossing, onset)| {
            let margin = onset.margin.as_ref()?;
            Some((crossing, onset.threshold, margin.fold?, margin.large?))
        })
        .collect();
    let some: Vec<_> = known.iter().step_by(known.len().div_ceil(LOOKED_AT).max(1)).collect();
    let motions: Vec<[Fate; 2]> = some
        .par_iter()
        .filter_map(|(crossing, threshold, fold, start)| {
            crossing.fates_about(*threshold, crossing.place(*threshold, *fold), *start, progress)
        })
        .collect();
    let count = motions.len();
    let is_wrong = |[within, beyond]: &[Fate; 2]| {
        matches!(within, Fate::Lost | Fate::AtRest) || *beyond == Fate::Lost || within.is_like(*beyond)
    };
    let others = motions.iter().filter(|[_, beyond]| matches!(beyond, Fate::Moving { .. })).count();
    let compared = format!(
        "number of {count} folds where a motion 1 % inside dies out, or one 1 % outside stays on the cycle"
    );
    let check = (count > 0).then(|| {
        let wrong = Disagreement::exceptions(motions.iter().map(is_wrong));
        CheckRecord::new("motions from large cycles end at the folds", compared, wrong, 0.0)
    });
    let warning = (others > 0).then(|| {
        format!(
            "at {others} of {count} folds looked at, a motion 1 % beyond does not die out: other cycles live there, and the fold is no safe limit"
        )
    });
    (check, warning)
}
