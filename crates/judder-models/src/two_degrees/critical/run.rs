//! Where stability changes along one parameter.

use crate::axis::{self, range};
use crate::error::ModelError;
use crate::sweep::{ParameterKey, Sweep};
use crate::two_degrees::case::TwoDegreesCase;
use judder_numerics::root::all_roots;
use judder_oscillator::characteristic::Characteristic;
use judder_oscillator::spectrum::{eigenvalues, growth_rate, leading};
use judder_store::{Dataset, Results, Table, Variable};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};

/// What is told of thresholds.
#[derive(Results)]
#[results(columns(frequency))]
pub(super) struct ToldThresholds {
    /// the swept parameter
    key: String,
    /// where stability changes
    #[result(unit = "1")]
    critical: Vec<f64>,
    frequency: Vec<f64>,
}

/// Where stability changes along one parameter, with the frequency of the oscillation that is born there.
pub(super) fn run(
    case: &TwoDegreesCase,
    sweep: &Sweep<ParameterKey>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let range = range(sweep);
    let last = sweep.points - 1;
    let positions: Vec<f64> = (0..=last).map(|k| k as f64 / last as f64).collect();
    let reduced = |position: f64| case.system(&[(sweep, range.value(position))])?.reduced().ok();
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
        dataset: Dataset::new().with(roots)?.with(frequencies)?,
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
