//! The analyses of a two-degrees case: any M, C, K with swept parameters.

use crate::axis::{self, Curves, range};
use crate::checks;
use crate::error::ModelError;
use crate::oscillator::spectrum::{self, Spectra, ToldSpectra};
use crate::oscillator::stability_map::{
    MapArrays, ONE_WAY, Overlay, ToldMap, checked_points, incomplete, unresolved_warning,
};
use crate::sweep::{ParameterKey, StabilityMap as MapSettings, Sweep};
use crate::two_degrees::case::{ParameterSpectrum, TwoDegreesAnalysis, TwoDegreesCase};
use judder_numerics::root::all_roots;
use judder_oscillator::LinearSystem;
use judder_oscillator::boundary::boundaries_of_system;
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::map::StabilityMap;
use judder_oscillator::mechanism::StabilityClass;
use judder_oscillator::spectrum::{eigenvalues, growth_rate, leading};
use judder_store::{Dataset, Declared, Results, Table, Variable};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};
use rayon::prelude::*;

/// The keys of the summary of an analysis.
pub(super) fn summary_keys(analysis: &TwoDegreesAnalysis) -> Vec<Declared> {
    match analysis {
        TwoDegreesAnalysis::Spectrum(_) => ToldSpectra::declared(),
        TwoDegreesAnalysis::StabilityMap(_) => ToldMap::keys(ONE_WAY),
        TwoDegreesAnalysis::Critical(_) => ToldThresholds::declared(),
    }
}

/// What is told of thresholds.
#[derive(Results)]
#[results(columns(frequency))]
struct ToldThresholds {
    /// the swept parameter
    key: String,
    /// where stability changes
    critical: Vec<f64>,
    frequency: Vec<f64>,
}

pub(super) fn run(
    case: &TwoDegreesCase,
    analysis: &TwoDegreesAnalysis,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    match analysis {
        TwoDegreesAnalysis::Spectrum(ParameterSpectrum { sweep }) => {
            let axis = axis::of_parameter(sweep);
            let spectra =
                axis.values.iter().map(|value| Spectra::new(&system(case, &[(sweep, *value)])?)).collect();
            let mut outcome = spectrum::outcome(&axis, &Curves::alone(), spectra)?;
            if outcome.missing > 0 {
                outcome.warnings.push(format!(
                    "no eigenvalues at {} of {} values: the matrices are not finite there, or M is not symmetric and positive definite",
                    outcome.missing,
                    axis.values.len()
                ));
            }
            Ok(outcome)
        }
        TwoDegreesAnalysis::StabilityMap(settings) => map(case, settings),
        TwoDegreesAnalysis::Critical(asked) => critical(case, &asked.sweep, progress),
    }
}

/// M, C, K with these parameters set; `None` where an entry is not finite.
fn system(case: &TwoDegreesCase, set: &[(&Sweep<ParameterKey>, f64)]) -> Option<LinearSystem> {
    let mut values = case.values();
    for (sweep, value) in set {
        sweep.set(&mut values, *value);
    }
    let matrices = case.matrices(&values).ok()?;
    Some(LinearSystem { mass: matrices.mass, damping: matrices.damping, stiffness: matrices.stiffness })
}

