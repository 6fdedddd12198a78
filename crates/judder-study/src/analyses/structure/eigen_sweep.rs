//! `eigen-sweep`: complex modes along a parameter, followed from value to value.

use super::eigen::{VERDICTS, code, entry, gap_warnings, in_order, region};
use crate::error::StudyError;
use crate::labels::parameter;
use crate::outcome::{CheckRecord, Outcome};
use crate::progress::Progress;
use crate::structure::{Structure, factors};
use judder_case::StructureCase;
use judder_case::structure::analysis::{EigenMethod, EigenSweep};
use judder_store::{Dataset, Table, Variable};
use judder_structure::affine::Factors;
use judder_structure::complex_modes::{Settings, Verdict, complex_modes};
use judder_structure::eigen_sweep::{Method, Point, Sweep, Tracked, eigen_sweep};
use num_complex::Complex64;
use serde_json::{Map, Value, json};

/// Points of a projected sweep that are solved on the full matrices as well.
const CHECKED: usize = 3;

pub(super) fn run(
    (case, structure): (&StructureCase, &Structure),
    settings: &EigenSweep,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let values = &settings.sweep.values;
    let points =
        values.iter().map(|value| at(case, settings, *value)).collect::<Result<Vec<Factors>, _>>()?;
    let method = match settings.method {
        EigenMethod::Full => Method::Full,
        EigenMethod::Projected { tolerance } => Method::Projected { tolerance },
    };
    let sought = region(&settings.region);
    let mut sweep = eigen_sweep(&structure.family, &points, &sought, &Settings::default(), method)?;
    for point in &mut sweep.points {
        point.eigenvalues.sort_by(|a, b| in_order(&a.eigenvalue, &b.eigenvalue));
    }
    (1..values.len()).for_each(|_| progress.advance());
    let incomplete = sweep.points.iter().filter(|point| !point.gaps.is_empty()).count();
    let mut checks = vec![CheckRecord {
        name: "no eigenvalue is missing".to_owned(),
        compared: format!("values at which a check did not close, of {}", values.len()),
        figure: incomplete as f64,
        limit: 0.0,
    }];
    checks.extend(against_full((case, structure), settings, &sweep)?);
    Ok(Outcome {
        scalars: scalars(settings, &sweep),
        dataset: dataset(settings, &sweep)?,
        table: Some(table(settings, &sweep)?),
        checks,
        missing: incomplete,
        warnings: warnings(values, &sweep.points),
        files: Vec::new(),
    })
}

/// The factors at a value of the parameter.
fn at(case: &StructureCase, settings: &EigenSweep, value: f64) -> Result<Factors, StudyError> {
    let mut values = case.values();
    if let Some(parameter) = values.get_mut(settings.sweep.key.index()) {
        *parameter = value;
    }
    factors(case, &values)
}

fn warnings(values: &[f64], points: &[Point]) -> Vec<String> {
    const SHOWN: usize = 3;
    let told = values.iter().zip(points).filter(|(_, point)| !point.gaps.is_empty());
    told.take(SHOWN)
        .flat_map(|(value, point)| {
            gap_warnings(&point.gaps).into_iter().map(move |gap| format!("at {value}: {gap}"))
        })
        .collect()
}

/// A few points of a projected sweep, solved again on the full matrices: how far eigenvalues lie apart over the error that is shown.
fn against_full(
    (case, structure): (&StructureCase, &Structure),
    settings: &EigenSweep,
    sweep: &Sweep,
) -> Result<Option<CheckRecord>, StudyError> {
    let projected: Vec<usize> = (0..sweep.points.len()).filter(|k| !sweep.points[*k].full).collect();
    if projected.is_empty() {
        return Ok(None);
    }
    let step = projected.len().div_ceil(CHECKED);
    let chosen: Vec<usize> = projected.iter().skip(step / 2).step_by(step).copied().collect();
    let mut figure = 0.0_f64;
    for point in &chosen {
        let problem = structure.family.at(&at(case, settings, settings.sweep.values[*point])?)?;
        let full = complex_modes(&problem, &region(&settings.region), &Settings::default())?;
        for Tracked { eigenvalue, .. } in &sweep.points[*point].eigenvalues {
            let distance = full.modes.iter().map(|mode| (mode.eigenvalue.value - eigenvalue.value).norm());
            let error = full.modes.iter().map(|mode| mode.eigenvalue.error).fold(eigenvalue.error, f64::max);
            figure = figure.max(distance.fold(f64::INFINITY, f64::min) / error);
        }
        if full.modes.len() != sweep.points[*point].eigenvalues.len() {
            figure = f64::INFINITY;
        }
    }
    Ok(Some(CheckRecord {
        name: "the projected eigenvalues are those of the full matrices".to_owned(),
        compared: format!("distance over the error that is shown, at {} values", chosen.len()),
        figure,
        limit: 1.0,
    }))
}

