//! Seconds on one core, measured on the beams paper's pair of 243 modes in the release build; good to a factor of a few.

use super::system::{self, ReducedPair};
use judder_sliding::march::ContactMethod;
use judder_sliding::motion::Motion;

/// One step of a march and one mode.
pub(super) const STEP_AND_MODE: f64 = 1.5e-9;
/// One value of a locus, one branch and one mode, with the search for zones beside it.
pub(super) const VALUE: f64 = 4e-7;
/// A structure read, assembled and reduced, a degree of freedom.
pub(super) const FREEDOM: f64 = 1e-4;
/// Two eigenproblems with full matrices, over the cube of the modes.
pub(super) const DENSE: f64 = 1e-7;
/// Periods of a mode that a growth is measured over, at most.
pub(super) const PERIODS: f64 = 600.0;

/// Degrees of freedom of one of the structures.
pub(super) fn freedoms(system: &ReducedPair, structure: usize) -> f64 {
    system.parts[structure].structure.family.size() as f64
}

/// The step that is given, or chosen; where it is refused, the one asked for.
pub(super) fn step(system: &ReducedPair, method: ContactMethod, given: Option<f64>, motion: Motion) -> f64 {
    match system::step(&system.pair, method, given, motion) {
        Ok(step) => step.step,
        Err(_) => given.unwrap_or(f64::INFINITY),
    }
}
