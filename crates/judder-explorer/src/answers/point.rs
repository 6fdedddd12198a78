//! One operating point: the document of `judder point --json`, the shapes of its modes, the same with units.

use super::oscillator;
use crate::body::JsonBody;
use crate::limiter::RequestWatch;
use crate::refusal::RequestRefusal;
use crate::site::SharedSite;
use crate::subject::ViewedCase;
use crate::view::View;
use axum::Json;
use axum::extract::State;
use judder_models::oscillator::law_name::LawName;
use judder_models::point::{AnalysedPoint, SteadyPoint};
use judder_oscillator::groups::Scales;
use judder_oscillator::spectrum::mode;
use judder_study::case::file::CaseFile;
use serde_json::{Value, json};

/// Answers `/api/point`.
pub(crate) async fn answer(
    State(site): SharedSite,
    JsonBody(view): JsonBody<View>,
) -> Result<Json<Value>, RequestRefusal> {
    view.check()?;
    let options = view.set.clone();
    let at_once = site.compute(move |subject, watch| {
        let file = subject.with(&options)?;
        let case = oscillator(&file)?;
        let is_known = case.law != LawName::Bem || subject.laws.knows(case);
        if is_known { compute(subject, &file, watch).map(Some) } else { Ok(None) }
    });
    if let Some(document) = at_once.await? {
        return Ok(document);
    }
    site.compute_with_law(move |subject, watch| compute(subject, &subject.with(&view.set)?, watch)).await
}

fn compute(
    subject: &ViewedCase,
    file: &CaseFile,
    watch: &RequestWatch,
) -> Result<Json<Value>, RequestRefusal> {
    let ready = subject.laws.ready(oscillator(file)?, watch).map_err(|error| watch.refusal(error))?;
    Ok(Json(document(&ready.point()?, &ready.case.inputs.scales())))
}

fn document(point: &AnalysedPoint, scales: &Scales) -> Value {
    json!({
        "point": point.json(),
        "modes": modes(&point.steady),
        "dimensional": dimensional(&point.steady, scales),
    })
}

/// The right vector of every eigenvalue, of unit length.
fn modes(steady: &SteadyPoint) -> Vec<Value> {
    let system = steady.linearisation.system();
    let of = |eigenvalue| {
        let shape = mode(&system, eigenvalue).right.map(|entry| [entry.re, entry.im]);
        json!({ "eigenvalue": [eigenvalue.re, eigenvalue.im], "shape": shape })
    };
    steady.eigenvalues.into_iter().map(of).collect()
}

/// Lengths of displacement are x0 = F_n/k_x, forces E0* R², areas R².
fn dimensional(steady: &SteadyPoint, scales: &Scales) -> Value {
    let Scales { reduced_modulus, radius, natural_frequency } = *scales;
    let length = radius / steady.groups.radius();
    let quantities = steady.groups.dimensional(scales);
    let response = &steady.equilibrium.response;
    let leading = judder_oscillator::spectrum::leading(&steady.eigenvalues);
    json!({
        "growth_rate_per_s": steady.growth_rate() * natural_frequency,
        "frequency_hz": leading.im.abs() * natural_frequency / std::f64::consts::TAU,
        "indentation_m": steady.equilibrium.indentation * radius,
        "x_m": steady.equilibrium.x * length,
        "y_m": steady.equilibrium.y * length,
        "force_n": response.force.value * reduced_modulus * radius * radius,
        "area_m2": response.area.value * radius * radius,
        "velocity_m_per_s": quantities.velocity,
        "normal_load_n": quantities.normal_load,
        "shear_strength_pa": quantities.shear_strength,
    })
}
