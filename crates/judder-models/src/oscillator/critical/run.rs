//! Thresholds along one key (Figs. 7, 8).

use super::found::FoundThresholds;
use super::{onsets, within_law};
use crate::axis::{self, Curves, keys_of_curves};
use crate::bridge;
use crate::checks;
use crate::error::ModelError;
use crate::key_unit::{in_unit, unit_of};
use crate::oscillator::case::OscillatorCase;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::margins::{KeptMargins, MarginCrossing, MarginOnset, fold_check};
use crate::oscillator::settings::{CriticalThresholds, SoughtThresholds};
use judder_keys::numeric_key::{Form, Value};
use judder_numerics::parallel;
use judder_oscillator::Contact;
use judder_oscillator::critical::{ParameterRange, RangeScale, Thresholds, thresholds};
use judder_oscillator::undecided::undecided;
use judder_store::{Dataset, Declared, Results, Table, Variable};
use judder_study::Progress;
use judder_study::axis::SweptAxis;
use judder_study::kept::KeptLines;
use judder_study::outcome::Outcome;

/// Samples of the search a decade of its range.
const SAMPLES_PER_DECADE: f64 = 40.0;

/// Label and unit of the axis of thresholds.
pub(super) fn label(sought: SoughtThresholds, form: Form) -> (&'static str, &'static str) {
    match (sought, form) {
        (SoughtThresholds::ShearStrength, Form::Group) => ("Critical shear strength $τ̃_{0,crit}$ (−)", "1"),
        (SoughtThresholds::ShearStrength, Form::Si) => ("Critical shear strength $τ_{0,crit}$ (Pa)", "Pa"),
        (SoughtThresholds::Load, Form::Group) => ("Critical load $F̃_{n,crit}$ (−)", "1"),
        (SoughtThresholds::Load, Form::Si) => ("Critical load $F_{n,crit}$ (N)", "N"),
    }
}

pub(super) fn run(
    case: &OscillatorCase,
    contact: &Contact,
    settings: &CriticalThresholds,
    (kept, progress): (KeptLines<'_>, &dyn Progress),
) -> Result<Outcome, ModelError> {
    let (axis, curves) = (axis::of_key(&settings.sweep), Curves::new(case, settings.family.as_ref()));
    let points: Vec<OscillatorInputs> = curves
        .inputs
        .iter()
        .flat_map(|inputs| {
            axis.values.iter().map(|value| {
                let mut here = *inputs;
                settings.sweep.set(&mut here, *value);
                here
            })
        })
        .collect();
    let kept = KeptMargins::of("points", kept);
    let found: Vec<FoundThresholds> = parallel::try_each_place(points.len(), |place| {
        let found = at_point(contact, settings, (place, points[place]), (&kept, progress));
        progress.advance();
        // a branch that was interrupted has only ended early
        if progress.interrupted() { Err(ModelError::Interrupted) } else { Ok(found) }
    })?;
    let mut outcome = assemble(settings, &axis, &curves, &found)?;
    if !contact.law.is_formula() {
        within_law::add(
            &mut outcome,
            &axis,
            &curves,
            &found,
            label(settings.sought, settings.within.form).1,
        )?;
    }
    let roots: Vec<(OscillatorInputs, &Thresholds)> =
        found.iter().map(|found| (found.inputs, &found.thresholds)).collect();
    outcome.checks = checks::thresholds(contact, &roots, |inputs, value| {
        let mut inputs = *inputs;
        inputs.set(settings.sought.key(), Value { number: value, form: settings.within.form });
        inputs
    });
    let onsets: Vec<(MarginCrossing<'_>, &MarginOnset)> = found
        .iter()
        .flat_map(|found| {
            let crossing = crossing(contact, settings, found.inputs);
            found.onsets.iter().flatten().map(move |onset| (crossing, onset))
        })
        .collect();
    let (check, warning) = fold_check(&onsets, progress);
    outcome.checks.extend(check);
    outcome.warnings.extend(warning);
    if progress.interrupted() { Err(ModelError::Interrupted) } else { Ok(outcome) }
}

fn crossing<'a>(
    contact: &'a Contact,
    settings: &CriticalThresholds,
    inputs: OscillatorInputs,
) -> MarginCrossing<'a> {
    let (key, within) = (settings.sought.key(), &settings.within);
    let range = ParameterRange { from: within.from, to: within.to, scale: RangeScale::Logarithmic };
    MarginCrossing { contact, inputs, key, form: within.form, range }
}

