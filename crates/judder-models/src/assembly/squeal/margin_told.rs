//! What is told of global margins.

use super::margin::SoughtMargins;
use super::settings::AssemblySqueal;
use crate::assembly::branch_checks::{ShrunkAt, equations, shrinks};
use crate::key_sweep::KeySweep;
use judder_store::Results;
use judder_structure::onset::Onset;
use judder_study::labels::any_key;
use judder_study::outcome::CheckRecord;

/// How far the cycles of a mode reach beyond its onset.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CycleReach {
    /// Where their branch turns farthest beyond, and what that may be off; none where it does not.
    pub(super) fold: Option<[f64; 2]>,
    /// The value farthest on the side of stable steady sliding at which a cycle is known.
    pub(super) reaches: Option<f64>,
    /// How the branch ends.
    pub(super) end: MarginEnd,
    /// Residuals of its cycles.
    pub(super) residuals: Vec<f64>,
    /// Where it shrinks to steady sliding.
    pub(super) shrunk: Option<ShrunkAt>,
}

/// How a branch of cycles ends.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum MarginEnd {
    /// It shrinks to steady sliding at the onset.
    Onset,
    /// It turns, and leaves the range on the side on which the mode grows.
    Growing,
    /// It turns before it reaches the onset.
    Before(f64),
    /// It shrinks to steady sliding elsewhere.
    OtherOnset(f64),
    /// It leaves the range on the side on which steady sliding is stable.
    Range,
    /// It goes on.
    Points,
    /// No next cycle was found.
    Lost(String),
    /// There is none.
    None(String),
}

impl MarginEnd {
    /// Whether the branch is known as far as it has to do with the margin.
    pub(super) fn is_whole(&self) -> bool {
        matches!(self, Self::Onset | Self::Growing)
    }

    fn words(&self, sweep: &KeySweep) -> String {
        match self {
            Self::Onset => "shrinks to steady sliding at the onset".to_owned(),
            Self::Growing => "turns and leaves the range where the mode grows".to_owned(),
            Self::Before(value) => format!(
                "turns at {} before it comes to the onset, and leaves the range: it is not the branch that begins there",
                sweep.text(*value)
            ),
            Self::OtherOnset(value) => {
                format!(
                    "shrinks below 2 % of its largest amplitude at {}, not at this onset",
                    sweep.text(*value)
                )
            }
            Self::Range => "leaves the range where steady sliding is stable: the margin is larger".to_owned(),
            Self::Points => "goes on after as many cycles as are followed".to_owned(),
            Self::Lost(reason) => format!("lost: {reason}"),
            Self::None(reason) => reason.clone(),
        }
    }
}

impl CycleReach {
    pub(super) fn unknown(reason: String) -> Self {
        let end = MarginEnd::None(reason);
        Self { fold: None, reaches: None, end, residuals: Vec::new(), shrunk: None }
    }
}

/// An onset with the margin beyond it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MarginOfOnset {
    onset: Onset,
    mode: Option<usize>,
    reach: CycleReach,
    margin: Option<KnownMargin>,
    is_within: Option<bool>,
}

/// A margin, and what it may be off; not a number where that is not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct KnownMargin {
    pub(super) value: f64,
    error: f64,
}

/// The place of a margin among others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MarginPlace {
    /// One more than those that are larger whatever both may be off; none where that is not known of the margin itself.
    pub(super) rank: Option<usize>,
    /// The others that may be larger as well as smaller.
    pub(super) tied: usize,
}

impl KnownMargin {
    /// Whether it is larger than another whatever both may be off.
    fn is_beyond(self, other: Self) -> bool {
        self.value - self.error > other.value + other.error
    }

    /// Its place among all, itself one of them.
    fn place(self, all: &[Option<Self>]) -> MarginPlace {
        let others = || all.iter().flatten();
        let larger = others().filter(|other| other.is_beyond(self)).count();
        let smaller = others().filter(|other| self.is_beyond(**other)).count();
        let rank = (!self.error.is_nan()).then_some(1 + larger);
        MarginPlace { rank, tied: others().count() - 1 - larger - smaller }
    }
}

impl MarginOfOnset {
    /// The margin beyond an onset at which a mode, of those that grow in the case, begins to grow; `own` is the value of the case.
    pub(super) fn new(onset: &Onset, mode: Option<usize>, reach: CycleReach, own: f64) -> Self {
        let is_whole = reach.end.is_whole();
        let size = onset.value.abs();
        let margin = match reach.fold {
            Some([fold, error]) => Some(KnownMargin {
                value: (fold - onset.value).abs() / size,
                error: (error + onset.error * fold.abs() / size) / size,
            }),
            None => is_whole.then_some(KnownMargin { value: 0.0, error: 0.0 }),
        };
        let sign = if onset.gains { 1.0 } else { -1.0 };
        let beyond_onset = sign * (own - onset.value);
        let is_reached = match (reach.fold, reach.reaches) {
            (Some([fold, error]), _) => sign * (fold - own) > error,
            (None, Some(value)) => sign * (value - own) > 0.0,
            (None, None) => false,
        };
        let is_within = match is_reached {
            _ if beyond_onset < -onset.error => Some(false),
            true if beyond_onset > onset.error => Some(true),
            // within what onset and fold may be off; and cycles of branches that do not begin at the onset are not sought
            _ => None,
        };
        Self { onset: *onset, mode, reach, margin, is_within }
    }

