//! Two structures in sliding contact.
//!
//! In the order in which the data flows:
//!
//! - [`body`]: a structure in modal form, and places of it.
//! - [`reduced`]: modal form and places of a structure that was reduced.
//! - [`edge`]: the contact edge between its nodes, and where a point touches it.
//! - [`friction`]: the friction coefficient.
//! - [`pair`]: a slider and its track.
//! - [`coupling`]: compatibility row and equilibrium column.
//! - [`statics`]: the deformed configuration of steady sliding.
//! - [`motion`]: prescribed motion, load and ramps.
//! - [`march`]: through time: Subs, EnSubs, FiLM, and the march with residual flexibility.
//! - [`recorder`]: signals of a march, decimated while it runs, and the extremes of every step.
//! - [`shape`]: the shape of a coupled mode.
//! - [`growth`]: growth with the contact held, measured against the eigenvalue.

pub mod body;
pub mod coupling;
pub mod edge;
mod error;
pub mod friction;
pub mod growth;
pub mod march;
pub mod motion;
pub mod pair;
pub mod plane;
pub mod recorder;
pub mod reduced;
pub mod shape;
pub mod statics;

pub use error::SlidingError;
