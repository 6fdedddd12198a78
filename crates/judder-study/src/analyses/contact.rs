//! The analyses of a contact case: a rigid indenter on a viscoelastic substrate.

mod fields;
mod fit;
mod law;
mod modulus;
mod periodic;
mod refined;
mod single;
mod transient;

pub(crate) use single::{grid, loading};
pub(crate) use transient::Asked;

use crate::computed_law::Points;
use crate::error::StudyError;
use crate::material::temperature_warning;
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_case::{Analysis, ContactAnalysis, ContactCase, LawMethod};

/// Contacts that a law usually takes.
pub(crate) fn usual_contacts(method: LawMethod) -> usize {
    match method {
        LawMethod::Collapse => 65,
        LawMethod::Sweep => 99,
    }
}

/// How many steps an analysis announces.
pub(super) fn steps(kind: &ContactAnalysis) -> usize {
    match kind {
        ContactAnalysis::Contact(_) | ContactAnalysis::Modulus { .. } | ContactAnalysis::Transient(_) => 1,
        ContactAnalysis::ContactLaw(law) | ContactAnalysis::Fit { law, .. } => usual_contacts(law.method),
    }
}

pub(super) fn run(
    case: &ContactCase,
    analysis: &Analysis<ContactAnalysis>,
    points: Points<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let mut outcome = match &analysis.kind {
        ContactAnalysis::Contact(settings) if case.shape.is_periodic() => {
            periodic::run(case, &analysis.name, settings)
        }
        ContactAnalysis::Contact(settings) => single::run(case, &analysis.name, settings, progress),
        ContactAnalysis::ContactLaw(settings) => law::run(case, &analysis.name, settings, points, progress),
        ContactAnalysis::Fit { law, velocity_scale } => {
            fit::run(case, (law, *velocity_scale), points, progress)
        }
        ContactAnalysis::Modulus { frequency } => modulus::run(case, frequency.as_ref()),
        ContactAnalysis::Transient(settings) => transient::run(case, settings, progress),
    }?;
    outcome.warnings.extend(temperature_warning(&case.substrate)?);
    Ok(outcome)
}
