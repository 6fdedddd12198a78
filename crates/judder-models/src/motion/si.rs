//! Motions in SI: what the units of a model are in seconds and metres, where its case is written in SI.
//!
//! - `arrays`: what that makes of arrays and tables.

mod arrays;

use judder_store::Results;
use std::f64::consts::TAU;

pub(crate) use arrays::{second_of, shown, stored_beside};

/// The units of a model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SiUnits {
    /// That of time, in s: 1/ω_nx of the oscillator.
    pub(crate) second: f64,
    /// That of displacements, in m: x0 = F_n/k_x of the oscillator.
    pub(crate) metre: f64,
    /// That of energies, in J: k_x x0² of the oscillator.
    pub(crate) joule: f64,
    /// That of contact areas, in m²: R² of the oscillator.
    pub(crate) square_metre: f64,
}

/// Where energy came from and went: the works after the transient and the change of what is stored.
#[derive(Debug, Clone, Copy, PartialEq, Results)]
pub(crate) struct EnergyFlow {
    pub(crate) substrate: f64,
    pub(crate) sliding: f64,
    pub(crate) friction: f64,
    pub(crate) normal: f64,
    pub(crate) damping: f64,
    pub(crate) change: f64,
}

impl EnergyFlow {
    /// All times a unit.
    fn times(self, unit: f64) -> Self {
        Self {
            substrate: unit * self.substrate,
            sliding: unit * self.sliding,
            friction: unit * self.friction,
            normal: unit * self.normal,
            damping: unit * self.damping,
            change: unit * self.change,
        }
    }
}

/// What is told of a motion in SI.
#[derive(Debug, Clone, Copy, PartialEq, Results)]
pub(crate) struct MotionInSi {
    /// rms of x about its mean
    #[result(unit = "m")]
    rms_m: f64,
    /// mean of x
    #[result(unit = "m")]
    mean_m: f64,
    /// of a cycle; the mean time of an oscillation where there is none
    #[result(unit = "s")]
    period_s: Option<f64>,
    /// its inverse
    #[result(unit = "Hz")]
    frequency_hz: Option<f64>,
    /// where energy came from and went, in J
    energy_j: EnergyFlow,
}

impl SiUnits {
    /// A motion in SI.
    pub(crate) fn motion(self, [rms, mean]: [f64; 2], period: Option<f64>, energy: EnergyFlow) -> MotionInSi {
        let period_s = period.map(|period| period * self.second);
        MotionInSi {
            rms_m: rms * self.metre,
            mean_m: mean * self.metre,
            period_s,
            frequency_hz: period_s.map(f64::recip),
            energy_j: energy.times(self.joule),
        }
    }

    /// A circular frequency in Hz.
    pub(crate) fn hertz(self, frequency: f64) -> f64 {
        frequency / (TAU * self.second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_in_si_is_that_in_groups_times_its_units() {
        let units = SiUnits { second: 0.025, metre: 4e-3, joule: 8e-4, square_metre: 1e-4 };
        let [substrate, sliding, friction, normal, damping, change] = [3.0, -1.0, 2.0, 0.5, -2.0, 0.5];
        let energy = EnergyFlow { substrate, sliding, friction, normal, damping, change };
        let motion = units.motion([0.5, 1.0], Some(6.0), energy);
        assert_eq!((motion.energy_j.friction, motion.energy_j.change), (1.6e-3, 4e-4));
        assert_eq!(motion.rms_m, 2e-3);
        assert!((motion.period_s.unwrap() - 0.15).abs() < 1e-15);
        assert!((motion.frequency_hz.unwrap() - 1.0 / 0.15).abs() < 1e-12);
    }
}
