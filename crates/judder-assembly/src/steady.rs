//! Steady sliding: forces and gaps of all contact points under loads that rest.
//!
//! A primal–dual active set: given which rigid points are closed, and the slopes of compliant ones where they are, the equations on the
//! points are linear; their solution says which are closed. Where the sets go round in circles, one point changes at a time, the
//! first of those that should: with as many steps as it takes this ends for every problem that has one solution whatever the loads
//! (K. G. Murty, *Note on a Bard-type scheme for solving the complementarity problem*, Opsearch 11, 1974).

mod active_set;
mod friction_limit;
mod lost;

use crate::AssemblyError;
use crate::assembly::{Assembly, triplets};
use crate::compliance::Compliance;
use crate::error::check_length;
use crate::interface::FramedPoint;
use active_set::{FoundContacts, Solver};
use faer::sparse::Triplet;
use friction_limit::friction_limit;
pub(crate) use friction_limit::{GrowingFriction, Singular, first_singular};
use lost::followed;

pub use friction_limit::{FrictionAmount, FrictionLimit};

/// An assembly in steady sliding.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadySliding {
    /// q in m.
    pub displacement: Vec<f64>,
    /// The contact points of all interfaces in their order.
    pub points: Vec<PointState>,
    /// Linear systems that were solved.
    pub iterations: usize,
    /// ‖K q − f − Σ (N cᵀ + T tᵀ)‖/(‖f‖ + ‖Σ (N cᵀ + T tᵀ)‖ + ‖K q‖) without what the rounding of K q explains: the balance of forces on
    /// all freedoms, which the search, on the points alone, does not see.
    pub residual: f64,
    /// Where friction makes the equations of the closed points singular.
    pub friction_limit: FrictionLimit,
}

/// A contact point in steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointState {
    /// Its interface, by its place in the assembly.
    pub interface: usize,
    /// g in m; of a compliant point that is closed negative.
    pub gap: f64,
    /// N in N.
    pub normal_force: f64,
    /// T in N, along the slip on the slider.
    pub friction_force: f64,
    /// Whether it carries a force.
    pub is_closed: bool,
}

impl SteadySliding {
    /// Bodies that touch nowhere, at rest where they are: what small motions need where there are no contact points.
    #[must_use]
    pub fn untouched(freedoms: usize) -> Self {
        Self {
            displacement: vec![0.0; freedoms],
            points: Vec::new(),
            iterations: 0,
            residual: 0.0,
            friction_limit: FrictionLimit::None,
        }
    }

    /// The bodies of an assembly as they are meshed, at rest, with contact points that carry nothing: what no load moves.
    #[must_use]
    pub fn as_meshed(assembly: &Assembly) -> Self {
        let points = assembly.interfaces.iter().enumerate().flat_map(|(interface, own)| {
            own.points.iter().map(move |point| PointState {
                interface,
                gap: point.gap,
                normal_force: 0.0,
                friction_force: 0.0,
                is_closed: false,
            })
        });
        Self { points: points.collect(), ..Self::untouched(assembly.size()) }
    }
}

/// Forces and gaps of steady sliding, on the compliance of the assembly's points.
///
/// Where the search does not find it, it is followed as friction grows from nothing.
///
/// # Errors
/// [`AssemblyError::NoSteadySliding`] where that ends before friction is as large as it is; of contact without friction already
/// [`AssemblyError::NothingCloses`], [`AssemblyError::Undetermined`], [`AssemblyError::NoConvergence`]; [`AssemblyError::AtRest`] of friction
/// on a track at rest; [`AssemblyError::Length`] for a compliance of another assembly.
pub fn steady_sliding(assembly: &Assembly, compliance: &Compliance) -> Result<SteadySliding, AssemblyError> {
    assembly.check_sliding()?;
    let points = assembly.framed()?;
    check_length("the points of a compliance", compliance.of_load.len(), points.len())?;
    let solver = Solver { assembly, compliance, points: &points, friction: 1.0 };
    let FoundContacts { guess, carried, iterations } = match solver.solved() {
        Err(AssemblyError::Structure(error)) => return Err(error.into()),
        Err(_) => followed(&solver)?,
        Ok(found) => found,
    };
    let is_closed: Vec<bool> = (0..points.len()).map(|k| solver.is_closed(k, &guess)).collect();
    if !is_closed.contains(&true) {
        return Err(solver.nothing_closes(&guess.opening, true));
    }
    let (normal, friction): (Vec<f64>, Vec<f64>) =
        carried.iter().map(|point| (point.normal, point.friction)).unzip();
    let displacement = compliance.displacement(&assembly.load, &points, &normal, &friction, &guess.opening);
    let residual = imbalance(assembly, &points, &displacement, &normal, &friction);
    let state = |k: usize| PointState {
        interface: points[k].interface,
        gap: points[k].point.gap + guess.opening[k],
        normal_force: normal[k],
        friction_force: friction[k],
        is_closed: is_closed[k],
    };
    let friction_limit = friction_limit(&solver, &guess);
    let points = (0..points.len()).map(state).collect();
    Ok(SteadySliding { points, displacement, iterations, residual, friction_limit })
}

/// On which smooth piece of its law each point is, an open one on zero: where all are on the same at two values of a parameter, small motions change smoothly from one to the other.
///
/// # Errors
/// What [`Assembly::framed`] says.
pub fn pieces(assembly: &Assembly, steady: &SteadySliding) -> Result<Vec<usize>, AssemblyError> {
    let points = assembly.framed()?;
    let piece = |(point, state): (&FramedPoint<'_>, &PointState)| match state.is_closed {
        true => 1 + point.law.piece(-state.gap, point.frame.speed),
        false => 0,
    };
    Ok(points.iter().zip(&steady.points).map(piece).collect())
}

/// Digits of |K| |q| that are rounding: of a slender body, which bends easily, they are forces as large as its loads' last digits.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// ‖K q − f − Σ (N cᵀ + T tᵀ)‖ over what it is made of.
fn imbalance(
    assembly: &Assembly,
    points: &[FramedPoint<'_>],
    q: &[f64],
    normal: &[f64],
    friction: &[f64],
) -> f64 {
    let inner = judder_structure::statics::product(&assembly.stiffness, q);
    let mut contact = vec![0.0; q.len()];
    for (k, point) in points.iter().enumerate() {
        point.frame.normal.add_to(normal[k], &mut contact);
        point.frame.slip.add_to(friction[k], &mut contact);
    }
    let norm = |values: &mut dyn Iterator<Item = f64>| values.map(|x| x * x).sum::<f64>().sqrt();
    let mut sizes = vec![0.0; q.len()];
    for Triplet { row, col, val } in triplets(&assembly.stiffness) {
        sizes[row] += (val * q[col]).abs();
    }
    let off = (0..q.len()).map(|k| {
        let off = (inner[k] - assembly.load[k] - contact[k]).abs();
        (off - ROUNDING * sizes[k]).max(0.0)
    });
    let size = norm(&mut inner.iter().copied())
        + norm(&mut assembly.load.iter().copied())
        + norm(&mut contact.iter().copied());
    let off = norm(&mut off.into_iter());
    if off == 0.0 { 0.0 } else { off / size }
}
