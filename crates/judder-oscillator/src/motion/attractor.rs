//! Where a motion settles: steady sliding, a cycle, or neither within its time.

use super::measures::Measures;
use super::sliding_system::contact_change;
use super::{ContactState, Interrupted, SlidingSystem};
use judder_numerics::piecewise::{MarchError, PiecewiseMarch, StepSettings};
use std::collections::VecDeque;

/// How long a motion is followed and when it counts as settled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patience {
    /// The longest time.
    pub time: f64,
    /// The first part of it, which the averages of an irregular motion leave out.
    pub transient: f64,
    /// Distance of returns from each other, over their distance from steady sliding, below which they are the same.
    pub closeness: f64,
    /// Distance from steady sliding, in the same scales, below which the motion has come to it.
    pub rest: f64,
    /// The most oscillations in one period.
    pub oscillations: usize,
}

impl Default for Patience {
    fn default() -> Self {
        Self { time: 2e4, transient: 1e4, closeness: 1e-6, rest: 1e-6, oscillations: 21 }
    }
}

/// What a motion has settled to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Settled {
    /// Steady sliding.
    SteadySliding,
    /// A cycle of so many oscillations.
    Cycle {
        /// Returns to the section in a period.
        oscillations: usize,
    },
    /// Neither, within its time: irregular, or not settled yet; [`crate::cycle::settle_confirmed`] tells which.
    Irregular,
}

/// A settled motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Attractor<const N: usize> {
    /// What it is.
    pub settled: Settled,
    /// The time that it took.
    pub time: f64,
    /// The period of a cycle; the mean time of an oscillation otherwise, NaN where there was none.
    pub period: f64,
    /// Over one period of a cycle; over the time after the transient of an irregular motion.
    pub measures: Measures,
    /// Its last meetings with the section, the latest first: those of one period of a cycle, some of an irregular motion.
    pub returns: Vec<[f64; N]>,
    /// Its last state, on the section if it is a cycle.
    pub state: [f64; N],
    /// Of an irregular motion the returns that came nearest to an earlier one, and how many oscillations lie between, by
    /// rising number: each is next to an unstable cycle.
    pub recurrences: Vec<([f64; N], usize)>,
}

/// The largest component of a difference in units of the scales.
#[must_use]
pub fn distance<const N: usize>(a: &[f64; N], b: &[f64; N], scales: &[f64; N]) -> f64 {
    (0..N).fold(0.0, |largest: f64, i| largest.max((a[i] - b[i]).abs() / scales[i]))
}

/// Returns kept, over the most oscillations of a period: a period is seen where it comes back twice.
const REMEMBERED: usize = 3;

/// Follows a motion until it has settled.
///
/// # Errors
/// The motion cannot be followed: budget of steps, accumulation, a state that is not finite; or it was interrupted.
pub fn settle<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    settings: StepSettings<N>,
    patience: &Patience,
    interrupted: Interrupted<'_>,
) -> Result<Attractor<N>, MarchError> {
    let (rest, scales) = (system.steady_sliding(), system.scales());
    let mut march = PiecewiseMarch::new(system, system.starting_mode(&start), start, settings)?
        .with_section(system.section());
    let mut returns: VecDeque<(f64, [f64; N])> = VecDeque::new();
    let mut late = Measures::default();
    loop {
        if interrupted() {
            return Err(MarchError::Interrupted { time: march.time() });
        }
        let advance = system.advance(&mut march, patience.time)?;
        if march.time() > patience.transient
            && let Some(leg) = &advance.leg
        {
            system.measure(leg, rest[0], &mut late);
            late.changes += usize::from(advance.crossing.as_ref().and_then(contact_change).is_some());
        }
        // after every step: not every motion to steady sliding oscillates
        let state = march.state();
        if march.mode().into() == ContactState::SlipBehind && distance(&state, &rest, &scales) < patience.rest
        {
            return Ok(at_rest(&march, &returns, state));
        }
        if advance.on_section {
            returns.push_front((march.time(), state));
            returns.truncate(REMEMBERED * patience.oscillations);
            let allowed = patience.closeness * distance(&state, &rest, &scales);
            // half of the time is left to come as near after a part of the oscillations, or to keep away
            let is_settled = |oscillations: &usize| {
                repeats(&returns, &scales, allowed, *oscillations) || march.time() > 0.5 * patience.time
            };
            let oscillations = repetition(&returns, &scales, allowed, patience.oscillations);
            if let Some(oscillations) = oscillations.filter(is_settled) {
                let returns = returns.iter().take(oscillations).map(|(_, state)| *state).collect();
                return one_period(system, march, settings, returns);
            }
        }
        if march.time() >= patience.time {
            return Ok(Attractor {
                settled: Settled::Irregular,
                time: march.time(),
                period: mean_return_time(&returns),
                measures: late,
                returns: returns.iter().map(|(_, state)| *state).collect(),
                state: march.state(),
                recurrences: recurrences(&returns, &scales, patience.oscillations),
            });
        }
    }
}

