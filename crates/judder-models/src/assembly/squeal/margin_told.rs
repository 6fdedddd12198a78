//! What is told of global margins.

use super::known_margin::{KnownMargin, MarginOfOnset, MarginPlace};
use super::margin::SoughtMargins;
use super::margin_stability::StabilityOnBranch;
use super::settings::AssemblySqueal;
use super::small_motions::KnownSmallMotions;
use crate::assembly::branch_checks::{ShrunkAt, equations, shrinks};
use crate::key_sweep::KeySweep;
use judder_store::Results;
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
    /// Whether motions nearby are drawn to its cycles.
    pub(super) stability: StabilityOnBranch,
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

    pub(super) fn words(&self, sweep: &KeySweep) -> String {
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
        let stability = StabilityOnBranch::default();
        Self { fold: None, reaches: None, end, residuals: Vec::new(), shrunk: None, stability }
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
    #[result(unit = "1")]
    largest: Option<f64>,
    /// onsets whose margin is not known, or not what it may be off
    unknown: usize,
    /// whether a knock may suffice with the case as it is: a mode that does not grow has cycles there, or knocks keep vibrating where it is proven that nothing grows, at whatever frequency; none where neither is known
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
    #[result(unit = "1")]
    margin: Option<f64>,
    /// what it may be off; none where that is not known
    #[result(unit = "1")]
    margin_error: Option<f64>,
    /// its place from the largest margin on, one more than those that are larger whatever they may be off; none where it is not known what it may be off itself
    rank: Option<usize>,
    /// margins of other onsets that may be larger as well as smaller, for what they may be off
    tied: Option<usize>,
    /// whether the mode has cycles but does not grow with the case as it is; none where it is not known
    knock: Option<bool>,
    /// how the branch of cycles ends
    end: String,
    /// values of the key at cycles of the branch of which it was looked at whether motions nearby are drawn to them, in the order along it
    looked_at: Vec<f64>,
    /// whether they are; none where it is not known
    stable: Vec<Option<bool>>,
    /// how many are, on either side of the onset, in words
    stability: String,
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
                fold_error: own.reach.fold.map(|[_, error]| error).filter(|error| error.is_finite()),
                reaches: own.reach.reaches,
                margin: own.margin.map(|margin| margin.value),
                margin_error: own.margin.map(|margin| margin.error).filter(|error| error.is_finite()),
                rank: place.and_then(|place| place.rank),
                tied: place.map(|place| place.tied),
                knock: own.is_within,
                end: own.reach.end.words(sweep),
                looked_at: own.reach.stability.cycles.iter().map(|cycle| cycle.value).collect(),
                stable: own.reach.stability.cycles.iter().map(|cycle| cycle.stable).collect(),
                stability: own.reach.stability.words(),
            }
        });
        let is_within = found.onsets.iter().any(|own| own.is_within == Some(true));
        let is_left = found.onsets.iter().any(|own| own.is_left);
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
                (false, false) if is_left => {
                    "cycles of an onset reach the case, but all that were looked at beyond it are unstable: no motion is known to come to them; others are not sought"
                }
                (false, false) => {
                    "no cycles that begin at the onsets of the range are known to reach the case; others are not sought"
                }
            },
            harmonics: asked.margin_harmonics(),
            onsets: told.collect(),
        }
    }

    /// That knocks keep vibrating, which is for their sake where nothing grows by itself.
    pub(super) fn set_knocked(&mut self, small: &KnownSmallMotions) {
        if small.is_quiet() {
            (self.knock, self.knock_reason) = (Some(true), "");
        } else if self.knock.is_none() && !small.grows() {
            self.knock_reason = "knocks keep vibrating, but modes beyond the band, which are not all known, may grow by themselves";
        }
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
        let of_onsets = found.onsets.iter().flat_map(|own| [own.doubt(sweep), own.unstable(sweep)]).flatten();
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
