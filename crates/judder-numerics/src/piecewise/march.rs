//! The motion, step by step.

use super::error::MarchError;
use super::leg::{Advance, GuardCrossing, Leg, SectionPlane, StepMethod};
use super::quartic::{self, Quartic};
use super::stiffness::Stiffness;
use super::{PiecewiseSmooth, dormand_prince, radau, rate};
use std::array::from_fn;
use std::collections::VecDeque;

/// How a motion is stepped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepSettings<const N: usize> {
    /// Local error of a step, relative to the state.
    pub relative: f64,
    /// Local error of a step, absolute, of each component of the state.
    pub absolute: [f64; N],
    /// The longest step, in time.
    pub longest_step: f64,
    /// The most steps, taken or refused.
    pub steps: usize,
}

/// A motion that is under way.
#[derive(Debug, Clone)]
pub struct PiecewiseMarch<'a, S: PiecewiseSmooth<N>, const N: usize> {
    system: &'a S,
    settings: StepSettings<N>,
    section: Option<SectionPlane<N>>,
    time: f64,
    mode: S::Mode,
    state: [f64; N],
    field: [f64; N],
    step: f64,
    steps_used: usize,
    starts_on_section: bool,
    starts_at_edge: bool,
    stiffness: Stiffness,
    recent_crossings: VecDeque<f64>,
}

/// A step that may be taken.
struct Trial<const N: usize> {
    step: f64,
    end: [f64; N],
    end_field: Option<[f64; N]>,
    dense: [Quartic; N],
    /// In units of what is allowed; the step is good below 1.
    error: f64,
    rate: f64,
}

/// What a step runs into first.
#[derive(Clone, Copy)]
enum StepTarget {
    Guard(usize),
    Section,
}

/// Changes of mode looked at together for an accumulation, and the time that so many may not be shorter than.
const CROWD: usize = 64;
const CROWD_INTERVAL: f64 = 1e-11;
/// A step refused below it will not do.
const SHORTEST_STEP: f64 = 1e-14;

impl<'a, S: PiecewiseSmooth<N>, const N: usize> PiecewiseMarch<'a, S, N> {
    /// A motion from a state in a mode, at time zero.
    ///
    /// # Errors
    /// [`MarchError::NotFinite`].
    pub fn new(
        system: &'a S,
        mode: S::Mode,
        state: [f64; N],
        settings: StepSettings<N>,
    ) -> Result<Self, MarchError> {
        if let Some(component) = state.iter().position(|u| !u.is_finite()) {
            return Err(MarchError::NotFinite { component, value: state[component] });
        }
        let field = system.field(mode, &state);
        let mut march = Self {
            system,
            settings,
            section: None,
            time: 0.0,
            mode,
            state,
            field,
            step: 0.0,
            steps_used: 0,
            starts_on_section: false,
            starts_at_edge: true,
            stiffness: Stiffness::default(),
            recent_crossings: VecDeque::with_capacity(CROWD),
        };
        march.step = march.first_step();
        Ok(march)
    }

    /// Ends a step wherever the motion falls through the plane; a start on the plane is not counted.
    #[must_use]
    pub fn with_section(mut self, section: SectionPlane<N>) -> Self {
        self.starts_on_section = section.value(&self.state) == 0.0;
        self.section = Some(section);
        self
    }

    /// Time.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The state.
    #[must_use]
    pub fn state(&self) -> [f64; N] {
        self.state
    }

    /// The mode.
    #[must_use]
    pub fn mode(&self) -> S::Mode {
        self.mode
    }

    /// Steps used so far, taken or refused.
    #[must_use]
    pub fn steps_used(&self) -> usize {
        self.steps_used
    }

    /// One step, at most to the time `until`, shorter where a guard or the section is met.
    ///
    /// # Errors
    /// The budget of steps is spent, the step becomes too short, or changes of mode accumulate.
    pub fn advance(&mut self, until: f64) -> Result<Advance<S::Mode, N>, MarchError> {
        let trial = self.accepted_trial(until)?;
        let Some((target, fraction)) = self.first_target(&trial) else {
            return Ok(self.take(trial, None));
        };
        if let (StepTarget::Guard(guard), true) = (target, fraction == 0.0) {
            let advance = Advance { leg: None, crossing: Some(self.change(guard)), on_section: false };
            self.watch_for_accumulation(&advance)?;
            return Ok(advance);
        }
        match self.land(target, fraction * trial.step, trial.step) {
            Some(cut) => {
                let leg = self.take(cut, Some(target));
                self.watch_for_accumulation(&leg)?;
                Ok(leg)
            }
            // the true motion passes the guard without touching it
            None => Ok(self.take(trial, None)),
        }
    }

    fn weighted(&self, error: &[f64; N], end: &[f64; N]) -> f64 {
        let sum = (0..N).fold(0.0, |sum, i| {
            let allowed =
                self.settings.absolute[i] + self.settings.relative * self.state[i].abs().max(end[i].abs());
            sum + (error[i] / allowed) * (error[i] / allowed)
        });
        (sum / N as f64).sqrt()
    }

