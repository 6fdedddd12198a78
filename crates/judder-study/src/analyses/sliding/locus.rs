//! `locus`: complex eigenvalues against the position of the contact, or against any key.
//!
//! - `positions`, `swept`: the two families of pairs.
//! - `traced`: eigenvalues and zones of either, with what could not be.
//! - `doubt`: a few values against full matrices.
//! - `results`: scalars, arrays, table.

mod doubt;
mod positions;
mod results;
mod swept;
mod traced;

use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::sliding::SlidingSystem;
use judder_case::SlidingCase;
use judder_case::sliding::locus::{self, Along, Locus};
use judder_sliding::locus::{Conditions, Configuration};
use results::Results;

pub(super) fn run(
    (case, system): (&SlidingCase, &SlidingSystem),
    settings: &Locus,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let (axis, traced, checks) = match &settings.along {
        Along::Positions(positions) => positions::run((case, system), settings, positions, progress)?,
        Along::Key { at, sweep } => swept::run((case, system), settings, (*at, sweep), progress)?,
    };
    let results = Results { settings, axis: &axis, traced: &traced };
    let mut scalars = results.scalars();
    scalars.insert("degrees_of_freedom".to_owned(), system.pair.modes().into());
    Ok(Outcome {
        scalars,
        dataset: results.dataset()?,
        table: Some(results.table()?),
        checks,
        warnings: traced.warnings(&axis),
        missing: traced.missing(),
        files: Vec::new(),
        ..Outcome::default()
    })
}

/// Under what the pair of a case slides.
pub(crate) fn conditions(case: &SlidingCase, settings: &Locus) -> Conditions {
    Conditions {
        configuration: match settings.configuration {
            locus::Configuration::Undeformed => Configuration::Undeformed,
            locus::Configuration::Deformed => Configuration::Deformed,
        },
        is_damped: settings.damping,
        velocity: case.motion.velocity,
        load: case.motion.load.force,
    }
}
