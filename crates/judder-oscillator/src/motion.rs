//! Motion: the equations (12), (13), and what comes of them beyond small disturbances.
//!
//! - [`equations`]: the forces and accelerations of (12), (13), one formula each.
//! - [`sliding_system`]: what the nonsmooth engine and everything built on it ask of an oscillator.
//! - [`stick_slip`]: the oscillator of the paper as such a system.
//! - [`belt`]: the mass on a belt, with one degree of freedom, of the literature's benchmarks.
//! - [`measures`]: averages, fractions of the time, work along a motion.
//! - [`history`]: a motion over a given time.
//! - [`attractor`]: where a motion settles.
//! - [`time_stepping`], [`smoothed`]: two other engines for the same motion, to hold the first against.
//! - [`laps`]: their periods and averages.

pub mod attractor;
pub mod belt;
pub mod equations;
pub mod history;
pub mod laps;
pub mod measures;
pub mod sliding_system;
pub mod smoothed;
pub mod stick_slip;
pub mod time_stepping;

pub use belt::{BeltMode, BeltOscillator, FallingFriction, Friction};
pub use equations::accelerations;
pub use judder_numerics::contact_state::ContactState;
pub use judder_numerics::stopping::Interrupted;
pub use measures::Powers;
pub use sliding_system::SlidingSystem;
pub use smoothed::Smoothed;
pub use stick_slip::StickSlip;
pub use time_stepping::TimeStepping;