    /// A first step that an explicit Euler step of its length would just forgive (Hairer, Nørsett, Wanner, II.4).
    fn first_step(&self) -> f64 {
        let zero = [0.0; N];
        let size = self.weighted(&self.state, &zero).max(1e-5);
        let speed = self.weighted(&self.field, &zero).max(1e-5);
        let euler = 0.01 * size / speed;
        let place = from_fn(|i| self.state[i] + euler * self.field[i]);
        let there = self.system.field(self.mode, &place);
        let curvature = self.weighted(&from_fn(|i| there[i] - self.field[i]), &zero) / euler;
        let largest = speed.max(curvature);
        libm::pow(0.01 / largest, 0.2).min(100.0 * euler).min(self.settings.longest_step)
    }

    /// A step whose error is allowed.
    fn accepted_trial(&mut self, until: f64) -> Result<Trial<N>, MarchError> {
        let rest = until - self.time;
        loop {
            if self.steps_used >= self.settings.steps {
                let Self { settings, time, step, .. } = self;
                return Err(MarchError::StepsSpent { steps: settings.steps, time: *time, step: *step });
            }
            self.steps_used += 1;
            let step = self.step.min(self.settings.longest_step).min(rest);
            let trial = self.attempt(step);
            let error = trial.as_ref().map_or(f64::INFINITY, |trial| trial.error);
            if error <= 1.0
                && let Some(trial) = trial
            {
                // a step cut at the end of the time says nothing about the next
                if step == self.step || error > 0.5 {
                    self.step = step * self.growth(error);
                }
                if !self.stiffness.is_stiff() {
                    self.stiffness.observe(step * trial.rate);
                }
                return Ok(trial);
            }
            if step < SHORTEST_STEP {
                return Err(MarchError::StepTooShort { time: self.time, step });
            }
            self.step = step * if error.is_finite() { self.growth(error).min(0.9) } else { 0.1 };
        }
    }

    /// By what the next step may be longer.
    fn growth(&self, error: f64) -> f64 {
        let order = if self.stiffness.is_stiff() { 4.0 } else { 5.0 };
        (0.9 * libm::pow(error.max(1e-10), -1.0 / order)).clamp(0.2, 5.0)
    }

    /// A step of a given length by the method of the leg; `None` where it gives no number.
    fn attempt(&self, step: f64) -> Option<Trial<N>> {
        let field = |u: &[f64; N]| self.system.field(self.mode, u);
        let trial = if self.stiffness.is_stiff() {
            let jacobian = self.system.jacobian(self.mode, &self.state);
            let is_settled = |c: &[f64; N]| self.weighted(c, &self.state) < 1e-3;
            let stepped = radau::step(field, &jacobian, &self.state, &self.field, step, is_settled)?;
            Trial {
                step,
                end: stepped.end,
                end_field: None,
                dense: stepped.dense(&self.state),
                error: self.weighted(&stepped.error, &stepped.end),
                rate: 0.0,
            }
        } else {
            let stepped = dormand_prince::step(field, &self.state, &self.field, step);
            Trial {
                step,
                end: stepped.end,
                end_field: Some(stepped.end_field),
                dense: stepped.dense(&self.state, step),
                error: self.weighted(&stepped.error, &stepped.end),
                rate: stepped.rate,
            }
        };
        (trial.error.is_finite() && trial.end.iter().all(|u| u.is_finite())).then_some(trial)
    }

    /// The guard or section that the step crosses first, and at which fraction of it; a guard before the section, the
    /// lower guard before the higher where they are met together.
    fn first_target(&self, trial: &Trial<N>) -> Option<(StepTarget, f64)> {
        let mut first: Option<(StepTarget, f64)> = None;
        for guard in 0..self.system.guards(self.mode) {
            let along = self.guard_along(guard, trial);
            if let Some(fraction) = quartic::first_descent(&along)
                && first.is_none_or(|(_, earlier)| fraction < earlier)
            {
                first = Some((StepTarget::Guard(guard), fraction));
            }
        }
        if let Some(section) = &self.section {
            let mut along = section.along(&trial.dense);
            if self.starts_on_section {
                along[0] = 0.0;
            }
            if let Some(fraction) = quartic::first_fall(&along)
                && first.is_none_or(|(_, earlier)| fraction < earlier)
            {
                first = Some((StepTarget::Section, fraction));
            }
        }
        first
    }

    /// A guard along a step: exact where it is linear in the state, else as good as the step's own dense output.
    fn guard_along(&self, guard: usize, trial: &Trial<N>) -> Quartic {
        let (system, mode) = (self.system, self.mode);
        let slope = |state: &[f64; N], field: &[f64; N]| {
            trial.step * rate(&system.guard_gradient(mode, guard, state), field)
        };
        let middle = from_fn(|i| quartic::value(&trial.dense[i], 0.5));
        let end_field = trial.end_field.unwrap_or_else(|| system.field(mode, &trial.end));
        quartic::through(
            system.guard(mode, guard, &self.state),
            slope(&self.state, &self.field),
            system.guard(mode, guard, &middle),
            system.guard(mode, guard, &trial.end),
            slope(&trial.end, &end_field),
        )
    }

