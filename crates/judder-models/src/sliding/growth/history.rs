//! How the normal force swings while the contact is held: what the growth rate is taken from, as a history.

use crate::error::ModelError;
use judder_store::{Dataset, Variable};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// The largest deviation of the normal force from its rest in every period of a mode.
pub(super) struct ForceHistory {
    /// rad/s.
    frequency: f64,
    /// s.
    times: Vec<f64>,
    /// N.
    amplitudes: Vec<f64>,
}

impl ForceHistory {
    /// Of a mode's periods.
    pub(super) fn of(eigenvalue: Complex64) -> Self {
        Self { frequency: eigenvalue.im, times: Vec::new(), amplitudes: Vec::new() }
    }

    /// One more deviation in N, at a time in s.
    pub(super) fn see(&mut self, time: f64, deviation: f64) {
        let (period, swing) = ((time * self.frequency / TAU) as usize, deviation.abs());
        if period >= self.times.len() {
            self.times.push(time);
            self.amplitudes.push(swing);
        } else if self.amplitudes[period] < swing {
            (self.times[period], self.amplitudes[period]) = (time, swing);
        }
    }

    /// A dataset with this history, but for the last period, which is not whole.
    pub(super) fn kept(mut self, dataset: Dataset) -> Result<Dataset, ModelError> {
        self.times.pop();
        self.amplitudes.pop();
        let amplitude = Variable::new("amplitude", &["time"], &[self.times.len()], self.amplitudes);
        let words = "largest deviation of the normal force from its rest in each period";
        Ok(dataset
            .with(Variable::coordinate("time", self.times).units("s").long_name("time since the start"))?
            .with(amplitude.units("N").long_name(words))?)
    }
}
