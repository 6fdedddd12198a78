//! Where a branch of cycles whose period has doubled comes back to the cycles from which it has doubled.
//!
//! There its two halves become one. Beyond, the continuation would find the same cycles again, half a period later, or the shorter ones
//! walked twice: neither is a new branch.

use super::{BranchEnd, BranchPoint, CycleBranch, Walk};
use crate::cycle::CycleError;
use crate::cycle::return_map::returned_state;
use crate::motion::SlidingSystem;

/// How far, in scales, the second half of the last cycle starts from the first; `None` for an odd number of oscillations.
pub(super) struct Halves<const N: usize> {
    apart: Option<[f64; N]>,
}

impl<const N: usize> Halves<N> {
    pub(super) fn of<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError>>(
        walk: &Walk<'_, F, N>,
        first: &BranchPoint<N>,
    ) -> Self {
        Self { apart: walk.halves_apart(first) }
    }

    /// The end of a branch whose halves have passed through each other, or come so near that Newton's method cannot tell them apart. What
    /// was found beyond is taken off it.
    pub(super) fn end<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError>>(
        &mut self,
        walk: &Walk<'_, F, N>,
        branch: &mut CycleBranch<N>,
    ) -> Option<BranchEnd> {
        let before = self.apart?;
        let now = walk.halves_apart(branch.points.last()?)?;
        let largest = |apart: &[f64; N]| apart.iter().fold(0.0, |largest: f64, a| largest.max(a.abs()));
        // where a multiplier is -1 the return over both halves misses by the square
        let is_one =
            largest(&now) < walk.options.shooting.tolerance.sqrt() && largest(&now) < largest(&before);
        let has_passed = before.iter().zip(&now).map(|(a, b)| a * b).sum::<f64>() < 0.0;
        if !is_one && !has_passed {
            self.apart = Some(now);
            return None;
        }
        branch.points.pop();
        let last = branch.points.len().saturating_sub(1);
        branch.folds.retain(|fold| fold.after < last);
        branch.pattern_changes.retain(|change| change.after < last);
        Some(BranchEnd::Halves)
    }
}

impl<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError>, const N: usize> Walk<'_, F, N> {
    fn halves_apart(&self, point: &BranchPoint<N>) -> Option<[f64; N]> {
        if !self.oscillations.is_multiple_of(2) {
            return None;
        }
        let system = (self.system_at)(point.parameter).ok()?;
        let (shooting, start) = (&self.options.shooting, point.cycle.start);
        let half = self.oscillations / 2;
        let returned = returned_state(&system, start, half, shooting.settings, shooting.longest).ok()?;
        Some(std::array::from_fn(|i| (returned[i] - start[i]) / self.scales[i]))
    }
}