fn at_point(
    contact: &Contact,
    settings: &CriticalThresholds,
    (place, inputs): (usize, OscillatorInputs),
    way: (&KeptMargins<'_>, &dyn Progress),
) -> FoundThresholds {
    let crossing = crossing(contact, settings, inputs);
    let decades = libm::log10(settings.within.to / settings.within.from);
    let samples = (decades * SAMPLES_PER_DECADE).ceil() as usize + 1;
    let at = |value: f64| bridge::coefficients(&crossing.inputs_at(value));
    let thresholds = thresholds(contact, &crossing.range, samples, at);
    let onsets = match settings.global_margin {
        true => crossing.onsets_with_margins(place, &thresholds.full, way),
        false => thresholds.full.iter().map(|threshold| crossing.onset(*threshold)).collect(),
    };
    let roots = [thresholds.full.as_slice(), thresholds.conservative.as_slice()];
    let is_known = contact.law.knows_its_errors();
    let within_law = is_known.then(|| undecided(contact, &crossing.range, samples, roots, at));
    FoundThresholds { inputs, thresholds, onsets, within_law }
}

/// What is told of the thresholds of a curve, a list of them a value.
#[derive(Results)]
struct ThresholdCurve {
    value: Vec<f64>,
    full: Vec<Vec<f64>>,
    conservative: Vec<Vec<f64>>,
}

/// Where they were sought.
#[derive(Results)]
struct ToldRange {
    within: [f64; 2],
}

/// The keys of the summary.
pub(super) fn summary_keys(settings: &CriticalThresholds) -> Vec<Declared> {
    let curve =
        [ThresholdCurve::declared(), onsets::keys(settings.global_margin), within_law::keys()].concat();
    let keys = [keys_of_curves(settings.family.is_some(), curve), ToldRange::declared()].concat();
    let (_, unit) = label(settings.sought, settings.within.form);
    let keys = in_unit(keys, unit, &["full", "conservative", "within", "fold", "branch_fold", "reaches"]);
    in_unit(keys, &unit_of::<OscillatorKeys>(&settings.sweep), &["value"])
}

fn assemble(
    settings: &CriticalThresholds,
    axis: &SweptAxis,
    curves: &Curves,
    found: &[FoundThresholds],
) -> Result<Outcome, ModelError> {
    let CriticalThresholds { sought, within, global_margin, .. } = settings;
    let (sought, global_margin) = (*sought, *global_margin);
    let failures = found.iter().filter(|found| !found.thresholds.failures.is_empty()).count();
    let mut warnings = Vec::new();
    if failures > 0 {
        warnings.push(format!(
            "no steady sliding somewhere in the searched range at {failures} of {} points: thresholds next to it may be missing",
            found.len()
        ));
    }
    let scalars = found.chunks(axis.values.len()).map(|curve| {
        let list = |pick: fn(&Thresholds) -> &Vec<f64>| {
            curve.iter().map(|found| pick(&found.thresholds).clone()).collect::<Vec<_>>()
        };
        let (full, conservative) = (list(|t| &t.full), list(|t| &t.conservative));
        let mut scalars = ThresholdCurve { value: axis.values.clone(), full, conservative }.scalars();
        onsets::add_scalars(&mut scalars, curve, global_margin);
        scalars
    });
    let mut scalars = curves.scalars(scalars.collect());
    scalars.extend(ToldRange { within: [within.from, within.to] }.scalars());
    let (label, unit) = label(sought, within.form);
    let dataset = roots(axis, curves, found, label, unit)?;
    let dataset = onsets::add_arrays(dataset, axis, curves, found, unit, global_margin)?;
    warnings.extend(onsets::warnings(found));
    Ok(Outcome {
        scalars,
        dataset,
        table: Some(table(axis, curves, found, unit, global_margin)?),
        warnings,
        missing: failures,
        ..Outcome::default()
    })
}

/// The thresholds of both systems.
fn roots(
    axis: &SweptAxis,
    curves: &Curves,
    found: &[FoundThresholds],
    label: &str,
    unit: &str,
) -> Result<Dataset, ModelError> {
    let mut dataset = Dataset::new().with(axis.coordinate())?;
    if let Some(coordinate) = curves.coordinate() {
        dataset = dataset.with(coordinate)?;
    }
    for (name, pick, what) in [
        ("full", (|t: &Thresholds| &t.full) as fn(&Thresholds) -> &Vec<f64>, "of the full system"),
        ("conservative", |t| &t.conservative, "without damping, eqs. (27), (28) made self-consistent"),
    ] {
        let most = found.iter().map(|found| pick(&found.thresholds).len()).max().unwrap_or(0);
        let root = format!("{name}_root");
        let padded = found.iter().flat_map(|found| {
            let roots = pick(&found.thresholds);
            roots.iter().copied().chain(std::iter::repeat_n(f64::NAN, most - roots.len()))
        });
        let (dimensions, shape) = curves.dimensions(axis, &[(&root, most)]);
        let variable = Variable::new(name, &dimensions, &shape, padded.collect::<Vec<f64>>())
            .units(unit)
            .long_name(&format!("thresholds {what}, ascending, NaN where there are fewer"))
            .attribute("label", label)
            .apart();
        dataset = dataset.with(variable)?;
    }
    Ok(dataset)
}

/// One row a threshold.
fn table(
    axis: &SweptAxis,
    curves: &Curves,
    found: &[FoundThresholds],
    unit: &str,
    global_margin: bool,
) -> Result<Table, ModelError> {
    let (mut values, mut thresholds) = (Vec::<f64>::new(), Vec::<f64>::new());
    let mut systems: Vec<String> = Vec::new();
    let mut onsets: Vec<Option<&MarginOnset>> = Vec::new();
    let mut rows_of_curve = Vec::new();
    for curve in found.chunks(axis.values.len()) {
        let before = values.len();
        for (found, value) in curve.iter().zip(&axis.values) {
            let Thresholds { full, conservative, .. } = &found.thresholds;
            for (system, roots) in [("full", full), ("conservative", conservative)] {
                values.extend(std::iter::repeat_n(*value, roots.len()));
                systems.extend(std::iter::repeat_n(system.to_owned(), roots.len()));
                thresholds.extend(roots);
            }
            onsets.extend(found.onsets.iter().map(Option::as_ref));
            onsets.extend(conservative.iter().map(|_| None));
        }
        rows_of_curve.push(values.len() - before);
    }
    let mut table = Table::new();
    if let Some((name, unit, column)) = curves.column(&rows_of_curve) {
        table = table.column(&name, &unit, column)?;
    }
    table = table.column(axis.name(), &axis.quantity.unit, values)?.column("system", "", systems)?.column(
        "threshold",
        unit,
        thresholds,
    )?;
    onsets::add_columns(table, &onsets, unit, global_margin)
}
