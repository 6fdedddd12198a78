//! Newton's method on the return map.

use super::CycleError;
use super::return_map::{Return, return_map};
use crate::motion::SlidingSystem;
use crate::motion::attractor::distance;
use judder_numerics::dense::Triangles;
use judder_numerics::piecewise::StepSettings;
use judder_numerics::piecewise::tangent::SquareMatrix;
use std::array::from_fn;

/// How a cycle is sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shooting<const N: usize> {
    /// How the motion is stepped.
    pub settings: StepSettings<N>,
    /// The distance of the return from the start, in [`SlidingSystem::scales`], that is asked.
    pub tolerance: f64,
    /// The most iterations.
    pub iterations: usize,
    /// The longest period.
    pub longest: f64,
}

/// What Newton's method came to.
pub(super) struct Converged<const N: usize> {
    pub(super) guess: CycleGuess<N>,
    pub(super) oscillations: usize,
    pub(super) iterations: usize,
}

/// Newton's method until a motion of so many oscillations returns to its start.
pub(super) fn converge<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    oscillations: usize,
    shooting: &Shooting<N>,
) -> Result<Converged<N>, CycleError> {
    let scales = system.scales();
    let around = return_map(system, start, oscillations, shooting.settings, shooting.longest)?;
    let residual = distance(&around.state, &start, &scales);
    let mut guess = CycleGuess { start, around, residual };
    for iterations in 0..=shooting.iterations {
        if guess.residual <= shooting.tolerance {
            return Ok(Converged { guess, oscillations, iterations });
        }
        let step = newton_step(&guess, &scales)?;
        guess = damped(system, &guess, &step, oscillations, shooting)?;
    }
    Err(CycleError::NotConverged { iterations: shooting.iterations, residual: guess.residual })
}

/// A start and what comes back from it.
pub(super) struct CycleGuess<const N: usize> {
    pub(super) start: [f64; N],
    pub(super) around: Return<N>,
    /// Distance of the return from the start, in scales.
    pub(super) residual: f64,
}

/// (∂P/∂u − I)⁻¹ (u − P(u)), computed in scaled components.
pub(super) fn newton_step<const N: usize>(
    guess: &CycleGuess<N>,
    scales: &[f64; N],
) -> Result<[f64; N], CycleError> {
    let derivative = scaled(&guess.around.derivative, scales);
    let matrix = (0..N * N).map(|k| derivative[k / N][k % N] - f64::from(u8::from(k / N == k % N))).collect();
    let triangles = Triangles::new(N, matrix).ok_or(CycleError::Singular)?;
    let mut step: [f64; N] = from_fn(|i| (guess.start[i] - guess.around.state[i]) / scales[i]);
    triangles.solve(&mut step);
    Ok(from_fn(|i| step[i] * scales[i]))
}

/// A derivative by scaled components of scaled components.
pub(super) fn scaled<const N: usize>(derivative: &SquareMatrix<N>, scales: &[f64; N]) -> SquareMatrix<N> {
    from_fn(|i| from_fn(|j| derivative[i][j] * scales[j] / scales[i]))
}

/// A Newton step, shortened until it brings the return nearer to its start.
fn damped<const N: usize>(
    system: &impl SlidingSystem<N>,
    guess: &CycleGuess<N>,
    step: &[f64; N],
    oscillations: usize,
    shooting: &Shooting<N>,
) -> Result<CycleGuess<N>, CycleError> {
    const HALVINGS: i32 = 8;
    let scales = system.scales();
    let mut smallest = guess.residual;
    for halving in 0..HALVINGS {
        let start = from_fn(|i| guess.start[i] + 0.5_f64.powi(halving) * step[i]);
        // a start from which nothing returns is only too far away
        let Ok(around) = return_map(system, start, oscillations, shooting.settings, shooting.longest) else {
            continue;
        };
        let residual = distance(&around.state, &start, &scales);
        if residual < guess.residual {
            return Ok(CycleGuess { start, around, residual });
        }
        smallest = smallest.min(residual);
    }
    Err(CycleError::NotConverged { iterations: 0, residual: smallest })
}
