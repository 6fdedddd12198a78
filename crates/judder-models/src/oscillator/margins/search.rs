//! Motions beyond the branch of a threshold, sought from many starts.

use super::{MarginCrossing, MarginOnset, OwnBranch};
use judder_oscillator::cycle::{Continuation, CycleError, Exploration, Look, SearchEnd, explore};
use judder_store::Results;
use judder_study::Progress;
use serde::{Deserialize, Serialize};

/// What a search tells of the stable points beyond all that is known.
#[derive(Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum BeyondBranch {
    /// No start moved at the places that were looked at.
    NoneMoved = 1,
    /// Steady sliding is not stable there.
    NotStable = 2,
    /// The range ends there.
    RangeEnds = 3,
    /// Nothing: every round found a new motion, starts are undecided, or it was stopped.
    Open = 4,
}

/// Each in words, by its number in stored results; 0 where there is no threshold.
pub(crate) const TOLD: [(u8, &str); 5] = [
    (0, "none"),
    (BeyondBranch::NoneMoved as u8, "no start moved beyond"),
    (BeyondBranch::NotStable as u8, "steady sliding is not stable beyond"),
    (BeyondBranch::RangeEnds as u8, "the range ends beyond"),
    (NOT_KNOWN, "not known beyond"),
];

/// The number of a threshold beyond which nothing is known.
pub(crate) const NOT_KNOWN: u8 = BeyondBranch::Open as u8;

/// Motions beyond the threshold's own branch, in values of the quantity.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct MotionSearch {
    /// Up to here from the threshold on a motion is known everywhere.
    pub(crate) known_to: f64,
    /// The value farthest from the threshold at which one is known.
    pub(crate) farthest: f64,
    /// Whether that is the end of the range, or another threshold.
    pub(crate) is_at_end: bool,
    /// From the farthest up to here no start moved.
    pub(crate) quiet_to: Option<f64>,
    /// How often a new motion moved the limit.
    pub(crate) moves: usize,
    pub(crate) told: BeyondBranch,
    /// What became of starts a little before the farthest.
    before: Option<Look>,
    beyond: Vec<Look>,
    /// Why it was stopped.
    stopped: Option<String>,
}

impl MotionSearch {
    /// Nothing was sought beyond a value up to which motions are known.
    fn none(known_to: f64, told: BeyondBranch, stopped: Option<String>) -> Self {
        Self {
            known_to,
            farthest: known_to,
            is_at_end: false,
            quiet_to: None,
            moves: 0,
            told,
            before: None,
            beyond: Vec::new(),
            stopped,
        }
    }

    /// Which share of starts keeps moving a little before the farthest known motion ends.
    pub(crate) fn moving_share(&self) -> Option<f64> {
        self.before.map(|look| look.moved as f64 / look.starts as f64)
    }

    /// The basin a little before the farthest: where, how many starts, and what became of them.
    pub(crate) fn basin(&self) -> Option<ToldStarts> {
        self.before.map(|look| {
            let Look { parameter, starts, moved, undecided } = look;
            ToldStarts { value: parameter, starts, moving: moved, undecided }
        })
    }

    /// Why nothing is known beyond; `None` where something is.
    pub(crate) fn why_open(&self) -> Option<String> {
        let undecided: usize = self.beyond.iter().map(|look| look.undecided).sum();
        (self.told == BeyondBranch::Open).then(|| match &self.stopped {
            Some(reason) => format!("the search was not begun: {reason}"),
            None if undecided > 0 => format!("what becomes of {undecided} starts is not confirmed"),
            None => format!("each of {} rounds found a new motion", self.moves),
        })
    }

    /// Where was looked beyond it, and how.
    pub(crate) fn summary(&self) -> ToldSearch {
        let sum = |of: fn(&Look) -> usize| self.beyond.iter().map(of).sum::<usize>();
        ToldSearch {
            found: self.moves,
            places: self.beyond.iter().map(|look| look.parameter).collect(),
            starts: sum(|look| look.starts),
            undecided: sum(|look| look.undecided),
            stopped: self.stopped.clone(),
        }
    }
}

