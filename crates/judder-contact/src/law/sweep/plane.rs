//! The sweep over speed and depth.

use super::solving::Solving;
use super::{
    LawSample, LawSweep, SolvedLawPoint, SweepEnd, SweepLevel, SweepObserver, check_accuracy, excess,
    is_solver_noise,
};
use crate::law::error::LawError;
use crate::law::knots::Knots;
use crate::law::limits::LawLayer;
use crate::law::material::LawMaterial;
use crate::law::origin::LawOrigin;
use crate::law::quantities::PerQuantity;
use crate::law::scaled::{INDENTATION_AXIS, SPEED_AXIS, velocity};
use crate::law::table::TabulatedLaw;
use std::fmt::Display;

/// Knots of the first level: enough for a bell over six decades to be seen.
const FIRST_COLUMNS: usize = 9;
const FIRST_ROWS: usize = 3;

/// The part of the plane that a table covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepRange {
    /// ln z, z = v̂/√ŷ, from slow to fast.
    pub ln_speeds: (f64, f64),
    /// ln ŷ, from shallow to deep.
    pub ln_indentations: (f64, f64),
}

/// z between which a law is tabulated; beyond, its exact limits and their asymptotes hold.
///
/// Slow: what the tail does not know is of order z³ with the longest time. Fast: of order ln z/z times E∞/E0 with the shortest.
fn informative_speeds(material: &LawMaterial) -> (f64, f64) {
    const SLOW: f64 = 5e-2;
    const FAST: f64 = 1e2;
    let (shortest, longest) = material.time_span().unwrap_or((1.0, 1.0));
    (SLOW / longest, FAST * material.modulus_ratio / shortest)
}

/// ŷ below which an indenter is a paraboloid but for terms of order ŷ, which the table continues: ŷ² is 1e-4.
const SHALLOW: f64 = 1e-2;

impl SweepRange {
    /// What a table needs to know about v̂ and ŷ between two values each: z wherever the law is not its limit yet, ŷ wherever
    /// the indenter is not a paraboloid yet; beyond, the table continues as exactly.
    ///
    /// # Errors
    /// A material that is none; ranges that are not positive, finite and ascending.
    pub fn covering(
        velocities: (f64, f64),
        indentations: (f64, f64),
        material: &LawMaterial,
    ) -> Result<Self, LawError> {
        check_ranges(velocities, indentations)?;
        material.clone().checked()?;
        let (slow, fast) = informative_speeds(material);
        let lowest = (velocities.0 / indentations.1.sqrt()).clamp(slow, 0.1 * fast);
        let highest = (velocities.1 / indentations.0.sqrt()).clamp(10.0 * lowest, fast.max(10.0 * lowest));
        let shallowest = indentations.0.max(SHALLOW.min(0.1 * indentations.1));
        Ok(Self {
            ln_speeds: (libm::log(lowest), libm::log(highest)),
            ln_indentations: (libm::log(shallowest), libm::log(indentations.1)),
        })
    }

    /// What a cylinder's table needs to know about v̂ and ŷ between two values each: every depth, and z wherever the law is not its limit
    /// yet, wakes being short or long beside contact and layer.
    ///
    /// # Errors
    /// As [`covering`](Self::covering).
    pub fn covering_line(
        velocities: (f64, f64),
        indentations: (f64, f64),
        material: &LawMaterial,
        layer: LawLayer,
    ) -> Result<Self, LawError> {
        check_ranges(velocities, indentations)?;
        material.clone().checked()?;
        let (slow, fast) = informative_speeds(material);
        // √(R δ) in thicknesses: where the deepest contact is wider than the layer, where the shallowest is narrower
        let [shallow, deep] = [indentations.0, indentations.1].map(|depth| depth.sqrt() / layer.thickness);
        let (slow, fast) = (slow * (1.0 / deep).min(1.0), fast * (1.0 / shallow).max(1.0));
        let lowest = (velocities.0 / indentations.1.sqrt()).clamp(slow, 0.1 * fast);
        let highest = (velocities.1 / indentations.0.sqrt()).clamp(10.0 * lowest, fast.max(10.0 * lowest));
        Ok(Self {
            ln_speeds: (libm::log(lowest), libm::log(highest)),
            ln_indentations: (libm::log(indentations.0), libm::log(indentations.1)),
        })
    }

