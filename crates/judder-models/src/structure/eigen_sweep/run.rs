//! `eigen-sweep`: complex modes along a parameter, followed from value to value.

use super::branches::SweptBranches;
use super::kept_points::KeptPoints;
use super::onsets::LocatedOnsets;
use super::settings::EigenSweep;
use crate::axis::{Curves, name_of};
use crate::error::ModelError;
use crate::labels::parameter;
use crate::structure::build::{Structure, factors};
use crate::structure::case::StructureCase;
use crate::structure::solved_size::{complex_mode_settings, entries};
use judder_numerics::complex::ElementaryComplex;
use judder_store::Results;
use judder_structure::affine::Factors;
use judder_structure::complex_modes::{Eigenvalue, Region, complex_modes};
use judder_structure::eigen_sweep::{PointEigenvalues, PreparedSweep, SweptEigenvalues, followed};
use judder_structure::onset::StabilityAt;
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::kept::KeptLines;
use judder_study::labels::SweptQuantity;
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};

/// Points of a projected sweep that are solved on the full matrices as well.
const CHECKED: usize = 3;

pub(super) fn run(
    case: &StructureCase,
    structure: &Structure,
    settings: &EigenSweep,
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<Outcome, ModelError> {
    let curves = Curves::of_parameters(case.values(), settings.family.as_ref());
    let points = curves
        .inputs
        .iter()
        .map(|inputs| along(case, settings, inputs))
        .collect::<Result<Vec<Vec<Factors>>, _>>()?;
    let region = settings.region.rectangle();
    let prepared = PreparedSweep::new(
        &structure.family,
        points.iter().flatten().collect(),
        &region,
        complex_mode_settings(entries(structure)),
        settings.method,
    )?;
    let values = &settings.sweep.values;
    let kept = KeptPoints::of("points", kept);
    let numbers = 0..points.len() * values.len();
    // who runs analyses takes the last step of each
    numbers.filter(|number| *number > 0 && kept.has(*number)).for_each(|_| progress.advance());
    let solve = |number: usize| {
        progress.go_on()?;
        if number > 0 && !kept.has(number) {
            progress.advance();
        }
        Ok::<_, ModelError>(prepared.point(number)?)
    };
    let sweeps = (0..points.len())
        .map(|curve| {
            let curve = curve * values.len()..(curve + 1) * values.len();
            let sweep = followed(curve, &region, &solve, &kept)?;
            Ok(SweptEigenvalues { basis: prepared.basis(), samples: prepared.samples(), ..sweep })
        })
        .collect::<Result<Vec<_>, ModelError>>()?;
    let onsets = curves.inputs.iter().zip(&sweeps).map(|(inputs, sweep)| {
        let known: Vec<Option<StabilityAt>> =
            sweep.points.iter().map(|point| Some(point.stability(Vec::new()))).collect();
        LocatedOnsets::new(values, &known, &region, &|value, within| {
            progress.go_on()?;
            let factors = at(case, settings, inputs, value)?;
            Ok(prepared.within(&factors, within)?.stability(Vec::new()))
        })
    });
    let onsets = onsets.collect::<Result<_, _>>()?;
    let quantity = SweptQuantity { name: "value".to_owned(), ..parameter(name_of(&settings.sweep.path)) };
    let (values, scale) = (settings.sweep.values.clone(), settings.sweep.scale);
    let axis = SweptAxis { quantity, values, scale, shown: None };
    let (all_factors, all_points): (Vec<&Factors>, Vec<&PointEigenvalues>) =
        points.iter().flatten().zip(sweeps.iter().flat_map(|sweep| &sweep.points)).unzip();
    let against_full = against_full(structure, &region, &all_factors, &all_points)?;
    let branches = SweptBranches::new(&settings.region, axis, curves, sweeps, onsets);
    let checks = [branches.completeness()].into_iter().chain(against_full).collect();
    let mut scalars = branches.scalars();
    scalars.extend(ToldEigenSweep::new(settings, &branches).scalars());
    Ok(Outcome {
        scalars,
        dataset: branches.dataset()?,
        table: Some(branches.table()?),
        checks,
        missing: branches.incomplete(),
        warnings: branches.warnings(),
        files: Vec::new(),
        ..Outcome::default()
    })
}

/// The factors along a curve whose parameters have these values.
fn along(case: &StructureCase, settings: &EigenSweep, inputs: &[f64]) -> Result<Vec<Factors>, ModelError> {
    settings.sweep.values.iter().map(|value| at(case, settings, inputs, *value)).collect()
}

/// The factors at a value of the swept parameter, where the others have these values.
fn at(
    case: &StructureCase,
    settings: &EigenSweep,
    inputs: &[f64],
    value: f64,
) -> Result<Factors, ModelError> {
    let mut inputs = inputs.to_vec();
    if let Some(parameter) = inputs.get_mut(settings.sweep.key.index()) {
        *parameter = value;
    }
    factors(case, &inputs)
}

/// A few points of a projected sweep, solved again on the full matrices: how far eigenvalues lie apart over the error that is shown.
fn against_full(
    structure: &Structure,
    region: &Region,
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
        let full = complex_modes(&problem, region, &complex_mode_settings(entries(structure)))?;
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
        let distance = |k: &usize| (theirs[*k].value - one.value).modulus();
        let nearest = (0..theirs.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some(other) = nearest.map(|k| theirs.swap_remove(k)) else { continue };
        found.add((other.value - one.value).modulus() / (other.error + one.error));
    }
}

/// What is told of a sweep.
#[derive(Results)]
pub(super) struct ToldEigenSweep {
    /// the swept parameter
    key: String,
    /// `full` or `projected`
    method: String,
    /// vectors of the basis of a projected sweep
    basis: Option<usize>,
    /// values at which that was sampled
    samples: usize,
}

impl ToldEigenSweep {
    fn new<I>(settings: &EigenSweep, branches: &SweptBranches<'_, I>) -> Self {
        // one basis serves all curves
        let first = branches.sweeps.first();
        Self {
            key: settings.sweep.path.clone(),
            method: settings.method.to_string(),
            basis: first.and_then(|sweep| sweep.basis),
            samples: first.map_or(0, |sweep| sweep.samples.len()),
        }
    }
}