    /// The target's value after a step, and the speed at which it falls there.
    fn sight(&self, target: StepTarget, trial: &Trial<N>) -> (f64, f64) {
        let (system, mode) = (self.system, self.mode);
        let field = trial.end_field.unwrap_or_else(|| system.field(mode, &trial.end));
        match (target, &self.section) {
            (StepTarget::Section, Some(section)) => {
                (section.value(&trial.end), rate(&section.normal, &field))
            }
            (StepTarget::Section, None) => (f64::NAN, f64::NAN),
            (StepTarget::Guard(guard), _) => (
                system.guard(mode, guard, &trial.end),
                rate(&system.guard_gradient(mode, guard, &trial.end), &field),
            ),
        }
    }

    /// The step that ends on a target or a rounding error beyond it, found by steps of their own rather than on the dense
    /// output; `None` where the motion turns out to stay on the positive side.
    fn land(&self, target: StepTarget, guess: f64, longest: f64) -> Option<Trial<N>> {
        const LIMIT: usize = 80;
        let (mut inside, mut beyond) = (0.0_f64, None::<Trial<N>>);
        let mut step = guess;
        for _ in 0..LIMIT {
            let trial = self.attempt(step)?;
            let (value, fall) = self.sight(target, &trial);
            if value == 0.0 {
                return Some(trial);
            }
            let newton = step - value / fall;
            if value < 0.0 {
                beyond = Some(trial);
            } else {
                inside = step;
            }
            let upper = beyond.as_ref().map_or(longest, |trial| trial.step);
            if upper - inside <= 4.0 * f64::EPSILON * upper {
                break;
            }
            // a step that has settled on the near side is carried over by twice its distance
            let settled = (newton - step).abs() <= 4.0 * f64::EPSILON * step;
            let wanted = if settled && value > 0.0 { step + 4.0 * f64::EPSILON * step } else { newton };
            if settled && value < 0.0 {
                break;
            }
            step = if wanted > inside && wanted < upper {
                wanted
            } else if beyond.is_some() {
                0.5 * (inside + upper)
            } else if wanted >= upper {
                longest
            } else {
                return None;
            };
        }
        beyond
    }

    /// Takes a step; `met` is what its end lies on.
    fn take(&mut self, trial: Trial<N>, met: Option<StepTarget>) -> Advance<S::Mode, N> {
        let method = if self.stiffness.is_stiff() { StepMethod::Implicit } else { StepMethod::Explicit };
        let meets_edge =
            matches!(met, Some(StepTarget::Guard(guard)) if !self.system.is_corner(self.mode, guard));
        let leg = Leg {
            mode: self.mode,
            method,
            time: self.time,
            step: trial.step,
            is_at_edge: self.starts_at_edge || meets_edge,
            end: trial.end,
            dense: trial.dense,
        };
        let was_above = !self.starts_on_section && self.above_section().is_some_and(|above| above > 0.0);
        self.starts_at_edge = false;
        self.time += trial.step;
        self.state = trial.end;
        self.field = trial.end_field.unwrap_or_else(|| self.system.field(self.mode, &trial.end));
        self.starts_on_section = matches!(met, Some(StepTarget::Section));
        let crossing = match met {
            Some(StepTarget::Guard(guard)) => Some(self.change(guard)),
            _ => None,
        };
        // a guard may stand on the section itself
        if crossing.is_some() && was_above && self.falls_through_section() {
            self.starts_on_section = true;
        }
        Advance { leg: Some(leg), crossing, on_section: self.starts_on_section }
    }

    /// How far the state lies above the section.
    fn above_section(&self) -> Option<f64> {
        self.section.as_ref().map(|section| section.value(&self.state))
    }

    /// Whether the state lies on the section, or a rounding error beyond it, and falls.
    fn falls_through_section(&self) -> bool {
        let fall = self.section.as_ref().map(|section| rate(&section.normal, &self.field));
        self.above_section().is_some_and(|above| above <= 0.0) && fall.is_some_and(|fall| fall < 0.0)
    }

    fn change(&mut self, guard: usize) -> GuardCrossing<S::Mode, N> {
        let from = self.mode;
        let (to, state) = self.system.cross(from, guard, &self.state);
        self.mode = to;
        self.state = state;
        self.field = self.system.field(to, &state);
        self.starts_at_edge = !self.system.is_corner(from, guard);
        self.stiffness = Stiffness::default();
        self.step = self.step.min(self.first_step());
        GuardCrossing { time: self.time, from, to, guard, state }
    }

    fn watch_for_accumulation(&mut self, advance: &Advance<S::Mode, N>) -> Result<(), MarchError> {
        if advance.crossing.is_none() {
            return Ok(());
        }
        self.recent_crossings.push_back(self.time);
        if self.recent_crossings.len() < CROWD {
            return Ok(());
        }
        let oldest = self.recent_crossings.pop_front().unwrap_or(self.time);
        let interval = self.time - oldest;
        if interval < CROWD_INTERVAL {
            return Err(MarchError::Accumulation { changes: CROWD, interval, time: self.time });
        }
        Ok(())
    }
}
