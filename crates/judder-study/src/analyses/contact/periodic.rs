//! `contact` of a surface that repeats itself: one period under a load.

use super::fields::Fields;
use super::single::loading;
use crate::error::StudyError;
use crate::indenter::height_map;
use crate::material::ContactScales;
use crate::outcome::{CheckRecord, Outcome};
use judder_case::{ContactCase, ContactSettings};
use judder_contact::periodic_contact::{PeriodicQuestion, solve};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use judder_store::number;
use serde_json::{Map, json};

pub(super) fn run(case: &ContactCase, name: &str, settings: &ContactSettings) -> Result<Outcome, StudyError> {
    let scales = ContactScales::new(case)?;
    let surface = height_map(&case.shape, scales.scales.radius)?;
    let velocity = scales.velocity(settings.velocity);
    let Loading::Load(load) = loading(&case.shape, settings, &scales) else {
        return Err(StudyError::Unsupported("a surface that repeats itself takes a load".to_owned()));
    };
    let grid = surface.grid();
    let period = grid.len() as f64 * grid.cell_area();
    let limits = UnilateralLimits::default();
    let contact = solve(&PeriodicQuestion {
        substrate: &scales.material.sliding(velocity),
        surface: &surface,
        mean_pressure: load / period,
        limits,
        memory: settings.memory.bytes,
    })?;
    let solution = &contact.solution;
    let residual = solution.errors.worst();
    let fields = Fields::of_period(&contact, &surface);
    let force = solution.pressure.iter().sum::<f64>() * contact.grid.cell_area();
    let scalars = Map::from_iter([
        ("force".to_owned(), number(force)),
        ("area".to_owned(), number(contact.contact_fraction * period)),
        ("friction".to_owned(), number(contact.friction)),
        ("contact_fraction".to_owned(), number(contact.contact_fraction)),
        ("mean_pressure".to_owned(), number(load / period)),
        ("mean_gap".to_owned(), number(contact.mean_gap)),
        ("velocity".to_owned(), number(velocity)),
        ("cells".to_owned(), json!(contact.grid.columns)),
        ("iterations".to_owned(), json!(solution.iterations)),
        ("products".to_owned(), json!(solution.products)),
        ("residual".to_owned(), number(residual)),
        ("converged".to_owned(), json!(solution.converged)),
    ]);
    Ok(Outcome {
        scalars,
        dataset: fields.surfaces()?.attribute("kind", "contact")?,
        files: vec![(format!("fields/{name}.vtu"), fields.vtu()?)],
        checks: vec![
            CheckRecord {
                name: "the conditions of contact hold".to_owned(),
                compared: "largest of complementarity, tension, penetration, load, computed anew".to_owned(),
                figure: residual,
                limit: super::single::RESIDUAL_LIMIT,
            },
            CheckRecord {
                name: "the load is carried".to_owned(),
                compared: "the sum of the pressures against the imposed force, relative".to_owned(),
                figure: (force / load - 1.0).abs(),
                limit: super::single::RESIDUAL_LIMIT,
            },
        ],
        missing: usize::from(!solution.converged),
        warnings: if solution.converged {
            vec![
                "the grid is that of the heights: no finer one says how exact force, area and friction are"
                    .to_owned(),
            ]
        } else {
            vec![format!("the contact was not solved: residual {residual:.1e}")]
        },
        ..Outcome::default()
    })
}
