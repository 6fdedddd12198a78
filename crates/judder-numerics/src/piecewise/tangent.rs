//! How a small disturbance travels along a motion.

use super::leg::{GuardCrossing, Leg, StepMethod};
use super::{PiecewiseSmooth, dormand_prince, radau, rate};
use crate::dense::{Triangles, product};
use std::array::from_fn;

const ROOT_15: f64 = 3.872_983_346_207_417;
/// Gauss's collocation with three stages (Hairer, Wanner, *Solving …* II, table IV.5.2).
const GAUSS_PLACES: [f64; 3] = [0.5 - ROOT_15 / 10.0, 0.5, 0.5 + ROOT_15 / 10.0];
const GAUSS_WEIGHTS: [f64; 3] = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
const GAUSS_STAGES: [[f64; 3]; 3] = [
    [5.0 / 36.0, 2.0 / 9.0 - ROOT_15 / 15.0, 5.0 / 36.0 - ROOT_15 / 30.0],
    [5.0 / 36.0 + ROOT_15 / 24.0, 2.0 / 9.0, 5.0 / 36.0 - ROOT_15 / 24.0],
    [5.0 / 36.0 + ROOT_15 / 30.0, 2.0 / 9.0 + ROOT_15 / 15.0, 5.0 / 36.0],
];

/// A square matrix, row by row.
pub type SquareMatrix<const N: usize> = [[f64; N]; N];

/// The unit matrix.
#[must_use]
pub fn identity<const N: usize>() -> SquareMatrix<N> {
    from_fn(|i| from_fn(|j| if i == j { 1.0 } else { 0.0 }))
}

/// The derivative of a leg's end by its start, applied to `disturbance`.
///
/// Inside a mode the step's own formula is differentiated, so that the result agrees with differences of the computed
/// motion. A leg at the edge of its mode, where a Jacobian may be singular like an inverse root, has a quadrature that
/// takes this out. NaN where the equations of an implicit step are singular.
#[must_use]
pub fn along_leg<S: PiecewiseSmooth<N>, const N: usize>(
    system: &S,
    leg: &Leg<S::Mode, N>,
    disturbance: &SquareMatrix<N>,
) -> SquareMatrix<N> {
    if leg.is_at_edge {
        return along_edge(system, leg, disturbance).unwrap_or([[f64::NAN; N]; N]);
    }
    match leg.method {
        StepMethod::Explicit => along_explicit(system, leg, disturbance),
        StepMethod::Implicit => along_implicit(system, leg, disturbance).unwrap_or([[f64::NAN; N]; N]),
    }
}

fn along_explicit<S: PiecewiseSmooth<N>, const N: usize>(
    system: &S,
    leg: &Leg<S::Mode, N>,
    disturbance: &SquareMatrix<N>,
) -> SquareMatrix<N> {
    let start = leg.start();
    let mut fields = [[0.0; N]; 6];
    let mut slopes = [[[0.0; N]; N]; 6];
    let (mut place, mut carried) = (start, *disturbance);
    for (k, weights) in dormand_prince::STAGES.iter().enumerate() {
        fields[k] = system.field(leg.mode, &place);
        slopes[k] = product(&system.jacobian(leg.mode, &place), &carried);
        place = from_fn(|i| start[i] + leg.step * (0..=k).fold(0.0, |s, j| s + weights[j] * fields[j][i]));
        carried = from_fn(|i| {
            from_fn(|c| {
                disturbance[i][c] + leg.step * (0..=k).fold(0.0, |s, j| s + weights[j] * slopes[j][i][c])
            })
        });
    }
    carried
}

