//! The contact computation and the contact laws, against closed forms, other algorithms and themselves.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod convergence;
mod property;
mod questions;
mod synthetic;
mod validation;
