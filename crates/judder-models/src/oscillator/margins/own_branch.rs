//! The branch of cycles that begins at a subcritical threshold.

use super::{MarginCrossing, MarginOnset};
use judder_oscillator::cycle::{
    BranchEnd, BranchPoint, CycleBranch, CycleError, GlobalMargin, global_margin,
};
use judder_oscillator::hopf::growth_rate;
use judder_study::Progress;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The most flights around a cycle of one branch: most branches turn within a few hundred.
const FLIGHTS: usize = 4000;

/// The branch of cycles beside a subcritical threshold.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct OwnBranch {
    /// Its first turn.
    pub(crate) fold: Option<f64>,
    /// The value farthest from the threshold at which a cycle of it is known.
    pub(crate) reaches: Option<f64>,
    /// Whether it is not known where it turns.
    pub(crate) is_open: bool,
    /// Whether it shrinks to steady sliding at another threshold.
    pub(super) meets_threshold: bool,
    /// Where it ends, in words.
    pub(crate) end: String,
    /// A stable cycle behind the fold.
    pub(super) large: Option<[f64; 4]>,
    /// The last cycle of it.
    pub(super) last: Option<[f64; 4]>,
}

impl OwnBranch {
    fn unknown(end: String) -> Self {
        Self {
            fold: None,
            reaches: None,
            is_open: true,
            meets_threshold: false,
            end,
            large: None,
            last: None,
        }
    }
}

impl MarginCrossing<'_> {
    /// The branch from a subcritical threshold; one that is interrupted ends early.
    pub(super) fn own_branch(&self, onset: &MarginOnset, progress: &dyn Progress) -> OwnBranch {
        match self.follow(onset, progress) {
            Ok(followed) => self.told_of(onset, &followed),
            Err(error) => OwnBranch::unknown(format!("not started: {error}")),
        }
    }

    fn follow(&self, onset: &MarginOnset, progress: &dyn Progress) -> Result<GlobalMargin<4>, CycleError> {
        let flights = AtomicUsize::new(0);
        let system_at = |s: f64| {
            let flights = flights.fetch_add(1, Ordering::Relaxed);
            if flights >= FLIGHTS || progress.interrupted() {
                return Err(CycleError::Stopped { flights });
            }
            self.system(self.value(onset.threshold, s))
        };
        global_margin(&system_at, 0.0, onset.stable_side, &self.continuation(onset)?)
    }

    fn told_of(&self, onset: &MarginOnset, followed: &GlobalMargin<4>) -> OwnBranch {
        let Some(branch) = &followed.branch else { return OwnBranch::unknown(String::new()) };
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
        OwnBranch {
            fold: fold.map(value),
            reaches: turn
                .filter(|_| meets_threshold)
                .or_else(|| followed.reaches(0.0))
                .map(|s| value(s).clamp(from, to)),
            is_open: fold.is_none() && !ends_well,
            meets_threshold,
            end,
            large: fold.and_then(|fold| large_cycle(branch, inside(fold))),
            last: branch.points.last().map(|point| point.cycle.start),
        }
    }

    /// Whether a branch turns only because its cycles shrink to steady sliding, at another threshold: a step over that lands on the
    /// branch again.
    fn meets_threshold(&self, onset: &MarginOnset, branch: &CycleBranch<4>, turn: f64) -> bool {
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
}

/// Whether a branch was stopped while its last turn was being located.
fn is_unfinished(branch: &CycleBranch<4>) -> bool {
    let stopped = matches!(branch.end, BranchEnd::Lost(CycleError::Stopped { .. }));
    stopped && branch.folds.first().is_some_and(|fold| fold.after + 2 >= branch.points.len())
}

/// A place a little before a fold: a hundredth, less where the threshold is near.
pub(super) fn inside(fold: f64) -> f64 {
    fold - fold.signum() * (0.3 * fold.abs()).min(0.01)
}

/// The start of the stable cycle behind the first fold that is nearest to a place; `None` where that is far from it.
fn large_cycle(branch: &CycleBranch<4>, place: f64) -> Option<[f64; 4]> {
    const FAR: f64 = 0.1;
    let first = branch.folds.first()?.after + 1;
    let last = branch.folds.get(1).map_or(branch.points.len(), |fold| fold.after + 1);
    let away = |parameter: f64| (parameter - place).abs();
    let behind = branch.points.get(first..last)?.iter();
    let stable = behind.filter(|point| point.cycle.is_stable() && away(point.parameter) < FAR);
    stable.min_by(|a, b| away(a.parameter).total_cmp(&away(b.parameter))).map(|point| point.cycle.start)
}
