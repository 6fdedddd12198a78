//! Verdicts at the points of a map, and their boundaries.

use crate::axis::{self, range};
use crate::checks;
use crate::error::ModelError;
use crate::oscillator::stability_map::{
    MapArrays, MapWords, ONE_WAY, Overlay, ToldStabilityMap, checked_points, incomplete, unresolved_warning,
};
use crate::sweep::{ParameterKey, StabilityMapAnalysis};
use crate::two_degrees::case::TwoDegreesCase;
use judder_oscillator::LinearSystem;
use judder_oscillator::boundary::boundaries_of_system;
use judder_oscillator::map::StabilityMap;
use judder_oscillator::mechanism::StabilityClass;
use judder_store::Results;
use judder_study::axis::SweptAxis;
use judder_study::outcome::{CheckRecord, Outcome};
use rayon::prelude::*;

const WORDS: MapWords = MapWords {
    one_way: ONE_WAY,
    stability: "stability, by mechanism",
    frequency: "frequency of the oscillation born there",
};

pub(super) fn run(
    case: &TwoDegreesCase,
    settings: &StabilityMapAnalysis<ParameterKey>,
) -> Result<Outcome, ModelError> {
    let (x, y) = (axis::of_parameter(&settings.x), axis::of_parameter(&settings.y));
    let (columns, rows) = (x.values.len(), y.values.len());
    let start = std::time::Instant::now();
    let classes: Vec<u8> = (0..columns * rows)
        .into_par_iter()
        .map(|index| {
            let set = [(&settings.x, x.values[index % columns]), (&settings.y, y.values[index / columns])];
            let class = case.system(&set).and_then(|system| StabilityClass::of_system(&system).ok());
            class.unwrap_or(StabilityClass::Unresolved) as u8
        })
        .collect();
    let seconds = start.elapsed().as_secs_f64();
    let map = StabilityMap { columns, rows, classes, decisions: columns * rows };
    let mut overlays = Vec::new();
    if settings.options.boundaries {
        let at = |x: f64, y: f64| case.system(&[(&settings.x, x), (&settings.y, y)])?.reduced().ok();
        overlays.push(Overlay::of_system(boundaries_of_system(
            &range(&settings.x),
            &range(&settings.y),
            &at,
        )));
    }
    Ok(Outcome {
        scalars: ToldStabilityMap::new(&map, ONE_WAY, seconds, &overlays).scalars(),
        dataset: MapArrays { x: &x, y: &y, map: &map, growth: None, overlays: &overlays, words: &WORDS }
            .dataset()?,
        missing: map.count(StabilityClass::Unresolved),
        warnings: unresolved_warning(&map).into_iter().chain(incomplete(&overlays)).collect(),
        checks: map_checks(case, settings, &map, [&x, &y]),
        ..Outcome::default()
    })
}

/// The map against the eigenvalues, on a grid of points over it.
fn map_checks(
    case: &TwoDegreesCase,
    settings: &StabilityMapAnalysis<ParameterKey>,
    map: &StabilityMap,
    [x, y]: [&SweptAxis; 2],
) -> Vec<CheckRecord> {
    let points = checked_points(map.columns, map.rows);
    let systems: Vec<(LinearSystem, bool)> = points
        .filter_map(|(column, row)| {
            let system = case.system(&[(&settings.x, x.values[column]), (&settings.y, y.values[row])])?;
            Some((system, map.class(column, row).is_unstable()))
        })
        .collect();
    vec![checks::unstable_as_eigenvalues_say(&systems)]
}
