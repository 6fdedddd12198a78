//! Points that fill the unit cube: each is computed from its index alone, in any order and on any thread.
//!
//! - [`sobol`]: Sobol' sequences, scrambled.
//! - [`latin_hypercube`]: each dimension in as many cells as there are points, each cell hit once.
//!
//! Own code, since no kept library gives random access in f64: `sobol` iterates, `sobol_burley` ends at 2¹⁶ points in f32.

mod joe_kuo;
pub mod latin_hypercube;
pub mod sobol;

pub use latin_hypercube::LatinHypercube;
pub use sobol::SobolSequence;

use thiserror::Error;

/// Why there are no such points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SamplingError {
    /// No dimension, or more than such points have.
    #[error("points of {dimensions} dimensions were asked for; they have 1 to {most}")]
    Dimensions {
        /// The dimensions that were asked for.
        dimensions: usize,
        /// The most that there are.
        most: usize,
    },
    /// A number of points beyond what the cells of a Latin hypercube are counted in.
    #[error("a Latin hypercube of {points} points was asked for; it has 1 to {most}")]
    Points {
        /// The points that were asked for.
        points: u64,
        /// The most that there can be.
        most: u64,
    },
}
