//! The case file of a view.

use crate::body::Asked;
use crate::refusal::Refusal;
use crate::site::SharedSite;
use crate::view::View;
use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use judder_study::case::anywhere::anywhere;

/// Answers `/api/export`.
pub(crate) async fn answer(State(site): SharedSite, Asked(view): Asked<View>) -> Result<Response, Refusal> {
    let text = site.compute(move |subject, _| Ok(anywhere(&view.case(subject)?)?.source.text)).await?;
    Ok(([(CONTENT_TYPE, "text/plain; charset=utf-8")], text).into_response())
}
