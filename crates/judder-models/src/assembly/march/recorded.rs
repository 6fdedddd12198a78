//! What is kept of a motion: signals, low-passed as they are thinned, forces as means, and the states of all points at their times, on their way into
//! the study.

use crate::error::ModelError;
use judder_nonsmooth::NonsmoothError;
use judder_nonsmooth::contact_problem::PointMotion;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_numerics::contact_state::ContactState;
use judder_numerics::signal::Decimation;
use judder_numerics::signal::decimate::{Decimator, DecimatorState};
use judder_numerics::signal::means::WindowMeans;
use judder_store::StreamSlice;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Of the rate of the samples, what signals keep.
const PASS: f64 = 0.4;

/// Takes the steps of a motion.
pub(super) struct Recorded {
    decimation: Decimation,
    filter: Option<Decimator>,
    /// Of the forces, which jump.
    means: Option<WindowMeans>,
    /// Steps by which what the filter lets through lies behind.
    delay: u64,
    step: f64,
    factor: u64,
    /// Contact points of each interface.
    interfaces: Vec<Range<usize>>,
    /// N and T of each interface.
    forces: Vec<f64>,
    /// The velocity of each point along the slip, then acceleration and velocity of each observed displacement.
    values: Vec<f64>,
    /// Velocities of the observed points now and a step before.
    watched: [Vec<f64>; 2],
    steps: u64,
    /// What the filter has let through.
    outputs: u64,
    samples: WaitingSamples,
}

/// Samples that are not stored yet.
#[derive(Default)]
struct WaitingSamples {
    time: Vec<f64>,
    /// A column for each of the forces and the values but the velocities of the points,
    columns: Vec<Vec<f64>>,
    /// which have a row a sample, as states and normal forces of the points at their times have.
    velocities: Vec<f64>,
    state_time: Vec<f64>,
    states: Vec<u8>,
    normal_forces: Vec<f64>,
}

/// What a recorder remembers beside the samples that were taken from it, for a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct RecordedState {
    filter: Option<DecimatorState>,
    means: Option<WindowMeans>,
    watched: Vec<f64>,
    steps: u64,
    outputs: u64,
}

impl Recorded {
    /// Of a march with so many points an interface and so many observed displacements, with at least so many samples a second.
    pub(super) fn new(
        march: &NonsmoothMarch<'_>,
        counts: &[usize],
        watched: usize,
        rate: f64,
    ) -> Result<Self, ModelError> {
        let step = march.settings().step;
        let mut points = 0;
        let interfaces: Vec<_> = counts
            .iter()
            .map(|count| {
                let own = points..points + count;
                points += count;
                own
            })
            .collect();
        let single = 2 * counts.len() + 2 * watched;
        let forces = vec![0.0; 2 * counts.len()];
        let factor = Decimation::factor_to(1.0 / step, rate);
        let kept = 1.0 / step / factor as f64;
        let mut recorded = Self {
            decimation: Decimation {
                // as the bound of the filter is reckoned: rounding is not to pass it
                stop_edge: kept - PASS * kept,
                ..Decimation::new(1.0 / step, PASS * kept, factor)
            },
            filter: None,
            means: None,
            delay: 0,
            step,
            factor: factor as u64,
            interfaces,
            forces,
            values: vec![0.0; points + 2 * watched],
            watched: [vec![0.0; watched], vec![0.0; watched]],
            steps: 0,
            outputs: 0,
            samples: WaitingSamples { columns: vec![Vec::new(); single], ..WaitingSamples::default() },
        };
        march.observed_velocities(&mut recorded.watched[0]);
        if factor > 1 && !recorded.values.is_empty() {
            recorded.look(march);
            let filter = Decimator::new(&recorded.decimation, &recorded.values)?;
            recorded.delay = filter.delay_in_samples() as u64;
            recorded.means = Some(WindowMeans::beside(&filter, recorded.forces.len()));
            recorded.filter = Some(filter);
        }
        Ok(recorded)
    }

    /// Samples a second that are kept.
    pub(super) fn rate(&self) -> f64 {
        1.0 / (self.step * self.factor as f64)
    }

    /// Up to where signals are what they were, in Hz: all that steps tell, where every step is kept.
    pub(super) fn pass_band(&self) -> f64 {
        if self.filter.is_some() { PASS * self.rate() } else { 0.5 * self.rate() }
    }

    fn points(&self) -> usize {
        self.interfaces.last().map_or(0, |last| last.end)
    }

    fn look(&mut self, march: &NonsmoothMarch<'_>) {
        for (k, points) in self.interfaces.iter().enumerate() {
            let mut sums = [0.0; 2];
            for point in points.clone() {
                let [normal, friction, _] = march.force(point);
                sums[0] += normal;
                sums[1] += friction;
                self.values[point] = march.velocity(point)[1];
            }
            self.forces[2 * k..2 * k + 2].copy_from_slice(&sums);
        }
        let [now, before] = &mut self.watched;
        std::mem::swap(now, before);
        march.observed_velocities(now);
        let first = self.values.len() - 2 * now.len();
        for (k, (now, before)) in now.iter().zip(before).enumerate() {
            self.values[first + 2 * k] = (now - *before) / self.step;
            self.values[first + 2 * k + 1] = *now;
        }
    }

