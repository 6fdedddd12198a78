//! Nonlinear Gauss–Seidel: point after point solved exactly by itself, sweep after sweep.
//!
//! M. Jean, *The non-smooth contact dynamics method*, Comput. Methods Appl. Mech. Engrg. 177 (1999). Started from the impulses of the
//! step before, it takes a few sweeps where the motion is smooth.

use crate::contact_problem::{ContactProgress, ContactSolution, ImpulseProblem, PointMotion};
use crate::newton::{newton, same_as_before};

/// Sweeps before Newton's method is tried, at least.
const LEAST_SWEEPS: usize = 2;
/// Sweeps after which velocities are summed anew.
const REFRESH: usize = 64;
/// A last change of impulses beside which the residual is worth its sum, over the tolerance.
const NEAR: f64 = 1e3;

/// How far the contact is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactAccuracy {
    /// The residual that is enough, as a share of the scale.
    pub tolerance: f64,
    /// The most sweeps.
    pub sweeps: usize,
}

impl Default for ContactAccuracy {
    fn default() -> Self {
        Self { tolerance: 1e-11, sweeps: 20_000 }
    }
}

/// Solves the contact of a step from the impulses in `solution`, and tells how well.
///
/// Where every point does what it did, one step of Newton's method with the elimination of the step before ends it. Where so many sweeps were in
/// vain as a step of Newton's method costs, some of these are tried before the sweeps go on.
pub fn solve(
    problem: &ImpulseProblem<'_>,
    accuracy: ContactAccuracy,
    solution: &mut ContactSolution,
) -> ContactProgress {
    problem.delassus.velocities(problem.free, &solution.impulse, &mut solution.velocity);
    if let Some(found) = same_as_before(problem, accuracy.tolerance, solution) {
        return found;
    }
    let mut progress = ContactProgress { residual: f64::INFINITY, ..ContactProgress::default() };
    let mut patience = 0;
    let mut spent = 0;
    for sweep in 1..=accuracy.sweeps {
        let change = self::sweep(problem, solution);
        // sums of many small changes
        if sweep % REFRESH == 0 {
            problem.delassus.velocities(problem.free, &solution.impulse, &mut solution.velocity);
        }
        // the residual is not far below what a sweep still changes
        if change <= NEAR * accuracy.tolerance * problem.scale || sweep == accuracy.sweeps {
            progress = ContactProgress { iterations: sweep + spent, ..problem.residual(solution) };
            // what is not a number does not become one
            if progress.residual <= accuracy.tolerance || progress.residual.is_nan() {
                return progress;
            }
        }
        if patience == 0 {
            patience = patience_for(problem, solution);
        }
        if sweep >= patience {
            patience += 2 * sweep;
            let found = newton(problem, accuracy.tolerance, solution);
            spent += found.iterations;
            if found.residual <= accuracy.tolerance {
                return ContactProgress { iterations: sweep + spent, ..found };
            }
        }
    }
    progress
}

/// Sweeps that cost about as much as an elimination of all that is not open.
fn patience_for(problem: &ImpulseProblem<'_>, solution: &ContactSolution) -> usize {
    let closed = solution.motion.iter().filter(|motion| **motion != PointMotion::Open).count();
    let unknowns = closed * problem.delassus.dimension();
    LEAST_SWEEPS + 2 * unknowns * unknowns / (5 * problem.delassus.size() + 300)
}

/// One sweep over all points; the largest change of an impulse.
fn sweep(problem: &ImpulseProblem<'_>, solution: &mut ContactSolution) -> f64 {
    let dimension = problem.delassus.dimension();
    let mut largest = 0.0_f64;
    for point in 0..problem.delassus.points() {
        let (block, first) = (problem.delassus.block(point), point * dimension);
        let impulse = problem.of_point(&solution.impulse, point);
        let velocity = problem.of_point(&solution.velocity, point);
        let free = block.without(velocity, impulse);
        let friction = problem.friction_at(point, velocity);
        let (found, motion) = block.solve(free, problem.normal[point], friction);
        solution.motion[point] = motion;
        let change = [0, 1, 2].map(|k| found[k] - impulse[k]);
        let size = change.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
        if size != 0.0 {
            largest = largest.max(size);
            solution.impulse[first..first + dimension].copy_from_slice(&found[..dimension]);
            problem.delassus.add_point(first, &change[..dimension], &mut solution.velocity);
        }
    }
    largest
}

/// What each point of a solution that Newton's method found does.
pub(crate) fn name_motions(problem: &ImpulseProblem<'_>, solution: &mut ContactSolution) {
    for point in 0..problem.delassus.points() {
        let block = problem.delassus.block(point);
        let impulse = problem.of_point(&solution.impulse, point);
        let velocity = problem.of_point(&solution.velocity, point);
        let free = block.without(velocity, impulse);
        let friction = problem.friction_at(point, velocity);
        solution.motion[point] = match block.solve(free, problem.normal[point], friction) {
            (_, PointMotion::Open) => PointMotion::Open,
            (_, motion) => motion,
        };
    }
}
