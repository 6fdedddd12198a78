//! `reduction`: the reduced structure against the full one.

use super::super::undamped::Undamped;
use super::files;
use crate::error::ModelError;
use crate::structure::build::Structure;
use crate::structure::case::StructureCase;
use crate::structure::case::reduction::{FIXED_MODES, FixedModes};
use judder_store::Results;
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::reduction_report::{ComparedFrequency, ReductionReport, TOLERANCE};
use judder_study::outcome::{CheckRecord, Outcome};
use std::f64::consts::TAU;

/// What rounding may leave of frequencies, relative.
const ROUNDING: f64 = 1e-7;
/// What the compliance at rest, exact by construction, may be off by.
const COMPLIANCE_LIMIT: f64 = 1e-8;

pub(super) fn run(
    case: &StructureCase,
    structure: &Structure,
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
    let fixed = reduced.fixed_interface.len();
    let told = ToldReduction {
        mode: (1..=rows.len() as i64).collect(),
        full: of(&|row| row.full_hz),
        reduced: of(&|row| row.reduced_hz),
        error: of(&|row| row.relative_error),
        bound: of(&|row| row.bound.unwrap_or(f64::NAN)),
        limit_hz: limit,
        static_compliance_error: report.static_compliance_error,
        dynamic_compliance: InterfaceCompliance {
            frequency_hz: probe,
            error: report.dynamic_compliance_error,
        },
        kept_freedoms: kept.len(),
        fixed_interface_modes: fixed,
        reduced_freedoms: kept.len() + fixed,
        degrees_of_freedom: problem.size(),
        reduction_of: modes_of.name(),
    };
    let checks = checks(&report);
    let files = files::files(name, structure, &reduced, limit, &mut warnings)?;
    Ok(Outcome { checks, warnings, files, ..Outcome::of(&told)? })
}

/// What is told of a reduction.
#[derive(Results)]
#[results(
    along = "mode",
    arrays(mode, full, reduced, error, bound),
    columns(mode, full, reduced, error, bound)
)]
pub(super) struct ToldReduction {
    /// number of the mode
    #[result(hidden)]
    mode: Vec<i64>,
    /// frequency of the full structure
    #[result(summary = "full_hz", unit = "Hz")]
    full: Vec<f64>,
    /// frequency of the reduced structure
    #[result(summary = "reduced_hz", unit = "Hz")]
    reduced: Vec<f64>,
    /// (reduced − full)/reduced
    #[result(summary = "errors")]
    error: Vec<f64>,
    /// what the reduction says its error is at most
    #[result(summary = "bounds")]
    bound: Vec<f64>,
    /// below it the reduction is to be trusted
    #[result(attribute)]
    limit_hz: f64,
    /// relative error of the compliance at rest
    #[result(unit = "1")]
    static_compliance_error: Option<f64>,
    /// that of the compliance in motion
    dynamic_compliance: InterfaceCompliance,
    /// freedoms of the interface
    kept_freedoms: usize,
    /// modes with the interface held
    fixed_interface_modes: usize,
    /// both together
    reduced_freedoms: usize,
    /// those of the full structure
    degrees_of_freedom: usize,
    /// of what matrices it is the reduction
    #[result(attribute)]
    reduction_of: &'static str,
}

/// The compliance of the interface at a frequency.
#[derive(Results)]
struct InterfaceCompliance {
    frequency_hz: f64,
    /// its relative error
    error: f64,
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
