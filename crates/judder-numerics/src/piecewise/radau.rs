//! One step of Radau's collocation method with three stages, for stiff legs: fifth order, damps what is infinitely fast.
//!
//! E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, 2nd ed., section IV.8: simplified Newton iterations
//! on the stages, and the error of an embedded formula of third order, filtered by the Jacobian.

use super::quartic::Quartic;
use crate::dense::Triangles;
use std::array::from_fn;

const ROOT_6: f64 = 2.449_489_742_783_178;

/// The abscissas.
pub(super) const PLACES: [f64; 3] = [(4.0 - ROOT_6) / 10.0, (4.0 + ROOT_6) / 10.0, 1.0];

/// The stages' weights; the last row is the step itself.
pub(super) const STAGES: [[f64; 3]; 3] = [
    [(88.0 - 7.0 * ROOT_6) / 360.0, (296.0 - 169.0 * ROOT_6) / 1800.0, (-2.0 + 3.0 * ROOT_6) / 225.0],
    [(296.0 + 169.0 * ROOT_6) / 1800.0, (88.0 + 7.0 * ROOT_6) / 360.0, (-2.0 - 3.0 * ROOT_6) / 225.0],
    [(16.0 - ROOT_6) / 36.0, (16.0 + ROOT_6) / 36.0, 1.0 / 9.0],
];

/// The real eigenvalue of the inverse of [`STAGES`], 3 + ∛9 − ∛3.
const REAL_EIGENVALUE: f64 = 3.637_834_252_744_496;

/// The embedded formula's weights of the stage increments.
const ERROR: [f64; 3] = [(-13.0 - 7.0 * ROOT_6) / 3.0, (-13.0 + 7.0 * ROOT_6) / 3.0, -1.0 / 3.0];

/// What a step gave.
pub(super) struct RadauStep<const N: usize> {
    pub(super) end: [f64; N],
    pub(super) error: [f64; N],
    /// Displacements of the three stages from the start.
    increments: [[f64; N]; 3],
}

/// One step of length `step` from `start`, where the field is `start_field`; `None` where the iteration fails.
///
/// `is_settled` says of a correction of the stages that it is small.
pub(super) fn step<const N: usize>(
    field: impl Fn(&[f64; N]) -> [f64; N],
    jacobian: &[[f64; N]; N],
    start: &[f64; N],
    start_field: &[f64; N],
    step: f64,
    is_settled: impl Fn(&[f64; N]) -> bool,
) -> Option<RadauStep<N>> {
    let iteration = Triangles::new(3 * N, stage_matrix(&[jacobian; 3], step))?;
    let increments = solve_stages(&field, &iteration, start, step, is_settled)?;
    let end = from_fn(|i| start[i] + increments[2][i]);
    let filter = Triangles::new(
        N,
        (0..N * N)
            .map(|k| if k / N == k % N { REAL_EIGENVALUE / step } else { 0.0 } - jacobian[k / N][k % N])
            .collect(),
    )?;
    let combined: [f64; N] = from_fn(|i| (0..3).fold(0.0, |sum, s| sum + ERROR[s] * increments[s][i]) / step);
    let estimate = |rate: &[f64; N]| {
        let mut error: [f64; N] = from_fn(|i| rate[i] + combined[i]);
        filter.solve(&mut error);
        error
    };
    // the second pass keeps the estimate from growing with the stiffness
    let first = estimate(start_field);
    let error = estimate(&field(&from_fn(|i| start[i] + first[i])));
    Some(RadauStep { end, error, increments })
}

/// I − h A ⊗ J with a Jacobian for each stage.
pub(super) fn stage_matrix<const N: usize>(jacobians: &[&[[f64; N]; N]; 3], step: f64) -> Vec<f64> {
    let size = 3 * N;
    let mut matrix = vec![0.0; size * size];
    for (row, entries) in matrix.chunks_exact_mut(size).enumerate() {
        for (column, entry) in entries.iter_mut().enumerate() {
            let (stage, of) = (row / N, column / N);
            *entry = -step * STAGES[stage][of] * jacobians[of][row % N][column % N];
            if row == column {
                *entry += 1.0;
            }
        }
    }
    matrix
}

