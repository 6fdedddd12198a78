//! Assemblies against other formulations of themselves, closed forms, other programs.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod common;
mod property;
mod validation;
