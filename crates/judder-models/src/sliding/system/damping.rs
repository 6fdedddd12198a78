//! α and β of C = α M + β K.

use crate::structure::case::damping::Damping;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::damping::{RayleighDamping, StructuralDamping};
use std::f64::consts::TAU;

/// α in 1/s and β in s of a structure: as the case has them, those of structural damping, or those that an imported matrix has.
///
/// # Errors
/// A matrix that is no αM + βK: then modes are coupled by damping, and the modal form is not diagonal.
pub(super) fn damping(
    own: &Damping,
    imported: &Sparse,
    [mass, stiffness]: [&Sparse; 2],
) -> Result<(f64, f64), StructureError> {
    match own {
        Damping::Rayleigh(own) => Ok((own.alpha, own.beta)),
        Damping::Structural(own) => {
            let damping = StructuralDamping::new(own.loss_factor, own.reference_frequency / TAU)?;
            Ok((0.0, damping.beta()))
        }
        Damping::Ratios { .. } | Damping::Ratio { .. } => Err(StructureError::NotRayleigh),
        Damping::None => {
            let damping = RayleighDamping::fitted(imported, mass, stiffness)?;
            Ok((damping.alpha(), damping.beta()))
        }
    }
}
