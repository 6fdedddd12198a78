//! Assemblies against other formulations of themselves, closed forms, other programs, and finer meshes.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod common;
mod convergence;
mod property;
mod validation;
