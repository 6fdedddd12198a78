//! Marches against closed forms, against each other, and what must hold for all of them.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod common;
mod convergence;
mod property;
mod validation;
