//! One step: an elastic contact over the surface that the past has left.

use super::TransientQuestion;
use super::error::TransientError;
use super::memory::{Footprint, StripMemory};
use super::weights::StepWeights;
use super::window::ContactWindow;
use crate::kernel::sliding::SlidingOperator;
use crate::kernel::substrate::SlidingSubstrate;
use crate::steady::contact_area::contact_area;
use crate::steady::level::{heights, resistance};
use crate::surface::operator::SurfaceOperator;
use crate::unilateral::active_set::UnilateralStart;
use crate::unilateral::{Loading, UnilateralLimits, UnilateralProblem, UnilateralSolution, symmetric};

/// The loosest tolerance of a step's contact, relative to its own depth, however little of it there is.
const LOOSEST: f64 = 1e-2;

/// The contact at the end of a step; forces in E0* R², lengths in R.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct StepContact {
    pub(super) time: f64,
    pub(super) position: f64,
    pub(super) indentation: f64,
    pub(super) footprint: Footprint,
    /// Gap on the window.
    pub(super) gap: Vec<f64>,
    pub(super) force: f64,
    pub(super) friction_force: f64,
    pub(super) area: f64,
    /// Largest error of the unilateral conditions, in displacement over the window's depth.
    pub(super) residual: f64,
    pub(super) converged: bool,
    pub(super) products: usize,
}

/// What the contacts of all steps share.
pub(super) struct ContactSolver<'a> {
    question: &'a TransientQuestion<'a>,
    window: ContactWindow,
    operator: SlidingOperator,
}

impl<'a> ContactSolver<'a> {
    pub(super) fn new(
        question: &'a TransientQuestion<'a>,
        window: ContactWindow,
    ) -> Result<Self, TransientError> {
        let allowed = question.grid.memory_limit;
        let operator = SlidingOperator::new(window.grid(0, 0.0), &SlidingSubstrate::elastic(), allowed)?;
        Ok(Self { question, window, operator })
    }

    /// The contact at a time, when pressures act on the surface with a compliance over a history.
    ///
    /// With q = J p the problem is that of an elastic half-space of unit compliance: W[q] + history + h − δ ≥ 0. What is left
    /// of the depth above the lowest point of history + h is the depth of this problem.
    pub(super) fn solve(
        &mut self,
        time: f64,
        history: &[f64],
        compliance: f64,
        guess: &Footprint,
    ) -> Result<StepContact, TransientError> {
        let position = self.question.path.position.at(time);
        let first_column = self.window.first_column(position);
        let grid = self.window.grid(first_column, position);
        let mut shape = heights(self.question.profile, &grid, 0.0);
        shape.iter_mut().zip(history).for_each(|(height, history)| *height += history);
        let lowest = shape.iter().copied().fold(f64::INFINITY, f64::min);
        shape.iter_mut().for_each(|height| *height -= lowest);
        let loading = match self.question.path.loading(time) {
            Loading::Indentation(depth) => Loading::Indentation(depth - lowest),
            Loading::Load(force) => Loading::Load(force * compliance),
        };
        let mut start = guess.on(first_column, self.window.side);
        start.iter_mut().for_each(|pressure| *pressure *= compliance);
        let mut solution = self.pressed(&shape, loading, &start)?;
        solution.pressure.iter_mut().for_each(|pressure| *pressure /= compliance);
        let footprint = Footprint { first_column, pressure: solution.pressure };
        self.refuse_edge(&footprint, time)?;
        let pressure = &footprint.pressure;
        Ok(StepContact {
            time,
            position,
            indentation: solution.indentation + lowest,
            force: pressure.iter().sum::<f64>() * grid.cell_area(),
            friction_force: resistance(self.question.profile, &grid, pressure),
            area: contact_area(&grid, pressure, &SlidingSubstrate::elastic()),
            residual: solution.errors.worst() * solution.indentation.max(0.0) / self.window.depth,
            gap: solution.gap,
            converged: solution.converged,
            products: solution.products,
            footprint,
        })
    }

    fn pressed(
        &mut self,
        shape: &[f64],
        loading: Loading,
        start: &[f64],
    ) -> Result<UnilateralSolution, TransientError> {
        let (Loading::Indentation(imposed) | Loading::Load(imposed)) = loading;
        let depth = match loading {
            Loading::Indentation(depth) => depth,
            Loading::Load(force) => self.question.profile.elastic_depth(force.max(0.0)),
        };
        if imposed <= 0.0 {
            let indentation = if matches!(loading, Loading::Load(_)) { 0.0 } else { depth };
            return Ok(untouched(shape, indentation));
        }
        let limits = self.question.limits;
        let tolerance = (limits.tolerance * self.window.depth / depth).min(LOOSEST).max(limits.tolerance);
        let limits = UnilateralLimits { tolerance, ..limits };
        let problem = UnilateralProblem { heights: shape, loading };
        let start = UnilateralStart { pressure: start, indentation: depth };
        Ok(symmetric::solve(&mut self.operator, &problem, start, limits)?)
    }

    /// The error that a step makes by taking its pressure as linear: its mean square over the contact, over the depth.
    ///
    /// `before` is the pressure a step earlier, `step` and `step_before` are the lengths of both steps. The curvature of
    /// the pressure is that of a parabola through three points.
    pub(super) fn linearity_error(
        &mut self,
        contacts: [&Footprint; 3],
        steps: [f64; 2],
        memory: &StripMemory,
        weights: &[StepWeights],
    ) -> f64 {
        let factor = memory.sum(weights, |weights| weights.curvature);
        let [before, last, next] = contacts;
        let side = self.window.side;
        let (before, last) = (before.on(next.first_column, side), last.on(next.first_column, side));
        let [step_before, step] = steps;
        let scale = 2.0 * factor * step / (step + step_before);
        let per_step = step / step_before;
        let curvature: Vec<f64> = next
            .pressure
            .iter()
            .zip(&last)
            .zip(&before)
            .map(|((next, last), before)| scale * ((next - last) - per_step * (last - before)))
            .collect();
        let mut error = vec![0.0; curvature.len()];
        self.operator.displacement(&curvature, &mut error);
        let inside = next.pressure.iter().zip(&error).filter(|(pressure, _)| **pressure > 0.0);
        let (sum, count) =
            inside.fold((0.0, 0_usize), |(sum, count), (_, error)| (sum + error * error, count + 1));
        if count == 0 { 0.0 } else { (sum / count as f64).sqrt() / self.window.depth }
    }

    fn refuse_edge(&self, footprint: &Footprint, time: f64) -> Result<(), TransientError> {
        let side = self.window.side;
        let last = side - 1;
        let touches = footprint.pressure.iter().enumerate().any(|(cell, pressure)| {
            let (row, column) = (cell / side, cell % side);
            *pressure > 0.0 && (row == 0 || column == 0 || row == last || column == last)
        });
        if !touches {
            return Ok(());
        }
        let half_width = 0.5 * self.window.cell * side as f64;
        Err(TransientError::WindowTooSmall { time, half_width, needed: 1.5 * half_width })
    }
}

/// The indenter above the surface: no pressure, the gap as it is.
fn untouched(shape: &[f64], indentation: f64) -> UnilateralSolution {
    let gap: Vec<f64> = shape.iter().map(|height| height - indentation).collect();
    let pressure = vec![0.0; shape.len()];
    let errors = crate::unilateral::UnilateralErrors::of(&pressure, &gap, 1.0, 0.0);
    UnilateralSolution { pressure, gap, indentation, errors, converged: true, iterations: 0, products: 0 }
}
