//! What changes over the time of a motion: speeds, loads and friction by a course, forces and the acceleration of the base by signals.
//!
//! - [`settings`]: the keys. [`signal`]: those of a signal.
//! - `drive`: what they make of an assembly.
//! - `arrays`: what is kept of it.

mod arrays;
mod drive;
pub mod settings;
pub mod signal;

pub(super) use arrays::{COURSE, with_absolute, with_drive};
pub(super) use drive::MotionDrive;
