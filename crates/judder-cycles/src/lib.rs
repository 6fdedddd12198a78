//! Limit cycles of structures that touch at many points.
//!
//! In the order in which the data flows:
//!
//! - [`series`]: periodic signals as their mean and harmonics.
//! - [`receptance`]: how the contact points yield to harmonic forces, whatever the size of the bodies.
//! - [`point_law`]: the force of a contact point as the projection of its force and motion on what the contact allows, with its derivatives.
//! - [`balance`]: the balance of harmonics on the contact points, with its derivatives.
//! - `reduced`: linear systems some of whose unknowns stand alone in a row.
//! - [`path`]: solutions of equations with one unknown more, one after the other.
//! - `crossing`: where an unknown of a path changes its sign.
//! - `turning`: where paths turn, and where others may branch off.
//! - `extended`: the balance with unknowns beside the forces: the frequency, and what else is free.
//! - `phase`: where the period of a motion begins that nothing drives.
//! - [`backbone`]: the periodic motions of a mode over their amplitude; those that need neither drive nor brake are limit cycles.
//! - [`branch`]: limit cycles along a parameter.
//! - [`fold`]: where the parameter of a branch turns, and how well that is known.
//! - [`forced`]: periodic motions that a force drives, over its frequency.
//! - [`stability`]: Floquet multipliers by steps of small motions about a periodic one, and by Hill's method.
//! - [`shooting`]: cycles by a march that comes back.
//! - [`cycle`]: what is told of a limit cycle.
//! - [`contributions`]: of which modes one is made up.
//! - [`near`]: cycles near a periodic motion that is known from elsewhere. [`marched`]: the motion that a march comes to.
//! - [`power`]: where the energy of a periodic motion comes from and goes to.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod backbone;
pub mod balance;
pub mod branch;
pub mod contributions;
mod crossing;
pub mod cycle;
mod error;
mod extended;
pub mod fold;
pub mod forced;
pub mod marched;
pub mod near;
pub mod path;
mod phase;
pub mod point_law;
pub mod power;
pub mod receptance;
mod reduced;
pub mod series;
pub mod shooting;
pub mod stability;
mod turning;

pub use error::CyclesError;