    /// What is told of it where the margin is not known, or not how far it is off.
    fn doubt(&self, sweep: &KeySweep) -> Option<String> {
        let (path, onset) = (&sweep.path, sweep.text(self.onset.value));
        match self.reach.fold {
            None if self.margin.is_none() => {
                let words = self.reach.end.words(sweep);
                Some(format!(
                    "how far the cycles reach beyond the onset at {path} = {onset} is not known: {words}"
                ))
            }
            Some([fold, error]) if error.is_nan() => Some(format!(
                "what the fold at {path} = {} beyond the onset at {onset} may be off is not known: no such fold is found with twice the harmonics",
                sweep.text(fold)
            )),
            _ => None,
        }
    }
}

/// Global margins along a key.
#[derive(Clone, Results)]
pub(super) struct ToldMargins {
    /// the key along which they are; `friction` is a factor on the friction of all contacts
    key: String,
    /// its unit
    unit: String,
    /// the unit in which the case has its values, in which tables show them
    shown_unit: String,
    /// its value in the case; none where it gives none
    own: Option<f64>,
    /// the largest margin of which it is known what it may be off
    largest: Option<f64>,
    /// onsets whose margin is not known, or not what it may be off
    unknown: usize,
    /// whether a knock may suffice with the case as it is: a mode that does not grow has cycles there, or knocks keep vibrating where nothing grows; none where neither is known
    knock: Option<bool>,
    /// why it is not known
    knock_reason: &'static str,
    /// harmonics of the cycles
    harmonics: usize,
    /// each onset with its margin, by rising value
    onsets: Vec<MarginOfMode>,
}

/// An onset with its margin.
#[derive(Clone, Results)]
struct MarginOfMode {
    /// value of the key at which the mode begins to grow
    onset: f64,
    /// how far the onset may be from it
    onset_error: f64,
    /// frequency there
    frequency_hz: f64,
    /// whether the mode grows above it, else below
    grows_above: bool,
    /// the number of the mode that begins to grow there, where it grows with the case as it is
    mode: Option<usize>,
    /// value at which its cycles end on the side of stable steady sliding; none where they do not reach beyond the onset, or it is not known
    fold: Option<f64>,
    /// what it may be off
    fold_error: Option<f64>,
    /// the value farthest on that side at which a cycle is known
    reaches: Option<f64>,
    /// how far the fold lies from the onset, of the onset: so far before it cycles exist already
    margin: Option<f64>,
    /// what it may be off; none where that is not known
    margin_error: Option<f64>,
    /// its place from the largest margin on, one more than those that are larger whatever they may be off; none where it is not known what it may be off itself
    rank: Option<usize>,
    /// margins of other onsets that may be larger as well as smaller, for what they may be off
    tied: Option<usize>,
    /// whether the mode has cycles but does not grow with the case as it is; none where it is not known
    knock: Option<bool>,
    /// how the branch of cycles ends
    end: String,
}

impl SoughtMargins {
    /// What is checked of the branches: their cycles, and the eigenvalues where they shrink to steady sliding at an onset.
    pub(super) fn checks(&self, sweep: &KeySweep) -> Vec<CheckRecord> {
        let residuals: Vec<f64> =
            self.onsets.iter().flat_map(|own| own.reach.residuals.iter().copied()).collect();
        let of_cycles = (!residuals.is_empty()).then(|| equations(residuals.into_iter()));
        let at_onset = self.onsets.iter().filter(|own| own.reach.end == MarginEnd::Onset);
        let shrunk = at_onset.filter_map(|own| own.reach.shrunk);
        of_cycles.into_iter().chain(shrunk.map(|own| shrinks(sweep, own))).collect()
    }

    /// The margin of each of so many modes that grow, and its place from the largest on among them.
    pub(super) fn of_modes(&self, count: usize) -> Vec<Option<(KnownMargin, MarginPlace)>> {
        let margin = |mode: usize| self.onsets.iter().find(|own| own.mode == Some(mode))?.margin;
        let all: Vec<Option<KnownMargin>> = (0..count).map(margin).collect();
        all.iter().map(|own| own.map(|own| (own, own.place(&all)))).collect()
    }
}

