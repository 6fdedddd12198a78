//! `fit`: the three functions of the oscillator paper through a computed law (appendix B).

use crate::computed_law::{KnownPoints, compute};
use crate::contact::case::ContactCase;
use crate::contact::law::LawPlane;
use crate::contact::settings::LawSettings;
use crate::error::ModelError;
use crate::material::ContactScales;
use judder_contact::fit::{CoefficientComparison, FitError, FunctionFit, LawFit};
use judder_contact::{FittedLaw, Law};
use judder_store::{Results, Table, Variable};
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};

/// What the samples of a fit are.
const SAMPLES: &str = "the computed law at every speed and indentation of the case";
/// How closely a fit must come back when it is fitted to itself.
const RETURN_LIMIT: f64 = 1e-6;

pub(super) fn run(
    case: &ContactCase,
    settings: &LawSettings,
    velocity_scale: f64,
    points: KnownPoints<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let scales = ContactScales::new(case)?;
    let plane = LawPlane::new(settings, &scales);
    let computed = compute(&plane.task(case, &scales, settings)?, points, progress)?;
    let values = plane.values(&computed.law);
    let unfit = |error: FitError| ModelError::Unsupported(error.to_string());
    let fit = plane.fit(&computed.law, libm::log10(velocity_scale)).map_err(unfit)?;
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
    let (missed, law_error) = (computed.missed(settings.accuracy), computed.errors().total());
    let told = ToldFit {
        force: ToldFunction::new(&fit.force),
        area: ToldFunction::new(&fit.area),
        friction: ToldFunction::new(&fit.friction),
        velocity_scale,
        samples: SAMPLES,
        sample_count: shape.iter().product(),
        contacts_solved: computed.points.len(),
        r2: [fit.force.r2, fit.area.r2, fit.friction.r2],
        beside_the_paper: beside.iter().map(ToldCoefficient::new).collect(),
        law_error: [law_error.force, law_error.area, law_error.friction],
    };
    Ok(Outcome {
        scalars: told.scalars(),
        dataset,
        table: Some(told.add_columns(Table::new())?),
        checks: vec![returns(&plane, &fit).map_err(unfit)?],
        missing: usize::from(missed.is_some()),
        warnings: missed.into_iter().chain(warning(&fit)).collect(),
        ..Outcome::default()
    })
}

/// What is told of a fit.
#[derive(Results)]
#[results(columns(beside_the_paper))]
pub(super) struct ToldFit {
    force: ToldFunction,
    area: ToldFunction,
    friction: ToldFunction,
    velocity_scale: f64,
    /// what the samples are
    samples: &'static str,
    sample_count: usize,
    contacts_solved: usize,
    /// of force, area and friction
    #[result(unit = "1")]
    r2: [f64; 3],
    #[result(rows)]
    beside_the_paper: Vec<ToldCoefficient>,
    /// of force, area and friction
    #[result(unit = "1")]
    law_error: [f64; 3],
}

/// A function of appendix B.
#[derive(Results)]
struct ToldFunction {
    #[result(unit = "1")]
    coefficients: Vec<f64>,
    #[result(unit = "1")]
    standard_errors: Vec<f64>,
    /// with 95 % confidence
    #[result(unit = "1")]
    intervals: Vec<[f64; 2]>,
    #[result(unit = "1")]
    r2: f64,
}

/// A coefficient beside the paper's.
#[derive(Results)]
#[results(
    rows = "coefficient",
    columns(coefficient, value, standard_error, lower_95, upper_95, paper, deviation)
)]
struct ToldCoefficient {
    #[result(summary = "name")]
    coefficient: &'static str,
    value: f64,
    standard_error: f64,
    paper: f64,
    deviation: f64,
    #[result(unit = "1")]
    relative_deviation: f64,
    #[result(hidden)]
    lower_95: f64,
    #[result(hidden)]
    upper_95: f64,
}

impl ToldFunction {
    fn new<const N: usize>(fit: &FunctionFit<N>) -> Self {
        Self {
            coefficients: fit.coefficients.to_vec(),
            standard_errors: fit.standard_errors.to_vec(),
            intervals: fit.intervals.iter().map(|(low, high)| [*low, *high]).collect(),
            r2: fit.r2,
        }
    }
}

impl ToldCoefficient {
    fn new(line: &CoefficientComparison) -> Self {
        Self {
            coefficient: line.name,
            value: line.value,
            standard_error: line.standard_error,
            paper: line.reference,
            deviation: line.deviation(),
            relative_deviation: line.relative_deviation(),
            lower_95: line.interval.0,
            upper_95: line.interval.1,
        }
    }
}

/// The functions, fitted to their own values, must come back.
fn returns(plane: &LawPlane, fit: &LawFit) -> Result<CheckRecord, FitError> {
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
