//! With how much friction steady sliding ceases to be the only one.

use super::are_few;
use super::complementarity::{Complementarity, PIVOTED, is_definite};
use crate::assembly::Assembly;
use crate::interface::{FramedPoint, InterfaceLaw};
use crate::steady::{FrictionAmount, GrowingFriction, Singular, SteadySliding, first_singular};
use faer::Mat;
use judder_structure::factor::SymmetricFactor;

/// Where something begins as all friction coefficients grow alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionOnset {
    /// How much there is.
    pub friction: FrictionAmount,
    /// The point where it begins, in the order of all interfaces.
    pub point: usize,
}

/// Where states and motions begin to be lost; none where that is for no friction coefficient, or not known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionOnsets {
    /// Where the equations of some set of closed points become singular, of whichever: up to there, there is one state whatever the loads.
    pub any_set: Option<FrictionOnset>,
    /// Where a closed point, were it the only one, would dig in: c·K⁻¹ e + k⁻¹ = 0.
    pub one_point: Option<FrictionOnset>,
    /// Where a closed rigid point, were it the only one, would lock at once, its inertia alone: c·M⁻¹ e = 0. A normal spring lets no point lock at once.
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
/// Up to so many sets times the cube of all points, those that stay closed among them: 10 of 25 points.
const SETS_WORK: usize = 1 << 24;
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
        let growing = GrowingFriction::of(points);
        let told = |own: PointOnset| FrictionOnset { friction: growing.amount(own.size), point: own.point };
        let mut onsets = Self::default();
        if let Some(problem) = problem
            && let Some(parts) = &problem.parts
            && !problem.is_curved
        {
            let [normal, friction] = parts;
            // of what pulls itself shut without friction already nothing is said
            if (0..points.len()).filter(closed).all(|k| normal[(k, k)] > 0.0) {
                onsets.one_point_known = true;
                let own = |k: usize| onset(normal[(k, k)], friction[(k, k)], k);
                onsets.one_point = first((0..points.len()).filter(closed).filter_map(own)).map(told);
            }
            if are_few(problem.free().len(), points.len(), SETS, SETS_WORK)
                && let Some(found) = any_set(problem, parts)
            {
                onsets.all_sets_known = true;
                onsets.any_set = first(found.into_iter()).map(told);
            }
        }
        if let Some(found) = inertia(assembly, points, &closed, &growing) {
            onsets.inertia_known = true;
            onsets.one_point_inertia = first(found.into_iter()).map(told);
        }
        onsets
    }
}

/// Where something begins as the friction of unit size grows to so many times itself.
struct PointOnset {
    size: f64,
    point: usize,
}

/// Where a + s b, positive without friction, comes to zero.
fn onset(resists: f64, pushes: f64, point: usize) -> Option<PointOnset> {
    let comes = resists > 0.0 && pushes < -ROUNDING * resists;
    comes.then(|| PointOnset { size: -resists / pushes, point })
}

fn first(onsets: impl Iterator<Item = PointOnset>) -> Option<PointOnset> {
    onsets.min_by(|a, b| a.size.total_cmp(&b.size))
}

/// With how much friction the equations of the sets of closed points are singular, and the point of each that moves most; `None` where that
/// is not known of one of them, or without friction there is not one state for all loads.
fn any_set(problem: &Complementarity, [normal, friction]: &[Mat<f64>; 2]) -> Option<Vec<PointOnset>> {
    let scale = |i: usize, j: usize| (normal[(i, i)] * normal[(j, j)]).sqrt();
    let scaled = Mat::from_fn(normal.nrows(), normal.nrows(), |i, j| normal[(i, j)] / scale(i, j));
    let is_positive = (0..normal.nrows()).all(|k| normal[(k, k)] > 0.0);
    if !is_positive || !is_definite(&scaled, PIVOTED) {
        return None;
    }
    let (free, bound) = (problem.free(), problem.bound());
    let mut found = Vec::new();
    for chosen in 0..1_usize << free.len() {
        let chosen = free.iter().enumerate().filter(|(k, _)| chosen >> k & 1 == 1).map(|(_, point)| *point);
        let set: Vec<usize> = bound.iter().copied().chain(chosen).collect();
        if set.is_empty() {
            continue;
        }
        let part = |of: &Mat<f64>| Mat::from_fn(set.len(), set.len(), |i, j| of[(set[i], set[j])]);
        match first_singular(&part(normal), &part(friction)) {
            Singular::At { size, row } => found.push(PointOnset { size, point: set[row] }),
            Singular::None => {}
            Singular::Unknown => return None,
        }
    }
    Some(found)
}

/// Where the closed rigid points would lock by their inertia, each by itself; `None` where masses are missing.
fn inertia(
    assembly: &Assembly,
    points: &[FramedPoint<'_>],
    closed: &dyn Fn(&usize) -> bool,
    growing: &GrowingFriction,
) -> Option<Vec<PointOnset>> {
    let factor = SymmetricFactor::new(&assembly.mass).ok()?;
    if factor.negative_eigenvalues() > 0 {
        return None;
    }
    let mut found = Vec::new();
    for k in (0..points.len()).filter(closed) {
        let FramedPoint { frame, law, .. } = &points[k];
        let friction = match law {
            InterfaceLaw::Rigid(friction) => friction,
            // its spring gives way first
            InterfaceLaw::Compliant(..) => continue,
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
        let coefficient = growing.coefficient(friction.at(frame.speed).coefficient);
        found.extend(onset(along, coefficient * across, k));
    }
    Some(found)
}
