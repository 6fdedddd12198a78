//! The pair of a sliding case, built and reduced, for whoever marches it by himself.

use crate::error::ModelError;
use crate::sliding::case::SlidingCase;
use crate::sliding::system::{self, ReducedPair};
use judder_sliding::SlidingError;
use judder_sliding::march::ContactMethod;
use judder_sliding::motion::Motion;
use judder_sliding::pair::Pair;
use judder_study::case::file::CaseFile;

/// The two structures of a case, reduced and coupled.
#[derive(Debug, Clone)]
pub struct CoupledPair {
    /// The pair; of each point of the case it observes the displacements along x and y, in the order of the case.
    pub pair: Pair,
    /// What the case prescribes along its whole path.
    pub motion: Motion,
    /// What has to be known of it, a sentence each.
    pub warnings: Vec<String>,
}

/// Reads, assembles, reduces and couples what a case describes.
///
/// # Errors
/// A case of another model, structures that cannot be built or coupled.
pub fn coupled_pair(file: &CaseFile) -> Result<CoupledPair, ModelError> {
    let Some(case) = file.case.of::<SlidingCase>() else {
        return Err(ModelError::WrongModel { command: "march", model: file.case.model() });
    };
    let system = ReducedPair::new(case).map_err(|uncoupled| uncoupled.placed(file))?;
    let ReducedPair { pair, motion, warnings, .. } = system;
    Ok(CoupledPair { pair, motion, warnings })
}

/// The time step in s that a march takes by itself: a share of its limit along the path of the motion, and no longer than what is heard
/// asks for.
///
/// # Errors
/// What [`judder_sliding::march::March::beyond_limit`] says.
pub fn own_step(pair: &Pair, method: ContactMethod, motion: Motion) -> Result<f64, SlidingError> {
    Ok(system::step(pair, method, None, motion)?.step)
}
