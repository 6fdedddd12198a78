//! What is prescribed: motion, load, and how both begin.

use crate::SlidingError;
#[cfg(feature = "keys")]
use judder_keys::{
    declared::{Number, UNLIMITED, Whole},
    dimension::Dimension,
};
use judder_numerics::counter::uniform;
use judder_numerics::ramp::half_cosine;
use std::f64::consts::PI;

#[cfg(feature = "keys")]
const DURATION: Number = Number::non_negative(Dimension::TIME);

/// The prescribed motion of the slider, its load, and their ramps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Distance of C from the track's first node at the start, m.
    pub start: f64,
    /// Where the march ends, m.
    pub end: f64,
    /// Speed of the slider's frame after its ramp, m/s; negative towards the first node.
    pub velocity: f64,
    /// Load in N after its ramp, in the direction of the slider's load.
    pub load: f64,
    /// Gap, or negative penetration, between C and the track at the start, m; closed over its ramp.
    pub initial_gap: f64,
    /// A random force on C, against which bursts start.
    pub noise: Noise,
    /// How long speed, load, friction and an initial gap take to their values, s.
    pub ramps: Ramps,
    /// Damping at the start; `None` where the structures have their own from the start on.
    pub initial_damping: Option<InitialDamping>,
}

/// A random force on C across the track.
///
/// Along its normal: even numbers of a seed, one every [`Noise::INTERVAL`], straight between them.
///
/// It is a function of time alone, the same for every method and step; its spectrum is flat to about a third of 1/INTERVAL.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct Noise {
    /// Root mean square of a random force on C across the track; 0 is none.
    ///
    /// Of the numbers, N.
    #[cfg_attr(feature = "keys", key(rule = Number::non_negative(Dimension::FORCE), symbol = "f_rms", default = 0.0))]
    pub force: f64,
    /// Which one: the same seed gives the same force.
    #[cfg_attr(feature = "keys", key(rule = Whole { from: 0, to: UNLIMITED }, default = 1))]
    pub seed: u64,
}

impl Noise {
    /// From number to number, s.
    pub const INTERVAL: f64 = 1e-5;

    /// The force at a time, N.
    #[must_use]
    pub fn at(&self, time: f64) -> f64 {
        if self.force == 0.0 {
            return 0.0;
        }
        let place = time.max(0.0) / Self::INTERVAL;
        let (number, share) = (place.floor() as u64, place.fract());
        // of −1 … 1 the root mean square is 1/√3
        let drawn = |n| (2.0 * uniform(self.seed, n) - 1.0) * 3.0_f64.sqrt() * self.force;
        drawn(number) * (1.0 - share) + drawn(number + 1) * share
    }
}

/// Times of half a cosine from zero, s; 0 is at once.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct Ramps {
    /// Time over which the velocity rises from zero.
    #[cfg_attr(feature = "keys", key(rule = DURATION, symbol = "T", default = 0.1))]
    pub velocity: f64,
    /// Time over which the load rises from zero.
    #[cfg_attr(feature = "keys", key(rule = DURATION, symbol = "T", default = 0.1))]
    pub load: f64,
    /// Time over which friction rises from zero.
    #[cfg_attr(feature = "keys", key(rule = DURATION, symbol = "T", default = 0.1))]
    pub friction: f64,
    /// Time over which the initial gap closes.
    #[cfg_attr(feature = "keys", key(rule = DURATION, symbol = "T", default = 0.1))]
    pub gap: f64,
}

