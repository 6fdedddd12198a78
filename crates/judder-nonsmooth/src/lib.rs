//! Motion of structures that touch at many points, through stick, slip and lift-off.
//!
//! In the order in which the data flows:
//!
//! - [`contact_problem`]: what one step asks of the contact: impulses and velocities that complement each other at every point.
//! - `one_point`: its exact solution at one point; [`gauss_seidel`], [`newton`]: at all of them; `elimination`: the linear systems of the latter.
//! - [`bodies`]: the bodies as a step moves them: modes that are free of each other, or whole matrices.
//! - [`contact`]: the contact points on the coordinates of the bodies.
//! - [`travel`]: contact points that travel along an edge of their track.
//! - [`scheme`]: Moreau–Jean, forward increment Lagrange multipliers, and a smoothed contact to doubt them.
//! - [`course`]: what speeds, loads and friction are multiplied by over time; [`excitation`]: forces that follow signals.
//! - [`march`]: a motion, step by step, with its balance of energy.
//! - [`energy`]: its mechanical energy about steady sliding, and how that falls.
//! - [`statistics`]: what its points do on average. [`mode_share`], [`growth`]: how much of a mode a motion has, and how that grows.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod bodies;
pub mod contact;
pub mod contact_problem;
pub mod course;
mod elimination;
pub mod energy;
mod error;
pub mod excitation;
pub mod gauss_seidel;
pub mod growth;
pub mod march;
pub mod mode_share;
pub mod newton;
mod one_point;
pub mod scheme;
pub mod statistics;
pub mod travel;

pub use error::NonsmoothError;
