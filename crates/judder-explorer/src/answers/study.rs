//! The study folder: what it holds, arrays, sounds, shapes of its coupled modes.

use crate::body::JsonBody;
use crate::frame::FrameInTheMaking;
use crate::limits::{check_answer, check_bytes};
use crate::refusal::{InTerminal, RequestRefusal};
use crate::reporter::Reporter;
use crate::scheduler::Pace;
use crate::site::{SharedSite, Site};
use crate::subject::{Studied, ViewedCase};
use axum::Json;
use axum::body::{Body, Bytes};
use axum::extract::{Path, State};
use axum::http::HeaderValue;
use axum::http::header::{CACHE_CONTROL, CONTENT_LENGTH, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use judder_models::sliding_shapes::SlidingShapes;
use judder_store::{CheckedFile, Complex64, Status, StoreError, Variable};
use judder_study::case::compose::alone;
use judder_study::study_view::{AnalysisListing, ReportedAnalysis, RowWindow};
use judder_study::{Progress, StudyError};
use serde::Deserialize;
use serde_json::{Value, json};
use std::io::Read;
use std::sync::Arc;
use tokio::sync::mpsc;
use tokio_stream::wrappers::ReceiverStream;

/// Variables that one request may ask for, at most.
const VARIABLES: usize = 32;
/// Bytes of a file that are read at a time, and how many such pieces wait for the network.
const PIECE_BYTES: usize = 64 << 10;
const PIECES: usize = 2;
/// Modes whose shapes are sent, at most.
const MODES: usize = 64;

fn studied(subject: &ViewedCase) -> Result<&Studied, RequestRefusal> {
    let help = "no study folder is looked at; `judder run CASE.toml` makes one, `judder explore CASE.toml --study DIR` shows it";
    subject.study.as_ref().ok_or_else(|| RequestRefusal::missing(help))
}

/// Answers `/api/study`.
pub(crate) async fn answer(State(site): SharedSite) -> Result<Json<Value>, RequestRefusal> {
    site.compute(|subject, _| {
        let listing = studied(subject)?.view.listing()?;
        let sounds = listing.sounds.iter().map(|(path, bytes)| json!({ "path": path, "bytes": bytes }));
        Ok(Json(json!({
            "name": listing.name, "title": listing.title, "model": listing.model, "version": listing.version,
            "analyses": listing.analyses.iter().map(analysis).collect::<Vec<_>>(),
            "sounds": sounds.collect::<Vec<_>>(),
            "warnings": listing.warnings,
        })))
    })
    .await
}

fn analysis(listing: &AnalysisListing) -> Value {
    let (status, reason) = match &listing.status {
        Status::Done => ("done", Value::Null),
        Status::Failed { reason } => ("failed", json!(reason)),
    };
    json!({
        "name": listing.name, "kind": listing.kind, "status": status, "reason": reason, "seconds": listing.seconds,
        "scalars": listing.scalars, "warnings": listing.warnings, "attributes": listing.attributes,
        "variables": listing.variables.iter().map(variable).collect::<Vec<_>>(),
    })
}

fn variable(variable: &Variable) -> Value {
    json!({
        "name": variable.name, "dimensions": variable.dimensions, "shape": variable.shape, "units": variable.units,
        "long_name": variable.long_name, "attributes": variable.attributes,
    })
}

/// Tells a frame of the study, made beside the network's threads.
async fn stream(
    site: &Site,
    slot: Option<String>,
    make: impl FnOnce(&Studied, &Reporter) -> Result<FrameInTheMaking, RequestRefusal> + Send + 'static,
) -> Result<Response, RequestRefusal> {
    studied(&site.subject)?;
    let subject = Arc::clone(&site.subject);
    let work = move |reporter: &Reporter| {
        reporter.send(make(studied(&subject)?, reporter)?);
        Ok(())
    };
    site.scheduler.stream(Pace::Quick, slot, Box::new(work)).await
}

/// Which arrays are wanted.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct WantedArrays {
    analysis: String,
    variables: Vec<String>,
    #[serde(default)]
    from: Option<usize>,
    #[serde(default)]
    to: Option<usize>,
    #[serde(default)]
    most: Option<usize>,
    #[serde(default)]
    slot: Option<String>,
}

/// Answers `/api/study/arrays`.
pub(crate) async fn arrays(
    State(site): SharedSite,
    JsonBody(wanted): JsonBody<WantedArrays>,
) -> Result<Response, RequestRefusal> {
    if wanted.variables.len() > VARIABLES {
        return Err(RequestRefusal::too_large(format!(
            "{} variables are asked for; at most {VARIABLES} at once",
            wanted.variables.len()
        )));
    }
    stream(&site, wanted.slot.clone(), move |study, reporter| {
        let window = RowWindow { from: wanted.from, to: wanted.to, most: wanted.most };
        let found = study.view.arrays(&wanted.analysis, &wanted.variables, &window, reporter);
        let found = found.map_err(|error| reporter.refusal(error))?;
        check_answer(&found, InTerminal::Report)?;
        Ok(found.iter().fold(FrameInTheMaking::new("arrays"), FrameInTheMaking::array))
    })
    .await
}

