//! The oscillator from Python.
//!
//! - `keys`: keyword arguments as the keys of a case.
//! - `operating_point`: one operating point.
//! - `map`: a plane of them.
//! - `points`: any number of them, over arrays.

mod keys;
mod map;
mod operating_point;
mod points;

pub(crate) use map::oscillator_map;
pub(crate) use operating_point::{OscillatorPoint, point, rebuilt_point, repeated_points};
pub(crate) use points::oscillator_points;
