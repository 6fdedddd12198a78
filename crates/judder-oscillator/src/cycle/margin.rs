//! From a subcritical Hopf point back to the fold of its branch.
//!
//! Beside a subcritical threshold an unstable cycle bounds the disturbances that stable steady sliding survives. Its branch
//! leads away from the threshold, on the stable side, to a turn: beyond it no cycle of the branch is left, before it a large
//! cycle waits for a knock. So the turn, and not the threshold, is the safe limit as far as this branch tells: cycles of other
//! branches, with more oscillations in a period, may live beyond it.

use super::continuation::{Continuation, CycleBranch, continue_branch};
use super::{CycleError, small_cycle};
use crate::hopf::{HopfPoint, hopf_point};
use crate::motion::SlidingSystem;

/// What lies beside a threshold.
#[derive(Debug, Clone, PartialEq)]
pub struct GlobalMargin<const N: usize> {
    /// The mode at the threshold with its first Lyapunov coefficient.
    pub hopf: HopfPoint<N>,
    /// The first turn of the branch away from the threshold; `None` beside a supercritical threshold, and where the branch
    /// ends before it turns.
    pub fold: Option<f64>,
    /// The branch, from its small cycles on; `None` beside a supercritical threshold.
    pub branch: Option<CycleBranch<N>>,
}

impl<const N: usize> GlobalMargin<N> {
    /// The parameter farthest from the threshold at which a cycle of the branch is known: the fold, a later turn beyond it, or
    /// the last point of a branch that was lost.
    #[must_use]
    pub fn reaches(&self, threshold: f64) -> Option<f64> {
        let branch = self.branch.as_ref()?;
        let first = branch.points.first()?.parameter - threshold;
        let turns = branch.folds.iter().map(|fold| fold.parameter);
        let known = branch.points.iter().map(|point| point.parameter).chain(turns);
        known.max_by(|a, b| (first * a).total_cmp(&(first * b)))
    }
}

/// Follows the cycles that bound stable steady sliding beside a threshold at `threshold`.
///
/// `system_at` makes the oscillator at a value of the parameter; `stable_side` is +1 where steady sliding is stable above the
/// threshold, −1 where it is below.
///
/// # Errors
/// The mode at the threshold or the first small cycle cannot be had.
pub fn global_margin<S: SlidingSystem<N>, const N: usize>(
    system_at: &impl Fn(f64) -> Result<S, CycleError>,
    threshold: f64,
    stable_side: f64,
    options: &Continuation<N>,
) -> Result<GlobalMargin<N>, CycleError> {
    let hopf = hopf_point(&system_at(threshold)?)?;
    if !hopf.is_subcritical() {
        return Ok(GlobalMargin { hopf, fold: None, branch: None });
    }
    let (parameter, small) = small_cycle(system_at, threshold, &hopf, stable_side, options)?;
    let branch = continue_branch(system_at, parameter, (small.start, 1), stable_side, options)?;
    let fold = branch.folds.first().map(|fold| fold.parameter);
    Ok(GlobalMargin { hopf, fold, branch: Some(branch) })
}