/// Whose figure and tables are wanted.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Reported {
    analysis: String,
    #[serde(default)]
    slot: Option<String>,
}

/// Answers `/api/study/report`: what the report shows of one analysis.
pub(crate) async fn report(
    State(site): SharedSite,
    JsonBody(wanted): JsonBody<Reported>,
) -> Result<Response, RequestRefusal> {
    stream(&site, wanted.slot.clone(), move |study, reporter| {
        let ReportedAnalysis { figure, tables } = study.view.reported(&wanted.analysis, reporter)?;
        if reporter.interrupted() {
            return Err(reporter.refusal(StudyError::Interrupted));
        }
        let drawn = figure.map_err(RequestRefusal::from).and_then(|figure| {
            figure.as_ref().map_or(Ok(()), |text| check_bytes(text.len(), InTerminal::Report))?;
            Ok(figure)
        });
        let (figure, undrawn) =
            drawn.map_or_else(|why| (None, why.document()), |figure| (figure, Value::Null));
        let tables =
            tables.iter().map(|own| json!({ "caption": own.caption, "head": own.head, "rows": own.rows }));
        let frame = FrameInTheMaking::new("report").with("figure", figure).with("undrawn", undrawn);
        Ok(frame.with("tables", tables.collect::<Vec<_>>()))
    })
    .await
}

/// Whose case is wanted.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct NamedCase {
    analysis: String,
}

/// Answers `/api/study/case`: the case file of one analysis of the study.
pub(crate) async fn case(
    State(site): SharedSite,
    JsonBody(named): JsonBody<NamedCase>,
) -> Result<Response, RequestRefusal> {
    let text =
        site.compute(move |subject, _| Ok(alone(studied(subject)?.case()?, &named.analysis)?.source.text));
    Ok(([(CONTENT_TYPE, "text/plain; charset=utf-8")], text.await?).into_response())
}

/// Answers `/api/study/sound/…`: a name of the listing, or nothing.
pub(crate) async fn sound(
    State(site): SharedSite,
    Path(path): Path<String>,
) -> Result<Response, RequestRefusal> {
    site.compute(move |subject, _| {
        let file = studied(subject)?.view.sound(&path).map_err(|error| match error {
            StudyError::Store(damaged @ StoreError::Damaged { .. }) => StudyError::from(damaged).into(),
            _ => RequestRefusal::missing("the study has no such sound; `/api/study` lists them"),
        })?;
        let head = [
            (CONTENT_TYPE, HeaderValue::from_static("audio/wav")),
            (CACHE_CONTROL, HeaderValue::from_static("no-store")),
            // not those of `Read`
            (CONTENT_LENGTH, CheckedFile::bytes(&file).into()),
        ];
        Ok((head, in_pieces(file)).into_response())
    })
    .await
}

/// A file as the body of an answer, however large: it is read as the other side takes it.
fn in_pieces(mut file: impl Read + Send + 'static) -> Body {
    let (sender, receiver) = mpsc::channel(PIECES);
    tokio::task::spawn_blocking(move || {
        loop {
            let mut piece = vec![0; PIECE_BYTES];
            let read = file.read(&mut piece).map(|count| {
                piece.truncate(count);
                Bytes::from(piece)
            });
            let is_last = read.as_ref().map_or(true, Bytes::is_empty);
            // who has gone wants no more of it
            if sender.blocking_send(read).is_err() || is_last {
                return;
            }
        }
    });
    Body::from_stream(ReceiverStream::new(receiver))
}

/// Which shapes are wanted.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Shaped {
    analysis: String,
    at: f64,
    #[serde(default)]
    count: Option<usize>,
    #[serde(default)]
    slot: Option<String>,
}

/// Answers `/api/study/shapes`.
pub(crate) async fn shapes(
    State(site): SharedSite,
    JsonBody(wanted): JsonBody<Shaped>,
) -> Result<Response, RequestRefusal> {
    stream(&site, wanted.slot.clone(), move |study, reporter| {
        let count = wanted.count.unwrap_or(MODES).min(MODES);
        let found = study.shapes(&wanted.analysis, wanted.at, count, reporter);
        Ok(frame(found.map_err(|refusal| reporter.refusal(refusal))?))
    })
    .await
}

fn frame(shapes: SlidingShapes) -> FrameInTheMaking {
    let SlidingShapes { points, slider_points, lines, eigenvalues, shapes, .. } = shapes;
    let (count, modes) = (points.len(), eigenvalues.len());
    let flat = |points: &[[f64; 3]]| points.iter().flatten().copied().collect::<Vec<f64>>();
    let moved: Vec<Complex64> = shapes.into_iter().flatten().flatten().collect();
    let ends: Vec<i64> = lines.iter().flatten().map(|point| *point as i64).collect();
    FrameInTheMaking::new("shapes")
        .with("slider_points", slider_points)
        .with("eigenvalues", eigenvalues.iter().map(|value| json!([value.re, value.im])).collect::<Vec<_>>())
        .array(&Variable::new("points", &["point", "direction"], &[count, 3], flat(&points)).units("m"))
        .array(&Variable::new("lines", &["line", "end"], &[lines.len(), 2], ends))
        .array(&Variable::new("shapes", &["mode", "point", "direction"], &[modes, count, 3], moved))
}
