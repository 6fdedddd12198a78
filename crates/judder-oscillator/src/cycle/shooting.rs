//! Cycles sought by shooting, with their Floquet multipliers.

use super::CycleError;
use super::least_period::shortest;
use super::newton::{CycleGuess, converge, scaled};
use super::return_map::Return;
use crate::motion::attractor::{Patience, Settled, distance, settle};
use crate::motion::{ContactState, Interrupted, SlidingSystem};
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::dense::eigenvalues;
use judder_numerics::order::sort_by_numbers;
use judder_numerics::piecewise::tangent::SquareMatrix;
use num_complex::Complex64;
use std::array::from_fn;

pub use super::newton::Shooting;

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
        others.fold(0.0, |largest, (_, m)| m.modulus().max(largest))
    }

    /// Whether small disturbances die out.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.largest_multiplier() < 1.0
    }

    /// Whether its largest multiplier is one but for what is known of it: without damping all motions nearby are cycles.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        const KNOWN: f64 = 1e-6;
        (self.largest_multiplier() - 1.0).abs() < KNOWN
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

pub(super) fn finished<const N: usize>(
    system: &impl SlidingSystem<N>,
    oscillations: usize,
    guess: CycleGuess<N>,
    iterations: usize,
) -> Result<Cycle<N>, CycleError> {
    let CycleGuess { start, around, residual } = guess;
    let scales = system.scales();
    let multipliers = multipliers(&scaled(&around.derivative, &scales))?;
    let velocity = system.field(system.starting_mode(&start), &start);
    let carried = from_fn(|i| (0..N).fold(0.0, |sum, j| sum + around.monodromy[i][j] * velocity[j]));
    let trivial_error = distance(&carried, &velocity, &scales) / distance(&velocity, &[0.0; N], &scales);
    Ok(Cycle { start, oscillations, around, multipliers, trivial_error, residual, iterations })
}

/// The eigenvalues of the return map's derivative; the zero that belongs to the section's normal makes room for the 1 of
/// the cycle's own direction, which is exact.
fn multipliers<const N: usize>(derivative: &SquareMatrix<N>) -> Result<Vec<Complex64>, CycleError> {
    let falling = |own: &Complex64| [-own.modulus(), -own.im];
    let mut values = eigenvalues(derivative)?;
    sort_by_numbers(&mut values, falling);
    if let Some(smallest) = values.last_mut() {
        *smallest = Complex64::ONE;
    }
    sort_by_numbers(&mut values, falling);
    Ok(values)
}
