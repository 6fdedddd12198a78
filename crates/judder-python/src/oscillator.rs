//! The oscillator from Python.
//!
//! - `keys`: keyword arguments as the keys of a case.
//! - `operating_point`: one operating point.
//! - `map`: a plane of them.

mod keys;
mod map;
mod operating_point;

pub(crate) use map::oscillator_map;
pub(crate) use operating_point::{OscillatorPoint, point, rebuilt_point, repeated_points};