/// Damping C = α_0 M + β_0 K of both structures at the start, which gives way to their own.
///
/// It is against what a start stirs up.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "keys", derive(judder_keys::Settings))]
pub struct InitialDamping {
    /// Damping of both structures in proportion to their mass at the start.
    ///
    /// α₀, 1/s.
    #[cfg_attr(feature = "keys", key(rule = Number::non_negative(Dimension::RATE), symbol = "α_0", default = 40.0))]
    pub alpha: f64,
    /// Damping of both structures in proportion to their stiffness at the start.
    ///
    /// β₀, s.
    #[cfg_attr(feature = "keys", key(rule = DURATION, symbol = "β_0", default = 4e-8))]
    pub beta: f64,
    /// Time for which it holds.
    ///
    /// In s.
    #[cfg_attr(feature = "keys", key(rule = DURATION, symbol = "T", default = 0.2))]
    pub hold: f64,
    /// Time over which it then gives way to the structures' own.
    ///
    /// In s.
    #[cfg_attr(feature = "keys", key(rule = DURATION, symbol = "T", default = 0.05))]
    pub release: f64,
}

/// What is prescribed at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// Distance of C from the track's first node without deformation, m.
    pub position: f64,
    /// Speed of the slider's frame, m/s.
    pub velocity: f64,
    /// Its acceleration, m/s².
    pub acceleration: f64,
    /// Load, N.
    pub load: f64,
    /// What the friction coefficient is multiplied by.
    pub friction: f64,
    /// Share of the initial gap that is still open.
    pub gap: f64,
    /// Share of the initial damping that is still there.
    pub initial_damping: f64,
    /// Random force on C, N.
    pub noise: f64,
}

impl Motion {
    /// The same motion held at a position, without ramps: what a frozen contact is marched with.
    #[must_use]
    pub fn held(&self, position: f64) -> Self {
        Self {
            start: position,
            end: position,
            velocity: 0.0,
            initial_gap: 0.0,
            noise: Noise::default(),
            ramps: Ramps::default(),
            initial_damping: None,
            ..*self
        }
    }

    /// Whether every number is one and the end lies ahead.
    ///
    /// # Errors
    /// [`SlidingError::InvalidNumber`].
    pub fn check(&self) -> Result<(), SlidingError> {
        let Ramps { velocity, load, friction, gap } = self.ramps;
        let damping = self.initial_damping.map(|d| [d.alpha, d.beta, d.hold, d.release]).unwrap_or_default();
        let durations = [velocity, load, friction, gap].into_iter().chain(damping);
        let refuse = |name: &str, value, requirement| {
            Err(SlidingError::InvalidNumber { name: name.to_owned(), value, requirement })
        };
        for value in durations {
            if !(value.is_finite() && value >= 0.0) {
                return refuse("a ramp or initial damping", value, "finite and not negative");
            }
        }
        for (name, value) in [
            ("the start", self.start),
            ("the end", self.end),
            ("the load", self.load),
            ("the initial gap", self.initial_gap),
            ("the noise", self.noise.force),
        ] {
            if !value.is_finite() {
                return refuse(name, value, "finite");
            }
        }
        if !self.velocity.is_finite() || self.velocity == 0.0 {
            return refuse("the speed", self.velocity, "finite and not zero");
        }
        if (self.end - self.start) * self.velocity <= 0.0 {
            return refuse(
                "the end of the path",
                self.end,
                "ahead of the start in the direction of the speed",
            );
        }
        Ok(())
    }

    /// When every ramp is over, s.
    #[must_use]
    pub fn settled(&self) -> f64 {
        let Ramps { velocity, load, friction, gap } = self.ramps;
        let damping = self.initial_damping.map_or(0.0, |d| d.hold + d.release);
        [velocity, load, friction, gap, damping].into_iter().fold(0.0, f64::max)
    }

