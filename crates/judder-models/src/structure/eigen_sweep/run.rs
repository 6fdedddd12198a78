//! `eigen-sweep`: complex modes along a parameter, followed from value to value.

use super::super::eigen::run::{ToldMode, VERDICTS, code, gap_warnings, in_order};
use super::settings::EigenSweep;
use crate::axis::{Curves, name_of};
use crate::error::ModelError;
use crate::labels::parameter;
use crate::structure::build::{Structure, factors};
use crate::structure::case::StructureCase;
use judder_store::{Dataset, Results, Table, Variable};
use judder_structure::affine::Factors;
use judder_structure::complex_modes::{ComplexModeSettings, Eigenvalue, EigenvalueVerdict, complex_modes};
use judder_structure::eigen_sweep::{PointEigenvalues, SweptEigenvalues, Tracked, eigen_sweeps};
use judder_study::Progress;
use judder_study::axis::Axis;
use judder_study::labels::Quantity;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};
use num_complex::Complex64;
use serde_json::{Map, Value, json};

/// Points of a projected sweep that are solved on the full matrices as well.
const CHECKED: usize = 3;

/// What is swept and what came of it.
struct Run<'a> {
    settings: &'a EigenSweep,
    axis: Axis,
    curves: Curves<Vec<f64>>,
    /// One for each curve.
    sweeps: Vec<SweptEigenvalues>,
}

pub(super) fn run(
    case: &StructureCase,
    structure: &Structure,
    settings: &EigenSweep,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let curves = Curves::of_parameters(case.values(), settings.family.as_ref());
    let points = curves
        .inputs
        .iter()
        .map(|inputs| along(case, settings, inputs))
        .collect::<Result<Vec<Vec<Factors>>, _>>()?;
    let each_curve: Vec<&[Factors]> = points.iter().map(Vec::as_slice).collect();
    let mut sweeps = eigen_sweeps(
        &structure.family,
        &each_curve,
        &settings.region,
        &ComplexModeSettings::default(),
        settings.method,
    )?;
    for point in sweeps.iter_mut().flat_map(|sweep| &mut sweep.points) {
        point.eigenvalues.sort_by(|a, b| in_order(&a.eigenvalue, &b.eigenvalue));
    }
    let (all_factors, all_points): (Vec<&Factors>, Vec<&PointEigenvalues>) =
        points.iter().flatten().zip(sweeps.iter().flat_map(|sweep| &sweep.points)).unzip();
    (1..all_points.len()).for_each(|_| progress.advance());
    let incomplete = all_points.iter().filter(|point| !point.gaps.is_empty()).count();
    let mut checks = vec![CheckRecord::new(
        "no eigenvalue is missing",
        format!("values at which a check did not close, of {}", all_points.len()),
        Disagreement::exceptions(all_points.iter().map(|point| !point.gaps.is_empty())),
        0.0,
    )];
    checks.extend(against_full(structure, settings, &all_factors, &all_points)?);
    let quantity = Quantity { name: "value".to_owned(), ..parameter(name_of(&settings.sweep.path)) };
    let axis = Axis { quantity, values: settings.sweep.values.clone(), scale: settings.sweep.scale };
    let run = Run { settings, axis, curves, sweeps };
    Ok(Outcome {
        scalars: run.scalars(),
        dataset: run.dataset()?,
        table: Some(run.table()?),
        checks,
        missing: incomplete,
        warnings: run.warnings(),
        files: Vec::new(),
        ..Outcome::default()
    })
}

/// The factors along a curve whose parameters have these values.
fn along(case: &StructureCase, settings: &EigenSweep, inputs: &[f64]) -> Result<Vec<Factors>, ModelError> {
    let mut inputs = inputs.to_vec();
    let mut at = |value: &f64| {
        if let Some(parameter) = inputs.get_mut(settings.sweep.key.index()) {
            *parameter = *value;
        }
        factors(case, &inputs)
    };
    settings.sweep.values.iter().map(&mut at).collect()
}

