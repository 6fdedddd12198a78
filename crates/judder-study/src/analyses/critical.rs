//! `critical-shear-strength`, `critical-load`: thresholds along one key (Figs. 7, 8).

use super::axis::{Axis, Curves};
use crate::bridge;
use crate::checks;
use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use judder_case::{Family, Form, OscillatorCase, OscillatorInputs, OscillatorKey, Sweep, Value, Within};
use judder_oscillator::Contact;
use judder_oscillator::critical::{Range, Scale, Thresholds, thresholds};
use judder_store::{Dataset, Table, Variable};
use rayon::prelude::*;
use serde_json::{Map, json};

/// Samples of the search a decade of its range.
const SAMPLES_PER_DECADE: f64 = 40.0;

/// Which quantity's thresholds are sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sought {
    /// τ0,crit.
    ShearStrength,
    /// F_n,crit.
    Load,
}

impl Sought {
    fn key(self) -> OscillatorKey {
        match self {
            Self::ShearStrength => OscillatorKey::ShearStrength,
            Self::Load => OscillatorKey::NormalLoad,
        }
    }

    fn kind(self) -> &'static str {
        match self {
            Self::ShearStrength => "critical-shear-strength",
            Self::Load => "critical-load",
        }
    }

    /// Label of the axis of thresholds.
    fn label(self, form: Form) -> (&'static str, &'static str) {
        match (self, form) {
            (Self::ShearStrength, Form::Group) => ("Critical shear strength $τ̃_{0,crit}$ (−)", "1"),
            (Self::ShearStrength, Form::Si) => ("Critical shear strength $τ_{0,crit}$ (Pa)", "Pa"),
            (Self::Load, Form::Group) => ("Critical load $F̃_{n,crit}$ (−)", "1"),
            (Self::Load, Form::Si) => ("Critical load $F_{n,crit}$ (N)", "N"),
        }
    }
}

pub(super) fn run(
    (case, contact): (&OscillatorCase, &Contact),
    sought: Sought,
    sweep: &Sweep<OscillatorKey>,
    within: &Within,
    family: Option<&Family<OscillatorKey>>,
    progress: &dyn Progress,
) -> Result<Outcome, StudyError> {
    let (axis, curves) = (Axis::of_oscillator(sweep), Curves::new(case, family));
    let range = Range { from: within.from, to: within.to, scale: Scale::Logarithmic };
    let samples = ((within.to / within.from).log10() * SAMPLES_PER_DECADE).ceil() as usize + 1;
    let set = |inputs: &OscillatorInputs, value: f64| {
        let mut inputs = *inputs;
        inputs.set(sought.key(), Value { number: value, form: within.form });
        inputs
    };
    let mut found: Vec<(OscillatorInputs, Thresholds)> = Vec::new();
    for inputs in &curves.inputs {
        let line: Result<Vec<_>, StudyError> = axis
            .values
            .par_iter()
            .map(|value| {
                if progress.interrupted() {
                    return Err(StudyError::Interrupted);
                }
                let mut here = *inputs;
                sweep.set(&mut here, *value);
                let at = |threshold: f64| bridge::coefficients(&set(&here, threshold));
                let found = thresholds(contact, &range, samples, at);
                progress.advance();
                Ok((here, found))
            })
            .collect();
        found.extend(line?);
    }
    let roots: Vec<(OscillatorInputs, &Thresholds)> = found.iter().map(|(inputs, t)| (*inputs, t)).collect();
    let mut outcome = assemble(sought, within, &axis, &curves, &found)?;
    outcome.checks = checks::thresholds(contact, &roots, set);
    Ok(outcome)
}

fn assemble(
    sought: Sought,
    within: &Within,
    axis: &Axis,
    curves: &Curves,
    found: &[(OscillatorInputs, Thresholds)],
) -> Result<Outcome, StudyError> {
    let failures: usize = found.iter().map(|(_, t)| usize::from(!t.failures.is_empty())).sum();
    let mut warnings = Vec::new();
    if failures > 0 {
        warnings.push(format!(
            "no steady sliding somewhere in the searched range at {failures} of {} points: thresholds next to it may be missing",
            found.len()
        ));
    }
    let scalars = found.chunks(axis.values.len()).map(|curve| {
        let list = |pick: fn(&Thresholds) -> &Vec<f64>| {
            curve.iter().map(|(_, t)| json!(pick(t))).collect::<Vec<_>>()
        };
        Map::from_iter([
            ("value".to_owned(), json!(axis.values)),
            ("full".to_owned(), json!(list(|t| &t.full))),
            ("conservative".to_owned(), json!(list(|t| &t.conservative))),
        ])
    });
    let mut scalars = curves.scalars(scalars.collect());
    scalars.insert("within".to_owned(), json!([within.from, within.to]));
    let mut dataset = Dataset::new().with(axis.coordinate())?;
    if let Some(coordinate) = curves.coordinate() {
        dataset = dataset.with(coordinate)?;
    }
    let (label, unit) = sought.label(within.form);
    for (name, pick, what) in [
        ("full", (|t: &Thresholds| &t.full) as fn(&Thresholds) -> &Vec<f64>, "of the full system"),
        ("conservative", |t| &t.conservative, "without damping, eqs. (27), (28) made self-consistent"),
    ] {
        let most = found.iter().map(|(_, t)| pick(t).len()).max().unwrap_or(0);
        let root = format!("{name}_root");
        let padded = found.iter().flat_map(|(_, t)| {
            let roots = pick(t);
            roots.iter().copied().chain(std::iter::repeat_n(f64::NAN, most - roots.len()))
        });
        let (dimensions, shape) = curves.dimensions(axis, &[(&root, most)]);
        let variable = Variable::new(name, &dimensions, &shape, padded.collect::<Vec<f64>>())
            .units(unit)
            .long_name(&format!("thresholds {what}, ascending, NaN where there are fewer"))
            .attribute("label", label);
        dataset = dataset.with(variable)?;
    }
    Ok(Outcome {
        scalars,
        dataset: dataset.attribute("kind", sought.kind())?,
        table: Some(table(axis, curves, found, unit)?),
        warnings,
        missing: failures,
        ..Outcome::default()
    })
}

/// One row a threshold.
fn table(
    axis: &Axis,
    curves: &Curves,
    found: &[(OscillatorInputs, Thresholds)],
    unit: &str,
) -> Result<Table, StudyError> {
    let (mut values, mut thresholds) = (Vec::<f64>::new(), Vec::<f64>::new());
    let mut systems: Vec<String> = Vec::new();
    let mut rows_of_curve = Vec::new();
    for curve in found.chunks(axis.values.len()) {
        let before = values.len();
        for ((_, t), value) in curve.iter().zip(&axis.values) {
            for (system, roots) in [("full", &t.full), ("conservative", &t.conservative)] {
                values.extend(std::iter::repeat_n(*value, roots.len()));
                systems.extend(std::iter::repeat_n(system.to_owned(), roots.len()));
                thresholds.extend(roots);
            }
        }
        rows_of_curve.push(values.len() - before);
    }
    let mut table = Table::new();
    if let Some((name, unit, column)) = curves.column(&rows_of_curve) {
        table = table.column(&name, &unit, column)?;
    }
    Ok(table.column(axis.name(), &axis.quantity.unit, values)?.column("system", "", systems)?.column(
        "threshold",
        unit,
        thresholds,
    )?)
}
