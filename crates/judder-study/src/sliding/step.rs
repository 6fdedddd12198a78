//! Methods and steps of marches.

use judder_case::sliding::march::MarchMethod;
use judder_sliding::SlidingError;
use judder_sliding::march::{March, MarchSettings, Method};
use judder_sliding::motion::Motion;
use judder_sliding::pair::Pair;
use std::f64::consts::TAU;

/// The step of a march and its limit, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Step {
    /// h.
    pub(crate) step: f64,
    /// The largest stable one.
    pub(crate) limit: f64,
}

/// The step of the paper, s, which a march of central differences takes by itself where it is stable.
const STEP: f64 = 3e-7;
/// The largest that the exact march takes by itself, s: 100 kHz is still seen.
const EXACT_STEP: f64 = 3e-6;
/// Shares of the limit that are taken at most where the case leaves the step to the march.
const SHARE: f64 = 0.9;
const EXACT_SHARE: f64 = 0.75;
/// A step that any pair could take; the limit does not depend on it.
const ANY: f64 = 1e-9;

/// The method of a case as the march has it.
pub(crate) fn method(own: MarchMethod) -> Method {
    match own {
        MarchMethod::Subs { static_slope } => Method::Subs { static_slope },
        MarchMethod::Ensubs => Method::EnSubs,
        MarchMethod::Film => Method::Film,
        MarchMethod::ResidualFlexibility { cut_off } => {
            Method::ResidualFlexibility { cut_off: cut_off / TAU }
        }
    }
}

/// The step that a case gives, or that the march chooses, with the limit along the path of the motion.
///
/// # Errors
/// [`SlidingError::StepOverLimit`], and what [`March::beyond_limit`] says.
pub(crate) fn step(
    pair: &Pair,
    method: Method,
    given: Option<f64>,
    motion: Motion,
) -> Result<Step, SlidingError> {
    // the static path does not matter to the limit, and takes long
    let method =
        if matches!(method, Method::Subs { .. }) { Method::Subs { static_slope: false } } else { method };
    let limit = March::beyond_limit(pair, MarchSettings { method, step: ANY, motion })?.step_limit();
    let own = match method {
        Method::ResidualFlexibility { .. } => (EXACT_SHARE * limit).min(EXACT_STEP),
        _ => (SHARE * limit).min(STEP),
    };
    let step = given.unwrap_or(own);
    if step > limit {
        return Err(SlidingError::StepOverLimit { step, limit });
    }
    Ok(Step { step, limit })
}
