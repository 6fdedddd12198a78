//! A history in the making: what of each step is kept.

use super::{MotionHistory, Oscillation, PATH_POINTS, StateSample, TimeWindow};
use crate::motion::measures::Measures;
use crate::motion::sliding_system::contact_change;
use crate::motion::{ContactState, SlidingSystem};
use judder_numerics::piecewise::quartic::{first_fall, value};
use judder_numerics::piecewise::{Advance, Leg, PiecewiseMarch};
use std::collections::VecDeque;

/// A history in the making.
pub(super) struct MotionRecorder<'a, S, const N: usize> {
    system: &'a S,
    window: &'a TimeWindow,
    /// Of a step, relative.
    tolerance: f64,
    /// x of steady sliding, about which moments are taken.
    centre: f64,
    pub(super) history: MotionHistory<N>,
    /// The energy where averages begin.
    energy: f64,
    /// When the section was last met, where it was.
    last_return: Option<f64>,
    /// Smallest and largest x since then.
    range: (f64, f64),
}

impl<'a, S: SlidingSystem<N>, const N: usize> MotionRecorder<'a, S, N> {
    pub(super) fn new(system: &'a S, window: &'a TimeWindow, tolerance: f64) -> Self {
        let history = MotionHistory {
            samples: Vec::with_capacity(window.points),
            path: VecDeque::new(),
            events: Vec::new(),
            oscillations: Vec::new(),
            measures: Measures::default(),
            energy_change: 0.0,
            energy_resolution: 0.0,
            steps: 0,
        };
        let centre = system.steady_sliding()[0];
        let (last_return, range) = (None, (f64::NAN, f64::NAN));
        Self { system, window, tolerance, centre, history, energy: 0.0, last_return, range }
    }

    /// Averages begin here, anew.
    pub(super) fn begin(&mut self, march: &PiecewiseMarch<'_, S, N>) {
        self.history.measures = Measures::default();
        self.history.oscillations.clear();
        self.energy = self.system.energy(&march.state());
        let state = march.state();
        // where x' is zero and falling x is largest
        let falls = self.system.field(march.mode(), &state)[N / 2] < 0.0;
        let starts_on_section = falls && self.system.section().value(&state) == 0.0;
        self.last_return = starts_on_section.then(|| march.time());
        self.range = (state[0], state[0]);
    }

    pub(super) fn add(&mut self, advance: &Advance<S::Mode, N>) {
        if let Some(leg) = &advance.leg {
            self.system.measure(leg, self.centre, &mut self.history.measures);
            self.add_samples(leg);
            self.widen(leg);
            self.add_to_path(leg, advance.crossing.is_some());
            if advance.on_section {
                self.add_return(leg);
            }
        }
        if let Some(change) = advance.crossing.as_ref().and_then(contact_change) {
            self.history.events.push(change);
            self.history.measures.changes += 1;
        }
    }

    /// The time of the next point of the grid.
    fn next_time(&self) -> f64 {
        self.window.duration * self.history.samples.len() as f64 / (self.window.points - 1) as f64
    }

    fn add_samples(&mut self, leg: &Leg<S::Mode, N>) {
        while self.history.samples.len() < self.window.points && self.next_time() <= leg.time + leg.step {
            let time = self.next_time();
            let fraction = ((time - leg.time) / leg.step).clamp(0.0, 1.0);
            self.history.samples.push(StateSample {
                time,
                contact_state: leg.mode.into(),
                state: leg.at(fraction),
            });
        }
    }

    fn add_to_path(&mut self, leg: &Leg<S::Mode, N>, changes: bool) {
        if leg.mode.into() == ContactState::Stick && !changes {
            return;
        }
        if self.history.path.len() == PATH_POINTS {
            self.history.path.pop_front();
        }
        let time = leg.time + leg.step;
        self.history.path.push_back(StateSample { time, contact_state: leg.mode.into(), state: leg.end });
    }

    /// Takes note of how far x goes along a leg: a smallest x within it is where x' rises through zero.
    fn widen(&mut self, leg: &Leg<S::Mode, N>) {
        let turn = first_fall(&leg.dense[N / 2].map(|c| -c)).map(|fraction| value(&leg.dense[0], fraction));
        for x in [leg.dense[0][0], leg.end[0]].into_iter().chain(turn) {
            self.range = (self.range.0.min(x), self.range.1.max(x));
        }
    }

    fn add_return(&mut self, leg: &Leg<S::Mode, N>) {
        let time = leg.time + leg.step;
        if let Some(last) = self.last_return {
            let amplitude = 0.5 * (self.range.1 - self.range.0);
            let oscillation = Oscillation { time, period: time - last, amplitude, state: leg.end };
            self.history.oscillations.push(oscillation);
        }
        self.last_return = Some(time);
        self.range = (leg.end[0], leg.end[0]);
    }

    pub(super) fn finish(mut self, march: &PiecewiseMarch<'_, S, N>) -> MotionHistory<N> {
        // the last point of the grid may lie a rounding error beyond the last step
        while self.history.samples.len() < self.window.points {
            let (time, contact_state, state) = (self.next_time(), march.mode().into(), march.state());
            self.history.samples.push(StateSample { time, contact_state, state });
        }
        let energy = self.system.energy(&march.state());
        self.history.energy_change = energy - self.energy;
        self.history.steps = march.steps_used();
        let largest = energy.abs().max(self.energy.abs());
        self.history.energy_resolution = self.tolerance * largest * self.history.steps as f64;
        self.history
    }
}
