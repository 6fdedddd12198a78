//! The contact law of a case over speed and depth.

use super::oscillator;
use crate::body::JsonBody;
use crate::frame::FrameInTheMaking;
use crate::refusal::RequestRefusal;
use crate::reporter::Reporter;
use crate::scheduler::Pace;
use crate::site::SharedSite;
use crate::subject::ViewedCase;
use crate::view::View;
use axum::extract::State;
use axum::response::Response;
use judder_keys::numeric_key::Form;
use judder_keys::span::Span;
use judder_models::law_cache::{LawSurface, law_surface};
use judder_store::Variable;
use serde::Deserialize;
use std::sync::Arc;

/// Points along each side of a surface, at most.
const SIDE: usize = 500;

/// A view, and the ranges over which its law is wanted.
#[derive(Debug, Deserialize)]
pub(crate) struct WantedLaw {
    #[serde(flatten)]
    view: View,
    /// v τ/R.
    velocity: LogarithmicRange,
    /// y/R.
    indentation: LogarithmicRange,
}

/// Logarithmically spaced values.
#[derive(Debug, Clone, Copy, Deserialize)]
struct LogarithmicRange {
    from: f64,
    to: f64,
    points: usize,
}

impl LogarithmicRange {
    fn values(self, name: &str) -> Result<Vec<f64>, RequestRefusal> {
        let Self { from, to, points } = self;
        let is_range = from > 0.0 && to > from && to.is_finite() && (2..=SIDE).contains(&points);
        if !is_range {
            return Err(RequestRefusal::wrong(format!(
                "`{name}` from {from} to {to} in {points} points is no range; `from` is above zero, `to` above it, with 2 to {SIDE} points"
            )));
        }
        Ok(Span { from, to, points, form: Form::Group }.values())
    }
}

/// Answers `/api/law`.
pub(crate) async fn answer(
    State(site): SharedSite,
    JsonBody(wanted): JsonBody<WantedLaw>,
) -> Result<Response, RequestRefusal> {
    wanted.view.check()?;
    let (velocities, indentations) =
        (wanted.velocity.values("velocity")?, wanted.indentation.values("indentation")?);
    let subject = Arc::clone(&site.subject);
    let slot = wanted.view.slot.clone();
    let work = move |reporter: &Reporter| draw(&subject, &wanted.view, velocities, indentations, reporter);
    site.scheduler.stream(Pace::Quick, slot, Box::new(work)).await
}

fn draw(
    subject: &ViewedCase,
    view: &View,
    velocities: Vec<f64>,
    indentations: Vec<f64>,
    reporter: &Reporter,
) -> Result<(), RequestRefusal> {
    let file = view.case(subject)?;
    let ready = subject.laws.ready(oscillator(&file)?, reporter).map_err(|error| reporter.refusal(error))?;
    let LawSurface { force, area, friction } =
        law_surface(&ready.contact.contact, &velocities, &indentations);
    let shape = [indentations.len(), velocities.len()];
    let surface = |name: &str, long_name: &str, values: Vec<f64>| {
        Variable::new(name, &["indentation", "velocity"], &shape, values).units("1").long_name(long_name)
    };
    let frame = FrameInTheMaking::new("law")
        .with("law", ready.case.law.name())
        .with("warnings", serde_json::json!(ready.contact.warnings))
        .array(&Variable::coordinate("velocity", velocities).units("1").long_name("speed v τ/R"))
        .array(&Variable::coordinate("indentation", indentations).units("1").long_name("indentation y/R"))
        .array(&surface("force", "normal force F_k/(E0* R²)", force))
        .array(&surface("area", "contact area A/R²", area))
        .array(&surface("friction", "viscoelastic friction coefficient μ_visc", friction));
    reporter.send(frame);
    Ok(())
}
