//! Places along a branch: whether the next one is a neighbour, whether the branch has come back to the first.

use super::{BranchEnd, BranchPoint, CycleBranch};
use crate::cycle::CycleError;
use num_complex::Complex64;

/// A place on the way with the unit tangent there; both hold the scaled state and then the scaled parameter.
#[derive(Clone)]
pub(super) struct BranchPlace {
    pub(super) at: Vec<f64>,
    pub(super) tangent: Vec<f64>,
}

impl BranchPlace {
    pub(super) fn distance(&self, other: &Self) -> f64 {
        self.at.iter().zip(&other.at).fold(0.0, |sum, (a, b)| sum + (a - b) * (a - b)).sqrt()
    }

    /// The cosine of the angle between the tangents.
    fn alignment(&self, other: &Self) -> f64 {
        self.tangent.iter().zip(&other.tangent).map(|(a, b)| a * b).sum()
    }
}

/// How far a branch has been from its start.
pub(super) struct Outing {
    start: BranchPlace,
    farthest: f64,
}

impl Outing {
    pub(super) fn from(start: BranchPlace) -> Self {
        Self { start, farthest: 0.0 }
    }

    /// The end of a branch that has been away and has come back to its start, going the same way.
    pub(super) fn end<const N: usize>(
        &mut self,
        place: &BranchPlace,
        branch: &CycleBranch<N>,
    ) -> Option<BranchEnd> {
        /// Of the farthest place, and the cosine of the angle to the first tangent.
        const NEAR: f64 = 0.05;
        const SAME_WAY: f64 = 0.9;
        let distance = place.distance(&self.start);
        self.farthest = self.farthest.max(distance);
        let is_back = !branch.folds.is_empty() && distance < NEAR * self.farthest;
        (is_back && place.alignment(&self.start) > SAME_WAY).then_some(BranchEnd::Closed)
    }
}

/// Whether two cycles can be neighbours on a smooth piece of a branch: where the parameter turns, and there alone, the number of real
/// multipliers above 1 changes by one. Otherwise the second lies on the same piece, and the branch has turned back on itself.
fn keeps_its_sense<const N: usize>(last: &BranchPoint<N>, next: &BranchPoint<N>) -> bool {
    /// A multiplier nearer to 1 tells nothing.
    const CLEAR: f64 = 1e-4;
    let real = |point: &BranchPoint<N>| {
        let trivial = point.cycle.multipliers.iter().position(|m| *m == Complex64::ONE);
        let others = point.cycle.multipliers.iter().enumerate().filter(move |(k, _)| Some(*k) != trivial);
        others.filter(|(_, m)| m.im == 0.0).map(|(_, m)| m.re - 1.0).collect::<Vec<f64>>()
    };
    let is_clear = [last, next].iter().all(|point| real(point).iter().all(|m| m.abs() > CLEAR));
    let sense = |point: &BranchPoint<N>| {
        real(point).iter().fold(point.slope.signum(), |sign, m| if *m > 0.0 { -sign } else { sign })
    };
    let is_one_piece = last.cycle.around.pattern == next.cycle.around.pattern;
    !is_one_piece || !is_clear || sense(last) == sense(next)
}

/// What was found a step from a place if it is a neighbour of the branch's last cycle. Steady sliding is a fixed point of the return
/// map too, and a long step can end at it, or on another sheet of the branch.
pub(super) fn neighbour<const N: usize>(
    branch: &CycleBranch<N>,
    place: &BranchPlace,
    step: f64,
    found: (BranchPoint<N>, BranchPlace),
) -> Result<(BranchPoint<N>, BranchPlace), CycleError> {
    /// What the amplitude may shrink to in a step, and what the period may change by, either way.
    const SHRINKS: f64 = 0.2;
    const PERIOD: f64 = 1.5;
    /// How far the cycle may lie from where it was, over the step: Newton's method may correct no more than half a step.
    const ASTRAY: f64 = 1.1;
    let Some(last) = branch.points.last() else { return Ok(found) };
    let (from, to) = (last.cycle.period(), found.0.cycle.period());
    let amplitude = |point: &BranchPoint<N>| point.cycle.around.measures.amplitude();
    let is_neighbour = amplitude(&found.0) > SHRINKS * amplitude(last)
        && to < PERIOD * from
        && from < PERIOD * to
        && found.1.distance(place) < ASTRAY * step
        && keeps_its_sense(last, &found.0);
    if is_neighbour { Ok(found) } else { Err(CycleError::Elsewhere { from, to }) }
}
