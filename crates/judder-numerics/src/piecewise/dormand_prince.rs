//! One step of the explicit pair of Dormand and Prince, of fifth order, with an error of fourth order.
//!
//! J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19; dense output: E. Hairer, S. P. Nørsett, G. Wanner,
//! *Solving Ordinary Differential Equations I*, 2nd ed., section II.6.

use super::quartic::Quartic;
use std::array::from_fn;

/// The stages' weights, a row a stage; the last row is the step itself.
pub(super) const STAGES: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Fifth minus fourth order.
const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// The fourth-order part of the dense output.
const DENSE: [f64; 7] = [
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

/// What a step gave.
pub(super) struct DormandPrinceStep<const N: usize> {
    pub(super) end: [f64; N],
    /// The field at the end, which is the next step's first stage.
    pub(super) end_field: [f64; N],
    /// The estimated local error.
    pub(super) error: [f64; N],
    /// The largest rate of the field as the last two stages saw it, 1/time.
    pub(super) rate: f64,
    stages: [[f64; N]; 7],
}

/// One step of length `step` from `start`, where the field is `start_field`.
pub(super) fn step<const N: usize>(
    field: impl Fn(&[f64; N]) -> [f64; N],
    start: &[f64; N],
    start_field: &[f64; N],
    step: f64,
) -> DormandPrinceStep<N> {
    let mut stages = [[0.0; N]; 7];
    stages[0] = *start_field;
    let mut place = *start;
    let mut before = *start;
    for (k, weights) in STAGES.iter().enumerate() {
        before = place;
        place = from_fn(|i| start[i] + step * (0..=k).fold(0.0, |sum, j| sum + weights[j] * stages[j][i]));
        stages[k + 1] = field(&place);
    }
    let error = from_fn(|i| step * (0..7).fold(0.0, |sum, j| sum + ERROR[j] * stages[j][i]));
    let square = |a: &[f64; N], b: &[f64; N]| a.iter().zip(b).fold(0.0, |s, (a, b)| s + (a - b) * (a - b));
    let moved = square(&place, &before);
    let rate = if moved > 0.0 { (square(&stages[6], &stages[5]) / moved).sqrt() } else { 0.0 };
    DormandPrinceStep { end: place, end_field: stages[6], error, rate, stages }
}

impl<const N: usize> DormandPrinceStep<N> {
    /// The solution along the step, of fourth order.
    pub(super) fn dense(&self, start: &[f64; N], step: f64) -> [Quartic; N] {
        from_fn(|i| {
            let rise = self.end[i] - start[i];
            let first = step * self.stages[0][i];
            let bend = first - rise;
            let twist = rise - step * self.stages[6][i] - bend;
            let fourth = step * (0..7).fold(0.0, |sum, j| sum + DENSE[j] * self.stages[j][i]);
            [start[i], first, twist + fourth - bend, -twist - 2.0 * fourth, fourth]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::quartic::value;
    use super::*;

    fn turn(u: &[f64; 2]) -> [f64; 2] {
        [u[1], -u[0]]
    }

    #[test]
    fn the_error_of_a_step_falls_with_the_sixth_power() {
        let error = |h: f64| {
            let end = step(turn, &[1.0, 0.0], &[0.0, -1.0], h).end;
            (end[0] - h.cos()).hypot(end[1] + h.sin())
        };
        let order = (error(0.2) / error(0.1)).log2();
        assert!((order - 6.0).abs() < 0.3, "{order}");
    }

    #[test]
    fn the_dense_output_has_a_local_error_of_fifth_order() {
        let error = |h: f64| {
            let s = step(turn, &[1.0, 0.0], &[0.0, -1.0], h);
            let dense = s.dense(&[1.0, 0.0], h);
            (1..10)
                .map(|k| f64::from(k) / 10.0)
                .fold(0.0_f64, |worst, t| worst.max((value(&dense[0], t) - (t * h).cos()).abs()))
        };
        let order = (error(0.2) / error(0.1)).log2();
        assert!(order > 4.7, "{order}");
    }
}
