//! Motions on both sides of some folds, followed to where they end.

use super::own_branch::inside;
use super::{MarginCrossing, MarginOnset, STEPS};
use judder_numerics::parallel;
use judder_numerics::piecewise::StepSettings;
use judder_oscillator::cycle::shoot;
use judder_oscillator::motion::attractor::{Attractor, Patience, Settled, settle};
use judder_oscillator::motion::{Interrupted, StickSlip};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Disagreement};

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
        let settings = StepSettings { steps: 100 * STEPS, ..MarginCrossing::settings(system) };
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

impl MarginCrossing<'_> {
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
}

/// A fold of a threshold's own branch with a stable cycle behind it.
struct OwnFold<'a> {
    crossing: MarginCrossing<'a>,
    threshold: f64,
    fold: f64,
    large: [f64; 4],
    /// Whether nothing is known beyond it.
    is_limit: bool,
}

impl<'a> OwnFold<'a> {
    fn of(crossing: MarginCrossing<'a>, onset: &MarginOnset) -> Option<Self> {
        let margin = onset.margin.as_ref()?;
        let own = margin.own.as_ref()?;
        let (fold, large) = (own.fold?, own.large?);
        Some(Self { crossing, threshold: onset.threshold, fold, large, is_limit: margin.search.moves == 0 })
    }
}

/// Motions from large cycles, a little inside of the folds of some thresholds' own branches and as much outside: inside they must go
/// on, outside they must not stay on a cycle of the branch. With a warning where they do not die out there either although no search
/// has found more.
pub(crate) fn fold_check(
    onsets: &[(MarginCrossing<'_>, &MarginOnset)],
    progress: &dyn Progress,
) -> (Option<CheckRecord>, Option<String>) {
    let known: Vec<_> = onsets.iter().filter_map(|(crossing, onset)| OwnFold::of(*crossing, onset)).collect();
    let some: Vec<_> = known.iter().step_by(known.len().div_ceil(LOOKED_AT).max(1)).collect();
    let motions = parallel::each(&some, |OwnFold { crossing, threshold, fold, large, is_limit }| {
        let place = crossing.place(*threshold, *fold);
        Some((*is_limit, crossing.fates_about(*threshold, place, *large, progress)?))
    });
    let motions: Vec<(bool, [Fate; 2])> = motions.into_iter().flatten().collect();
    let count = motions.len();
    let is_wrong = |(_, [within, beyond]): &(bool, [Fate; 2])| {
        matches!(within, Fate::Lost | Fate::AtRest) || *beyond == Fate::Lost || within.is_like(*beyond)
    };
    let moves_on =
        |(is_limit, [_, beyond]): &&(bool, [Fate; 2])| *is_limit && matches!(beyond, Fate::Moving { .. });
    let others = motions.iter().filter(moves_on).count();
    let compared = format!(
        "number of {count} folds where a motion 1 % inside dies out, or one 1 % outside stays on the cycle"
    );
    let check = (count > 0).then(|| {
        let wrong = Disagreement::exceptions(motions.iter().map(is_wrong));
        CheckRecord::new("motions from large cycles end at the folds", compared, wrong, 0.0)
    });
    let warning = (others > 0).then(|| {
        format!(
            "at {others} of {count} folds looked at, a motion 1 % beyond does not die out, although the search beyond found none: other \
             motions live there, and the fold is no safe limit"
        )
    });
    (check, warning)
}
