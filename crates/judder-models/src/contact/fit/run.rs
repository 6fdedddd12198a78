//! `fit`: the three functions of the oscillator paper through a computed law (appendix B).

use crate::computed_law::{ComputedLaw, Points, compute};
use crate::contact::case::ContactCase;
use crate::contact::law::Plane;
use crate::contact::settings::LawSettings;
use crate::error::ModelError;
use crate::material::ContactScales;
use judder_contact::fit::{CoefficientComparison, FitError, FunctionFit, LawFit};
use judder_contact::{FittedLaw, Law};
use judder_store::{Table, Variable, number};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};
use serde_json::{Map, Value, json};

/// What the samples of a fit are.
const SAMPLES: &str = "the computed law at every speed and indentation of the case";
/// How closely a fit must come back when it is fitted to itself.
const RETURN_LIMIT: f64 = 1e-6;

pub(super) fn run(
    case: &ContactCase,
    (settings, velocity_scale): (&LawSettings, f64),
    points: Points<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let scales = ContactScales::new(case)?;
    let plane = Plane::new(settings, &scales);
    let computed = compute(&plane.task(case, &scales, settings)?, points, progress)?;
    let values = plane.values(&computed.law);
    let unfit = |error: FitError| ModelError::Unsupported(error.to_string());
    let fit = plane.fit(&computed.law, velocity_scale.log10()).map_err(unfit)?;
    let beside = fit.beside(&FittedLaw::oscillator_paper());
    let shape = [plane.indentations.len(), plane.velocities.len()];
    let over_plane = |name: &str, values: Vec<f64>, long_name: &str| {
        Variable::new(name, &["indentation", "velocity"], &shape, values).units("1").long_name(long_name)
    };
    let fitted = plane.values(&Law::Fitted(fit.law()));
    let mut dataset = plane.coordinates()?;
    for (name, values, symbol) in [
        ("force", values.force, "normal force F/(E0* R²), computed"),
        ("area", values.area, "contact area A/R², computed"),
        ("friction", values.friction, "viscoelastic friction coefficient, computed"),
        ("fitted_force", fitted.force, "normal force F/(E0* R²), eq. (34)"),
        ("fitted_area", fitted.area, "contact area A/R², eq. (36)"),
        ("fitted_friction", fitted.friction, "viscoelastic friction coefficient, eq. (38)"),
    ] {
        dataset = dataset.with(over_plane(name, values, symbol))?;
    }
    let missed = computed.missed(settings.accuracy);
    Ok(Outcome {
        scalars: scalars(&fit, &beside, velocity_scale, (&computed, shape.iter().product())),
        dataset: dataset.attribute("kind", "fit")?,
        table: Some(table(&beside)?),
        checks: vec![returns(&plane, &fit).map_err(unfit)?],
        missing: usize::from(missed.is_some()),
        warnings: missed.into_iter().chain(warning(&fit)).collect(),
        ..Outcome::default()
    })
}

fn scalars(
    fit: &LawFit,
    beside: &[CoefficientComparison],
    velocity_scale: f64,
    (computed, samples): (&ComputedLaw, usize),
) -> Map<String, Value> {
    let law_error = computed.errors().total();
    fn function<const N: usize>(fit: &FunctionFit<N>) -> Value {
        json!({
            "coefficients": fit.coefficients.to_vec(), "standard_errors": fit.standard_errors.to_vec(),
            "intervals": fit.intervals.iter().map(|(low, high)| [*low, *high]).collect::<Vec<_>>(),
            "r2": number(fit.r2),
        })
    }
    let compared = beside.iter().map(|line| {
        json!({
            "name": line.name, "value": line.value, "standard_error": number(line.standard_error),
            "paper": line.reference, "deviation": number(line.deviation()),
            "relative_deviation": number(line.relative_deviation()),
        })
    });
    Map::from_iter([
        ("force".to_owned(), function(&fit.force)),
        ("area".to_owned(), function(&fit.area)),
        ("friction".to_owned(), function(&fit.friction)),
        ("velocity_scale".to_owned(), number(velocity_scale)),
        ("samples".to_owned(), json!(SAMPLES)),
        ("sample_count".to_owned(), json!(samples)),
        ("contacts_solved".to_owned(), json!(computed.points.len())),
        ("r2".to_owned(), json!([fit.force.r2, fit.area.r2, fit.friction.r2])),
        ("beside_the_paper".to_owned(), compared.collect()),
        (
            "law_error".to_owned(),
            json!([number(law_error.force), number(law_error.area), number(law_error.friction)]),
        ),
    ])
}

/// The coefficients beside the paper's, one a row.
fn table(beside: &[CoefficientComparison]) -> Result<Table, ModelError> {
    let column = |value: fn(&CoefficientComparison) -> f64| beside.iter().map(value).collect::<Vec<f64>>();
    let names: Vec<String> = beside.iter().map(|line| line.name.to_owned()).collect();
    Ok(Table::new()
        .column("coefficient", "", names)?
        .column("value", "1", column(|line| line.value))?
        .column("standard_error", "1", column(|line| line.standard_error))?
        .column("lower_95", "1", column(|line| line.interval.0))?
        .column("upper_95", "1", column(|line| line.interval.1))?
        .column("paper", "1", column(|line| line.reference))?
        .column("deviation", "1", column(CoefficientComparison::deviation))?)
}

/// The functions, fitted to their own values, must come back.
fn returns(plane: &Plane, fit: &LawFit) -> Result<CheckRecord, FitError> {
    let law = fit.law();
    let again = plane.fit(&Law::Fitted(law), fit.log10_velocity_scale)?;
    Ok(CheckRecord::new(
        "the fit finds the coefficients of functions of its own form",
        "fourteen coefficients, fitted to the values of the fitted functions, relative",
        again.beside(&law).iter().map(|line| line.relative_deviation().abs()).collect(),
        RETURN_LIMIT,
    ))
}

/// What the functions do not describe.
fn warning(fit: &LawFit) -> Option<String> {
    let worst = fit.force.r2.min(fit.area.r2).min(fit.friction.r2);
    (worst < 0.99).then(|| {
        format!("the functions of the paper describe this law poorly: r² is {worst:.3} at the worst; mind the velocity scale")
    })
}