fn at_rest<S: SlidingSystem<N>, const N: usize>(
    march: &PiecewiseMarch<'_, S, N>,
    returns: &VecDeque<(f64, [f64; N])>,
    state: [f64; N],
) -> Attractor<N> {
    Attractor {
        settled: Settled::SteadySliding,
        time: march.time(),
        period: mean_return_time(returns),
        measures: Measures::default(),
        returns: Vec::new(),
        state,
        recurrences: Vec::new(),
    }
}

fn mean_return_time<const N: usize>(returns: &VecDeque<(f64, [f64; N])>) -> f64 {
    match (returns.front(), returns.back()) {
        (Some(last), Some(first)) if returns.len() > 1 => (last.0 - first.0) / (returns.len() - 1) as f64,
        _ => f64::NAN,
    }
}

fn recurrences<const N: usize>(
    returns: &VecDeque<(f64, [f64; N])>,
    scales: &[f64; N],
    most: usize,
) -> Vec<([f64; N], usize)> {
    let nearest = |oscillations: usize| {
        let pairs = returns.iter().zip(returns.iter().skip(oscillations));
        let distances = pairs.map(|(later, earlier)| (distance(&later.1, &earlier.1, scales), later.1));
        distances.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, state)| (state, oscillations))
    };
    (1..=most).filter_map(nearest).collect()
}

/// Distances between returns (time and state, the latest first) so many oscillations apart, over two such spans: a slow passage is
/// not to be taken for a cycle. Fewer where there are not as many returns.
fn misses<const N: usize>(
    returns: &VecDeque<(f64, [f64; N])>,
    scales: &[f64; N],
    oscillations: usize,
) -> impl Iterator<Item = f64> {
    let pairs = returns.iter().zip(returns.iter().skip(oscillations)).take(2 * oscillations);
    pairs.map(|(later, earlier)| distance(&later.1, &earlier.1, scales))
}

/// Whether returns so many oscillations apart come `allowed` near to each other, twice in a row.
fn repeats<const N: usize>(
    returns: &VecDeque<(f64, [f64; N])>,
    scales: &[f64; N],
    allowed: f64,
    oscillations: usize,
) -> bool {
    returns.len() >= 3 * oscillations && misses(returns, scales, oscillations).all(|miss| miss < allowed)
}

/// The fewest oscillations, `most` at most, after which the returns (time and state, the latest first) come `allowed` near to
/// each other in units of the scales, twice in a row; `None` where there are none.
///
/// Of these it is the least part after which they miss each other by little more: a motion that comes to its cycle on alternating
/// sides is near to itself after two oscillations sooner than after one, though it has the period of one.
#[must_use]
pub fn repetition<const N: usize>(
    returns: &VecDeque<(f64, [f64; N])>,
    scales: &[f64; N],
    allowed: f64,
    most: usize,
) -> Option<usize> {
    /// Times as much: 1/(1 + μ) with a multiplier μ near −1. A doubled period makes it ever more while the motion settles.
    const LITTLE_MORE: f64 = 30.0;
    let whole = (1..=most).find(|count| repeats(returns, scales, allowed, *count))?;
    let near = LITTLE_MORE * misses(returns, scales, whole).fold(0.0, f64::max);
    let parts = (1..whole).filter(|count| whole.is_multiple_of(*count));
    parts.filter(|count| repeats(returns, scales, near, *count)).min().or(Some(whole))
}

