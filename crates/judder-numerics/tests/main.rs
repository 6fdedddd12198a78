//! Evidence for the numerical tools: closed forms (`validation`).
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on has failed")]

mod validation;
