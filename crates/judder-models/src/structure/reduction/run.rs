//! `reduction`: the reduced structure against the full one.

use super::super::undamped::Undamped;
use super::files;
use crate::error::ModelError;
use crate::structure::build::Structure;
use crate::structure::case::StructureCase;
use crate::structure::case::reduction::{FIXED_MODES, FixedModes};
use judder_store::{Dataset, Table, Variable, number};
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::reduction_report::{ComparedFrequency, ReductionReport, TOLERANCE};
use judder_study::outcome::{CheckRecord, Outcome};
use serde_json::{Map, json};
use std::f64::consts::TAU;

/// What rounding may leave of frequencies, relative.
const ROUNDING: f64 = 1e-7;
/// What the compliance at rest, exact by construction, may be off by.
const COMPLIANCE_LIMIT: f64 = 1e-8;

pub(super) fn run(
    (case, structure): (&StructureCase, &Structure),
    name: &str,
    count: usize,
) -> Result<Outcome, ModelError> {
    let problem = structure.at(case, &case.values())?;
    let Undamped { mass, stiffness, of: modes_of } = Undamped::new(case, structure)?;
    let mut warnings: Vec<String> = modes_of.warning("the reduction is that").into_iter().collect();
    let kept = &structure.kept;
    let reduced = CraigBampton::new(&stiffness, &mass, kept, cut_off(case))?;
    let limit = reduced.error()?.limit_hz(TOLERANCE);
    // halfway to the limit of what is trusted; where nothing was left out, at the first kept mode held alone
    let probe = if limit.is_finite() { 0.5 * limit } else { 0.5 * first_frequency(&reduced) };
    let report = ReductionReport::new(&stiffness, &mass, kept, &reduced, count, probe)?;
    let rows = &report.frequencies;
    let of = |pick: &dyn Fn(&ComparedFrequency) -> f64| -> Vec<f64> { rows.iter().map(pick).collect() };
    let (full, reduced_hz) = (of(&|r| r.full_hz), of(&|r| r.reduced_hz));
    let (errors, bounds) = (of(&|r| r.relative_error), of(&|r| r.bound.unwrap_or(f64::NAN)));
    let numbers: Vec<i64> = (1..=rows.len() as i64).collect();
    let modal = |name: &str, values: &[f64]| Variable::new(name, &["mode"], &[rows.len()], values.to_vec());
    let dataset = Dataset::new()
        .attribute("kind", "reduction")?
        .attribute("limit_hz", number(limit))?
        .attribute("reduction_of", modes_of.name())?
        .with(Variable::coordinate("mode", numbers.clone()).long_name("number of the mode"))?
        .with(modal("full", &full).units("Hz").long_name("frequency of the full structure"))?
        .with(modal("reduced", &reduced_hz).units("Hz").long_name("frequency of the reduced structure"))?
        .with(modal("error", &errors).units("1").long_name("(reduced − full)/reduced"))?
        .with(modal("bound", &bounds).units("1").long_name("what the reduction says its error is at most"))?;
    let table = Table::new()
        .column("mode", "1", numbers)?
        .column("full", "Hz", full.clone())?
        .column("reduced", "Hz", reduced_hz.clone())?
        .column("error", "1", errors.clone())?
        .column("bound", "1", bounds.clone())?;
    let fixed = reduced.fixed_interface.len();
    let scalars = Map::from_iter([
        ("full_hz".to_owned(), json!(full)),
        ("reduced_hz".to_owned(), json!(reduced_hz)),
        ("errors".to_owned(), json!(errors)),
        ("bounds".to_owned(), bounds.iter().map(|bound| number(*bound)).collect()),
        ("limit_hz".to_owned(), number(limit)),
        ("static_compliance_error".to_owned(), json!(report.static_compliance_error)),
        (
            "dynamic_compliance".to_owned(),
            json!({ "frequency_hz": probe, "error": number(report.dynamic_compliance_error) }),
        ),
        ("kept_freedoms".to_owned(), json!(kept.len())),
        ("fixed_interface_modes".to_owned(), json!(fixed)),
        ("reduced_freedoms".to_owned(), json!(kept.len() + fixed)),
        ("degrees_of_freedom".to_owned(), json!(problem.size())),
        ("reduction_of".to_owned(), json!(modes_of.name())),
    ]);
    let checks = checks(&report);
    let files = files::files(name, structure, &reduced, limit, &mut warnings)?;
    Ok(Outcome { scalars, dataset, table: Some(table), checks, warnings, files, ..Outcome::default() })
}

/// Where the fixed-interface modes end.
fn cut_off(case: &StructureCase) -> CutOff {
    match case.reduction.as_ref().map(|reduction| reduction.modes) {
        Some(FixedModes::CutOff(limit)) => CutOff::Frequency(limit / TAU),
        Some(FixedModes::Count(count)) => CutOff::Count(count),
        None => CutOff::Count(FIXED_MODES),
    }
}

/// The lowest fixed-interface frequency, Hz; of a structure without such modes zero.
fn first_frequency(reduced: &CraigBampton) -> f64 {
    reduced.fixed_interface.first().map_or(0.0, judder_structure::modes::Mode::frequency_hz)
}

fn checks(report: &ReductionReport) -> Vec<CheckRecord> {
    let rows: Vec<&ComparedFrequency> =
        report.frequencies.iter().filter(|row| row.bound != Some(0.0)).collect();
    let count = rows.len();
    // the full structure has the lower one of both
    let within = rows.iter().filter(|row| row.full_hz < report.limit_hz);
    let mut checks = vec![
        CheckRecord::new(
            "reduced frequencies lie above the full ones",
            format!("how far one lies below, relative, of {count}"),
            rows.iter().map(|row| -row.relative_error).collect(),
            ROUNDING,
        ),
        CheckRecord::new(
            "errors stay below what the reduction says of itself",
            format!("error less its bound, of {count} frequencies"),
            rows.iter().filter_map(|row| Some(row.relative_error - row.bound?)).collect(),
            ROUNDING,
        ),
        CheckRecord::new(
            "below its limit the reduction is as exact as it says",
            format!(
                "largest relative error of frequencies of the full structure below {:.6} Hz",
                report.limit_hz
            ),
            within.map(|row| row.relative_error.abs()).collect(),
            TOLERANCE,
        ),
    ];
    // rigid motions are exact, and a reduction may have its limit below its first frequency: then there is nothing to compare
    checks.retain(|check| !check.compared_nothing());
    if let Some(error) = report.static_compliance_error {
        checks.push(CheckRecord::new(
            "the interface yields to loads at rest as that of the full structure",
            "compliance of the kept freedoms, relative",
            error.into(),
            COMPLIANCE_LIMIT,
        ));
    }
    checks
}