/// A few points of a projected sweep, solved again on the full matrices: how far eigenvalues lie apart over the error that is shown.
fn against_full(
    structure: &Structure,
    settings: &EigenSweep,
    factors: &[&Factors],
    points: &[&PointEigenvalues],
) -> Result<Option<CheckRecord>, ModelError> {
    let projected: Vec<usize> = (0..points.len()).filter(|k| !points[*k].full).collect();
    if projected.is_empty() {
        return Ok(None);
    }
    let step = projected.len().div_ceil(CHECKED);
    let chosen: Vec<usize> = projected.iter().skip(step / 2).step_by(step).copied().collect();
    let mut found = Disagreement::default();
    for point in &chosen {
        let problem = structure.family.at(factors[*point])?;
        let full = complex_modes(&problem, &settings.region, &ComplexModeSettings::default())?;
        let projected = points[*point].eigenvalues.iter().map(|tracked| tracked.eigenvalue).collect();
        let full = full.modes.iter().map(|mode| mode.eigenvalue).collect();
        compare(projected, full, &mut found);
    }
    let check = CheckRecord::new(
        "the projected eigenvalues are those of the full matrices",
        format!("distance over the error that is shown, at {} values", chosen.len()),
        found,
        1.0,
    );
    // where neither has an eigenvalue, there is nothing to compare
    Ok((!check.compared_nothing()).then_some(check))
}