    /// All of ln z where a paraboloid's law is not its limit yet.
    #[must_use]
    pub fn all_speeds(material: &LawMaterial) -> (f64, f64) {
        let (slow, fast) = informative_speeds(material);
        (libm::log(slow), libm::log(fast))
    }
}

/// What a sweep over the plane is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRequest {
    /// Substrate, indenter, and the words for where the values come from.
    pub origin: LawOrigin,
    /// The part of the plane.
    pub range: SweepRange,
    /// The largest relative interpolation error of each quantity.
    pub accuracy: PerQuantity<f64>,
    /// The most points that may be solved.
    pub most_points: usize,
}

/// Solves the contact over speed and depth until the table through the solutions is as accurate as asked.
///
/// `sampler` solves the contact at v̂, ŷ. `known` are points that an
/// earlier, interrupted sweep handed to its observer: they are not solved again. With the same sampler the result is the same
/// to the last bit for any number of threads, resumed or not.
///
/// # Errors
/// A request that makes no sense; [`LawError::Interrupted`]; [`LawError::FailedPoints`] with all points of a level that
/// could not be solved.
pub fn sweep<S, E>(
    request: &SweepRequest,
    known: &[SolvedLawPoint],
    sampler: &S,
    observer: &dyn SweepObserver,
) -> Result<LawSweep<TabulatedLaw>, LawError>
where
    S: Fn(f64, f64) -> Result<LawSample, E> + Sync,
    E: Display,
{
    check_accuracy(request.accuracy)?;
    request.origin.material.clone().checked()?;
    let SweepRange { ln_speeds, ln_indentations } = request.range;
    let mut speeds = Knots::new(SPEED_AXIS, ln_speeds.0, ln_speeds.1, FIRST_COLUMNS)?;
    let mut depths = Knots::new(INDENTATION_AXIS, ln_indentations.0, ln_indentations.1, FIRST_ROWS)?;
    request.origin.indenter.elastic(libm::exp(depths.last()))?;
    let mut solving = Solving::new(sampler, observer, known);
    let mut levels: Vec<SweepLevel> = Vec::new();
    let mut before = [PerQuantity::uniform(f64::INFINITY); 2];
    loop {
        let points = points(&speeds, &depths);
        solving.solve(&points)?;
        let (values, solver) = solving.values(request.origin.indenter);
        let law = TabulatedLaw::new(request.origin.clone(), speeds, depths, values, solver)?;
        let errors = law.errors_by_axis();
        let [along_speed, along_indentation] = errors;
        levels.push(SweepLevel {
            columns: speeds.count(),
            rows: depths.count(),
            along_speed,
            along_indentation,
        });
        let axis =
            usize::from(excess(along_indentation, request.accuracy) > excess(along_speed, request.accuracy));
        let finer = if axis == 0 { (speeds.refined(), depths) } else { (speeds, depths.refined()) };
        let end = if excess(errors[axis], request.accuracy) <= 1.0 {
            Some(SweepEnd::Accurate)
        } else if is_solver_noise(before[axis], errors[axis], solver, request.accuracy) {
            Some(SweepEnd::SolverError)
        } else if finer.0.count() * finer.1.count() > request.most_points {
            Some(SweepEnd::MostPoints)
        } else {
            None
        };
        if let Some(end) = end {
            return Ok(LawSweep { law, end, levels, points: solving.into_points() });
        }
        before[axis] = errors[axis];
        (speeds, depths) = finer;
    }
}

fn check_ranges(velocities: (f64, f64), indentations: (f64, f64)) -> Result<(), LawError> {
    for (axis, (first, last)) in [("v τ/R", velocities), ("δ/R", indentations)] {
        if !(first > 0.0 && first < last && last.is_finite()) {
            return Err(LawError::NotAscending { axis, first, last });
        }
    }
    Ok(())
}

/// v̂, ŷ of every knot, speed fastest.
fn points(speeds: &Knots, depths: &Knots) -> Vec<(f64, f64)> {
    depths
        .iter()
        .flat_map(|ln_indentation| {
            speeds.iter().map(move |ln_speed| (velocity(ln_speed, ln_indentation), libm::exp(ln_indentation)))
        })
        .collect()
}
