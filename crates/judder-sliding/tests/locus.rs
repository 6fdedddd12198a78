//! Eigenvalues of the pair of the beams paper against contact position.
mod common;

#[path = "locus/spectra.rs"]
mod spectra;
#[path = "locus/zones.rs"]
mod zones;
