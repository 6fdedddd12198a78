//! Structures that touch at many points.
//!
//! In the order in which the data flows:
//!
//! - [`contact_point`]: a place on the slider, its partner on the track, and the forms that give their displacements beside each other.
//! - [`surface`], [`search`]: contact points of two sets of faces whose meshes need not match.
//! - [`friction`], [`pressure`]: friction coefficient against slip speed, pressure against closure.
//! - [`interface`]: contact points with one law.
//! - [`assembly`]: bodies with their loads and interfaces; [`spring`], [`tie`]: what else joins them.
//! - [`compliance`]: how the contact points yield.
//! - [`steady`]: steady sliding: forces, gaps, which points are closed.
//! - [`uniqueness`]: whether it is the only one, and with how much friction that is lost.
//! - [`linearised`]: small motions about it, `null_basis` on the freedoms that closed rigid points leave.
//! - [`work`]: what each damping and each interface adds to the growth of a mode.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod assembly;
pub mod compliance;
pub mod contact_point;
mod error;
pub mod friction;
pub mod interface;
pub mod linearised;
mod null_basis;
pub mod pressure;
pub mod row;
pub mod search;
pub mod spring;
pub mod steady;
pub mod surface;
pub mod tie;
pub mod uniqueness;
mod vector;
pub mod work;

pub use error::AssemblyError;
