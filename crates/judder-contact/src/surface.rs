//! Pressures and displacements on a surface of square cells.

pub mod convolution;
pub mod grid;
pub mod operator;
pub(crate) mod stoppable;
