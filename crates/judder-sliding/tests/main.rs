//! Two structures in sliding contact: the pair of the beams paper, and random ones.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

mod common;

#[path = "main/bad_input.rs"]
mod bad_input;
#[path = "main/beams.rs"]
mod beams;
#[path = "main/equilibria.rs"]
mod equilibria;
#[path = "main/frozen.rs"]
mod frozen;
#[path = "main/locus.rs"]
mod locus;
#[path = "main/marches.rs"]
mod marches;
#[path = "main/random_pairs.rs"]
mod random_pairs;
#[path = "main/recorder.rs"]
mod recorder;
#[path = "main/residual_flexibility.rs"]
mod residual_flexibility;
#[path = "main/seen.rs"]
mod seen;
