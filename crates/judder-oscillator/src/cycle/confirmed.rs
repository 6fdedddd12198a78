//! What a motion settles to, told where a finer tolerance tells the same and another algorithm closes it.
//!
//! Steps to a tolerance disturb a motion at every step. A cycle to which motions return slowly gathers the disturbances of many
//! rounds: its returns then differ by more than what counts as the same, or fall into a pattern of several oscillations that the cycle
//! does not have. That does not outlive steps of another size, nor Newton's method on the return map. What has only not settled within
//! its time is no kind of motion: irregular is one from which nearby ones part.

use super::shooting::{Shooting, shoot};
use super::wandering::wanders;
use crate::hopf::growth_rate;
use crate::motion::attractor::{Attractor, Patience, Settled, settle};
use crate::motion::{Interrupted, SlidingSystem};
use judder_numerics::piecewise::{MarchError, StepSettings};

/// By how much more exactly a motion is followed in each round, and how exactly at most.
const FINER: f64 = 1e-2;
const FINEST: f64 = 1e-13;
/// Rounds at most, beside the first.
const ROUNDS: usize = 3;
/// What rms and period of a cycle may change by from one round to the next, and to Newton's cycle, relative.
const SAME: f64 = 1e-3;
/// How far off unstable steady sliding a motion that has come to it goes on, in the magnitudes of steady sliding.
const OFF_REST: f64 = 1e-3;

/// What a motion settles to, and whether that is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Confirmed<const N: usize> {
    /// At the finest tolerance at which it was followed; its time is what it took to come there.
    pub attractor: Attractor<N>,
    /// Whether its two finest tolerances tell the same, and another algorithm closes it.
    pub is_confirmed: bool,
    /// The finest tolerance, relative.
    pub tolerance: f64,
}

/// Follows a motion until it has settled, and on from there to a hundredth of the tolerance, until two rounds tell the same.
///
/// Two cycles are the same with as many oscillations, and rms and period to 10⁻³; they are confirmed where Newton's method on the return
/// map closes them, with the least number of oscillations and multipliers that say stable: where one is 1 but for rounding all motions
/// nearby are cycles, and none is what motions settle to. Motions without a period are irregular where nearby ones part and they are not on
/// their way from or to something. Steady sliding is confirmed by the eigenvalues of its linear motion, which must decay. After three rounds, or where no finer tolerance is left, what was found last is told as not
/// confirmed, and so is what has not settled within its time. Below 10⁻¹¹ no tolerance is left that is much finer: the first round is
/// then a coarser one.
///
/// # Errors
/// As [`settle`].
pub fn settle_confirmed<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    settings: StepSettings<N>,
    patience: &Patience,
    interrupted: Interrupted<'_>,
) -> Result<Confirmed<N>, MarchError> {
    let (first, finer) = tolerances(settings.relative);
    let follow = |before: Option<&Attractor<N>>, tolerance: f64| {
        let settings = stepping(settings, tolerance);
        let from = before.map_or(start, |before| goes_on_from(system, before));
        let settled = settle(system, from, settings, patience, interrupted)?;
        Ok::<_, MarchError>(judged(system, before, settled, settings, patience))
    };
    let mut told = follow(None, first)?;
    for tolerance in finer {
        if told.is_confirmed {
            break;
        }
        told = follow(Some(&told.attractor), tolerance)?;
    }
    Ok(told)
}

/// The tolerance of the first round and those of the others, each finer than the one before.
fn tolerances(asked: f64) -> (f64, Vec<f64>) {
    let finest = FINEST.min(asked);
    let first = asked.max(finest / FINER);
    let finer = |tolerance: &f64| (*tolerance > finest).then(|| (FINER * tolerance).max(finest));
    (first, std::iter::successors(Some(first), finer).skip(1).take(ROUNDS).collect())
}

fn stepping<const N: usize>(settings: StepSettings<N>, relative: f64) -> StepSettings<N> {
    let ratio = relative / settings.relative;
    StepSettings { relative, absolute: settings.absolute.map(|absolute| ratio * absolute), ..settings }
}

