//! The bifurcations of a branch, by name.

use super::told::KnownCycle;
use crate::assembly::cycles_along_key::{SOLVED, branch_point_with_error};
use crate::assembly::limit_cycle::stability::crossing_words;
use judder_cycles::branch::{AssemblyCycleBranch, CycleAtKey};
use judder_cycles::stability::{CircleCrossing, StabilityChange, stability_changes};
use judder_store::Results;
use std::f64::consts::TAU;

/// How bifurcations are called; their places here are their codes.
pub(super) const KINDS: [&str; 8] = [
    "Hopf point",
    "fold",
    "branch point",
    "branch point or kink",
    "fold or branch point",
    "period doubling",
    "Neimark–Sacker bifurcation",
    "change of stability of unknown kind",
];
const HOPF: &str = KINDS[0];
const FOLD: &str = KINDS[1];
const BRANCH_POINT: &str = KINDS[2];
const KINK: &str = KINDS[3];
const DOUBLING: &str = KINDS[5];
const NEIMARK_SACKER: &str = KINDS[6];
const UNKNOWN: &str = KINDS[7];

/// What is known of the motions that come in at a bifurcation of a kind: whether there are any on the side of unstable cycles multipliers alone do not tell.
fn motion_of(kind: &str) -> &'static str {
    match kind {
        DOUBLING => "unknown: of twice the period where such motions attract; a march tells",
        NEIMARK_SACKER => "unknown: quasi-periodic where such motions attract; a march tells",
        UNKNOWN => "unknown: a march tells",
        _ => "",
    }
}

/// A bifurcation.
#[derive(Debug, Clone, Results)]
pub(super) struct NamedBifurcation {
    /// what it is
    pub(super) kind: &'static str,
    /// the value of the key there, where it was searched for; of a Hopf point where the square of the amplitude vanishes; amid the two below otherwise
    pub(super) value: f64,
    /// what that may be off: of a fold what the path and the harmonics leave, missing where it is not found with twice the harmonics; of a Hopf point how far it lies from the smallest cycle, and no less than cycles are solved to; of what lies amid two cycles half the way between them
    pub(super) error: Option<f64>,
    /// frequency of the first of the cycles below, in Hz
    pub(super) frequency_hz: f64,
    /// its root mean square over all contact points of the velocity along the slip about its mean
    #[result(unit = "m/s")]
    pub(super) rms: f64,
    /// the values of the key at the cycles before and after it, in the order along the branch; of a Hopf point that of the smallest cycle and its own
    pub(super) between: Vec<f64>,
    /// the first of these cycles, counted from 0
    pub(super) cycle: usize,
    /// what is known of the motions that come in there, for which the multipliers of the cycles do not suffice; empty where cycles or steady sliding alone meet
    pub(super) motion: &'static str,
}

impl NamedBifurcation {
    /// One of this kind, with its value and what that may be off, between two of the cycles.
    fn new(
        kind: &'static str,
        [value, error]: [f64; 2],
        known: &[KnownCycle],
        [before, after]: [usize; 2],
    ) -> Self {
        Self {
            kind,
            value,
            error: Some(error).filter(|error| error.is_finite()),
            frequency_hz: known[before].frequency / TAU,
            rms: known[before].rms,
            between: vec![known[before].value, known[after].value],
            cycle: before,
            motion: motion_of(kind),
        }
    }

    /// Whether it was searched for where a change of stability between these cycles is seen.
    fn is_located(&self, [before, after]: [usize; 2]) -> bool {
        let [from, to] = [self.cycle, self.cycle + 2];
        [FOLD, BRANCH_POINT, KINK].contains(&self.kind) && from <= after && before <= to
    }

    /// Where it lies and what comes in there, where that is not known.
    pub(super) fn unknown_motion(&self, text: impl Fn(f64) -> String) -> Option<String> {
        (!self.motion.is_empty()).then(|| {
            let (kind, at) = (self.kind, text(self.value));
            format!("what motions become at the {kind} near {at} is {}", self.motion)
        })
    }

    /// Whether the key turns there.
    pub(super) fn is_fold(&self) -> bool {
        self.kind == FOLD
    }

    /// Whether a kink makes it doubtful.
    pub(super) fn is_kink(&self) -> bool {
        self.kind == KINK
    }

