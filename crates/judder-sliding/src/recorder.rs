//! What is kept of a march: signals, low-passed and decimated while it runs, and the extremes of every step.

use crate::SlidingError;
use crate::march::{ContactState, MarchSample, Sink};
use crate::motion::Motion;
use crate::pair::Pair;
use judder_numerics::signal::Decimation;
use judder_numerics::signal::SignalError;
use judder_numerics::signal::decimate::{Decimator, DecimatorState};
use judder_numerics::signal::extremes::Extremes;
use serde::{Deserialize, Serialize};

/// A signal of a march.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Channel {
    /// ü of an observed displacement, m/s².
    Acceleration(usize),
    /// u̇ of an observed displacement, m/s.
    Velocity(usize),
    /// u of an observed displacement, m, with what the slider's frame has moved since the start.
    Displacement(usize),
    /// N, N.
    NormalForce,
    /// T on the slider, N.
    TangentialForce,
    /// Of C along the track's own material, m/s.
    SlidingVelocity,
}

/// Extremes of all steps after the ramps, and how many of them each state of the contact had: every step counts once.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Tally {
    /// Of N, N; with the steps, counted from 1.
    pub normal_force: Extremes,
    /// Of the sliding velocity, m/s.
    pub sliding_velocity: Extremes,
    /// Steps in which closed contact slid along with the motion.
    pub slip_steps: u64,
    /// Steps in which C stuck.
    pub stick_steps: u64,
    /// Steps in which it had lifted off.
    pub open_steps: u64,
    /// Steps in which closed contact slid against the direction of the motion.
    pub reversed_steps: u64,
}

/// Two displacements of the steps before, for velocities by central differences.
type Past = [f64; 2];

/// Takes the steps of a march and keeps of them what is asked for; one sample in so many of each signal.
///
/// All signals are of the same instants: those of a step before the last, since accelerations and velocities are central differences.
/// The filters' delay is taken out of the times. Allocates nothing in a step once there is [`reserve`](Self::reserve)d room.
#[derive(Debug, Clone)]
pub struct Recorder {
    motion: Motion,
    step: f64,
    factor: u64,
    delay: u64,
    channels: Vec<Channel>,
    /// The channels' values in this step.
    values: Vec<f64>,
    /// What the motion of the slider's frame adds to each observed displacement.
    rigid: Vec<f64>,
    filter: Decimator,
    /// Time, position, then a column a channel.
    columns: Vec<Vec<f64>>,
    /// Times of states in s, and the numbers of these.
    states: (Vec<f64>, Vec<u8>),
    steps: u64,
    outputs: u64,
    /// N, T and sliding velocity of the step before.
    contact: [f64; 3],
    past: Vec<Past>,
    moved: Vec<f64>,
    tally: Tally,
}

/// What a [`Recorder`] remembers beside the samples that were taken from it, for a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecorderState {
    filter: DecimatorState,
    steps: u64,
    outputs: u64,
    contact: [f64; 3],
    past: Vec<Past>,
    tally: Tally,
}

impl Recorder {
    /// Keeps these channels of a march from its start; the input rate of `decimation` is one sample a step.
    ///
    /// # Errors
    /// A decimation that cannot be.
    pub fn new(
        pair: &Pair,
        motion: &Motion,
        channels: &[Channel],
        decimation: &Decimation,
    ) -> Result<Self, SignalError> {
        let start = [0.0, 0.0, motion.at(0.0).velocity];
        let level = |channel: &Channel| match channel {
            Channel::SlidingVelocity => start[2],
            _ => 0.0,
        };
        let levels: Vec<f64> = channels.iter().map(level).collect();
        let filter = Decimator::new(decimation, &levels)?;
        let delay = filter.delay_in_samples() as u64;
        Ok(Self {
            motion: *motion,
            step: 1.0 / decimation.sample_rate,
            factor: decimation.factor as u64,
            delay,
            channels: channels.to_vec(),
            rigid: pair.observed().iter().map(|point| point.rigid).collect(),
            filter,
            values: levels,
            columns: vec![Vec::new(); 2 + channels.len()],
            states: (Vec::new(), Vec::new()),
            steps: 0,
            outputs: 0,
            contact: start,
            past: vec![[0.0; 2]; pair.observed().len()],
            moved: vec![0.0; pair.observed().len()],
            tally: Tally::default(),
        })
    }

    /// Makes room for what so many more steps leave.
    pub fn reserve(&mut self, steps: u64) {
        let samples = (steps / self.factor + 2) as usize;
        for column in &mut self.columns {
            column.reserve(samples);
        }
        self.states.0.reserve(samples);
        self.states.1.reserve(samples);
    }

    /// The samples since they were last cleared: times in s, positions of C without deformation in m, then a column a channel.
    #[must_use]
    pub fn columns(&self) -> Vec<&[f64]> {
        self.columns.iter().map(Vec::as_slice).collect()
    }

