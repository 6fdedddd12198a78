//! The built page, embedded, with the headers that bind it to this server.

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderName, HeaderValue};
use axum::response::Response;
use rust_embed::RustEmbed;
use std::borrow::Cow;

/// Everything comes from this server, nothing runs that is not a file of it, and no other page shows it.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; \
                      connect-src 'self'; font-src 'self'; media-src 'self' blob:; base-uri 'none'; form-action 'none'; \
                      frame-ancestors 'none'";

/// On every answer. The address may hold the token once: it is told to nobody.
const HEADERS: [(HeaderName, &str); 6] = [
    (header::CONTENT_SECURITY_POLICY, POLICY),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::X_FRAME_OPTIONS, "DENY"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

/// The built page: `npm run build` in `web` writes it.
#[derive(RustEmbed)]
#[folder = "page"]
struct Built;

/// The views of the page; each has an address of its own, and the page itself reads it.
pub(crate) const VIEWS: [&str; 5] = ["/", "/map", "/point", "/contact", "/structures"];

/// Lays the headers of this server onto an answer.
pub(crate) fn bind(headers: &mut HeaderMap) {
    for (name, value) in HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
}

/// A file of the page, or a font of the pictures; names are looked up in a table, never on a disk.
pub(crate) fn file(name: &str) -> Option<Response> {
    let content = match name.strip_prefix("fonts/") {
        Some(font) => Cow::Borrowed(judder_report::web_font(font)?),
        None => Built::get(name)?.data,
    };
    let mut response = Response::new(Body::from(content.into_owned()));
    let kept = if name.starts_with("assets/") { "private, max-age=31536000, immutable" } else { "no-store" };
    for (name, value) in [(header::CONTENT_TYPE, kind(name)), (header::CACHE_CONTROL, kept)] {
        response.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    Some(response)
}

/// The media type of a file of the page.
fn kind(name: &str) -> &'static str {
    match name.rsplit_once('.').map(|(_, extension)| extension) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("svg") => "image/svg+xml",
        Some("woff2") => "font/woff2",
        Some("txt") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}
