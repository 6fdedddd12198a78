//! Where a branch comes to cycles that touch a guard: beyond a kink it goes on, at a jump of the return map it ends.

use super::{BranchEnd, BranchPlace, BranchPoint, CycleBranch, Walk};
use crate::cycle::CycleError;
use crate::motion::attractor::distance;
use crate::motion::{ContactState, SlidingSystem};

impl<S: SlidingSystem<N>, F: Fn(f64) -> Result<S, CycleError>, const N: usize> Walk<'_, F, N> {
    /// A jump of the return map that lies close by, if there is one.
    pub(super) fn grazing(&self, place: &BranchPlace, branch: &CycleBranch<N>) -> Option<BranchEnd> {
        let along = |component: usize, sign: f64| {
            let mut direction = vec![0.0; N + 1];
            direction[component] = sign;
            direction
        };
        let axes = (0..=N).flat_map(|component| [along(component, 1.0), along(component, -1.0)]);
        let cycle = &branch.points.last()?.cycle;
        std::iter::once(place.tangent.clone())
            .chain(axes)
            .find_map(|direction| self.jump_along(place, &direction, &cycle.around.pattern))
    }

    /// A jump of the return map where, along a direction, the pattern changes.
    fn jump_along(
        &self,
        place: &BranchPlace,
        direction: &[f64],
        pattern: &[ContactState],
    ) -> Option<BranchEnd> {
        /// How far away it is sought.
        const NEAR: f64 = 1e-3;
        /// Of the interval between two patterns: so near to each other all that is smooth is the same.
        const CLOSE: f64 = 1e-12;
        /// In scales: what differs by more has jumped.
        const JUMP: f64 = 1e-3;
        let ahead = |step: f64| {
            let at: Vec<f64> = place.at.iter().zip(direction).map(|(p, d)| p + step * d).collect();
            self.around(&at).ok().map(|(_, around)| around)
        };
        let (mut before, mut beyond) = (0.0, NEAR);
        let mut changed = ahead(beyond).filter(|around| around.pattern != pattern)?;
        let mut kept = ahead(before)?;
        while beyond - before > CLOSE {
            let middle = 0.5 * (before + beyond);
            let around = ahead(middle)?;
            if around.pattern == pattern {
                (before, kept) = (middle, around);
            } else {
                (beyond, changed) = (middle, around);
            }
        }
        let jump = distance(&changed.state, &kept.state, &self.scales);
        (jump > JUMP).then_some(BranchEnd::Grazing { pattern: changed.pattern, jump })
    }

    /// What was found a step from a place, or the cycle the other way where that has turned back: a lone cycle of another pattern,
    /// right behind a kink, does not tell which way the branch goes on, but the branch keeps its pattern there.
    pub(super) fn away_from_the_kink(
        &self,
        place: &BranchPlace,
        step: f64,
        branch: &CycleBranch<N>,
        found: (BranchPoint<N>, BranchPlace),
    ) -> (BranchPoint<N>, BranchPlace) {
        let pattern = |point: &BranchPoint<N>| point.cycle.around.pattern.clone();
        let [.., before, lone] = branch.points.as_slice() else { return found };
        if pattern(before) == pattern(lone) || pattern(before) != pattern(&found.0) {
            return found;
        }
        let tangent = place.tangent.iter().map(|t| -t).collect();
        let back = BranchPlace { at: place.at.clone(), tangent };
        match self.next(&back, step) {
            Ok(other) if pattern(&other.0) == pattern(lone) => other,
            _ => found,
        }
    }

    /// The first cycle on the other piece of a branch that ends, on this one, at a cycle that touches a guard.
    ///
    /// Beside the last cycle motions have another pattern, and the derivative of their return is that of the other piece.
    /// Along its tangent the branch goes on to the side on which cycles have that pattern.
    pub(super) fn round_the_kink(
        &self,
        place: &BranchPlace,
        branch: &CycleBranch<N>,
    ) -> Option<(BranchPoint<N>, BranchPlace)> {
        const AWAY: [f64; 3] = [1e-2, 1e-3, 1e-4];
        let here = branch.points.last()?;
        let mut upwards = vec![0.0; N + 1];
        upwards[N] = 1.0;
        for at in self.neighbours(place) {
            let Ok((_, around)) = self.around(&at) else { continue };
            if around.pattern == here.cycle.around.pattern {
                continue;
            }
            let Ok(tangent) = self.tangent(&at, &around, &upwards) else { continue };
            for (step, sign) in AWAY.iter().flat_map(|step| [(*step, -1.0), (*step, 1.0)]) {
                let tangent = tangent.iter().map(|t| sign * t).collect();
                let start = BranchPlace { at: place.at.clone(), tangent };
                match self.next(&start, step) {
                    Ok((point, there)) if point.cycle.around.pattern == around.pattern => {
                        return Some((point, there));
                    }
                    _ => {}
                }
            }
        }
        None
    }

    /// Places around one, each moved in one component of the state, ever further.
    fn neighbours(&self, place: &BranchPlace) -> Vec<Vec<f64>> {
        const AWAY: [f64; 3] = [1e-4, 1e-3, 1e-2];
        let moves = AWAY.iter().flat_map(|away| (0..N).flat_map(move |i| [(i, *away), (i, -*away)]));
        moves
            .map(|(i, by)| {
                let mut at = place.at.clone();
                at[i] += by;
                at
            })
            .collect()
    }
}
