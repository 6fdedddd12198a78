//! `contact` of a cylinder: a line contact under a load per length.

use super::single::loading;
use crate::error::StudyError;
use crate::material::ContactScales;
use crate::outcome::{CheckRecord, Outcome};
use judder_case::{ContactCase, ContactSettings};
use judder_contact::steady::line::{LineContact, LineQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use judder_store::{Dataset, Table, Variable, number};
use serde_json::{Map, json};

/// Strips across the domain where none are asked for.
pub(crate) const STRIPS: usize = 1024;
/// What the conditions may leave, computed anew, over a depth that is measured to far away.
const RESIDUAL_LIMIT: f64 = 1e-5;

pub(super) fn run(case: &ContactCase, settings: &ContactSettings) -> Result<Outcome, StudyError> {
    let scales = ContactScales::new(case)?;
    let velocity = scales.velocity(settings.velocity);
    let Loading::Load(load) = loading(&case.shape, settings, &scales) else {
        return Err(StudyError::Unsupported("a line contact takes a load".to_owned()));
    };
    let substrate = scales.material.sliding(velocity);
    let strips = settings.cells.unwrap_or(STRIPS);
    let on = |cells: usize| {
        solve(&LineQuestion {
            substrate: &substrate,
            load,
            cells,
            limits: UnilateralLimits::default(),
            memory: settings.memory.bytes,
        })
    };
    // the coarser grid says how exact the finer one is
    let (coarse, fine) = (on(strips / 2)?, on(strips)?);
    let change = |value: fn(&LineContact) -> f64| {
        let (before, now) = (value(&coarse), value(&fine));
        if before == now { 0.0 } else { (before / now - 1.0).abs() }
    };
    let errors = [change(|c| c.peak_pressure), change(|c| c.width), change(|c| c.friction)];
    let converged = fine.solution.converged && errors[0].max(errors[1]) <= 5.0 * settings.accuracy;
    let residual = fine.solution.errors.worst();
    let scalars = Map::from_iter([
        ("force".to_owned(), number(load)),
        ("area".to_owned(), number(fine.width)),
        ("friction".to_owned(), number(fine.friction)),
        ("velocity".to_owned(), number(velocity)),
        ("peak_pressure".to_owned(), number(fine.peak_pressure)),
        ("peak_pressure_pascal".to_owned(), number(fine.peak_pressure * scales.scales.reduced_modulus)),
        ("peak_pressure_error".to_owned(), number(errors[0])),
        ("area_error".to_owned(), number(errors[1])),
        ("friction_error".to_owned(), number(errors[2])),
        ("cells".to_owned(), json!(fine.grid.columns)),
        ("iterations".to_owned(), json!(fine.solution.iterations)),
        ("residual".to_owned(), number(residual)),
        ("converged".to_owned(), json!(converged)),
    ]);
    let x: Vec<f64> = (0..fine.grid.columns).map(|column| fine.grid.x(column)).collect();
    Ok(Outcome {
        scalars,
        dataset: dataset(&x, &fine)?,
        table: Some(Table::new().column("x", "R", x)?.column(
            "pressure",
            "E0*",
            fine.solution.pressure.clone(),
        )?),
        checks: vec![CheckRecord {
            name: "the conditions of contact hold".to_owned(),
            compared: format!("largest of complementarity, tension, penetration, load, {strips} strips"),
            figure: residual,
            limit: RESIDUAL_LIMIT,
        }],
        missing: usize::from(!converged),
        warnings: if converged {
            Vec::new()
        } else {
            vec![format!(
                "not converged: between {} and {strips} strips peak pressure and width change by {:.1e} and {:.1e}, residual {residual:.1e}",
                strips / 2,
                errors[0],
                errors[1]
            )]
        },
        ..Outcome::default()
    })
}

fn dataset(x: &[f64], contact: &LineContact) -> Result<Dataset, StudyError> {
    let over_x = |name: &str, values: &[f64], long_name: &str| {
        Variable::new(name, &["y", "x"], &[1, x.len()], values.to_vec()).units("1").long_name(long_name)
    };
    Ok(Dataset::new()
        .with(
            Variable::coordinate("x", x.to_vec()).units("1").long_name("x/R along the direction of sliding"),
        )?
        .with(
            Variable::coordinate("y", vec![0.0])
                .units("1")
                .long_name("y/R across it: one row stands for all"),
        )?
        .with(over_x("pressure", &contact.solution.pressure, "pressure p/E0*"))?
        .with(over_x("gap", &contact.solution.gap, "gap g/R"))?
        .attribute("kind", "contact")?)
}
