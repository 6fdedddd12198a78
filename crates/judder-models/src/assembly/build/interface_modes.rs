//! Which bodies may have their contact freedoms reduced.

use super::Unassembled;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::contact::{ContactForceSettings, ContactInterface, TrackSettings};
use crate::assembly::case::normal_law::NormalLaw;
use crate::assembly::case::problem::AssemblyProblem;
use crate::assembly::case::structure::{BodyReduction, ReducedBody};

/// Refuses interface modes of bodies that touch nowhere, or at a rigid contact.
pub(super) fn admit(case: &AssemblyCase) -> Result<(), Unassembled> {
    for (index, own) in case.structures.iter().enumerate() {
        let BodyReduction::Modes(ReducedBody { interface_modes: Some(_), .. }) = own.reduction else {
            continue;
        };
        let touches = |contact: &&ContactInterface| {
            let track = match &contact.track {
                TrackSettings::Plane(_) => None,
                TrackSettings::Surface(track) => Some(*track.surface.structure),
            };
            *contact.slider.structure == index || track == Some(index)
        };
        let rigid = |contact: &&ContactInterface| {
            matches!(contact.forces, ContactForceSettings::Coulomb { normal: NormalLaw::Rigid, .. })
        };
        let structure = own.name.to_string();
        let mut contacts = case.contacts.iter().filter(touches).peekable();
        let problem = match contacts.peek() {
            None => Some(AssemblyProblem::NoInterface { structure }),
            Some(_) => contacts.find(rigid).map(|contact| AssemblyProblem::RigidInterfaceModes {
                structure,
                contact: contact.name.to_string(),
            }),
        };
        if let Some(problem) = problem {
            return Err(Unassembled::new(
                format!("structure.{}.reduction.interface_modes", own.name),
                problem,
            ));
        }
    }
    Ok(())
}
