//! Which request is answered by what.

use crate::admission::Decision;
use crate::answers;
use crate::guest::Guest;
use crate::page;
use crate::refusal::RequestRefusal;
use crate::site::{SharedSite, Site};
use axum::Router;
use axum::extract::{Request, State};
use axum::http::header::{ACCEPT, CACHE_CONTROL, CONNECTION, HeaderMap, SET_COOKIE};
use axum::http::{HeaderValue, Method, StatusCode, Uri};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{Html, IntoResponse, Response};
use axum::routing::{get, post};
use std::sync::Arc;

/// All routes, for those who are let in.
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
        .route("/api/study/report", post(answers::study::report))
        .route("/api/study/shapes", post(answers::study::shapes))
        .route("/api/study/sound/{*path}", get(answers::study::sound))
        .fallback(asset)
        .layer(from_fn_with_state(Arc::clone(&site), pass))
        .with_state(site)
}

/// Lets a request in, and binds its answer to this server.
async fn pass(State(site): SharedSite, request: Request, next: Next) -> Response {
    let mut response = match site.admission.admit(request.method(), request.uri(), request.headers()) {
        Decision::Admitted => {
            if let Some(guest) = request.extensions().get::<Arc<Guest>>() {
                guest.is_let_in();
            }
            next.run(request).await
        }
        Decision::Welcomed { cookie } => welcome(&cookie),
        Decision::Refused { status, reason } => turned_away(status, reason),
    };
    page::bind(response.headers_mut());
    response
}

/// A stranger gets one answer a connection.
fn turned_away(status: StatusCode, reason: &'static str) -> Response {
    let mut response = RequestRefusal::new(status, reason).into_response();
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
        RequestRefusal::missing(
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
        RequestRefusal::missing("there is nothing at this address; `/` is the page").into_response()
    })
}
