//! The bodies of requests: JSON, within limits.

use crate::refusal::RequestRefusal;
use axum::body::to_bytes;
use axum::extract::{FromRequest, Request};
use axum::http::StatusCode;
use axum::http::header::{CONTENT_LENGTH, CONTENT_TYPE};
use serde::de::DeserializeOwned;
use std::time::Duration;
use tokio::time::timeout;

/// Bytes of the body of a request, at most.
const BODY_BYTES: usize = 64 << 10;
/// The longest that a body may take to come.
const BODY_TIME: Duration = Duration::from_secs(10);

/// The body of a request, read as JSON within limits.
pub(crate) struct JsonBody<T>(pub(crate) T);

impl<T: DeserializeOwned, S: Send + Sync> FromRequest<S> for JsonBody<T> {
    type Rejection = RequestRefusal;

    async fn from_request(request: Request, _state: &S) -> Result<Self, RequestRefusal> {
        // other sites' forms cannot send this kind without asking first
        let is_json = request.headers().get(CONTENT_TYPE).is_some_and(|kind| kind == "application/json");
        if !is_json {
            let sentence = "the body is of another kind; it is `application/json`";
            return Err(RequestRefusal::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, sentence));
        }
        let claimed = request
            .headers()
            .get(CONTENT_LENGTH)
            .and_then(|length| length.to_str().ok()?.parse::<u64>().ok());
        if claimed.is_some_and(|length| length > BODY_BYTES as u64) {
            return Err(too_long());
        }
        let body = timeout(BODY_TIME, to_bytes(request.into_body(), BODY_BYTES)).await.map_err(|_| {
            let sentence = format!("the body did not come within {} s; send it whole", BODY_TIME.as_secs());
            RequestRefusal::new(StatusCode::REQUEST_TIMEOUT, sentence)
        })?;
        let bytes = body.map_err(|_| too_long())?;
        serde_json::from_slice(&bytes)
            .map(Self)
            .map_err(|error| RequestRefusal::wrong(format!("the body is not what is asked for: {error}")))
    }
}

fn too_long() -> RequestRefusal {
    RequestRefusal::too_large(format!("the body is broken or too long; at most {BODY_BYTES} bytes are read"))
}
