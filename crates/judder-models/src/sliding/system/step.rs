//! Methods and steps of marches.

use judder_sliding::SlidingError;
use judder_sliding::march::{ContactMethod, March, MarchSettings, Predictor};
use judder_sliding::motion::Motion;
use judder_sliding::pair::Pair;

/// The step of a march and its limit, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MarchStep {
    /// h.
    pub(crate) step: f64,
    /// The largest stable one.
    pub(crate) limit: f64,
}

/// Share of the limit, and largest step in s, that a march takes by itself: central differences as the paper's reading has them.
const CENTRAL: (f64, f64) = (0.9, 3e-7);
/// Those of the march with residual flexibility: 100 kHz is still seen.
const RESIDUAL: (f64, f64) = (0.75, 3e-6);
/// A step that any pair could take; the limit does not depend on it.
const ANY: f64 = 1e-9;

/// The step that a case gives, or that the march chooses, with the limit along the path of the motion.
///
/// # Errors
/// [`SlidingError::StepOverLimit`], and what [`March::beyond_limit`] says.
pub(crate) fn step(
    pair: &Pair,
    method: ContactMethod,
    given: Option<f64>,
    motion: Motion,
) -> Result<MarchStep, SlidingError> {
    // the static path does not matter to the limit, and takes long
    let method = if matches!(method, ContactMethod::Subs { .. }) {
        ContactMethod::Subs { static_slope: false }
    } else {
        method
    };
    let limit = March::beyond_limit(
        pair,
        MarchSettings { method, step: ANY, motion, predictor: Predictor::default() },
    )?
    .step_limit();
    let (share, largest) =
        if matches!(method, ContactMethod::ResidualFlexibility { .. }) { RESIDUAL } else { CENTRAL };
    let step = given.unwrap_or((share * limit).min(largest));
    if step > limit {
        return Err(SlidingError::StepOverLimit { step, limit });
    }
    Ok(MarchStep { step, limit })
}