    /// Its code.
    pub(super) fn code(&self) -> u8 {
        KINDS.iter().position(|own| *own == self.kind).map_or(u8::MAX, |place| place as u8)
    }
}

/// Where a branch vanishes that shrinks to steady sliding, of which this is the smallest cycle.
pub(super) fn hopf_point(smallest: &CycleAtKey, ways: [&AssemblyCycleBranch; 2]) -> f64 {
    let own = ways.into_iter().find(|way| way.cycles.last() == Some(smallest));
    own.and_then(AssemblyCycleBranch::vanishes_at).unwrap_or(smallest.parameter)
}

/// All of them, in the order along the branch, of which `known` are the cycles within the range, and `fold_errors` what the folds of each way may be off.
pub(super) fn named(
    known: &[KnownCycle],
    ways: [&AssemblyCycleBranch; 2],
    fold_errors: &[Vec<f64>; 2],
    hopf: &[&CycleAtKey],
) -> Vec<NamedBifurcation> {
    let of = |kind, value, between| NamedBifurcation::new(kind, value, known, between);
    let place = |cycle: &CycleAtKey| {
        let omega = cycle.motion.turning.frequency;
        known.iter().position(|own| own.value == cycle.parameter && own.frequency == omega)
    };
    let mut all = Vec::new();
    for cycle in hopf {
        all.extend(place(cycle).map(|place| {
            let value = hopf_point(cycle, ways);
            let off = (value - cycle.parameter).abs().max(SOLVED * value.abs());
            NamedBifurcation {
                between: vec![cycle.parameter, value],
                ..of(HOPF, [value, off], [place, place])
            }
        }));
    }
    for (way, fold_errors) in ways.into_iter().zip(fold_errors) {
        let near = |cycle: usize, kind: &'static str, value: [f64; 2], after: usize| {
            let own = place(&way.cycles[cycle])?;
            let other = way.cycles.get(after).and_then(place)?;
            Some(of(kind, value, [own.min(other), own.max(other)]))
        };
        for ((cycle, fold), error) in way.folds.iter().zip(fold_errors) {
            all.extend(near(cycle - 1, FOLD, [*fold, *error], cycle + 1));
        }
        for own in &way.branch_points {
            let kind = if own.is_smooth { BRANCH_POINT } else { KINK };
            let place = branch_point_with_error(way, own);
            all.extend(near(own.cycle, kind, place, own.cycle + 1));
        }
    }
    let changes = changes_of_stability(known, &all);
    all.extend(changes);
    all.sort_by_key(|own| own.cycle);
    all
}

/// Where stability changes, but for those places that are located by another name.
fn changes_of_stability(known: &[KnownCycle], located: &[NamedBifurcation]) -> Vec<NamedBifurcation> {
    let multipliers: Vec<_> = known.iter().map(|own| own.stability.known()).collect();
    // a fold has one past 1, also where it jumps there from what sticking makes zero
    let is_fold = |own: &StabilityChange| match own.crossing {
        CircleCrossing::Unknown => own.outside == CircleCrossing::AtOne,
        crossing => crossing == CircleCrossing::AtOne,
    };
    let changes = stability_changes(&multipliers).into_iter();
    let others =
        changes.filter(|own| !(is_fold(own) && located.iter().any(|other| other.is_located(own.between))));
    others
        .map(|own| {
            let [from, to] = own.between.map(|place| known[place].value);
            let amid = [0.5 * (from + to), 0.5 * (to - from).abs()];
            NamedBifurcation::new(crossing_words(own.crossing), amid, known, own.between)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every way through the circle has a kind, and what follows from none of them alone is not guessed.
    #[test]
    fn what_motions_become_is_unknown_where_multipliers_alone_tell() {
        let told = [
            (CircleCrossing::AtOne, ""),
            (CircleCrossing::AtMinusOne, "unknown: of twice the period"),
            (CircleCrossing::Pair, "unknown: quasi-periodic"),
            (CircleCrossing::Unknown, "unknown: a march"),
        ];
        for (crossing, words) in told {
            let kind = crossing_words(crossing);
            assert!(KINDS.contains(&kind) && motion_of(kind).starts_with(words), "{kind}");
            assert_eq!(motion_of(kind).is_empty(), words.is_empty(), "{kind}");
        }
    }
}
