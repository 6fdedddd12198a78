//! Evidence for the oscillator, by kind: what holds everywhere (`property`), what others have printed (`validation`), what
//! the resolution of a map leaves unchanged (`convergence`).
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod computed;
mod convergence;
mod page;
mod panels;
mod property;
mod sampling;
mod validation;