    /// The states of the contact since they were last cleared, those of every so many-th step as of signals: times in s, and their numbers
    /// ([`ContactState::number`]).
    #[must_use]
    pub fn states(&self) -> (&[f64], &[u8]) {
        (&self.states.0, &self.states.1)
    }

    /// Forgets the samples, which have been stored elsewhere.
    pub fn clear(&mut self) {
        for column in &mut self.columns {
            column.clear();
        }
        self.states.0.clear();
        self.states.1.clear();
    }

    /// Lets the rest out of the filters, as if the signals stayed at their last values; the march has ended.
    pub fn flush(&mut self) {
        let tails = self.filter.clone().finish();
        for k in 0..tails.first().map_or(0, Vec::len) {
            if self.begin_sample() {
                for (column, tail) in self.columns[2..].iter_mut().zip(&tails) {
                    column.push(tail[k]);
                }
            }
        }
    }

    /// Extremes and counts so far.
    #[must_use]
    pub fn tally(&self) -> &Tally {
        &self.tally
    }

    /// What it remembers.
    #[must_use]
    pub fn state(&self) -> RecorderState {
        RecorderState {
            filter: self.filter.state(),
            steps: self.steps,
            outputs: self.outputs,
            contact: self.contact,
            past: self.past.clone(),
            tally: self.tally,
        }
    }

    /// Goes on from where a recorder of the same march was, to the bit.
    ///
    /// # Errors
    /// [`SlidingError::ForeignCheckpoint`].
    pub fn resume(&mut self, decimation: &Decimation, state: &RecorderState) -> Result<(), SlidingError> {
        let filter =
            Decimator::resumed(decimation, &state.filter).map_err(|_| SlidingError::ForeignCheckpoint)?;
        if filter.signals() != self.channels.len() || state.past.len() != self.past.len() {
            return Err(SlidingError::ForeignCheckpoint);
        }
        (self.filter, self.steps, self.outputs) = (filter, state.steps, state.outputs);
        (self.contact, self.tally) = (state.contact, state.tally);
        self.past.clone_from(&state.past);
        Ok(())
    }

    /// Counts an output of the filters; writes its time and position where it lies within the march.
    #[inline]
    fn begin_sample(&mut self) -> bool {
        let input = self.outputs * self.factor;
        self.outputs += 1;
        let Some(at) = input.checked_sub(self.delay) else { return false };
        let time = at as f64 * self.step;
        self.columns[0].push(time);
        self.columns[1].push(self.motion.at(time).position);
        true
    }

    /// The value of a channel at the step before this one.
    #[inline]
    fn value(&self, channel: Channel, accelerations: &[f64]) -> f64 {
        match channel {
            Channel::Acceleration(k) => accelerations[k],
            Channel::Velocity(k) => 0.5 * (self.moved[k] - self.past[k][1]) / self.step,
            Channel::Displacement(k) => self.past[k][0],
            Channel::NormalForce => self.contact[0],
            Channel::TangentialForce => self.contact[1],
            Channel::SlidingVelocity => self.contact[2],
        }
    }

    fn count(&mut self, sample: &MarchSample) {
        let tally = &mut self.tally;
        tally.normal_force.update(self.steps, sample.normal_force);
        tally.sliding_velocity.update(self.steps, sample.sliding_velocity);
        match sample.state {
            ContactState::Stick => tally.stick_steps += 1,
            ContactState::LiftOff => tally.open_steps += 1,
            ContactState::SlipAhead => tally.reversed_steps += 1,
            ContactState::SlipBehind => tally.slip_steps += 1,
        }
    }
}

impl Sink for Recorder {
    #[inline]
    fn displaced(&mut self, point: usize, displacement: f64, position: f64) {
        self.moved[point] = displacement + self.rigid[point] * (position - self.motion.start);
    }

    #[inline]
    fn take(&mut self, sample: &MarchSample, accelerations: &[f64]) {
        self.steps += 1;
        let is_due = (self.steps - 1).is_multiple_of(self.factor);
        if is_due {
            self.states.0.push(sample.time);
            self.states.1.push(sample.state.number());
        }
        let is_kept = is_due && self.begin_sample();
        for k in 0..self.channels.len() {
            self.values[k] = self.value(self.channels[k], accelerations);
        }
        if let Some(passed) = self.filter.push(&self.values)
            && is_kept
        {
            for (column, value) in self.columns[2..].iter_mut().zip(passed) {
                column.push(*value);
            }
        }
        for (past, moved) in self.past.iter_mut().zip(&self.moved) {
            *past = [*moved, past[0]];
        }
        self.contact = [sample.normal_force, sample.tangential_force, sample.sliding_velocity];
        if sample.time > self.motion.settled() {
            self.count(sample);
        }
    }
}
