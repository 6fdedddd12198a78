//! What has periodic motions that can be computed, and how many harmonics of them fit into memory.

use super::AssemblySubject;
use super::case::problem::AssemblyProblem;
use crate::error::ModelError;
use judder_cycles::receptance::check_size;
use judder_keys::memory::Memory;
use judder_nonsmooth::contact::ContactPoints;
use judder_study::model::Refusal;

/// Dense matrices of all unknowns that a step of Newton's method holds.
const MATRICES: usize = 5;
/// What they may take.
const LIMIT: Memory = Memory::DEFAULT;

/// Refuses contacts whose points travel, bodies with more freedoms than are taken, and so many harmonics that their equations would not fit into memory.
pub(super) fn admits_periodic(
    of: &AssemblySubject<'_>,
    harmonics: Option<usize>,
) -> Result<Result<(), Refusal>, ModelError> {
    let refused = |key, reason| Ok(Err(Refusal::key(key, AssemblyProblem::Refused { reason })));
    if let Some(travelling) = of.built.travelling.first() {
        let name = &of.built.assembly.interfaces[travelling.interface].name;
        let reason = format!(
            "the points of the contact `{name}` travel along their track: no motion repeats itself there"
        );
        return refused("", reason);
    }
    if let Err(error) = check_size(&of.built.assembly) {
        return refused("", error.to_string());
    }
    let components = components(of)?;
    let most = largest_count(components);
    match harmonics {
        Some(count) if count > most => {
            let unknowns = components * (2 * count + 1);
            let taken = Memory { bytes: (8 * MATRICES * unknowns * unknowns) as u64 };
            let reason = format!(
                "{count} harmonics of {components} components of contact forces are {unknowns} unknowns, whose matrices take {taken}, more than {LIMIT}: give up to {most}"
            );
            refused("harmonics", reason)
        }
        _ => Ok(Ok(())),
    }
}

/// The most harmonics of so many components whose equations fit into memory.
pub(super) fn largest_count(components: usize) -> usize {
    let unknowns = (LIMIT.bytes as f64 / (8 * MATRICES) as f64).sqrt();
    ((unknowns / components.max(1) as f64 - 1.0) / 2.0).floor().max(1.0) as usize
}

/// Components of all contact points: two each in the plane, three in space.
pub(super) fn components(of: &AssemblySubject<'_>) -> Result<usize, ModelError> {
    Ok(ContactPoints::new(&of.built.assembly, &[])?.rows.len())
}