/// Φ′ = J Φ along the dense output, by Gauss's collocation with three stages in a variable s with θ = s²(3 − 2s): it
/// moves from both ends with zero speed, so an inverse root at either is smooth in it and no end is looked at.
fn along_edge<S: PiecewiseSmooth<N>, const N: usize>(
    system: &S,
    leg: &Leg<S::Mode, N>,
    disturbance: &SquareMatrix<N>,
) -> Option<SquareMatrix<N>> {
    let jacobians = GAUSS_PLACES.map(|s| {
        let speed = leg.step * 6.0 * s * (1.0 - s);
        system.jacobian(leg.mode, &leg.at(s * s * (3.0 - 2.0 * s))).map(|row| row.map(|entry| speed * entry))
    });
    let size = 3 * N;
    let mut matrix = vec![0.0; size * size];
    for (k, entry) in matrix.iter_mut().enumerate() {
        let (row, column) = (k / size, k % size);
        let (stage, of) = (row / N, column / N);
        *entry = f64::from(u8::from(row == column))
            - jacobians[stage][row % N][column % N] * GAUSS_STAGES[stage][of];
    }
    let triangles = Triangles::new(size, matrix)?;
    let mut carried = *disturbance;
    for column in 0..N {
        let at_start: [f64; N] = from_fn(|i| disturbance[i][column]);
        let mut slopes: Vec<f64> = (0..size).map(|k| rate(&jacobians[k / N][k % N], &at_start)).collect();
        triangles.solve(&mut slopes);
        for (i, row) in carried.iter_mut().enumerate() {
            row[column] += (0..3).fold(0.0, |sum, s| sum + GAUSS_WEIGHTS[s] * slopes[s * N + i]);
        }
    }
    Some(carried)
}

fn along_implicit<S: PiecewiseSmooth<N>, const N: usize>(
    system: &S,
    leg: &Leg<S::Mode, N>,
    disturbance: &SquareMatrix<N>,
) -> Option<SquareMatrix<N>> {
    let jacobians: [SquareMatrix<N>; 3] =
        radau::PLACES.map(|place| system.jacobian(leg.mode, &leg.at(place)));
    let [first, second, third] = &jacobians;
    let triangles = Triangles::new(3 * N, radau::stage_matrix(&[first, second, third], leg.step))?;
    let mut carried = *disturbance;
    for column in 0..N {
        let at_start: [f64; N] = from_fn(|i| disturbance[i][column]);
        let slopes: [[f64; N]; 3] = from_fn(|s| from_fn(|i| rate(&jacobians[s][i], &at_start)));
        let mut right: Vec<f64> = (0..3 * N)
            .map(|k| leg.step * (0..3).fold(0.0, |sum, s| sum + radau::STAGES[k / N][s] * slopes[s][k % N]))
            .collect();
        triangles.solve(&mut right);
        for (i, row) in carried.iter_mut().enumerate() {
            row[column] += right[2 * N + i];
        }
    }
    Some(carried)
}

/// The saltation matrix of a change of mode, I + (f₊ − f₋) ∇gᵀ/(∇g·f₋): what the disturbed motion, which meets the guard a
/// little earlier or later, has gained behind it (R. I. Leine, H. Nijmeijer, *Dynamics and Bifurcations of Non-Smooth
/// Mechanical Systems*, 2004, section 7). Not finite where the motion grazes the guard.
#[must_use]
pub fn saltation<S: PiecewiseSmooth<N>, const N: usize>(
    system: &S,
    crossing: &GuardCrossing<S::Mode, N>,
) -> SquareMatrix<N> {
    let before = system.field(crossing.from, &crossing.state);
    let after = system.field(crossing.to, &crossing.state);
    if before == after {
        return identity();
    }
    let gradient = system.guard_gradient(crossing.from, crossing.guard, &crossing.state);
    let fall = rate(&gradient, &before);
    from_fn(|i| from_fn(|j| f64::from(u8::from(i == j)) + (after[i] - before[i]) * gradient[j] / fall))
}

/// A disturbance seen where the disturbed motion meets a plane: the part along the field f is taken out.
#[must_use]
pub fn onto_plane<const N: usize>(
    normal: &[f64; N],
    field: &[f64; N],
    disturbance: &SquareMatrix<N>,
) -> SquareMatrix<N> {
    let fall = rate(normal, field);
    from_fn(|i| {
        from_fn(|j| {
            let reached = (0..N).fold(0.0, |sum, k| sum + normal[k] * disturbance[k][j]);
            disturbance[i][j] - field[i] * reached / fall
        })
    })
}
