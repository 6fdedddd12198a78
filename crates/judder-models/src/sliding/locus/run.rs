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
        warnings: beyond_friction(system, &settings.along)
            .into_iter()
            .chain(traced.warnings(&axis))
            .collect(),
        missing: traced.missing(),
        files: Vec::new(),
        ..Outcome::default()
    })
}

/// That the speed lies beyond the table of friction: that of the case, or how many of those that are swept.
fn beyond_friction(system: &ReducedPair, along: &Along) -> Option<String> {
    let Along::Key { sweep, .. } = along else { return system.beyond_friction() };
    if sweep.path != "motion.velocity" {
        return system.beyond_friction();
    }
    let swept = sweep.values.iter();
    let beyond: Vec<_> = swept.filter_map(|speed| system.pair.friction().beyond(speed.abs())).collect();
    let first = beyond.first()?.text("m/s");
    Some(format!("at {} of {} values {first}", beyond.len(), sweep.values.len()))
}
