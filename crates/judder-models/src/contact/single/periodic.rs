//! `contact` of a surface that repeats itself: one period under a load or at a depth.

use super::refined::Refined;
use super::run::{DISSIPATION_LIMIT, RESIDUAL_LIMIT, loading};
use crate::contact::case::ContactCase;
use crate::contact::fields::ContactFields;
use crate::contact::memory::{operator_at_once, operator_limit};
use crate::contact::settings::ContactSettings;
use crate::error::ModelError;
use crate::indenter::height_map;
use crate::material::ContactScales;
use judder_contact::periodic_contact::{
    PeriodicContact, PeriodicContactError, PeriodicLoading, PeriodicQuestion, solve_until,
};
use judder_contact::unilateral::{Loading, UnilateralLimits};
use judder_store::Results;
use judder_study::Progress;
use judder_study::outcome::{CheckRecord, Outcome};

pub(super) fn run(
    case: &ContactCase,
    name: &str,
    settings: &ContactSettings,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let scales = ContactScales::new(case)?;
    let surface = height_map(&case.shape, scales.scales.radius)?;
    let velocity = scales.velocity(settings.velocity);
    let grid = surface.grid();
    let period = grid.len() as f64 * grid.cell_area();
    let substrate = scales.material.sliding(velocity);
    let question = PeriodicQuestion {
        substrate: &substrate,
        surface: &surface,
        loading: match loading(&case.shape, settings, &scales) {
            Loading::Load(load) => PeriodicLoading::MeanPressure(load / period),
            Loading::Indentation(depth) => PeriodicLoading::Indentation(depth),
        },
        accuracy: Some(settings.accuracy),
        limits: UnilateralLimits::default(),
        memory: operator_at_once(operator_limit(settings.memory), 1),
    };
    let contact = solve_until(&question, &|| progress.interrupted()).map_err(|error| match error {
        PeriodicContactError::Interrupted => ModelError::Interrupted,
        error => error.into(),
    })?;
    progress.advance();
    let refined = Refined {
        refinement: &contact.refinement,
        friction_from_dissipation: contact.finest.friction_from_dissipation,
        friction_difference: contact.friction_difference(),
        converged: contact.converged,
        is_line: false,
        length: None,
    };
    let fields = ContactFields::of_period(&contact.finest);
    let mut scalars = refined.told(&scales, velocity).scalars();
    let of_period = ToldPeriod {
        contact_fraction: contact.refinement.area.value / period,
        mean_pressure: contact.refinement.force.value / period,
        mean_gap: contact.finest.mean_gap,
    };
    scalars.extend(of_period.scalars());
    Ok(Outcome {
        scalars,
        dataset: fields.dataset(&contact.refinement, &scales, settings.is_in_si())?,
        table: Some(refined.history()?),
        files: vec![(format!("fields/{name}.vtu"), fields.vtu()?)],
        checks: checks(&contact, &question),
        missing: usize::from(!contact.converged),
        warnings: refined.missed(settings.accuracy).into_iter().collect(),
        ..Outcome::default()
    })
}

/// What is told of a periodic surface besides.
#[derive(Results)]
pub(super) struct ToldPeriod {
    contact_fraction: f64,
    mean_pressure: f64,
    mean_gap: f64,
}

fn checks(contact: &PeriodicContact, question: &PeriodicQuestion<'_>) -> Vec<CheckRecord> {
    let level = &contact.finest;
    let mut checks = vec![CheckRecord::new(
        "the conditions of contact hold",
        "largest of complementarity, tension, penetration, load, computed anew",
        level.solution.errors.worst().into(),
        RESIDUAL_LIMIT,
    )];
    if let PeriodicLoading::MeanPressure(imposed) = question.loading {
        checks.push(CheckRecord::new(
            "the load is carried",
            "the sum of the pressures against the imposed force, relative",
            (level.mean_pressure / imposed - 1.0).abs().into(),
            RESIDUAL_LIMIT,
        ));
    }
    if level.friction_from_dissipation > 0.0 {
        checks.push(CheckRecord::new(
            "friction at the surface is the energy dissipated in the bulk",
            "⟨p ∂h/∂x⟩ against the loss of every wave of the period, relative",
            contact.friction_difference().into(),
            DISSIPATION_LIMIT,
        ));
    }
    checks
}
