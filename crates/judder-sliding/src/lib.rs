//! Two structures in sliding contact.
//!
//! In the order in which the data flows:
//!
//! - [`body`]: a structure in modal form, and places of it.
//! - [`reduced`]: modal form and places of a structure that was reduced.
//! - [`edge`]: the contact edge between its nodes, and where a point touches it.
//! - [`pair`]: a slider and its track.
//! - [`coupling`]: compatibility row and equilibrium column.
//! - [`statics`]: the deformed configuration of steady sliding.
//! - [`characteristic`]: the function whose zeros are the eigenvalues of the coupled pair.
//! - [`spectrum`]: all eigenvalues up to a frequency, with the proof that none is missing.
//! - [`zones`]: where along a parameter the pair is unstable.
//! - [`locus`]: eigenvalues and unstable zones against contact position.
//! - [`dense_forms`]: the three-field form, its primal and its dual assembly with full matrices.
//! - [`amplification`]: what a zone of growth does to a vibration that passes through it.
//! - [`motion`]: prescribed motion, load and ramps.
//! - [`march`]: through time: Subs, EnSubs, FiLM, and the march with residual flexibility.
//! - [`recorder`]: signals of a march, decimated while it runs, and the extremes of every step.
//! - [`shape`]: the shape of a coupled mode.
//! - [`growth`]: growth with the contact held, measured against the eigenvalue.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod amplification;
pub mod body;
pub mod characteristic;
pub mod coupling;
pub mod dense_forms;
pub mod edge;
mod error;
pub mod growth;
pub mod locus;
pub mod march;
pub mod motion;
pub mod pair;
pub mod plane;
pub mod recorder;
pub mod reduced;
pub mod shape;
pub mod spectrum;
pub mod statics;
mod tracking;
#[cfg(test)]
mod vectors;
pub mod zones;

pub use error::SlidingError;
