//! The analyses of a contact case: a rigid indenter on a viscoelastic substrate.

mod excited;
mod fields;
mod fit;
mod law;
mod modulus;
mod periodic;
mod refined;
mod single;
mod size;
mod transient;

pub(crate) use excited::band_warning;
pub(crate) use law::Plane;
pub(crate) use single::{grid, loading};
pub(crate) use size::{cells_of_law, lattice};
pub(crate) use transient::Asked;

use crate::computed_law::Points;
use crate::error::StudyError;
use crate::kept::Kept;
use crate::material::ContactScales;
use crate::outcome::{CheckRecord, Outcome};
use crate::progress::Progress;
use crate::spectrum_source::temperature_warning;
use judder_case::{Analysis, ContactAnalysis, ContactCase, LawMethod};
use judder_contact::law::sweep::SolvedPoint;
use judder_contact::material::Discretisation;
use judder_store::number;
use serde_json::json;

/// What the terms of a continuous spectrum may leave of its modulus.
const SPECTRUM_LIMIT: f64 = 1e-2;

/// Contacts that a law usually takes, for an estimate: how many it is depends on where they are needed.
pub(crate) fn usual_contacts(method: LawMethod) -> usize {
    match method {
        LawMethod::Collapse => 65,
        LawMethod::Sweep => 99,
    }
}

/// How many steps an analysis announces; a law does so itself, level by level.
pub(super) fn steps(kind: &ContactAnalysis) -> usize {
    match kind {
        ContactAnalysis::Contact(_) | ContactAnalysis::Modulus { .. } | ContactAnalysis::Transient(_) => 1,
        ContactAnalysis::ContactLaw(_) | ContactAnalysis::Fit { .. } => 0,
    }
}

pub(super) fn run(
    case: &ContactCase,
    analysis: &Analysis<ContactAnalysis>,
    kept: Kept<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let known: Vec<SolvedPoint> = kept.known();
    let keep = |point: &SolvedPoint| kept.add(point);
    let points: Points<'_> = (&known, &keep);
    let mut outcome = match &analysis.kind {
        ContactAnalysis::Contact(settings) if case.shape.is_periodic() => {
            periodic::run(case, &analysis.name, settings, progress)
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
    let scales = ContactScales::new(case)?;
    outcome.warnings.extend(band_warning(case, &analysis.kind, &scales)?);
    if let Some(found) = scales.material.discretisation {
        tell_discretisation(&mut outcome, &found);
    }
    Ok(outcome)
}

/// Says how well the terms stand for a continuous spectrum.
fn tell_discretisation(outcome: &mut Outcome, found: &Discretisation) {
    let terms = found.spectrum.terms().len();
    outcome.scalars.insert("spectrum_terms".to_owned(), json!(terms));
    outcome.scalars.insert("spectrum_error".to_owned(), number(found.error));
    outcome.checks.push(CheckRecord::new(
        "the terms stand for the continuous spectrum",
        format!("E(ω) of {terms} retardation times against that of the spectrum, the largest relative error"),
        found.error.into(),
        SPECTRUM_LIMIT,
    ));
}