fn solve_stages<const N: usize>(
    field: impl Fn(&[f64; N]) -> [f64; N],
    iteration: &Triangles,
    start: &[f64; N],
    step: f64,
    is_settled: impl Fn(&[f64; N]) -> bool,
) -> Option<[[f64; N]; 3]> {
    const LIMIT: usize = 12;
    let mut increments = [[0.0; N]; 3];
    let mut residual = vec![0.0; 3 * N];
    let mut size_before = f64::INFINITY;
    for _ in 0..LIMIT {
        let fields: [[f64; N]; 3] = from_fn(|s| field(&from_fn(|i| start[i] + increments[s][i])));
        for (k, r) in residual.iter_mut().enumerate() {
            let (stage, i) = (k / N, k % N);
            *r = step * (0..3).fold(0.0, |sum, s| sum + STAGES[stage][s] * fields[s][i])
                - increments[stage][i];
        }
        iteration.solve(&mut residual);
        let size = residual.iter().fold(0.0, |sum: f64, r| sum + r * r);
        if !size.is_finite() || size > 4.0 * size_before {
            return None;
        }
        size_before = size;
        for (k, r) in residual.iter().enumerate() {
            increments[k / N][k % N] += r;
        }
        if (0..3).all(|s| is_settled(&from_fn(|i| residual[s * N + i]))) {
            return Some(increments);
        }
    }
    None
}

impl<const N: usize> RadauStep<N> {
    /// The collocation polynomial, of third order.
    pub(super) fn dense(&self, start: &[f64; N]) -> [Quartic; N] {
        let [p, q, _] = PLACES;
        from_fn(|i| {
            // Newton's divided differences of increment/θ, a parabola
            let [a, b, c] = from_fn(|s| self.increments[s][i] / PLACES[s]);
            let slope = (b - a) / (q - p);
            let bend = ((c - b) / (1.0 - q) - slope) / (1.0 - p);
            [start[i], a - p * slope + p * q * bend, slope - (p + q) * bend, bend, 0.0]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::quartic::value;
    use super::*;

    fn precise(correction: &[f64; 2]) -> bool {
        correction.iter().all(|c| c.abs() < 1e-15)
    }

    fn turned(h: f64) -> RadauStep<2> {
        step(|u| [u[1], -u[0]], &[[0.0, 1.0], [-1.0, 0.0]], &[1.0, 0.0], &[0.0, -1.0], h, precise).unwrap()
    }

    #[test]
    fn the_error_of_a_step_falls_with_the_sixth_power() {
        let error = |h: f64| {
            let end = turned(h).end;
            (end[0] - h.cos()).hypot(end[1] + h.sin())
        };
        let order = (error(0.4) / error(0.2)).log2();
        assert!((order - 6.0).abs() < 0.4, "{order}");
    }

    #[test]
    fn the_dense_output_passes_through_the_end_and_near_the_motion() {
        let s = turned(0.1);
        let dense = s.dense(&[1.0, 0.0]);
        assert!((value(&dense[0], 1.0) - s.end[0]).abs() < 1e-15);
        assert!((value(&dense[0], 0.5) - 0.05_f64.cos()).abs() < 1e-6);
    }

    #[test]
    fn what_is_infinitely_fast_is_gone_after_a_step() {
        let rate = -1e9;
        let s = step(|u| [rate * u[0]], &[[rate]], &[1.0], &[rate], 1.0, |c: &[f64; 1]| c[0].abs() < 1e-12)
            .unwrap();
        assert!(s.end[0].abs() < 1e-8, "{}", s.end[0]);
    }
}
