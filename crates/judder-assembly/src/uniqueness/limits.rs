//! With how much friction steady sliding ceases to be the only one.

use super::complementarity::Complementarity;
use crate::assembly::Assembly;
use crate::interface::{FramedPoint, InterfaceLaw};
use crate::steady::SteadySliding;
use faer::Mat;
use judder_dense::general::{real_eigenvalues, solve};
use judder_structure::factor::SymmetricFactor;

/// Where something begins as all friction coefficients grow alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionOnset {
    /// By what they are multiplied.
    pub factor: f64,
    /// The point where it begins, in the order of all interfaces.
    pub point: usize,
}

/// Where states and motions begin to be lost; none where that is at no friction, or not known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionOnsets {
    /// Where the equations of some set of closed points become singular, of whichever: up to there, there is one state whatever the loads.
    pub any_set: Option<FrictionOnset>,
    /// Where a closed point, were it the only one, would dig in: c·K⁻¹ e = 0.
    pub one_point: Option<FrictionOnset>,
    /// Where a closed point, were it the only one, would lock at once, its inertia alone: c·M⁻¹ e = 0.
    pub one_point_inertia: Option<FrictionOnset>,
    /// Whether all sets were looked at.
    pub all_sets_known: bool,
    /// Whether the points were looked at by themselves.
    pub one_point_known: bool,
    /// Whether their inertia was.
    pub inertia_known: bool,
}

/// Points that may open up to which every set of them is looked at.
const SETS: usize = 10;
/// Points up to which their inertia is looked at.
const LARGEST: usize = 2000;
/// An eigenvalue is real where its imaginary part is below so much of its size.
const REAL: f64 = 1e-8;
/// What pushes on by less than so much of what resists does so by rounding.
const ROUNDING: f64 = 1e-12;

impl FrictionOnsets {
    pub(super) fn new(
        assembly: &Assembly,
        points: &[FramedPoint<'_>],
        problem: Option<&Complementarity>,
        steady: &SteadySliding,
    ) -> Self {
        let closed = |k: &usize| steady.points[*k].is_closed;
        let mut onsets = Self::default();
        if let Some([normal, friction]) = problem.and_then(|problem| problem.parts.as_ref()) {
            onsets.one_point_known = true;
            let own = |k: usize| onset(normal[(k, k)], friction[(k, k)], k);
            onsets.one_point = first((0..points.len()).filter(closed).filter_map(own));
        }
        if let Some(problem) = problem
            && let Some(parts) = &problem.parts
            && problem.free().len() <= SETS
        {
            onsets.all_sets_known = true;
            onsets.any_set = any_set(problem, parts);
        }
        if points.len() <= LARGEST
            && let Some(found) = inertia(assembly, points, &closed)
        {
            onsets.inertia_known = true;
            onsets.one_point_inertia = first(found.into_iter());
        }
        onsets
    }
}

/// Where a + s b, positive without friction, comes to zero.
fn onset(resists: f64, pushes: f64, point: usize) -> Option<FrictionOnset> {
    let comes = resists > 0.0 && pushes < -ROUNDING * resists;
    comes.then(|| FrictionOnset { factor: -resists / pushes, point })
}

fn first(onsets: impl Iterator<Item = FrictionOnset>) -> Option<FrictionOnset> {
    onsets.min_by(|a, b| a.factor.total_cmp(&b.factor))
}

/// The least friction with which the equations of some set of closed points are singular, and its point that moves most.
fn any_set(problem: &Complementarity, [normal, friction]: &[Mat<f64>; 2]) -> Option<FrictionOnset> {
    let (free, bound) = (problem.free(), problem.bound());
    let sets = (0..1_usize << free.len()).map(|set| {
        let chosen = free.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1).map(|(_, point)| *point);
        bound.iter().copied().chain(chosen).collect::<Vec<_>>()
    });
    first(sets.filter(|set| !set.is_empty()).filter_map(|set| {
        let part = |of: &Mat<f64>| Mat::from_fn(set.len(), set.len(), |i, j| of[(set[i], set[j])]);
        let (normal, friction) = (part(normal), part(friction));
        let mut moved = friction.clone();
        solve(normal.clone(), &mut moved)?;
        let values = real_eigenvalues(&moved)?;
        let real =
            values.iter().filter(|value| value.re < -ROUNDING && value.im.abs() <= REAL * value.norm());
        let factor = -1.0 / real.map(|value| value.re).reduce(f64::min)?;
        // one step of inverse iteration beside the singular matrix gives what moves
        let near = Mat::from_fn(set.len(), set.len(), |i, j| {
            normal[(i, j)] + factor * (1.0 + 1e-6) * friction[(i, j)]
        });
        let mut shape = Mat::from_fn(set.len(), 1, |i, _| 1.0 + (i as f64).sin());
        solve(near, &mut shape)?;
        let size = |k: &usize| shape[(*k, 0)].abs();
        let largest = (0..set.len()).max_by(|a, b| size(a).total_cmp(&size(b)).then(b.cmp(a)))?;
        Some(FrictionOnset { factor, point: set[largest] })
    }))
}

/// Where the closed points would lock by their inertia, each by itself; `None` where masses are missing.
fn inertia(
    assembly: &Assembly,
    points: &[FramedPoint<'_>],
    closed: &dyn Fn(&usize) -> bool,
) -> Option<Vec<FrictionOnset>> {
    let factor = SymmetricFactor::new(&assembly.mass).ok()?;
    if factor.negative_eigenvalues() > 0 {
        return None;
    }
    let mut found = Vec::new();
    for k in (0..points.len()).filter(closed) {
        let FramedPoint { frame, law, .. } = &points[k];
        let friction = match law {
            InterfaceLaw::Rigid(friction) | InterfaceLaw::Compliant(_, friction) => friction,
            InterfaceLaw::Asperity(_) => return None,
        };
        let mut moved = vec![0.0; assembly.size()];
        frame.normal.add_to(1.0, &mut moved);
        factor.solve(&mut moved);
        let (along, across) = (frame.normal.of(&moved), frame.slip.of(&moved));
        let is_known = along > 0.0 && along.is_finite() && across.is_finite();
        if !is_known {
            return None;
        }
        found.extend(onset(along, friction.at(frame.speed).coefficient * across, k));
    }
    Some(found)
}
