//! The margin beyond one onset, what it may be off, and its place among others.

use super::margin_told::CycleReach;
use crate::key_sweep::KeySweep;
use judder_structure::onset::Onset;

/// An onset with the margin beyond it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MarginOfOnset {
    pub(super) onset: Onset,
    pub(super) mode: Option<usize>,
    pub(super) reach: CycleReach,
    pub(super) margin: Option<KnownMargin>,
    /// Whether the mode has cycles that may draw motions, but does not grow, with the case as it is.
    pub(super) is_within: Option<bool>,
    /// Whether it has cycles there, but all that were looked at are left by motions nearby.
    pub(super) is_left: bool,
}

/// A margin, and what it may be off; not a number where that is not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct KnownMargin {
    pub(super) value: f64,
    pub(super) error: f64,
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
    pub(super) fn place(self, all: &[Option<Self>]) -> MarginPlace {
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
            // a branch of more harmonics may turn where this one does not
            None => is_whole.then_some(KnownMargin { value: 0.0, error: f64::NAN }),
        };
        let sign = if onset.gains { 1.0 } else { -1.0 };
        let beyond_onset = sign * (own - onset.value);
        let is_reached = match (reach.fold, reach.reaches) {
            (Some([fold, error]), _) => sign * (fold - own) > error,
            (None, Some(value)) => sign * (value - own) > 0.0,
            (None, None) => false,
        };
        let is_left = is_reached && beyond_onset > onset.error && reach.stability.is_left_beyond();
        let is_within = match is_reached {
            _ if beyond_onset < -onset.error => Some(false),
            true if beyond_onset > onset.error && !is_left => Some(true),
            // within what onset and fold may be off; and cycles of branches that do not begin at the onset are not sought
            _ => None,
        };
        Self { onset: *onset, mode, reach, margin, is_within, is_left }
    }

    /// That no motion is known to come to the cycles beyond the onset, where that was looked at.
    pub(super) fn unstable(&self, sweep: &KeySweep) -> Option<String> {
        let beyond = self.reach.stability.beyond().count();
        let is_doubted = beyond > 0 && self.reach.stability.beyond().all(|own| own.stable != Some(true));
        is_doubted.then(|| {
            format!(
                "of {beyond} cycles beyond the onset at {} = {} none is known to be stable: {}",
                sweep.path,
                sweep.text(self.onset.value),
                self.reach.stability.words()
            )
        })
    }

    /// What is told of it where the margin is not known, or not how far it is off.
    pub(super) fn doubt(&self, sweep: &KeySweep) -> Option<String> {
        let (path, onset) = (&sweep.path, sweep.text(self.onset.value));
        match self.reach.fold {
            None if self.margin.is_none() => {
                let words = self.reach.end.words(sweep);
                Some(format!(
                    "how far the cycles reach beyond the onset at {path} = {onset} is not known: {words}"
                ))
            }
            None => Some(format!(
                "with these harmonics no cycles reach beyond the onset at {path} = {onset}; what the harmonics leave out of that is not known"
            )),
            Some([fold, error]) if error.is_nan() => Some(format!(
                "what the fold at {path} = {} beyond the onset at {onset} may be off is not known: no such fold is found with twice the harmonics",
                sweep.text(fold)
            )),
            Some(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::margin_stability::{CycleOnBranch, StabilityOnBranch};
    use super::super::margin_told::MarginEnd;
    use super::*;
    use judder_keys::dimension::Dimension;
    use judder_keys::quantity::WrittenUnit;
    use judder_structure::onset::OnsetKind;
    use judder_study::case::scale::Spacing;

    const ONSET: Onset = Onset {
        value: 1.0,
        error: 0.01,
        frequency_hz: 100.0,
        kind: OnsetKind::Flutter,
        gains: true,
        jumps: false,
        crossing: None,
    };

    /// Whether a mode that grows below 1 ± 0.01 and has cycles up to 1.5 ± `error` has cycles at a value at which it does not grow.
    fn knock(own: f64, error: f64) -> Option<bool> {
        let reach = CycleReach {
            fold: Some([1.5, error]),
            reaches: Some(1.49),
            end: MarginEnd::Growing,
            residuals: Vec::new(),
            shrunk: None,
            stability: StabilityOnBranch::default(),
        };
        MarginOfOnset::new(&ONSET, None, reach, own).is_within
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

    fn friction() -> KeySweep {
        KeySweep {
            path: "friction".to_owned(),
            values: vec![0.0, 2.0],
            dimension: Dimension::NUMBER,
            scale: Spacing::Linear,
            unit: WrittenUnit::si(Dimension::NUMBER),
        }
    }

    /// A branch of other harmonics may turn beyond the onset.
    #[test]
    fn a_margin_of_zero_is_not_told_to_be_exact() {
        let reach =
            CycleReach { reaches: Some(1.0), end: MarginEnd::Onset, ..CycleReach::unknown(String::new()) };
        let own = MarginOfOnset::new(&ONSET, None, reach, 0.9);
        let margin = own.margin.unwrap();
        assert!(margin.value == 0.0 && margin.error.is_nan() && margin.place(&[Some(margin)]).rank.is_none());
        let said = own.doubt(&friction()).unwrap();
        assert!(said.ends_with("what the harmonics leave out of that is not known"), "{said}");
    }

    /// Cycles that motions leave are none that a knock leads to.
    #[test]
    fn unstable_cycles_are_no_reason_for_a_knock() {
        let with = |stable: Option<bool>| {
            let cycle = CycleOnBranch { value: 1.2, is_beyond: true, stable };
            let reach = CycleReach {
                fold: Some([1.5, 0.02]),
                reaches: Some(1.49),
                end: MarginEnd::Growing,
                stability: StabilityOnBranch { cycles: vec![cycle] },
                ..CycleReach::unknown(String::new())
            };
            let own = MarginOfOnset::new(&ONSET, None, reach, 1.2);
            // where the mode grows its cycles are no reason for anything
            let growing = MarginOfOnset::new(&ONSET, None, own.reach.clone(), 0.5);
            assert!(growing.is_within == Some(false) && !growing.is_left);
            assert_eq!(own.is_left, stable == Some(false));
            (own.is_within, own.unstable(&friction()))
        };
        assert_eq!(with(Some(true)), (Some(true), None));
        let (unknown, unstable) = (with(None), with(Some(false)));
        assert!(unknown.0 == Some(true) && unknown.1.unwrap().contains("0 unstable, 1 unknown"));
        assert!(unstable.0.is_none() && unstable.1.unwrap().contains("none is known to be stable"));
    }
}
