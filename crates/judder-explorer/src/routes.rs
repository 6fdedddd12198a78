//! Which request is answered by what; limits on bodies.

use crate::answers;
use crate::attention::Stools;
use crate::desk::Desk;
use crate::gate::{Admission, Gate};
use crate::page;
use crate::refusal::Refusal;
use crate::subject::Subject;
use axum::Router;
use axum::body::to_bytes;
use axum::extract::{FromRequest, Request, State};
use axum::http::header::{
    ACCEPT, CACHE_CONTROL, CONNECTION, CONTENT_LENGTH, CONTENT_TYPE, HeaderMap, SET_COOKIE,
};
use axum::http::{HeaderValue, Method, StatusCode, Uri};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{Html, IntoResponse, Response};
use axum::routing::{get, post};
use serde::de::DeserializeOwned;
use std::sync::Arc;
use std::time::Duration;
use tokio::time::timeout;

/// Bytes of the body of a request, at most.
const BODY_BYTES: usize = 64 << 10;
/// The longest that a body may take to come.
const BODY_TIME: Duration = Duration::from_secs(10);

/// What every answer may need.
#[derive(Debug)]
pub(crate) struct Site {
    pub(crate) subject: Arc<Subject>,
    pub(crate) gate: Gate,
    pub(crate) desk: Arc<Desk>,
    /// For what is computed at once: points under a cursor.
    pub(crate) stools: Stools,
    /// For the points of a case whose law has to be computed first: one computes it, the others wait.
    pub(crate) law_stool: Stools,
}

/// The site as answers get it.
pub(crate) type SharedSite = State<Arc<Site>>;

/// All routes, behind the gate.
pub(crate) fn router(site: Arc<Site>) -> Router {
    let views = page::VIEWS.iter().fold(Router::new(), |router, view| router.route(view, get(index)));
    views
        .route("/api/session", get(answers::session::answer))
        .route("/api/case", post(answers::case::answer))
        .route("/api/point", post(answers::point::answer))
        .route("/api/map", post(answers::map::answer))
        .route("/api/analysis", post(answers::analysis::answer))
        .route("/api/motion", post(answers::motion::answer))
        .route("/api/law", post(answers::law::answer))
        .route("/api/export", post(answers::export::answer))
        .route("/api/study", get(answers::study::answer))
        .route("/api/study/case", post(answers::study::case))
        .route("/api/study/arrays", post(answers::study::arrays))
        .route("/api/study/shapes", post(answers::study::shapes))
        .route("/api/study/sound/{*path}", get(answers::study::sound))
        .fallback(asset)
        .layer(from_fn_with_state(Arc::clone(&site), pass))
        .with_state(site)
}

/// Lets a request through the gate, and binds its answer to this server.
async fn pass(State(site): SharedSite, request: Request, next: Next) -> Response {
    let mut response = match site.gate.admit(request.method(), request.uri(), request.headers()) {
        Admission::Admitted => next.run(request).await,
        Admission::Welcomed { cookie } => welcome(&cookie),
        Admission::Refused { status, reason } => turned_away(status, reason),
    };
    page::bind(response.headers_mut());
    response
}

/// A stranger gets one answer a connection.
fn turned_away(status: StatusCode, reason: &'static str) -> Response {
    let mut response = Refusal::new(status, reason).into_response();
    response.headers_mut().insert(CONNECTION, HeaderValue::from_static("close"));
    response
}

/// The cookie, and the way to the page. A redirection would still count as the step of whoever led here, and a browser keeps a strict
/// cookie from another's steps; what this page does is its own.
fn welcome(cookie: &str) -> Response {
    let onwards = "<!doctype html><html lang=\"en\"><title>judder</title><link rel=\"icon\" href=\"data:,\">\
                   <meta http-equiv=\"refresh\" content=\"0; url=/\">";
    let mut response = Html(onwards).into_response();
    let headers = response.headers_mut();
    headers.insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    if let Ok(cookie) = HeaderValue::from_str(cookie) {
        headers.insert(SET_COOKIE, cookie);
    }
    response
}

async fn index() -> Response {
    page::file("index.html").unwrap_or_else(|| {
        Refusal::missing(
            "the page was not built into this program; run `npm run build` and build judder again",
        )
        .into_response()
    })
}

/// A file of the page. A reader who has mistyped an address gets the page, which tells him.
async fn asset(method: Method, uri: Uri, headers: HeaderMap) -> Response {
    let is_reader = headers
        .get(ACCEPT)
        .and_then(|kinds| kinds.to_str().ok())
        .is_some_and(|kinds| kinds.contains("text/html"));
    if method == Method::GET && is_reader && !uri.path().starts_with("/api/") && !uri.path().contains('.') {
        return index().await;
    }
    let found = (method == Method::GET).then(|| page::file(uri.path().trim_start_matches('/'))).flatten();
    found.unwrap_or_else(|| {
        Refusal::missing("there is nothing at this address; `/` is the page").into_response()
    })
}

/// The body of a request, read as JSON within limits.
pub(crate) struct Asked<T>(pub(crate) T);

impl<T: DeserializeOwned, S: Send + Sync> FromRequest<S> for Asked<T> {
    type Rejection = Refusal;

    async fn from_request(request: Request, _state: &S) -> Result<Self, Refusal> {
        // other sites' forms cannot send this kind without asking first
        let is_json = request.headers().get(CONTENT_TYPE).is_some_and(|kind| kind == "application/json");
        if !is_json {
            let sentence = "the body is of another kind; it is `application/json`";
            return Err(Refusal::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, sentence));
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
            Refusal::new(StatusCode::REQUEST_TIMEOUT, sentence)
        })?;
        let bytes = body.map_err(|_| too_long())?;
        serde_json::from_slice(&bytes)
            .map(Self)
            .map_err(|error| Refusal::wrong(format!("the body is not what is asked for: {error}")))
    }
}

fn too_long() -> Refusal {
    Refusal::too_large(format!("the body is broken or too long; at most {BODY_BYTES} bytes are read"))
}