    /// Takes the step that a march has come to.
    pub(super) fn take(&mut self, march: &NonsmoothMarch<'_>) {
        self.look(march);
        let points = self.points();
        if let Some(means) = &mut self.means {
            means.push(&self.forces);
        }
        let passed = match &mut self.filter {
            Some(filter) => filter.push(&self.values),
            None => Some(&self.values[..]),
        };
        if let Some(passed) = passed {
            let time = sample_time(self.outputs, self.factor, self.delay, self.step);
            self.outputs += 1;
            if let (Some(means), Some(_)) = (&mut self.means, time) {
                means.take(&mut self.forces);
            }
            self.samples.push(time, &self.forces, passed, points);
        }
        if self.steps.is_multiple_of(self.factor) && self.points() > 0 {
            self.samples.state_time.push((self.steps + 1) as f64 * self.step);
            for point in 0..self.points() {
                self.samples.states.push(state(march, point).number());
                self.samples.normal_forces.push(march.force(point)[0]);
            }
        }
        self.steps += 1;
    }

    /// Lets the rest out of the filter, as if the signals stayed at their last values; the march has ended.
    pub(super) fn flush(&mut self) {
        let points = self.points();
        let tails = self.filter.clone().map(Decimator::finish).unwrap_or_default();
        for k in 0..tails.first().map_or(0, Vec::len) {
            let passed: Vec<f64> = tails.iter().map(|tail| tail[k]).collect();
            let time = sample_time(self.outputs, self.factor, self.delay, self.step);
            self.outputs += 1;
            if let (Some(means), Some(_)) = (&mut self.means, time) {
                means.take(&mut self.forces);
            }
            self.samples.push(time, &self.forces, &passed, points);
        }
    }

    /// What waits to be stored, in the order of [`growing`](super::arrays::growing).
    pub(super) fn slices(&self) -> Vec<StreamSlice<'_>> {
        let WaitingSamples { time, columns, velocities, state_time, states, normal_forces } = &self.samples;
        let columns = columns.iter().map(|column| StreamSlice::F64(column));
        let of_points = [
            StreamSlice::F64(velocities),
            StreamSlice::F64(state_time),
            StreamSlice::U8(states),
            StreamSlice::F64(normal_forces),
        ];
        let of_points = of_points.into_iter().filter(|_| self.points() > 0);
        std::iter::once(StreamSlice::F64(time)).chain(columns).chain(of_points).collect()
    }

    /// Bytes that wait.
    pub(super) fn waiting(&self) -> usize {
        let WaitingSamples { time, columns, velocities, states, normal_forces, .. } = &self.samples;
        let numbers = time.len() * (1 + columns.len()) + velocities.len() + normal_forces.len();
        8 * numbers + states.len()
    }

    /// Forgets the samples, which have been stored elsewhere.
    pub(super) fn clear(&mut self) {
        let WaitingSamples { time, columns, velocities, state_time, states, normal_forces } =
            &mut self.samples;
        let single = [time, velocities, state_time, normal_forces];
        single.into_iter().chain(columns).for_each(Vec::clear);
        states.clear();
    }

    /// What it remembers.
    pub(super) fn state(&self) -> RecordedState {
        RecordedState {
            filter: self.filter.as_ref().map(Decimator::state),
            means: self.means.clone(),
            watched: self.watched[0].clone(),
            steps: self.steps,
            outputs: self.outputs,
        }
    }

    /// Goes on from where a recorder of the same march was, to the bit.
    pub(super) fn resume(&mut self, state: &RecordedState) -> Result<(), ModelError> {
        let signals = |means: &Option<WindowMeans>| means.as_ref().map(WindowMeans::signals);
        let fits = state.watched.len() == self.watched[0].len()
            && state.filter.is_some() == self.filter.is_some()
            && signals(&state.means) == signals(&self.means);
        if !fits {
            return Err(NonsmoothError::ForeignCheckpoint.into());
        }
        if let Some(kept) = &state.filter {
            let filter = Decimator::resumed(&self.decimation, kept)?;
            if filter.signals() != self.values.len() {
                return Err(NonsmoothError::ForeignCheckpoint.into());
            }
            self.filter = Some(filter);
        }
        self.means.clone_from(&state.means);
        self.watched[0].copy_from_slice(&state.watched);
        (self.steps, self.outputs) = (state.steps, state.outputs);
        Ok(())
    }
}

impl WaitingSamples {
    /// A sample of forces and values, of which the first are the velocities of so many points; none before the first step.
    fn push(&mut self, time: Option<f64>, forces: &[f64], values: &[f64], points: usize) {
        let (Some(time), false) = (time, values.is_empty()) else { return };
        self.time.push(time);
        let (velocities, observed) = values.split_at(points);
        self.velocities.extend_from_slice(velocities);
        let single = forces.iter().chain(observed);
        self.columns.iter_mut().zip(single).for_each(|(column, value)| column.push(*value));
    }
}

/// When an output of a filter is, counted from 0, in s; none of those that show the level from which it started.
fn sample_time(output: u64, factor: u64, delay: u64, step: f64) -> Option<f64> {
    let input = (output * factor).checked_sub(delay)?;
    Some((input + 1) as f64 * step)
}

/// What a point of a march does.
fn state(march: &NonsmoothMarch<'_>, point: usize) -> ContactState {
    named_state(march.motion(point), march.force(point)[1])
}

/// What a point does with this friction along the slip, by the names that every model has.
pub(in crate::assembly) fn named_state(motion: PointMotion, friction: f64) -> ContactState {
    match motion {
        PointMotion::Open => ContactState::LiftOff,
        PointMotion::Stick => ContactState::Stick,
        // friction drags the slider with the track while it lags behind it
        PointMotion::Slip if friction >= 0.0 => ContactState::SlipBehind,
        PointMotion::Slip => ContactState::SlipAhead,
    }
}