/// One more period, measured.
fn one_period<S: SlidingSystem<N>, const N: usize>(
    system: &S,
    march: PiecewiseMarch<'_, S, N>,
    settings: StepSettings<N>,
    returns: Vec<[f64; N]>,
) -> Result<Attractor<N>, MarchError> {
    let (start, rest) = (march.state(), system.steady_sliding());
    let mut lap = PiecewiseMarch::new(system, march.mode(), start, settings)?.with_section(system.section());
    let mut measures = Measures::default();
    let oscillations = returns.len();
    let mut left = oscillations;
    while left > 0 {
        let advance = system.advance(&mut lap, f64::INFINITY)?;
        if let Some(leg) = &advance.leg {
            system.measure(leg, rest[0], &mut measures);
        }
        measures.changes += usize::from(advance.crossing.as_ref().and_then(contact_change).is_some());
        left -= usize::from(advance.on_section);
    }
    Ok(Attractor {
        settled: Settled::Cycle { oscillations },
        time: march.time(),
        period: lap.time(),
        measures,
        returns,
        state: lap.state(),
        recurrences: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns at positions `at(k)` along a line, k oscillations ago.
    fn returns(at: impl Fn(i32) -> f64) -> VecDeque<(f64, [f64; 2])> {
        (0..24).map(|ago| (-f64::from(ago), [at(ago), 0.0])).collect()
    }

    fn found(at: impl Fn(i32) -> f64) -> Option<usize> {
        repetition(&returns(at), &[1.0; 2], 1e-4, 8)
    }

    #[test]
    fn returns_on_alternating_sides_repeat_after_one_oscillation() {
        // u_k = (−0.77)^k: near after two before after one; after three with a third of a turn
        let alternating = |ago: i32| 1e-4 * (-0.77_f64).powi(-ago);
        let returns_now = returns(alternating);
        assert!(repeats(&returns_now, &[1.0; 2], 2e-4, 2) && !repeats(&returns_now, &[1.0; 2], 2e-4, 1));
        assert_eq!(repetition(&returns_now, &[1.0; 2], 2e-4, 8), Some(1));
        let turning =
            |ago: i32| 2e-5 * 0.95_f64.powi(-ago) * (f64::from(ago) * std::f64::consts::TAU / 3.0).cos();
        let returns_now = returns(turning);
        assert!(repeats(&returns_now, &[1.0; 2], 2e-5, 3) && !repeats(&returns_now, &[1.0; 2], 2e-5, 1));
        assert_eq!(repetition(&returns_now, &[1.0; 2], 2e-5, 8), Some(1));
    }

    #[test]
    fn a_doubled_period_is_two_oscillations_however_near_they_are() {
        let doubled = |apart: f64, transient: f64| {
            move |ago: i32| f64::from(ago % 2) * apart + transient * 0.9_f64.powi(-ago)
        };
        for (apart, transient) in [(1.0, 0.0), (1e-2, 1e-5), (1e-3, 1e-6), (2e-4, 1e-8)] {
            assert_eq!(found(doubled(apart, transient)), Some(2), "{apart:e} {transient:e}");
        }
        assert_eq!(found(doubled(1e-5, 0.0)), Some(1));
    }

    #[test]
    fn parts_count_where_they_divide_and_nothing_repeats_that_drifts() {
        // of four oscillations two, not one
        assert_eq!(found(|ago| f64::from(ago % 2) + 6e-5 * (-1.1_f64).powi(ago / 2)), Some(2));
        assert_eq!(found(|ago| f64::from(ago % 3)), Some(3));
        assert_eq!(found(|ago| 1e-3 * f64::from(ago)), None);
        assert_eq!(repetition(&VecDeque::<(f64, [f64; 2])>::new(), &[1.0; 2], 1.0, 8), None);
    }
}
