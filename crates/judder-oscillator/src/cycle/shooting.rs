//! Newton's method on the return map, and the Floquet multipliers of what it finds.

use super::CycleError;
use super::least_period::shortest;
use super::return_map::{Return, return_map};
use crate::motion::attractor::{Patience, Settled, distance, settle};
use crate::motion::{ContactState, Interrupted, SlidingSystem};
use judder_numerics::dense::{Triangles, eigenvalues};
use judder_numerics::piecewise::Settings;
use judder_numerics::piecewise::tangent::Matrix;
use num_complex::Complex64;
use std::array::from_fn;

/// How a cycle is sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shooting<const N: usize> {
    /// How the motion is stepped.
    pub settings: Settings<N>,
    /// The distance of the return from the start, in [`SlidingSystem::scales`], that is asked.
    pub tolerance: f64,
    /// The most iterations.
    pub iterations: usize,
    /// The longest period.
    pub longest: f64,
}

/// A limit cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle<const N: usize> {
    /// The state at the start, on the section.
    pub start: [f64; N],
    /// Oscillations in a period, the least one.
    pub oscillations: usize,
    /// The flight around it.
    pub around: Return<N>,
    /// All Floquet multipliers, by falling magnitude; the trivial one is exactly 1.
    pub multipliers: Vec<Complex64>,
    /// By how much the computed monodromy fails to carry the cycle's own velocity into itself, relative.
    pub trivial_error: f64,
    /// Distance of the return from the start, in scales.
    pub residual: f64,
    /// Newton's iterations, all together.
    pub iterations: usize,
}

impl<const N: usize> Cycle<N> {
    /// The period, in the time of the oscillator.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.around.time
    }

    /// The magnitude of the largest multiplier beside the trivial one.
    #[must_use]
    pub fn largest_multiplier(&self) -> f64 {
        let trivial = self.multipliers.iter().position(|m| *m == Complex64::ONE);
        let others = self.multipliers.iter().enumerate().filter(|(k, _)| Some(*k) != trivial);
        others.fold(0.0, |largest, (_, m)| m.norm().max(largest))
    }

    /// Whether small disturbances die out.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.largest_multiplier() < 1.0
    }

    /// The share of the period in a contact state.
    #[must_use]
    pub fn fraction(&self, contact_state: ContactState) -> f64 {
        self.around.measures.fraction(contact_state)
    }
}

/// The cycle that a motion from `start` settles to, made exact by Newton's method.
///
/// An irregular motion comes near unstable cycles again and again: from its recurrences Newton's method goes to the shortest that it finds.
///
/// # Errors
/// The motion comes to rest, or is irregular and no cycle was found beside it, or is interrupted; Newton's method fails.
pub fn from_simulation<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    shooting: &Shooting<N>,
    patience: &Patience,
    interrupted: Interrupted<'_>,
) -> Result<Cycle<N>, CycleError> {
    let settled = settle(system, start, shooting.settings, patience, interrupted)?;
    match settled.settled {
        Settled::SteadySliding => Err(CycleError::ComesToRest { time: settled.time }),
        Settled::Irregular => settled
            .recurrences
            .iter()
            .find_map(|(state, oscillations)| shoot(system, *state, *oscillations, shooting).ok())
            .ok_or(CycleError::Irregular { time: settled.time }),
        Settled::Cycle { oscillations } => shoot(system, settled.state, oscillations, shooting),
    }
}

/// The cycle near a state on the section, by Newton's method: of so many oscillations, or of the fewest that divide them if what is
/// found is a shorter cycle walked several times.
///
/// # Errors
/// The motion cannot be followed, the derivative is singular, or the iteration does not settle.
pub fn shoot<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    oscillations: usize,
    shooting: &Shooting<N>,
) -> Result<Cycle<N>, CycleError> {
    let found = converge(system, start, oscillations, shooting)?;
    match shortest(system, &found, shooting) {
        Some(shorter) => {
            finished(system, shorter.oscillations, shorter.guess, found.iterations + shorter.iterations)
        }
        None => finished(system, oscillations, found.guess, found.iterations),
    }
}

/// What Newton's method came to.
pub(super) struct Converged<const N: usize> {
    pub(super) guess: Guess<N>,
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
    let mut guess = Guess { start, around, residual };
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
pub(super) struct Guess<const N: usize> {
    pub(super) start: [f64; N],
    pub(super) around: Return<N>,
    /// Distance of the return from the start, in scales.
    pub(super) residual: f64,
}

/// (∂P/∂u − I)⁻¹ (u − P(u)), computed in scaled components.
pub(super) fn newton_step<const N: usize>(
    guess: &Guess<N>,
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
pub(super) fn scaled<const N: usize>(derivative: &Matrix<N>, scales: &[f64; N]) -> Matrix<N> {
    from_fn(|i| from_fn(|j| derivative[i][j] * scales[j] / scales[i]))
}

/// A Newton step, shortened until it brings the return nearer to its start.
fn damped<const N: usize>(
    system: &impl SlidingSystem<N>,
    guess: &Guess<N>,
    step: &[f64; N],
    oscillations: usize,
    shooting: &Shooting<N>,
) -> Result<Guess<N>, CycleError> {
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
            return Ok(Guess { start, around, residual });
        }
        smallest = smallest.min(residual);
    }
    Err(CycleError::NotConverged { iterations: 0, residual: smallest })
}

pub(super) fn finished<const N: usize>(
    system: &impl SlidingSystem<N>,
    oscillations: usize,
    guess: Guess<N>,
    iterations: usize,
) -> Result<Cycle<N>, CycleError> {
    let Guess { start, around, residual } = guess;
    let scales = system.scales();
    let multipliers = multipliers(&scaled(&around.derivative, &scales))?;
    let velocity = system.field(system.contact_state(&start), &start);
    let carried = from_fn(|i| (0..N).fold(0.0, |sum, j| sum + around.monodromy[i][j] * velocity[j]));
    let trivial_error = distance(&carried, &velocity, &scales) / distance(&velocity, &[0.0; N], &scales);
    Ok(Cycle { start, oscillations, around, multipliers, trivial_error, residual, iterations })
}

/// The eigenvalues of the return map's derivative; the zero that belongs to the section's normal makes room for the 1 of
/// the cycle's own direction, which is exact.
fn multipliers<const N: usize>(derivative: &Matrix<N>) -> Result<Vec<Complex64>, CycleError> {
    let by_magnitude =
        |a: &Complex64, b: &Complex64| b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im));
    let mut values = eigenvalues(derivative)?;
    values.sort_by(by_magnitude);
    if let Some(smallest) = values.last_mut() {
        *smallest = Complex64::ONE;
    }
    values.sort_by(by_magnitude);
    Ok(values)
}