fn map(case: &TwoDegreesCase, settings: &MapSettings<ParameterKey>) -> Result<Outcome, ModelError> {
    let (x, y) = (axis::of_parameter(&settings.x), axis::of_parameter(&settings.y));
    let (columns, rows) = (x.values.len(), y.values.len());
    let start = std::time::Instant::now();
    let classes: Vec<u8> = (0..columns * rows)
        .into_par_iter()
        .map(|index| {
            let set = [(&settings.x, x.values[index % columns]), (&settings.y, y.values[index / columns])];
            let class = system(case, &set).and_then(|system| StabilityClass::of_system(&system).ok());
            class.unwrap_or(StabilityClass::Unresolved) as u8
        })
        .collect();
    let seconds = start.elapsed().as_secs_f64();
    let map = StabilityMap { columns, rows, classes, decisions: columns * rows };
    let mut overlays = Vec::new();
    if settings.options.boundaries {
        let at = |x: f64, y: f64| system(case, &[(&settings.x, x), (&settings.y, y)])?.reduced().ok();
        overlays.push(Overlay::of_system(boundaries_of_system(
            &range(&settings.x),
            &range(&settings.y),
            &at,
        )));
    }
    Ok(Outcome {
        scalars: ToldMap::new(&map, ONE_WAY, seconds, &overlays).scalars(),
        dataset: MapArrays { x: &x, y: &y, map: &map, growth: None, overlays: &overlays, one_way: ONE_WAY }
            .dataset()?,
        missing: map.count(StabilityClass::Unresolved),
        warnings: unresolved_warning(&map).into_iter().chain(incomplete(&overlays)).collect(),
        checks: map_checks(case, settings, &map, (&x.values, &y.values)),
        ..Outcome::default()
    })
}

/// The map against the eigenvalues, on a grid of points over it.
fn map_checks(
    case: &TwoDegreesCase,
    settings: &MapSettings<ParameterKey>,
    map: &StabilityMap,
    (x, y): (&[f64], &[f64]),
) -> Vec<CheckRecord> {
    let points = checked_points(x.len(), y.len());
    let systems: Vec<(LinearSystem, bool)> = points
        .filter_map(|(column, row)| {
            let system = system(case, &[(&settings.x, x[column]), (&settings.y, y[row])])?;
            Some((system, map.class(column, row).is_unstable()))
        })
        .collect();
    vec![checks::unstable_as_eigenvalues_say(&systems)]
}

/// Where stability changes along one parameter, with the frequency of the oscillation that is born there.
fn critical(
    case: &TwoDegreesCase,
    sweep: &Sweep<ParameterKey>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let range = range(sweep);
    let last = sweep.points - 1;
    let positions: Vec<f64> = (0..=last).map(|k| k as f64 / last as f64).collect();
    let reduced = |position: f64| system(case, &[(sweep, range.value(position))])?.reduced().ok();
    let margin = |position: f64| reduced(position).map_or(f64::NAN, |r| Characteristic::new(&r).margin());
    let search = all_roots(margin, &positions);
    progress.advance();
    let at_root = |position: &f64| {
        let values = reduced(*position).and_then(|r| eigenvalues(&r).ok())?;
        Some((leading(&values).im.abs(), growth_rate(&values)))
    };
    let born: Vec<Option<(f64, f64)>> = search.roots.iter().map(at_root).collect();
    let frequency: Vec<f64> = born.iter().map(|b| b.map_or(f64::NAN, |b| b.0)).collect();
    let growth: Disagreement = born.iter().map(|b| b.map_or(f64::NAN, |b| b.1.abs())).collect();
    let values: Vec<f64> = search.roots.iter().map(|position| range.value(*position)).collect();
    let told = ToldThresholds { key: sweep.path.clone(), critical: values.clone(), frequency };
    let axis = axis::of_parameter(sweep);
    let count = values.len();
    let check = CheckRecord::new(
        "growth rate vanishes at the critical values",
        format!("largest real part of the eigenvalues, at {count} values"),
        growth,
        // a root of multiplicity two carries half the digits
        1e-6,
    );
    let roots =
        Variable::coordinate("critical", values.clone()).long_name(&format!("critical {}", axis.name()));
    let frequencies = Variable::new("frequency", &["critical"], &[count], told.frequency.clone())
        .units("1")
        .long_name("frequency of the oscillation born there")
        .apart();
    Ok(Outcome {
        scalars: told.scalars(),
        dataset: Dataset::new().with(roots)?.with(frequencies)?.attribute("kind", "critical")?,
        table: Some(told.add_columns(Table::new().column(axis.name(), "1", values)?)?),
        checks: if count > 0 { vec![check] } else { Vec::new() },
        missing: search.failures.len(),
        warnings: if search.failures.is_empty() {
            Vec::new()
        } else {
            vec![format!("no system at {} of {} samples of the search", search.failures.len(), sweep.points)]
        },
        ..Outcome::default()
    })
}
