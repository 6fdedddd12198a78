//! Step after step along the path.

use super::control::Control;
use super::error::TransientError;
use super::history::{TransientEnergy, TransientFields, TransientHistory, TransientSample};
use super::memory::{Footprint, StripMemory};
use super::path::SAME;
use super::quadrature::work_of_step;
use super::step::{ContactSolver, StepContact};
use super::window::ContactWindow;
use super::{Before, TransientQuestion};
use std::ops::ControlFlow;

/// A run under way.
pub(super) struct TransientMarch<'a> {
    question: &'a TransientQuestion<'a>,
    window: ContactWindow,
    solver: ContactSolver<'a>,
    memory: StripMemory,
    control: Control<'a>,
    /// The end of the step before the last; at the start the start itself.
    before: StepContact,
    last: StepContact,
    /// Dissipated power at the ends of the step before and of the last.
    dissipated_powers: [f64; 2],
    history: TransientHistory,
}

impl<'a> TransientMarch<'a> {
    /// The contact at time 0.
    pub(super) fn new(question: &'a TransientQuestion<'a>) -> Result<Self, TransientError> {
        let window = ContactWindow::of(question)?;
        let first_column = window.first_column(question.path.position.at(0.0));
        let allowed = question.grid.memory_limit;
        let mut memory = StripMemory::new(window, question.substrate, first_column, allowed)?;
        let mut solver = ContactSolver::new(question, window)?;
        let compliance = match question.before {
            Before::Untouched => question.substrate.instantaneous,
            Before::Settled => question.substrate.relaxed(),
        };
        let cells = window.side * window.side;
        let nothing = Footprint { first_column, pressure: vec![0.0; cells] };
        let contact = solver.solve(0.0, &vec![0.0; cells], compliance, &nothing)?;
        if question.before == Before::Settled {
            memory.settle(&contact.footprint);
        }
        let mut march = Self {
            question,
            window,
            solver,
            memory,
            control: Control::new(question, window.cell),
            before: contact.clone(),
            last: contact,
            dissipated_powers: [0.0; 2],
            history: TransientHistory {
                samples: Vec::new(),
                fields: Vec::new(),
                cell: window.cell,
                strip: [window.strip, window.side],
                rejected: 0,
                products: 0,
                converged: true,
                completed: false,
            },
        };
        march.record(0.0);
        Ok(march)
    }

    pub(super) fn run(
        mut self,
        progress: &mut dyn FnMut(&TransientSample) -> ControlFlow<()>,
    ) -> Result<TransientHistory, TransientError> {
        let mut steps = 0;
        while let Some(time) = self.control.next_time(self.last.time) {
            if steps >= self.question.steps.most {
                return Ok(self.history);
            }
            steps += 1;
            if !self.try_step(time)? {
                continue;
            }
            if let Some(sample) = self.history.samples.last()
                && progress(sample).is_break()
            {
                return Ok(self.history);
            }
        }
        self.history.completed = true;
        Ok(self.history)
    }

    /// Tries a step to a time; whether it stands.
    fn try_step(&mut self, time: f64) -> Result<bool, TransientError> {
        let step = time - self.last.time;
        let weights = self.memory.weights(step);
        let first_column = self.window.first_column(self.question.path.position.at(time));
        self.memory.cover(first_column);
        let history = self.memory.displacement(&self.last.footprint, &weights, first_column);
        let compliance = self.memory.compliance(&weights);
        let next = self.solver.solve(time, &history, compliance, &self.last.footprint)?;
        self.history.products += next.products;
        let step_before =
            if self.history.samples.len() > 1 { self.last.time - self.before.time } else { step };
        let footprints = [&self.before.footprint, &self.last.footprint, &next.footprint];
        let error = self.solver.linearity_error(footprints, [step_before, step], &self.memory, &weights);
        if !self.control.accepts(step, error) {
            self.history.rejected += 1;
            return Ok(false);
        }
        self.memory.remember(&self.last.footprint, &next.footprint, &weights);
        self.control.arrive(time);
        let last = std::mem::replace(&mut self.last, next);
        self.record(error);
        self.before = last;
        Ok(true)
    }

    /// Notes the contact at the end of a step.
    fn record(&mut self, error: f64) {
        let energy = self.question.energy.then(|| self.energy());
        let (last, now) = (self.history.samples.last(), &self.last);
        let [normal_work, sliding_work] = last.map_or([0.0; 2], |last| {
            let before = &self.before;
            let times = [before.time, last.time, now.time];
            let depths = [before.indentation, last.indentation, now.indentation];
            let normal = work_of_step(times, [before.force, last.force, now.force], depths);
            let resistance = [before.friction_force, last.friction_force, now.friction_force];
            let sliding = work_of_step(times, resistance, [before.position, last.position, now.position]);
            [last.normal_work + normal, last.sliding_work + sliding]
        });
        self.history.converged &= now.converged && error <= self.question.steps.tolerance;
        self.history.samples.push(TransientSample {
            time: now.time,
            position: now.position,
            indentation: now.indentation,
            force: now.force,
            friction_force: now.friction_force,
            area: now.area,
            normal_work,
            sliding_work,
            energy,
            step_error: error,
            residual: now.residual,
        });
        self.keep_fields();
    }

    fn keep_fields(&mut self) {
        let now = &self.last;
        let same = SAME * self.question.duration;
        if !self.question.fields_at.iter().any(|time| (time - now.time).abs() <= same) {
            return;
        }
        let mut grid = self.window.grid(now.footprint.first_column, now.position);
        grid.origin[0] += now.position;
        self.history.fields.push(TransientFields {
            time: now.time,
            position: now.position,
            grid,
            pressure: now.footprint.pressure.clone(),
            gap: now.gap.clone(),
        });
    }

    fn energy(&mut self) -> TransientEnergy {
        let stored = self.memory.stored_energy(&self.last.footprint);
        let power = self.memory.dissipated_power(&self.last.footprint);
        let [before, last] = self.dissipated_powers;
        self.dissipated_powers = [last, power];
        let dissipated = self.history.samples.last().and_then(|sample| {
            let times = [self.before.time, sample.time, self.last.time];
            Some(sample.energy?.dissipated + work_of_step(times, [before, last, power], times))
        });
        TransientEnergy { stored, dissipated: dissipated.unwrap_or(0.0) }
    }
}
