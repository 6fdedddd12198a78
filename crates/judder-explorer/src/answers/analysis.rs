//! Any analysis of a case, as `judder run` computes it, and every array that it leaves.

use crate::body::JsonBody;
use crate::frame::FrameInTheMaking;
use crate::limits::check_answer;
use crate::refusal::{InTerminal, RequestRefusal};
use crate::reporter::Reporter;
use crate::scheduler::Pace;
use crate::site::{SharedSite, Site};
use crate::view::View;
use axum::extract::State;
use axum::response::Response;
use judder_study::Progress;
use judder_study::analyses;
use judder_study::model::SampleBlock;
use judder_study::outcome::{CheckRecord, Outcome};
use serde_json::{Value, json};
use std::sync::Arc;

/// Answers `/api/analysis`.
pub(crate) async fn answer(
    State(site): SharedSite,
    JsonBody(view): JsonBody<View>,
) -> Result<Response, RequestRefusal> {
    stream(&site, view, |_, _| ()).await
}

/// Runs the analysis of a view, and sends what it leaves; `watch` sends the samples of a motion while it is computed.
pub(crate) async fn stream(
    site: &Site,
    view: View,
    watch: impl Fn(&Reporter, SampleBlock) + Send + 'static,
) -> Result<Response, RequestRefusal> {
    view.check()?;
    if view.analysis.is_none() {
        return Err(RequestRefusal::wrong(
            "no analysis is asked for; give one, a table as `[[analysis]]` takes it",
        ));
    }
    let subject = Arc::clone(&site.subject);
    site.scheduler
        .stream(
            Pace::Slow,
            view.slot.clone(),
            Box::new(move |reporter| {
                let file = view.case(&subject)?;
                reporter.begin("", analyses::steps(&file.case, 0));
                let outcome = analyses::run_watched(&file, 0, reporter, &mut |block| watch(reporter, block));
                let name = file.case.analysis_names().join("");
                send(reporter, &name, &outcome.map_err(|error| reporter.refusal(error))?)
            }),
        )
        .await
}

/// Sends what an analysis leaves.
fn send(reporter: &Reporter, name: &str, outcome: &Outcome) -> Result<(), RequestRefusal> {
    let variables = outcome.dataset.variables();
    check_answer(variables, InTerminal::Run)?;
    let frame = FrameInTheMaking::new("outcome")
        .with("name", name)
        .with("scalars", Value::Object(outcome.scalars.clone()))
        .with("checks", outcome.checks.iter().map(check).collect::<Vec<_>>())
        .with("warnings", json!(outcome.warnings))
        .with("missing", outcome.missing)
        .with("attributes", Value::Object(outcome.dataset.attributes().clone()));
    reporter.send(variables.iter().fold(frame, FrameInTheMaking::array));
    Ok(())
}

fn check(check: &CheckRecord) -> Value {
    json!({
        "name": check.name, "compared": check.compared, "figure": check.figure, "limit": check.limit, "passed": check.passed(),
        "numbers": check.numbers(),
    })
}
