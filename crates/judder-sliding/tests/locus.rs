//! Eigenvalues of the pair of the beams paper against contact position.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
mod common;

#[path = "locus/random.rs"]
mod random;
#[path = "locus/spectra.rs"]
mod spectra;
#[path = "locus/zones.rs"]
mod zones;
