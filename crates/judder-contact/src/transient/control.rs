//! The length of the next step.

use super::path::IndenterPath;
use super::substrate::CreepingSubstrate;
use super::{StepControl, TransientQuestion};

/// Part of the step that would just meet the tolerance.
const SAFETY: f64 = 0.9;
/// A step's error falls with its third power.
const ORDER: f64 = 3.0;
/// Most that a step may grow and shrink by.
const GROWTH: [f64; 2] = [0.2, 2.0];
/// The first step, in the shortest time in which a pressure relaxes.
const FIRST: f64 = 0.05;
/// The shortest step, over the duration: below it the error is accepted as it is.
const SHORTEST: f64 = 1e-9;

/// Chooses steps that land on given times, move the indenter by few cells and keep the error in bounds.
pub(super) struct Control<'a> {
    path: &'a IndenterPath,
    steps: StepControl,
    landings: Vec<f64>,
    next_landing: usize,
    cell: f64,
    duration: f64,
    wanted: f64,
}

impl<'a> Control<'a> {
    pub(super) fn new(question: &TransientQuestion<'a>, cell: f64) -> Self {
        let duration = question.duration;
        Self {
            path: question.path,
            steps: question.steps,
            landings: question.path.landings(duration, question.fields_at),
            next_landing: 0,
            cell,
            duration,
            wanted: FIRST * shortest_relaxation(question.substrate).min(duration),
        }
    }

    /// The end of the next step; `None` when the path has ended.
    pub(super) fn next_time(&mut self, time: f64) -> Option<f64> {
        let landing = *self.landings.get(self.next_landing)?;
        let moves = self.path.position.largest_rate();
        let few_cells = if moves > 0.0 { self.steps.cells_a_step * self.cell / moves } else { f64::INFINITY };
        let step = self.wanted.min(few_cells).min(self.path.longest_step());
        let left = landing - time;
        // Two equal steps rather than a long and a tiny one; whole steps where they fit up to rounding.
        if left <= step * (1.0 + 1e-9) {
            Some(landing)
        } else if left < 2.0 * step {
            Some(time + 0.5 * left)
        } else {
            Some(time + step)
        }
    }

    /// Whether a step with this error stands; the next is chosen from it.
    pub(super) fn accepts(&mut self, step: f64, error: f64) -> bool {
        let ratio = libm::pow(self.steps.tolerance / error, 1.0 / ORDER);
        let factor = if error > 0.0 { (SAFETY * ratio).clamp(GROWTH[0], GROWTH[1]) } else { GROWTH[1] };
        self.wanted = step * factor;
        error <= self.steps.tolerance || step <= SHORTEST * self.duration
    }

    /// Notes that the path has come to a time.
    pub(super) fn arrive(&mut self, time: f64) {
        if self.landings.get(self.next_landing).is_some_and(|landing| *landing <= time) {
            self.next_landing += 1;
        }
    }
}

/// min τ_k J(0)/J(∞), below every relaxation time of the contact; infinite for an elastic substrate.
fn shortest_relaxation(substrate: &CreepingSubstrate) -> f64 {
    let shortest = substrate.terms.iter().map(|term| term.time).fold(f64::INFINITY, f64::min);
    shortest * substrate.instantaneous / substrate.relaxed()
}
