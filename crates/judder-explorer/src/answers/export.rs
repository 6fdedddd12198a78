//! The case file of a view.

use crate::body::JsonBody;
use crate::refusal::RequestRefusal;
use crate::site::SharedSite;
use crate::view::View;
use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use judder_study::case::anywhere::anywhere;

/// Answers `/api/export`.
pub(crate) async fn answer(
    State(site): SharedSite,
    JsonBody(view): JsonBody<View>,
) -> Result<Response, RequestRefusal> {
    let text = site.compute(move |subject, _| Ok(anywhere(&view.case(subject)?)?.source.text)).await?;
    Ok(([(CONTENT_TYPE, "text/plain; charset=utf-8")], text).into_response())
}
