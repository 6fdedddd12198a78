//! A semismooth Newton method for the contact of many points.
//!
//! The roots of the projections of Alart and Curnier (*A mixed formulation for frictional contact problems prone to Newton like solution
//! methods*, Comput. Methods Appl. Mech. Engrg. 92, 1991), P_N − max(0, P_N − ρ (U_N + s P_N + u)) and P_T minus P_T − ρ U_T projected on the disc
//! of radius μ P_N, with steps that are halved until their size falls.

use crate::contact_problem::{ContactProblem, ContactSolution, NormalCondition, Progress};
use crate::gauss_seidel::name_motions;
use faer::Mat;
use judder_dense::general::solve;

/// Steps at most: a start that is near takes three to six.
const STEPS: usize = 30;
/// Halvings of a step.
const HALVINGS: usize = 12;

/// The projections at a place, their slopes by impulse and by velocity row by row.
struct Linearised {
    value: Vec<f64>,
    /// ∂/∂P of each component within its point, a row of three.
    by_impulse: Vec<[f64; 3]>,
    /// ∂/∂U of the same.
    by_velocity: Vec<[f64; 3]>,
}

/// Improves a solution; where no step helps it is left as it was best.
pub fn newton(problem: &ContactProblem<'_>, tolerance: f64, solution: &mut ContactSolution) -> Progress {
    let (size, dimension) = (problem.delassus.size(), problem.delassus.dimension());
    problem.delassus.velocities(problem.free, &solution.impulse, &mut solution.velocity);
    let mut progress = problem.residual(solution);
    let mut linearised = linearise(problem, solution);
    let mut trial = solution.clone();
    for step in 1..=STEPS {
        if progress.residual <= tolerance {
            break;
        }
        let mut matrix = Mat::zeros(size, size);
        for column in 0..size {
            let of_velocity = problem.delassus.column(column);
            for row in 0..size {
                let first = row - row % dimension;
                let slopes = &linearised.by_velocity[row];
                let sum: f64 = (0..dimension).map(|k| slopes[k] * of_velocity[first + k]).sum();
                let own = if column >= first && column < first + dimension {
                    linearised.by_impulse[row][column - first]
                } else {
                    0.0
                };
                matrix[(row, column)] = own + sum;
            }
        }
        let mut change = Mat::from_fn(size, 1, |row, _| -linearised.value[row]);
        if solve(matrix, &mut change).is_none() {
            break;
        }
        let before = norm(&linearised.value);
        let mut share = 1.0;
        let found = (0..HALVINGS).find_map(|_| {
            for (k, impulse) in trial.impulse.iter_mut().enumerate() {
                *impulse = solution.impulse[k] + share * change[(k, 0)];
            }
            problem.delassus.velocities(problem.free, &trial.impulse, &mut trial.velocity);
            let there = linearise(problem, &trial);
            share *= 0.5;
            (norm(&there.value) < before).then_some(there)
        });
        let Some(found) = found else { break };
        linearised = found;
        solution.impulse.copy_from_slice(&trial.impulse);
        solution.velocity.copy_from_slice(&trial.velocity);
        progress = Progress { iterations: step, ..problem.residual(solution) };
    }
    name_motions(problem, solution);
    progress
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

fn linearise(problem: &ContactProblem<'_>, solution: &ContactSolution) -> Linearised {
    let (size, dimension) = (problem.delassus.size(), problem.delassus.dimension());
    let mut found = Linearised {
        value: vec![0.0; size],
        by_impulse: vec![[0.0; 3]; size],
        by_velocity: vec![[0.0; 3]; size],
    };
    for point in 0..problem.delassus.points() {
        let [value, by_impulse, by_velocity] = &mut projections(problem, point, solution);
        for k in 0..dimension {
            let row = point * dimension + k;
            found.value[row] = value[k][0];
            found.by_impulse[row] = by_impulse[k];
            found.by_velocity[row] = by_velocity[k];
        }
    }
    found
}

/// The projections of a point, in the first place of each row, and their slopes by impulse and velocity.
fn projections(problem: &ContactProblem<'_>, point: usize, solution: &ContactSolution) -> [[[f64; 3]; 3]; 3] {
    let p = problem.of_point(&solution.impulse, point);
    let u = problem.of_point(&solution.velocity, point);
    let block = problem.delassus.block(point);
    let (mut value, mut by_p, mut by_u) = ([[0.0; 3]; 3], [[0.0; 3]; 3], [[0.0; 3]; 3]);
    let open = |value: &mut f64, slope: &mut f64, impulse: f64| (*value, *slope) = (impulse, 1.0);
    match problem.normal[point] {
        NormalCondition::Open => open(&mut value[0][0], &mut by_p[0][0], p[0]),
        NormalCondition::Given { impulse } => open(&mut value[0][0], &mut by_p[0][0], p[0] - impulse),
        NormalCondition::Bilateral { velocity, softness } => {
            let scale = 1.0 / (block.normal() + softness);
            value[0][0] = scale * (u[0] + softness * p[0] + velocity);
            (by_p[0][0], by_u[0][0]) = (scale * softness, scale);
        }
        NormalCondition::Unilateral { velocity, softness } => {
            let scale = 1.0 / (block.normal() + softness);
            let gap = u[0] + softness * p[0] + velocity;
            if p[0] - scale * gap > 0.0 {
                (value[0][0], by_p[0][0], by_u[0][0]) = (scale * gap, scale * softness, scale);
            } else {
                open(&mut value[0][0], &mut by_p[0][0], p[0]);
            }
        }
    }
    let scale = 1.0 / block.tangential();
    let tried = [1, 2].map(|k| p[k] - scale * u[k]);
    let size = tried[0].hypot(tried[1]);
    let [at_rest, now] = problem.coefficients(point, u);
    let coefficient = if size <= at_rest * p[0] { at_rest } else { now };
    let bound = coefficient * p[0].max(0.0);
    for k in 1..3 {
        if size <= bound {
            (value[k][0], by_u[k][k]) = (scale * u[k], scale);
            continue;
        }
        let direction = [tried[0] / size, tried[1] / size];
        value[k][0] = p[k] - bound * direction[k - 1];
        by_p[k][k] = 1.0;
        if p[0] > 0.0 {
            by_p[k][0] = -coefficient * direction[k - 1];
        }
        for j in 1..3 {
            let along = if j == k { 1.0 } else { 0.0 } - direction[k - 1] * direction[j - 1];
            by_p[k][j] -= bound / size * along;
            by_u[k][j] = bound / size * along * scale;
        }
    }
    [value, by_p, by_u]
}
