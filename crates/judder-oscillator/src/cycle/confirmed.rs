//! What a motion settles to, told where a finer tolerance tells the same.
//!
//! Steps to a tolerance disturb a motion at every step. A cycle to which motions return slowly gathers the disturbances of many
//! rounds: its returns then differ by more than what counts as the same, which looks irregular, or fall into a pattern of several
//! oscillations that the cycle does not have. Neither outlives steps of another size.

use crate::hopf::growth_rate;
use crate::motion::attractor::{Attractor, Patience, Settled, distance, settle};
use crate::motion::{Interrupted, SlidingSystem};
use judder_numerics::piecewise::{MarchError, Settings};

/// By how much more exactly a motion is followed in each round, and how exactly at most.
const FINER: f64 = 1e-2;
const FINEST: f64 = 1e-13;
/// Rounds at most.
const ROUNDS: usize = 3;
/// What rms and period of a cycle may change by from one round to the next, relative.
const SAME: f64 = 1e-3;
/// Recurrences of an irregular motion that miss each other by more than this, over their distance from steady sliding, are no
/// disturbance of steps; smaller ones must not shrink by this factor from one round to the next.
const APART: f64 = 1e-2;
const SHRINKS: f64 = 3.0;
/// How far off unstable steady sliding a motion that has come to it goes on, in the magnitudes of steady sliding.
const OFF_REST: f64 = 1e-3;

/// What a motion settles to, and whether that is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Confirmed<const N: usize> {
    /// At the finest tolerance at which it was followed; its time is what it took to come there.
    pub attractor: Attractor<N>,
    /// Whether its two finest tolerances tell the same.
    pub is_confirmed: bool,
    /// The finest tolerance, relative.
    pub tolerance: f64,
}

/// Follows a motion until it has settled, and on from there to a hundredth of the tolerance, until two rounds tell the same.
///
/// Two cycles are the same with as many oscillations, and rms and period to 10⁻³; two irregular motions are, if the distance at which
/// they come back to themselves does not shrink with the tolerance; steady sliding is confirmed by the eigenvalues of its linear
/// motion, which must decay. After three rounds what was found last is told as not confirmed.
///
/// # Errors
/// As [`settle`].
pub fn settle_confirmed<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    settings: Settings<N>,
    patience: &Patience,
    interrupted: Interrupted<'_>,
) -> Result<Confirmed<N>, MarchError> {
    let mut settings = settings;
    let mut attractor = settle(system, start, settings, patience, interrupted)?;
    for _ in 0..ROUNDS {
        if attractor.settled == Settled::SteadySliding && is_stable_at_rest(system) {
            return Ok(Confirmed { attractor, is_confirmed: true, tolerance: settings.relative });
        }
        settings = finer(settings);
        let from = match attractor.settled {
            Settled::SteadySliding => beside_rest(system),
            _ => attractor.state,
        };
        let again = settle(system, from, settings, patience, interrupted)?;
        let time = attractor.time;
        if tells_the_same(system, &attractor, &again, patience) {
            let attractor = Attractor { time, ..again };
            return Ok(Confirmed { attractor, is_confirmed: true, tolerance: settings.relative });
        }
        attractor = Attractor { time: time + again.time, ..again };
    }
    Ok(Confirmed { attractor, is_confirmed: false, tolerance: settings.relative })
}

fn finer<const N: usize>(settings: Settings<N>) -> Settings<N> {
    let relative = (FINER * settings.relative).max(FINEST.min(settings.relative));
    let ratio = relative / settings.relative;
    Settings { relative, absolute: settings.absolute.map(|absolute| ratio * absolute), ..settings }
}

fn is_stable_at_rest<const N: usize>(system: &impl SlidingSystem<N>) -> bool {
    growth_rate(system).is_ok_and(|growth| growth < 0.0)
}

/// Beside unstable steady sliding: at rest a motion would stay there.
fn beside_rest<const N: usize>(system: &impl SlidingSystem<N>) -> [f64; N] {
    let mut state = system.steady_sliding();
    state[0] += OFF_REST * system.scales()[0];
    state
}

fn tells_the_same<const N: usize>(
    system: &impl SlidingSystem<N>,
    before: &Attractor<N>,
    after: &Attractor<N>,
    patience: &Patience,
) -> bool {
    let near = |a: f64, b: f64| (a / b - 1.0).abs() < SAME;
    match (before.settled, after.settled) {
        (Settled::Cycle { oscillations: a }, Settled::Cycle { oscillations: b }) => {
            a == b && near(before.measures.rms(), after.measures.rms()) && near(before.period, after.period)
        }
        (Settled::Irregular, Settled::Irregular) => {
            let [coarse, fine] =
                [before, after].map(|motion| recurrence(system, motion, patience.oscillations));
            fine > APART || SHRINKS * fine > coarse
        }
        // steady sliding twice is steady sliding that does not decay
        _ => false,
    }
}

/// How near an irregular motion comes back to itself, after its best number of oscillations, over its distance from steady sliding.
fn recurrence<const N: usize>(system: &impl SlidingSystem<N>, motion: &Attractor<N>, most: usize) -> f64 {
    let (rest, scales) = (system.steady_sliding(), system.scales());
    let away = motion.returns.first().map_or(f64::NAN, |state| distance(state, &rest, &scales));
    let after = |oscillations: usize| {
        let pairs =
            motion.returns.iter().zip(motion.returns.iter().skip(oscillations)).take(2 * oscillations);
        pairs.map(|(later, earlier)| distance(later, earlier, &scales)).fold(0.0, f64::max)
    };
    let possible = (1..=most).filter(|oscillations| motion.returns.len() >= 3 * oscillations);
    possible.map(after).fold(f64::INFINITY, f64::min) / away
}
