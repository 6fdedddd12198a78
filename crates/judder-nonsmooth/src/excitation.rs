//! Forces that follow signals: functions of time alone, the same for every scheme and step.

mod band_noise;

pub use band_noise::BandNoise;

use crate::NonsmoothError;
use crate::course::{TimeFactor, TimeTable};
use std::f64::consts::TAU;

/// A signal over time, in the unit of what it is for: N, or m/s².
#[derive(Debug, Clone, PartialEq)]
pub enum DrivingSignal {
    /// a sin(ω t + φ).
    Sine {
        /// a.
        amplitude: f64,
        /// ω in rad/s.
        angular_frequency: f64,
        /// φ in rad.
        phase: f64,
    },
    /// A sine whose frequency changes.
    Sweep(FrequencySweep),
    /// Random, within a band of frequencies.
    Random(BandNoise),
    /// Samples, straight between them.
    Samples(TimeTable),
    /// How fast a factor changes, in 1/s: a share of the inertia of what is carried along with it.
    Rate(TimeFactor),
}

/// a sin φ(t), φ̇ = ω from one frequency to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrequencySweep {
    /// a.
    pub amplitude: f64,
    /// ω at the start, in rad/s.
    pub from: f64,
    /// ω at the end of the duration, in rad/s; it goes on as it came.
    pub to: f64,
    /// How long it takes from one to the other, in s.
    pub duration: f64,
    /// Whether the logarithm of the frequency grows evenly, not the frequency itself.
    pub is_logarithmic: bool,
}

/// Forces that follow a signal.
#[derive(Debug, Clone, PartialEq)]
pub struct Excitation {
    /// The signal.
    pub signal: DrivingSignal,
    /// Forces on the freedoms in N per unit of the signal.
    pub forces: Vec<f64>,
}

impl FrequencySweep {
    /// φ at a time in s.
    fn phase(&self, time: f64) -> f64 {
        let Self { from, to, duration, .. } = *self;
        if from == to {
            return from * time;
        }
        match self.is_logarithmic {
            true => {
                let rate = libm::log(to / from) / duration;
                from / rate * libm::expm1(rate * time)
            }
            false => time * (from + 0.5 * (to - from) * time / duration),
        }
    }
}