/// What is told of starts a little before the farthest motion.
#[derive(Results)]
pub(crate) struct ToldStarts {
    /// where the starts were followed
    value: f64,
    starts: usize,
    moving: usize,
    undecided: usize,
}

/// What is told of a search.
#[derive(Results)]
pub(crate) struct ToldSearch {
    /// new motions
    found: usize,
    /// where was looked beyond them
    places: Vec<f64>,
    starts: usize,
    undecided: usize,
    /// why it was
    stopped: Option<String>,
}

impl BeyondBranch {
    fn of(found: &Exploration, meets_threshold: bool) -> Self {
        let is_quiet = found.beyond.iter().all(Look::is_quiet);
        match found.end {
            SearchEnd::Rounds => Self::Open,
            _ if !is_quiet => Self::Open,
            _ if !found.beyond.is_empty() => Self::NoneMoved,
            SearchEnd::Range if !meets_threshold => Self::RangeEnds,
            _ => Self::NotStable,
        }
    }

    /// In words.
    pub(crate) fn words(self) -> &'static str {
        TOLD[self as usize].1
    }
}

impl MarginCrossing<'_> {
    /// Motions beyond a threshold's own branch, or beyond the threshold where it has none, up to the `next` threshold at most.
    pub(super) fn search(
        &self,
        onset: &MarginOnset,
        own: Option<&OwnBranch>,
        next: Option<f64>,
        progress: &dyn Progress,
    ) -> MotionSearch {
        let known_to = own.and_then(|own| own.fold.or(own.reaches)).unwrap_or(onset.threshold);
        let is_over = next.is_some_and(|next| (known_to - next) * onset.stable_side >= 0.0);
        if is_over || own.is_some_and(|own| own.meets_threshold) {
            return MotionSearch::none(known_to, BeyondBranch::NotStable, None);
        }
        let explored = self.continuation(onset).and_then(|all| {
            let mut options = all;
            let end = next.map(|next| self.place(onset.threshold, next));
            match onset.stable_side > 0.0 {
                true => options.range.1 = end.unwrap_or(all.range.1),
                false => options.range.0 = end.unwrap_or(all.range.0),
            }
            self.explored(onset, known_to, own, &options, progress)
        });
        match explored {
            Ok(found) => self.in_values(onset, next, &found),
            Err(error) => MotionSearch::none(known_to, BeyondBranch::Open, Some(error.to_string())),
        }
    }

    fn explored(
        &self,
        onset: &MarginOnset,
        known_to: f64,
        own: Option<&OwnBranch>,
        options: &Continuation<4>,
        progress: &dyn Progress,
    ) -> Result<Exploration, CycleError> {
        let system_at = |s: f64| match progress.interrupted() {
            true => Err(CycleError::Stopped { flights: 0 }),
            false => self.system(self.value(onset.threshold, s)),
        };
        let cycles = own.into_iter().flat_map(|own| own.large.into_iter().chain(own.last)).collect();
        let known = (self.place(onset.threshold, known_to), cycles);
        let interrupted = || progress.interrupted();
        explore(&system_at, known, onset.stable_side, options, &interrupted)
    }

    fn in_values(&self, onset: &MarginOnset, next: Option<f64>, found: &Exploration) -> MotionSearch {
        let (from, to) = (self.range.from.min(self.range.to), self.range.from.max(self.range.to));
        let end = next.unwrap_or(if onset.stable_side > 0.0 { to } else { from });
        let is_at_end = found.farthest == self.place(onset.threshold, end);
        let value = |s: f64| self.value(onset.threshold, s).clamp(from, to);
        let look = |look: &Look| Look { parameter: value(look.parameter), ..*look };
        MotionSearch {
            known_to: value(found.without_a_gap),
            farthest: if is_at_end { end } else { value(found.farthest) },
            is_at_end,
            quiet_to: found.quiet_to().map(value),
            moves: found.moves,
            told: BeyondBranch::of(found, next.is_some()),
            before: found.before.as_ref().map(look),
            beyond: found.beyond.iter().map(look).collect(),
            stopped: None,
        }
    }
}