impl ToldMargins {
    pub(super) fn new(asked: &AssemblySqueal, sweep: &KeySweep, found: &SoughtMargins) -> Self {
        let margins: Vec<Option<KnownMargin>> = found.onsets.iter().map(|own| own.margin).collect();
        let known = || margins.iter().flatten().filter(|own| !own.error.is_nan()).map(|own| own.value);
        let told = found.onsets.iter().map(|own| {
            let place = own.margin.map(|margin| margin.place(&margins));
            MarginOfMode {
                onset: own.onset.value,
                onset_error: own.onset.error,
                frequency_hz: own.onset.frequency_hz,
                grows_above: !own.onset.gains,
                mode: own.mode.map(|mode| mode + 1),
                fold: own.reach.fold.map(|[value, _]| value),
                fold_error: own.reach.fold.map(|[_, error]| error),
                reaches: own.reach.reaches,
                margin: own.margin.map(|margin| margin.value),
                margin_error: own.margin.map(|margin| margin.error),
                rank: place.and_then(|place| place.rank),
                tied: place.map(|place| place.tied),
                knock: own.is_within,
                end: own.reach.end.words(sweep),
            }
        });
        let is_within = found.onsets.iter().any(|own| own.is_within == Some(true));
        Self {
            key: sweep.path.clone(),
            unit: any_key(&sweep.path, sweep.dimension).unit,
            shown_unit: sweep.shown_unit(),
            own: Some(found.own).filter(|own| own.is_finite()),
            largest: known().reduce(f64::max),
            unknown: found.onsets.len() - known().count(),
            knock: is_within.then_some(true),
            knock_reason: match (is_within, found.onsets.is_empty()) {
                (true, _) => "",
                (false, true) => {
                    "no mode begins to grow within the range, and cycles are followed from onsets alone"
                }
                (false, false) => {
                    "no cycles that begin at the onsets of the range are known to reach the case; others are not sought"
                }
            },
            harmonics: asked.margin_harmonics(),
            onsets: told.collect(),
        }
    }

    /// That knocks keep vibrating although nothing grows.
    pub(super) fn set_knocked(&mut self) {
        (self.knock, self.knock_reason) = (Some(true), "");
    }

    /// What is to be said of margins that are not known.
    pub(super) fn doubts(sweep: &KeySweep, found: &SoughtMargins) -> Vec<String> {
        let none = || {
            let path = &sweep.path;
            format!(
                "no mode begins to grow within the range of {path}, so that no cycles are followed along it"
            )
        };
        let none = found.onsets.is_empty().then(none);
        let of_onsets = found.onsets.iter().filter_map(|own| own.doubt(sweep));
        of_onsets.chain(found.doubt.clone()).chain(none).collect()
    }

    /// Margins that should be known.
    pub(super) fn missing(found: &SoughtMargins) -> usize {
        let is_missing = |own: &&MarginOfOnset| {
            let has_error = own.reach.fold.is_none_or(|[_, error]| !error.is_nan());
            !has_error || !own.reach.end.is_whole() && !matches!(own.reach.end, MarginEnd::Range)
        };
        found.onsets.iter().filter(is_missing).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use judder_structure::onset::OnsetKind;

    /// Whether a mode that grows below 1 ± 0.01 and has cycles up to 1.5 ± `error` has cycles at a value at which it does not grow.
    fn knock(own: f64, error: f64) -> Option<bool> {
        let onset = Onset {
            value: 1.0,
            error: 0.01,
            frequency_hz: 100.0,
            kind: OnsetKind::Flutter,
            gains: true,
            jumps: false,
            crossing: None,
        };
        let reach = CycleReach {
            fold: Some([1.5, error]),
            reaches: Some(1.49),
            end: MarginEnd::Growing,
            residuals: Vec::new(),
            shrunk: None,
        };
        MarginOfOnset::new(&onset, None, reach, own).is_within
    }

    #[test]
    fn a_knock_is_told_beyond_what_onset_and_fold_may_be_off_alone() {
        let told = [0.98, 0.995, 1.005, 1.02, 1.47, 1.49, 1.6, f64::NAN].map(|own| knock(own, 0.02));
        let yes = Some(true);
        assert_eq!(told, [Some(false), None, None, yes, yes, None, None, None]);
        assert_eq!(knock(1.2, f64::NAN), None);
    }

    #[test]
    fn margins_that_their_errors_do_not_part_share_a_place() {
        let all = [(0.3, 0.02), (0.27, 0.02), (0.24, 0.02), (0.1, 0.01), (0.2, f64::NAN)];
        let all = all.map(|(value, error)| Some(KnownMargin { value, error }));
        let places = all.map(|own| own.map(|own| own.place(&all)).map(|own| (own.rank, own.tied)));
        // the first and the third are parted, the one between them from neither; of the last nothing is known
        let expected = [(Some(1), 2), (Some(1), 3), (Some(2), 2), (Some(4), 1), (None, 4)];
        assert_eq!(places, expected.map(Some));
        let exact = [Some(KnownMargin { value: 0.0, error: 0.0 }); 2];
        assert!(
            exact.iter().flatten().all(|own| own.place(&exact) == MarginPlace { rank: Some(1), tied: 1 })
        );
    }
}
