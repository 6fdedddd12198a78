//! The small cycles beside a Hopf point, from which a branch starts.

use super::{Continuation, Cycle, CycleError, shoot};
use crate::hopf::{HopfPoint, hopf_point};
use crate::motion::SlidingSystem;
use std::f64::consts::TAU;

/// How far beside a Hopf point the first cycle is sought, in the parameter's scale: the first that follows the amplitude law
/// is taken. Nearer, the cycle is too weak to be told from steady sliding; farther, the law need no longer hold.
const BESIDE: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-2];
/// What the rms of a cycle may be over that of the amplitude law, and its period over that of the mode, either way.
const RMS_FACTOR: f64 = 1.5;
const PERIOD_FACTOR: f64 = 1.1;

/// A cycle so near to the Hopf point at `threshold` that it follows the amplitude law, and its parameter.
///
/// `side` is +1 where the cycles live above the threshold, −1 where they live below: on the stable side of a subcritical
/// point, on the unstable side of a supercritical one.
///
/// # Errors
/// Newton's method finds no cycle there, or only others: steady sliding is a fixed point of the return map too.
pub fn small_cycle<S: SlidingSystem<N>, const N: usize>(
    system_at: &impl Fn(f64) -> Result<S, CycleError>,
    threshold: f64,
    hopf: &HopfPoint<N>,
    side: f64,
    options: &Continuation<N>,
) -> Result<(f64, Cycle<N>), CycleError> {
    let mut last = CycleError::NotBorn;
    for beside in BESIDE {
        let parameter = threshold + side * beside * options.parameter_scale;
        match beside_hopf(&system_at(parameter)?, hopf, options) {
            Ok(cycle) => return Ok((parameter, cycle)),
            Err(error) => last = error,
        }
    }
    Err(last)
}

fn beside_hopf<S: SlidingSystem<N>, const N: usize>(
    system: &S,
    hopf: &HopfPoint<N>,
    options: &Continuation<N>,
) -> Result<Cycle<N>, CycleError> {
    let here = hopf_point(system)?;
    let rms = hopf.rms(here.growth_rate).ok_or(CycleError::NotBorn)?;
    let start = hopf.state_on_cycle(&system.steady_sliding(), rms);
    let cycle = shoot(system, start, 1, &options.shooting)?;
    let within = |ratio: f64, factor: f64| ratio < factor && ratio * factor > 1.0;
    let follows_the_law = within(cycle.around.measures.rms() / rms, RMS_FACTOR)
        && within(cycle.period() * here.frequency / TAU, PERIOD_FACTOR);
    if follows_the_law { Ok(cycle) } else { Err(CycleError::NotBorn) }
}