/// How far the eigenvalues of two lists lie apart, pair by pair, over both errors; infinite where the lists differ in length.
fn compare(ours: Vec<Eigenvalue>, mut theirs: Vec<Eigenvalue>, found: &mut Disagreement) {
    if ours.len() != theirs.len() {
        found.add(f64::INFINITY);
        return;
    }
    for one in ours {
        let distance = |k: &usize| (theirs[*k].value - one.value).norm();
        let nearest = (0..theirs.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some(other) = nearest.map(|k| theirs.swap_remove(k)) else { continue };
        found.add((other.value - one.value).norm() / (other.error + one.error));
    }
}

/// What is told of a sweep.
#[derive(Results)]
pub(super) struct ToldSweep {
    /// the swept parameter
    key: String,
    /// `full` or `projected`
    method: String,
    /// vectors of the basis of a projected sweep
    basis: Option<usize>,
    /// values at which that was sampled
    samples: usize,
}

/// What is told of one curve.
#[derive(Results)]
pub(super) struct EigenvalueCurve {
    /// the values of the parameter
    value: Vec<f64>,
    /// the eigenvalues at each
    eigenvalues: Vec<Vec<OnBranch>>,
    /// whether it is proven that there are no more
    complete: bool,
    /// whether one grows, at each
    unstable: Vec<bool>,
    branches: usize,
    /// values that were solved on the full matrices
    solved_in_full: usize,
}

/// An eigenvalue of a branch.
#[derive(Results)]
struct OnBranch {
    #[result(flatten)]
    mode: ToldMode,
    branch: usize,
}

impl EigenvalueCurve {
    fn new(values: &[f64], sweep: &SweptEigenvalues) -> Self {
        let told = |own: &Tracked| OnBranch { mode: ToldMode::new(0, &own.eigenvalue), branch: own.branch };
        let is_unstable = |point: &PointEigenvalues| {
            point.eigenvalues.iter().any(|t| t.eigenvalue.verdict() == EigenvalueVerdict::Unstable)
        };
        Self {
            value: values.to_vec(),
            eigenvalues: sweep
                .points
                .iter()
                .map(|point| point.eigenvalues.iter().map(told).collect())
                .collect(),
            complete: sweep.points.iter().all(|point| point.gaps.is_empty()),
            unstable: sweep.points.iter().map(is_unstable).collect(),
            branches: sweep.branches,
            solved_in_full: sweep.points.iter().filter(|point| point.full).count(),
        }
    }
}

/// What stands where a branch has no eigenvalue.
const NONE: Complex64 = Complex64::new(f64::NAN, f64::NAN);
/// The code of a verdict where a branch has no eigenvalue.
const ABSENT: u8 = 3;

impl Run<'_> {
    fn scalars(&self) -> Map<String, Value> {
        let curves = self.sweeps.iter().map(|sweep| EigenvalueCurve::new(&self.axis.values, sweep).scalars());
        let mut scalars = self.curves.scalars(curves.collect());
        // one basis serves all curves
        let (basis, samples) =
            self.sweeps.first().map_or((None, 0), |sweep| (sweep.basis, sweep.samples.len()));
        let (key, method) = (self.settings.sweep.path.clone(), self.settings.method.to_string());
        scalars.extend(ToldSweep { key, method, basis, samples }.scalars());
        scalars
    }

    fn warnings(&self) -> Vec<String> {
        const SHOWN: usize = 3;
        let points = self.sweeps.iter().enumerate().flat_map(|(curve, sweep)| {
            self.axis.values.iter().zip(&sweep.points).map(move |(value, point)| (curve, value, point))
        });
        let open = points.filter(|(_, _, point)| !point.gaps.is_empty());
        let more = open.clone().count().saturating_sub(SHOWN);
        let mut warnings: Vec<String> = open
            .take(SHOWN)
            .flat_map(|(curve, value, point)| {
                let with = self.curves.told(curve).map_or_else(String::new, |told| format!(", {told}"));
                gap_warnings(&point.gaps).into_iter().map(move |gap| format!("at {value}{with}: {gap}"))
            })
            .collect();
        if more > 0 {
            warnings.push(format!("eigenvalues may be missing at {more} more values"));
        }
        warnings
    }

    fn dataset(&self) -> Result<Dataset, ModelError> {
        let branches = self.sweeps.iter().map(|sweep| sweep.branches).max().unwrap_or(0);
        let (over, shape) = self.curves.dimensions(&self.axis, &[("branch", branches)]);
        let count = shape.iter().product();
        let mut values = vec![NONE; count];
        let (mut errors, mut verdicts) = (vec![f64::NAN; count], vec![ABSENT; count]);
        for (row, point) in self.sweeps.iter().flat_map(|sweep| &sweep.points).enumerate() {
            for Tracked { eigenvalue, branch } in &point.eigenvalues {
                let place = row * branches + branch;
                values[place] = eigenvalue.value;
                errors[place] = eigenvalue.error;
                verdicts[place] = code(eigenvalue.verdict());
            }
        }
        let region = &self.settings.region;
        let meanings: Vec<(u8, &str)> = VERDICTS.into_iter().chain([(ABSENT, "not in the region")]).collect();
        let mut dataset = Dataset::new().attribute("region", json!({ "re": region.re, "im": region.im }))?;
        if let Some(family) = self.curves.coordinate() {
            dataset = dataset.with(family)?;
        }
        Ok(dataset
            .with(self.axis.coordinate())?
            .with(
                Variable::new("eigenvalue", &over, &shape, values)
                    .units("1/s")
                    .long_name("eigenvalue λ of a branch, NaN where it is not in the region"),
            )?
            .with(
                Variable::new("error", &over, &shape, errors)
                    .units("1/s")
                    .long_name("how far the true eigenvalue may be"),
            )?
            .with(Variable::classes("verdict", &over, &shape, verdicts, &meanings).long_name("verdict"))?)
    }

    fn table(&self) -> Result<Table, ModelError> {
        let rows_of =
            |sweep: &SweptEigenvalues| sweep.points.iter().map(|point| point.eigenvalues.len()).sum();
        let rows_of_curve: Vec<usize> = self.sweeps.iter().map(rows_of).collect();
        let points = self.sweeps.iter().flat_map(|sweep| self.axis.values.iter().zip(&sweep.points));
        let rows: Vec<(f64, &Tracked)> = points
            .flat_map(|(value, point)| point.eigenvalues.iter().map(move |tracked| (*value, tracked)))
            .collect();
        let of = |pick: &dyn Fn(&Tracked) -> f64| -> Vec<f64> {
            rows.iter().map(|(_, tracked)| pick(tracked)).collect()
        };
        let words: Vec<String> = rows.iter().map(|(_, t)| t.eigenvalue.verdict().name().to_owned()).collect();
        let branches: Vec<i64> = rows.iter().map(|(_, tracked)| tracked.branch as i64).collect();
        let mut table = Table::new();
        if let Some((name, unit, values)) = self.curves.column(&rows_of_curve) {
            table = table.column(&name, &unit, values)?;
        }
        Ok(table
            .column("value", "1", rows.iter().map(|(value, _)| *value).collect::<Vec<f64>>())?
            .column("branch", "1", branches)?
            .column("re", "1/s", of(&|t| t.eigenvalue.value.re))?
            .column("im", "1/s", of(&|t| t.eigenvalue.value.im))?
            .column("frequency", "Hz", of(&|t| t.eigenvalue.frequency_hz()))?
            .column("damping_ratio", "1", of(&|t| t.eigenvalue.damping_ratio()))?
            .column("error", "1/s", of(&|t| t.eigenvalue.error))?
            .column("verdict", "1", words)?)
    }
}
