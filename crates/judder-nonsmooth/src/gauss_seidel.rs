//! Nonlinear Gauss–Seidel: point after point solved exactly by itself, sweep after sweep.
//!
//! M. Jean, *The non-smooth contact dynamics method*, Comput. Methods Appl. Mech. Engrg. 177 (1999). Started from the impulses of the
//! step before, it takes a few sweeps where the motion is smooth.

use crate::contact_problem::{ContactProblem, ContactSolution, PointMotion, Progress, add};
use crate::newton::newton;

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
/// Where so many sweeps were in vain as a step of Newton's method costs, a few of these are tried before the sweeps go on.
pub fn solve(
    problem: &ContactProblem<'_>,
    accuracy: ContactAccuracy,
    solution: &mut ContactSolution,
) -> Progress {
    let patience = problem.delassus.size() / 3 + 20;
    problem.delassus.velocities(problem.free, &solution.impulse, &mut solution.velocity);
    let mut progress = Progress { residual: f64::INFINITY, ..Progress::default() };
    let mut tried = false;
    for sweep in 1..=accuracy.sweeps {
        self::sweep(problem, solution);
        // sums of many small changes
        if sweep % 64 == 0 {
            problem.delassus.velocities(problem.free, &solution.impulse, &mut solution.velocity);
        }
        progress = Progress { iterations: sweep, ..problem.residual(solution) };
        if progress.residual <= accuracy.tolerance {
            return progress;
        }
        if sweep >= patience && !tried {
            tried = true;
            let found = newton(problem, accuracy.tolerance, solution);
            if found.residual <= accuracy.tolerance {
                return Progress { iterations: sweep + found.iterations, ..found };
            }
        }
    }
    progress
}

/// One sweep over all points.
fn sweep(problem: &ContactProblem<'_>, solution: &mut ContactSolution) {
    let dimension = problem.delassus.dimension();
    for point in 0..problem.delassus.points() {
        let (block, first) = (problem.delassus.block(point), point * dimension);
        let impulse = problem.of_point(&solution.impulse, point);
        let velocity = problem.of_point(&solution.velocity, point);
        let free = block.without(velocity, impulse);
        let friction = problem.coefficients(point, velocity);
        let (found, motion) = block.solve(free, problem.normal[point], friction);
        solution.motion[point] = motion;
        for k in 0..dimension {
            let change = found[k] - impulse[k];
            if change != 0.0 {
                solution.impulse[first + k] = found[k];
                add(&mut solution.velocity, change, problem.delassus.column(first + k));
            }
        }
    }
}

/// What each point of a solution that Newton's method found does.
pub(crate) fn name_motions(problem: &ContactProblem<'_>, solution: &mut ContactSolution) {
    for point in 0..problem.delassus.points() {
        let block = problem.delassus.block(point);
        let impulse = problem.of_point(&solution.impulse, point);
        let velocity = problem.of_point(&solution.velocity, point);
        let free = block.without(velocity, impulse);
        let friction = problem.coefficients(point, velocity);
        solution.motion[point] = match block.solve(free, problem.normal[point], friction) {
            (_, PointMotion::Open) => PointMotion::Open,
            (_, motion) => motion,
        };
    }
}
