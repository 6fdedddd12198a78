//! What is kept of a motion: signals, low-passed as they are thinned, and the states of all points at their times.

use crate::error::ModelError;
use judder_nonsmooth::contact_problem::PointMotion;
use judder_nonsmooth::march::NonsmoothMarch;
use judder_numerics::contact_state::ContactState;
use judder_numerics::signal::Decimation;
use judder_numerics::signal::decimate::Decimator;

/// Of the rate of the samples, what signals keep.
const PASS: f64 = 0.4;

/// Takes the steps of a motion.
pub(super) struct Recorded {
    filter: Option<Decimator>,
    step: f64,
    factor: u64,
    /// Contact points of each interface.
    interfaces: Vec<std::ops::Range<usize>>,
    values: Vec<f64>,
    /// Velocities of the observed points now and a step before.
    watched: [Vec<f64>; 2],
    steps: u64,
    /// N and T of each interface, then the velocity of each point along the slip, then acceleration and velocity of each observed
    /// displacement: a column each.
    columns: Vec<Vec<f64>>,
    pub(super) states: Vec<u8>,
    pub(super) normal_forces: Vec<f64>,
    state_steps: Vec<u64>,
}

/// Signals at their times.
pub(super) struct Signals {
    pub(super) time: Vec<f64>,
    pub(super) columns: Vec<Vec<f64>>,
    pub(super) rate: f64,
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
        let mut first = 0;
        let interfaces: Vec<_> = counts
            .iter()
            .map(|count| {
                let own = first..first + count;
                first += count;
                own
            })
            .collect();
        let channels = 2 * counts.len() + first + 2 * watched;
        let factor = Decimation::factor_to(1.0 / step, rate);
        let mut recorded = Self {
            filter: None,
            step,
            factor: factor as u64,
            interfaces,
            values: vec![0.0; channels],
            watched: [vec![0.0; watched], vec![0.0; watched]],
            steps: 0,
            columns: vec![Vec::new(); channels],
            states: Vec::new(),
            normal_forces: Vec::new(),
            state_steps: Vec::new(),
        };
        march.observed_velocities(&mut recorded.watched[0]);
        if factor > 1 && channels > 0 {
            let kept = 1.0 / step / factor as f64;
            let asked = Decimation {
                stop_edge: (1.0 - PASS) * kept,
                ..Decimation::new(1.0 / step, PASS * kept, factor)
            };
            recorded.look(march);
            recorded.filter = Some(Decimator::new(&asked, &recorded.values)?);
        }
        Ok(recorded)
    }

    fn look(&mut self, march: &NonsmoothMarch<'_>) {
        for (k, points) in self.interfaces.iter().enumerate() {
            let mut sums = [0.0; 2];
            for point in points.clone() {
                let [normal, friction, _] = march.force(point);
                sums[0] += normal;
                sums[1] += friction;
                self.values[2 * self.interfaces.len() + point] = march.velocity(point)[1];
            }
            self.values[2 * k..2 * k + 2].copy_from_slice(&sums);
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
        match &mut self.filter {
            Some(filter) => {
                if let Some(passed) = filter.push(&self.values) {
                    self.columns.iter_mut().zip(passed).for_each(|(column, value)| column.push(*value));
                }
            }
            None => self.columns.iter_mut().zip(&self.values).for_each(|(column, value)| column.push(*value)),
        }
        if self.steps.is_multiple_of(self.factor) {
            self.state_steps.push(self.steps);
            for point in 0..self.interfaces.last().map_or(0, |last| last.end) {
                self.states.push(state(march, point).number());
                self.normal_forces.push(march.force(point)[0]);
            }
        }
        self.steps += 1;
    }

    /// When the states are, in s.
    pub(super) fn state_times(&self) -> Vec<f64> {
        self.state_steps.iter().map(|step| (step + 1) as f64 * self.step).collect()
    }

    /// The signals; their delay is taken out of their times.
    pub(super) fn signals(&mut self) -> Signals {
        let rate = 1.0 / (self.step * self.factor as f64);
        let mut columns = std::mem::take(&mut self.columns);
        let delay = match self.filter.take() {
            Some(filter) => {
                let delay = filter.delay_in_samples() as u64;
                for (column, rest) in columns.iter_mut().zip(filter.finish()) {
                    column.extend(rest);
                }
                delay
            }
            None => 0,
        };
        // outputs before the first input show the level from which the filter started
        let early = delay.div_ceil(self.factor) as usize;
        columns.iter_mut().for_each(|column| drop(column.drain(..early.min(column.len()))));
        let count = columns.first().map_or(0, Vec::len);
        let time = |k: usize| ((k + early) as u64 * self.factor + 1 - delay) as f64 * self.step;
        Signals { time: (0..count).map(time).collect(), columns, rate }
    }
}

/// What a point does, by the names that every model has.
fn state(march: &NonsmoothMarch<'_>, point: usize) -> ContactState {
    match march.motion(point) {
        PointMotion::Open => ContactState::LiftOff,
        PointMotion::Stick => ContactState::Stick,
        // friction drags the slider with the track while it lags behind it
        PointMotion::Slip if march.force(point)[1] >= 0.0 => ContactState::SlipBehind,
        PointMotion::Slip => ContactState::SlipAhead,
    }
}
