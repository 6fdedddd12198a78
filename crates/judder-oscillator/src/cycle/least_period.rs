//! The least period: a cycle of n oscillations may be a shorter one walked several times, which returns to its start too.
//!
//! A motion that comes to a cycle on alternating sides, a multiplier near −1, repeats itself after two oscillations sooner than after
//! one. Newton's method on two of them then finds the cycle walked twice, with the squares of its multipliers.

use super::CycleError;
use super::newton::{Converged, CycleGuess, Shooting, converge, newton_step};
use super::return_map::return_map;
use crate::motion::SlidingSystem;
use crate::motion::attractor::distance;

/// The shortest cycle of which the one that was found is a repetition; `None` where it is the shortest itself.
///
/// Of the proper divisors of the number of oscillations it is the least from which Newton's method leads no further away than the
/// found start is uncertain. The cycle from which another has doubled its period is further away than that.
pub(super) fn shortest<const N: usize>(
    system: &impl SlidingSystem<N>,
    found: &Converged<N>,
    shooting: &Shooting<N>,
) -> Option<Converged<N>> {
    let divisors = (1..found.oscillations).filter(|count| found.oscillations.is_multiple_of(*count));
    let mut divisors = divisors.peekable();
    // a cycle of one oscillation has none
    divisors.peek()?;
    let allowed = uncertainty(&found.guess, &system.scales(), shooting);
    divisors.find_map(|count| shorter(system, &found.guess.start, count, allowed, shooting))
}

/// How far from the true cycle, in scales, a start may lie from which Newton's method has ended.
fn uncertainty<const N: usize>(guess: &CycleGuess<N>, scales: &[f64; N], shooting: &Shooting<N>) -> f64 {
    /// Over the next step of Newton's method, which is the first order of the distance.
    const BEYOND: f64 = 2.0;
    let next = newton_step(guess, scales).map_or(0.0, |step| distance(&step, &[0.0; N], scales));
    // the return is no better known than its tolerance; beyond the root of it a first order says nothing, as beside a fold
    shooting.tolerance + (BEYOND * next).min(shooting.tolerance.sqrt())
}

/// The cycle of so many oscillations within `allowed` of the start.
fn shorter<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: &[f64; N],
    oscillations: usize,
    allowed: f64,
    shooting: &Shooting<N>,
) -> Option<Converged<N>> {
    let scales = system.scales();
    let first_step = || -> Result<f64, CycleError> {
        let around = return_map(system, *start, oscillations, shooting.settings, shooting.longest)?;
        let residual = distance(&around.state, start, &scales);
        let step = newton_step(&CycleGuess { start: *start, around, residual }, &scales)?;
        Ok(distance(&step, &[0.0; N], &scales))
    };
    // one flight tells most cycles from a shorter one; Newton's method need not go all the way to another
    first_step().ok().filter(|step| *step <= allowed)?;
    let shorter = converge(system, *start, oscillations, shooting).ok()?;
    (distance(&shorter.guess.start, start, &scales) <= allowed).then_some(shorter)
}
