//! Eigenvalues of the pair of the beams paper against contact position.
#[path = "locus/branches.rs"]
mod branches;
#[path = "locus/lossless.rs"]
mod lossless;
#[path = "locus/random.rs"]
mod random;
#[path = "locus/spectra.rs"]
mod spectra;
#[path = "locus/zones.rs"]
mod zones;