    /// How long the path from start to end takes, s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        let path = (self.end - self.start) / self.velocity;
        let ramp = self.ramps.velocity;
        if path >= 0.5 * ramp {
            return path + 0.5 * ramp;
        }
        // within the ramp: bisection, on a function that rises
        let (mut from, mut to) = (0.0, ramp);
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            if self.way(middle) < path { from = middle } else { to = middle }
        }
        to
    }

    /// How far the slider's frame has come, as a multiple of its final speed, s.
    fn way(&self, time: f64) -> f64 {
        let ramp = self.ramps.velocity;
        if time >= ramp {
            return time - 0.5 * ramp;
        }
        0.5 * (time - ramp / PI * libm::sin(PI * time / ramp))
    }

    /// What is prescribed at a time since the start, s.
    #[inline]
    #[must_use]
    pub fn at(&self, time: f64) -> Drive {
        let ramp = self.ramps.velocity;
        let rising = time < ramp;
        let acceleration =
            if rising { self.velocity * 0.5 * PI / ramp * libm::sin(PI * time / ramp) } else { 0.0 };
        let initial_damping = self.initial_damping.map_or(0.0, |damping| {
            if time < damping.hold { 1.0 } else { 1.0 - half_cosine(time - damping.hold, damping.release) }
        });
        Drive {
            position: self.start + self.velocity * self.way(time),
            velocity: self.velocity * half_cosine(time, ramp),
            acceleration,
            load: self.load * half_cosine(time, self.ramps.load),
            friction: half_cosine(time, self.ramps.friction),
            gap: 1.0 - half_cosine(time, self.ramps.gap),
            initial_damping,
            noise: self.noise.at(time),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion() -> Motion {
        Motion {
            start: 0.01,
            end: 0.09,
            velocity: 0.03,
            load: -0.2,
            initial_gap: 0.0,
            noise: Noise::default(),
            ramps: Ramps { velocity: 0.1, load: 0.2, friction: 0.1, gap: 0.0 },
            initial_damping: Some(InitialDamping { alpha: 40.0, beta: 4e-8, hold: 0.2, release: 0.05 }),
        }
    }

    /// Position and speed are the integrals of acceleration, and all is smooth where ramps end.
    #[test]
    fn the_drive_is_consistent() {
        let motion = motion();
        let h = 1e-6;
        for time in [0.01, 0.05, 0.0999, 0.1001, 0.3] {
            let [before, at, after] = [-h, 0.0, h].map(|d| motion.at(time + d));
            let velocity = (after.position - before.position) / (2.0 * h);
            assert!((velocity - at.velocity).abs() < 1e-8, "{time}: {velocity} {}", at.velocity);
            let acceleration = (after.velocity - before.velocity) / (2.0 * h);
            assert!(
                (acceleration - at.acceleration).abs() < 1e-5,
                "{time}: {acceleration} {}",
                at.acceleration
            );
        }
        let end = motion.at(motion.duration());
        assert!((end.position - motion.end).abs() < 1e-15 && end.load == motion.load);
        assert_eq!((motion.at(0.19).initial_damping, motion.at(0.26).initial_damping), (1.0, 0.0));
        assert_eq!(motion.settled(), 0.25);
    }

    /// The numbers have their root mean square; between them the force is straight.
    #[test]
    fn noise_has_its_root_mean_square() {
        let noise = Noise { force: 0.5, seed: 7 };
        let drawn: Vec<f64> = (0..20_000).map(|k| noise.at(f64::from(k) * Noise::INTERVAL)).collect();
        let square = drawn.iter().map(|f| f * f).sum::<f64>() / drawn.len() as f64;
        assert!((square.sqrt() - 0.5).abs() < 0.01);
        let halfway = noise.at(10.5 * Noise::INTERVAL);
        assert!((halfway - 0.5 * (drawn[10] + drawn[11])).abs() < 1e-12);
        assert_eq!(Noise::default().at(0.1), 0.0);
    }

    #[test]
    fn a_path_within_the_ramp_ends_where_it_should() {
        let motion = Motion { end: 0.0105, ..motion() };
        assert!((motion.at(motion.duration()).position - 0.0105).abs() < 1e-12);
    }

    #[test]
    fn an_end_behind_the_start_is_refused() {
        assert!(motion().check().is_ok());
        assert!(Motion { end: 0.0, ..motion() }.check().is_err());
        assert!(Motion { velocity: -0.03, ..motion() }.check().is_err());
        assert!(Motion { velocity: 0.0, ..motion() }.check().is_err());
        assert!(Motion { load: f64::NAN, ..motion() }.check().is_err());
    }
}
