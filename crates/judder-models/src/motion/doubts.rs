//! What makes a motion doubtful: that it leaves what is known of friction and contact, or that its size is nobody's.

use crate::error::ModelError;
use crate::motion::model::{Moving, Operating};
use judder_numerics::words::plain;
use judder_oscillator::cycle::shooting::Cycle;
use judder_oscillator::motion::SlidingSystem;
use judder_oscillator::motion::history::StateSample;

/// The share of a motion's instants beyond a law's range above which that is told: the tips of the fastest swings say little.
const TOLD: f64 = 0.01;

/// That steady sliding, or else a motion at more than a few of its instants, lies beyond what its law is known for.
pub(crate) fn beyond_law<M: Moving<N>, const N: usize>(
    operating: &Operating<M::System>,
    samples: &[StateSample<N>],
) -> Option<String> {
    let concern = |state: &[f64; N]| M::concern(operating, state);
    if let Some(concern) = concern(&operating.system.steady_sliding()) {
        return Some(format!("outside the law's range in steady sliding: {concern}"));
    }
    let mut beyond = samples.iter().filter_map(|sample| concern(&sample.state));
    let first = beyond.next()?;
    let (count, all) = (beyond.count() + 1, samples.len());
    let is_told = count as f64 > TOLD * all as f64;
    is_told.then(|| format!("outside the law's range at {count} of {all} instants, for one: {first}"))
}

/// That steady sliding lies beyond what its law is known for, at how many points of a diagram.
pub(crate) fn beyond_law_along<M: Moving<N>, const N: usize>(
    operating: impl Iterator<Item = Operating<M::System>>,
) -> Option<String> {
    let (mut all, mut concerns) = (0, Vec::new());
    for here in operating {
        all += 1;
        concerns.extend(M::concern(&here, &here.system.steady_sliding()));
    }
    let first = concerns.first()?;
    Some(format!(
        "outside the law's range in steady sliding at {} of {all} values, for one: {first}",
        concerns.len()
    ))
}

/// An error of what begins with steady sliding; where that lies beyond what its law is known for, it says so.
pub(crate) fn doubted<M: Moving<N>, const N: usize>(
    operating: &Operating<M::System>,
    error: ModelError,
) -> ModelError {
    match (error, beyond_law::<M, N>(operating, &[])) {
        (ModelError::Interrupted, _) => ModelError::Interrupted,
        (error, None) => error,
        (error, Some(doubt)) => ModelError::Doubted { cause: Box::new(error), doubt },
    }
}

/// That motions beside a cycle neither come to it nor leave it.
pub(crate) fn neutral<const N: usize>(cycle: &Cycle<N>) -> Option<String> {
    let others = cycle.largest_multiplier();
    cycle.is_neutral().then(|| {
        format!(
            "motions beside this cycle neither come to it nor leave it, as far as is known: beside the trivial one its largest Floquet multiplier is {}. Its size is \
             then that of the start, and whether it is stable is unknown",
            plain(others)
        )
    })
}