/// Where the next round starts: beside unstable steady sliding, for at rest a motion would stay there.
fn goes_on_from<const N: usize>(system: &impl SlidingSystem<N>, before: &Attractor<N>) -> [f64; N] {
    match before.settled {
        Settled::SteadySliding => {
            let mut state = system.steady_sliding();
            state[0] += OFF_REST * system.scales()[0];
            state
        }
        _ => before.state,
    }
}

/// What a round tells, and whether the round before and another algorithm confirm it.
fn judged<const N: usize>(
    system: &impl SlidingSystem<N>,
    before: Option<&Attractor<N>>,
    settled: Attractor<N>,
    settings: StepSettings<N>,
    patience: &Patience,
) -> Confirmed<N> {
    let closed = closed(system, &settled, settings, patience);
    let is_confirmed = match (settled.settled, before) {
        (Settled::SteadySliding, _) => growth_rate(system).is_ok_and(|growth| growth < 0.0),
        (_, None) => false,
        (Settled::Cycle { .. }, Some(before)) => {
            closed.as_ref().is_some_and(|cycle| is_same_cycle(before, cycle))
        }
        (Settled::Irregular, Some(before)) => {
            before.settled == Settled::Irregular && wanders(system, &settled, settings, patience.time)
        }
    };
    let mut attractor = closed.unwrap_or(settled);
    if let Some(before) = before {
        let had_settled = is_confirmed && before.settled == attractor.settled;
        attractor.time = before.time + if had_settled { 0.0 } else { attractor.time };
    }
    Confirmed { attractor, is_confirmed, tolerance: settings.relative }
}

/// The cycle that a motion has settled to as Newton's method closes it: over its least number of oscillations. `None` where it is no
/// cycle, and where Newton's method fails, leads elsewhere or to a cycle that repels.
fn closed<const N: usize>(
    system: &impl SlidingSystem<N>,
    settled: &Attractor<N>,
    settings: StepSettings<N>,
    patience: &Patience,
) -> Option<Attractor<N>> {
    /// The distance of the return from the start over the tolerance of a step, and what rounding leaves of it.
    const RETURN: (f64, f64) = (100.0, 1e-9);
    const ITERATIONS: usize = 20;
    let Settled::Cycle { oscillations } = settled.settled else { return None };
    let tolerance = (RETURN.0 * settings.relative).max(RETURN.1);
    let shooting = Shooting { settings, tolerance, iterations: ITERATIONS, longest: patience.time };
    let cycle = shoot(system, settled.state, oscillations, &shooting).ok()?;
    let found = Attractor {
        settled: Settled::Cycle { oscillations: cycle.oscillations },
        time: settled.time,
        period: cycle.period(),
        returns: settled.returns.iter().take(cycle.oscillations).copied().collect(),
        state: cycle.start,
        measures: cycle.around.measures,
        recurrences: Vec::new(),
    };
    let mean_time = |motion: &Attractor<N>, oscillations: usize| motion.period / oscillations as f64;
    let is_here = near(found.measures.rms(), settled.measures.rms())
        && near(mean_time(&found, cycle.oscillations), mean_time(settled, oscillations));
    (is_here && cycle.is_stable() && !cycle.is_neutral()).then_some(found)
}

fn is_same_cycle<const N: usize>(before: &Attractor<N>, after: &Attractor<N>) -> bool {
    before.settled == after.settled
        && near(before.measures.rms(), after.measures.rms())
        && near(before.period, after.period)
}

fn near(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() < SAME
}

#[cfg(test)]
mod tests {
    use super::tolerances;

    /// A round at the tolerance of the one before would repeat it digit for digit, and confirm nothing.
    #[test]
    fn every_round_is_finer_than_the_one_before() {
        for asked in [1e-3, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13, 2e-14] {
            let (first, finer) = tolerances(asked);
            let all: Vec<f64> = [first].into_iter().chain(finer).collect();
            assert!(all.len() >= 2 && all.is_sorted_by(|a, b| a > b), "{asked:e}: {all:?}");
            assert!(all[all.len() - 1] <= asked && (first == asked || asked < 1e-11), "{asked:e}: {all:?}");
        }
    }
}