impl DrivingSignal {
    /// Whether its numbers make a signal that steps of this length in s can follow.
    ///
    /// # Errors
    /// [`NonsmoothError::InvalidNumber`], [`NonsmoothError::SignalTooFast`], and what [`TimeTable::check`] says.
    pub fn check(&self, step: f64) -> Result<(), NonsmoothError> {
        let refused =
            |name, value, requirement| Err(NonsmoothError::InvalidNumber { name, value, requirement });
        let numbers: &[(&'static str, f64)] = match self {
            Self::Sine { amplitude, angular_frequency, phase } => &[
                ("the amplitude of a signal", *amplitude),
                ("the frequency of a signal", *angular_frequency),
                ("the phase of a signal", *phase),
            ],
            Self::Sweep(own) => &[
                ("the amplitude of a signal", own.amplitude),
                ("the first frequency of a sweep", own.from),
                ("the last frequency of a sweep", own.to),
                ("the duration of a sweep", own.duration),
            ],
            Self::Random(noise) => return noise.check().and_then(|()| self.check_speed(step)),
            Self::Samples(samples) => return samples.check(),
            Self::Rate(factor) => return factor.check(),
        };
        if let Some((name, value)) = numbers.iter().find(|(_, value)| !value.is_finite()) {
            return refused(name, *value, "finite");
        }
        if let Self::Sweep(own) = self {
            let lowest = own.from.min(own.to);
            if lowest < 0.0 || (own.is_logarithmic && lowest == 0.0) {
                let requirement = if own.is_logarithmic { "positive" } else { "not negative" };
                return refused("a frequency of a sweep", lowest / TAU, requirement);
            }
            if own.duration <= 0.0 {
                return refused("the duration of a sweep", own.duration, "positive");
            }
        }
        self.check_speed(step)
    }

    /// Refuses a signal whose frequency is above half the rate of the steps.
    fn check_speed(&self, step: f64) -> Result<(), NonsmoothError> {
        let frequency = self.highest_frequency().map_or(0.0, |omega| omega / TAU);
        match frequency * step <= 0.5 {
            true => Ok(()),
            false => Err(NonsmoothError::SignalTooFast { frequency, step }),
        }
    }

    /// Whether it lasts as long as a motion, in s.
    ///
    /// # Errors
    /// [`NonsmoothError::SignalEnds`].
    pub fn covers(&self, duration: f64) -> Result<(), NonsmoothError> {
        /// What the times of a file may be off by rounding, as a share of the duration.
        const ROUNDING: f64 = 1e-9;
        let Self::Samples(TimeTable { times, .. }) = self else { return Ok(()) };
        let (begins, ends) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
        let allowed = ROUNDING * duration;
        match begins <= allowed && ends >= duration - allowed {
            true => Ok(()),
            false => Err(NonsmoothError::SignalEnds { begins, ends, duration }),
        }
    }

    /// The highest frequency that it has, in rad/s; of samples and rates none is known.
    #[must_use]
    pub fn highest_frequency(&self) -> Option<f64> {
        match self {
            Self::Sine { angular_frequency, .. } => Some(angular_frequency.abs()),
            Self::Sweep(FrequencySweep { from, to, .. }) => Some(from.max(*to)),
            Self::Random(noise) => Some(noise.band[1]),
            Self::Samples(_) | Self::Rate(_) => None,
        }
    }

    /// Its value at a time in s; a random one remembers what it has drawn near it.
    #[must_use]
    pub fn at(&mut self, time: f64) -> f64 {
        match self {
            Self::Sine { amplitude, angular_frequency, phase } => {
                *amplitude * libm::sin(*angular_frequency * time + *phase)
            }
            Self::Sweep(own) => own.amplitude * libm::sin(own.phase(time)),
            Self::Random(noise) => noise.at(time),
            Self::Samples(samples) => samples.at(time),
            Self::Rate(factor) => factor.rate(time),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hertz(frequency: f64) -> f64 {
        TAU * frequency
    }

    /// The frequency of a sweep, from its phase, is at either end and halfway what it says.
    #[test]
    fn sweeps_go_from_one_frequency_to_the_other() {
        for (is_logarithmic, ends, halfway) in [
            (false, [10.0, 90.0], 50.0),
            (true, [10.0, 90.0], 30.0),
            (true, [90.0, 10.0], 30.0),
            (false, [5.0; 2], 5.0),
        ] {
            let [from, to] = ends.map(hertz);
            let sweep = FrequencySweep { amplitude: 1.0, from, to, duration: 4.0, is_logarithmic };
            let frequency = |time: f64| (sweep.phase(time + 1e-5) - sweep.phase(time - 1e-5)) / 2e-5 / TAU;
            for (time, expected) in [(0.0, ends[0]), (2.0, halfway), (4.0, ends[1])] {
                assert!((frequency(time) - expected).abs() < 1e-3, "{sweep:?} {time}: {}", frequency(time));
            }
            assert_eq!(DrivingSignal::Sweep(sweep).at(0.0), 0.0);
        }
    }

    #[test]
    fn signals_that_are_none_are_refused() {
        let step = 1e-3;
        let refused = |signal: DrivingSignal| signal.check(step).unwrap_err().to_string();
        let sine = |frequency: f64| DrivingSignal::Sine {
            amplitude: 1.0,
            angular_frequency: hertz(frequency),
            phase: 0.0,
        };
        assert!(sine(499.0).check(step).is_ok());
        assert_eq!(
            refused(sine(600.0)),
            "a signal of up to 600 Hz is too fast for steps of 0.001 s, which show no more than 500 Hz: shorten the step"
        );
        assert!(refused(sine(f64::NAN)).contains("the frequency of a signal is NaN: it must be finite"));
        let sweep = |from: f64, duration: f64, is_logarithmic: bool| {
            DrivingSignal::Sweep(FrequencySweep {
                amplitude: 1.0,
                from: hertz(from),
                to: hertz(20.0),
                duration,
                is_logarithmic,
            })
        };
        assert!(refused(sweep(0.0, 1.0, true)).contains("a frequency of a sweep is 0: it must be positive"));
        assert!(refused(sweep(-1.0, 1.0, false)).contains("is -1: it must be not negative"));
        assert!(
            refused(sweep(1.0, 0.0, false)).contains("the duration of a sweep is 0: it must be positive")
        );
        assert!(sweep(0.0, 1.0, false).check(step).is_ok());
        let samples = |times: &[f64]| {
            DrivingSignal::Samples(TimeTable { times: times.to_vec(), values: vec![1.0; times.len()] })
        };
        assert!(refused(samples(&[0.0, 0.0])).contains("it must be above the one before"));
        assert!(samples(&[0.0, 1.0]).covers(1.0 + 1e-12).is_ok());
        assert_eq!(
            samples(&[0.0, 1.0]).covers(2.0).unwrap_err().to_string(),
            "the samples of a signal go from 0 to 1 s, the motion from 0 to 2 s: they must cover it"
        );
        assert!(samples(&[0.5, 3.0]).covers(2.0).is_err());
    }
}