fn scalars(settings: &EigenSweep, sweep: &Sweep) -> Map<String, Value> {
    let lists: Vec<Value> = sweep
        .points
        .iter()
        .map(|point| {
            let entries = point.eigenvalues.iter().map(|tracked| {
                let mut json = entry(&tracked.eigenvalue);
                json["branch"] = json!(tracked.branch);
                json
            });
            entries.collect()
        })
        .collect();
    let is_unstable =
        |point: &Point| point.eigenvalues.iter().any(|t| t.eigenvalue.verdict() == Verdict::Unstable);
    Map::from_iter([
        ("key".to_owned(), json!(settings.sweep.path)),
        ("value".to_owned(), json!(settings.sweep.values)),
        ("eigenvalues".to_owned(), json!(lists)),
        ("complete".to_owned(), json!(sweep.points.iter().all(|point| point.gaps.is_empty()))),
        ("unstable".to_owned(), sweep.points.iter().map(is_unstable).collect()),
        ("branches".to_owned(), json!(sweep.branches)),
        ("method".to_owned(), json!(settings.method.name())),
        ("basis".to_owned(), json!(sweep.basis)),
        ("samples".to_owned(), json!(sweep.samples.len())),
        ("solved_in_full".to_owned(), json!(sweep.points.iter().filter(|point| point.full).count())),
    ])
}

/// What stands where a branch has no eigenvalue.
const NONE: Complex64 = Complex64::new(f64::NAN, f64::NAN);
/// The code of a verdict where a branch has no eigenvalue.
const ABSENT: u8 = 3;

fn dataset(settings: &EigenSweep, sweep: &Sweep) -> Result<Dataset, StudyError> {
    let name = settings.sweep.path.rsplit('.').next().unwrap_or(&settings.sweep.path);
    let quantity = parameter(name);
    let (rows, columns) = (sweep.points.len(), sweep.branches);
    let mut values = vec![NONE; rows * columns];
    let (mut errors, mut verdicts) = (vec![f64::NAN; rows * columns], vec![ABSENT; rows * columns]);
    for (row, point) in sweep.points.iter().enumerate() {
        for Tracked { eigenvalue, branch } in &point.eigenvalues {
            let place = row * columns + branch;
            values[place] = eigenvalue.value;
            errors[place] = eigenvalue.error;
            verdicts[place] = code(eigenvalue.verdict());
        }
    }
    let over = ["value", "branch"];
    let meanings: Vec<(u8, &str)> = VERDICTS.into_iter().chain([(ABSENT, "not in the region")]).collect();
    Ok(Dataset::new()
        .attribute("kind", "eigen-sweep")?
        .attribute("region", json!({ "re": settings.region.re, "im": settings.region.im }))?
        .with(
            Variable::coordinate("value", settings.sweep.values.clone())
                .units("1")
                .long_name(&quantity.label)
                .attribute("label", quantity.label.clone())
                .attribute("scale", settings.sweep.scale.name()),
        )?
        .with(
            Variable::new("eigenvalue", &over, &[rows, columns], values)
                .units("1/s")
                .long_name("eigenvalue λ of a branch, NaN where it is not in the region"),
        )?
        .with(
            Variable::new("error", &over, &[rows, columns], errors)
                .units("1/s")
                .long_name("how far the true eigenvalue may be"),
        )?
        .with(
            Variable::classes("verdict", &over, &[rows, columns], verdicts, &meanings).long_name("verdict"),
        )?)
}

fn table(settings: &EigenSweep, sweep: &Sweep) -> Result<Table, StudyError> {
    let rows: Vec<(f64, &Tracked)> = settings
        .sweep
        .values
        .iter()
        .zip(&sweep.points)
        .flat_map(|(value, point)| point.eigenvalues.iter().map(move |tracked| (*value, tracked)))
        .collect();
    let of = |pick: &dyn Fn(&Tracked) -> f64| -> Vec<f64> {
        rows.iter().map(|(_, tracked)| pick(tracked)).collect()
    };
    let words: Vec<String> = rows.iter().map(|(_, t)| t.eigenvalue.verdict().name().to_owned()).collect();
    let branches: Vec<i64> = rows.iter().map(|(_, tracked)| tracked.branch as i64).collect();
    Ok(Table::new()
        .column("value", "1", rows.iter().map(|(value, _)| *value).collect::<Vec<f64>>())?
        .column("branch", "1", branches)?
        .column("re", "1/s", of(&|t| t.eigenvalue.value.re))?
        .column("im", "1/s", of(&|t| t.eigenvalue.value.im))?
        .column("frequency", "Hz", of(&|t| t.eigenvalue.frequency_hz()))?
        .column("damping_ratio", "1", of(&|t| t.eigenvalue.damping_ratio()))?
        .column("error", "1/s", of(&|t| t.eigenvalue.error))?
        .column("verdict", "1", words)?)
}
