//! The page's server from outside: what it answers, and what it withstands.

#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod answers;
mod attacks;
mod client;
mod reported;
mod scheduler;
mod study;
