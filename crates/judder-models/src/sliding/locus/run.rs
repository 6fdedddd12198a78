//! The locus along either of its two families.

use super::results::Locating;
use super::{positions, swept};
use crate::error::ModelError;
use crate::sliding::case::SlidingCase;
use crate::sliding::locus::settings::{Along, LocusAnalysis};
use crate::sliding::system::ReducedPair;
use judder_store::Results;
use judder_study::Progress;
use judder_study::kept::KeptLines;
use judder_study::outcome::Outcome;

pub(super) fn run(
    case: &SlidingCase,
    system: &ReducedPair,
    settings: &LocusAnalysis,
    way: (KeptLines<'_>, &dyn Progress),
) -> Result<Outcome, ModelError> {
    let (axis, traced, checks) = match &settings.along {
        Along::Positions(positions) => positions::run(case, system, settings, positions, way)?,
        Along::Key { at, sweep } => swept::run(case, system, settings, *at, sweep, way)?,
    };
    let results = Locating { settings, axis: &axis, traced: &traced };
    Ok(Outcome {
        scalars: results.told(system.pair.modes()).scalars(),
        dataset: results.dataset()?,
        table: Some(results.table()?),
        checks,
        warnings: traced.warnings(&axis),
        missing: traced.missing(),
        files: Vec::new(),
        ..Outcome::default()
    })
}
