//! Errors as documents: what is wrong, where, what would be right.

use axum::Json;
use axum::http::StatusCode;
use axum::http::header::RETRY_AFTER;
use axum::response::{IntoResponse, Response};
use judder_keys::error::CaseError;
use judder_models::ModelError;
use judder_study::StudyError;
use serde_json::{Value, json};

/// Why a computation is given up with the program.
pub(crate) const ENDING: &str = "`judder explore` is ending; start it again";

/// After how many seconds a request may come again that found the waiting room full.
const AGAIN_AFTER: u16 = 1;

/// What to type in a terminal for what is too large, or takes too long, for a page.
#[derive(Debug, Clone, Copy)]
pub(crate) enum InTerminal {
    /// The analysis of the view.
    Run,
    /// The operating point of the view.
    Point,
    /// The study that is looked at.
    Report,
}

impl InTerminal {
    /// The command, in words that go on from what would be right.
    fn words(self) -> &'static str {
        match self {
            Self::Run => "export the case and type `judder run CASE.toml` in a terminal",
            Self::Point => "export the case and type `judder point CASE.toml` in a terminal",
            Self::Report => "type `judder report FOLDER` in a terminal, which draws the whole study",
        }
    }
}

/// A request without an answer.
#[derive(Debug)]
pub(crate) struct RequestRefusal {
    status: StatusCode,
    message: String,
    help: Option<String>,
    place: Option<Box<Value>>,
    /// What else is wrong with the same case, each as a document.
    others: Vec<Value>,
}

impl RequestRefusal {
    /// What is wrong; what stands behind the last semicolon is what would be right, as errors of judder have it.
    pub(crate) fn new(status: StatusCode, sentence: impl Into<String>) -> Self {
        let sentence = sentence.into();
        let (message, help) = match sentence.rsplit_once("; ") {
            Some((wrong, right)) => (wrong.to_owned(), Some(right.to_owned())),
            None => (sentence, None),
        };
        Self { status, message, help, place: None, others: Vec::new() }
    }

    /// The request is wrong.
    pub(crate) fn wrong(sentence: impl Into<String>) -> Self {
        Self::new(StatusCode::BAD_REQUEST, sentence)
    }

    /// There is no such thing.
    pub(crate) fn missing(sentence: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, sentence)
    }

    /// It is too large.
    pub(crate) fn too_large(sentence: impl Into<String>) -> Self {
        Self::new(StatusCode::PAYLOAD_TOO_LARGE, sentence)
    }

    /// It is larger than a page asks for or is sent: smaller would be right, or a terminal.
    pub(crate) fn beyond_page(what: String, smaller: &str, instead: InTerminal) -> Self {
        Self::too_large(format!("{what}; {smaller}, or {}", instead.words()))
    }

    /// It was given up after as many seconds as a page waits.
    pub(crate) fn took_too_long(seconds: u64, instead: InTerminal) -> Self {
        let words = instead.words();
        Self::interrupted(format!("this takes longer than the {seconds} s that a page waits; {words}"))
    }

    /// More requests wait already than are let wait.
    pub(crate) fn busy(waiting: usize) -> Self {
        let sentence = format!("{waiting} requests wait already; wait until one is done, or cancel one");
        Self::new(StatusCode::SERVICE_UNAVAILABLE, sentence)
    }

    /// The work was given up.
    pub(crate) fn interrupted(reason: String) -> Self {
        Self::new(StatusCode::CONFLICT, reason)
    }

    /// The document `{"message", "place", "help", "others"}`.
    pub(crate) fn document(&self) -> Value {
        json!({ "message": self.message, "place": self.place, "help": self.help, "others": self.others })
    }
}

impl From<CaseError> for RequestRefusal {
    fn from(error: CaseError) -> Self {
        let place = error.line_and_column().map(|(line, column)| {
            Box::new(json!({
                "source": error.source_name(), "line": line, "column": column, "text": error.place(),
            }))
        });
        let (message, help) = (error.to_string(), error.cause().help());
        let others = error.split().1.into_iter().map(|other| Self::from(other).document()).collect();
        Self { status: StatusCode::UNPROCESSABLE_ENTITY, message, help, place, others }
    }
}

impl From<StudyError> for RequestRefusal {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Case(error) => error.into(),
            error => Self::new(StatusCode::UNPROCESSABLE_ENTITY, error.to_string()),
        }
    }
}

impl From<ModelError> for RequestRefusal {
    fn from(error: ModelError) -> Self {
        StudyError::from(error).into()
    }
}

impl IntoResponse for RequestRefusal {
    fn into_response(self) -> Response {
        let mut response = (self.status, Json(json!({ "error": self.document() }))).into_response();
        if self.status == StatusCode::SERVICE_UNAVAILABLE {
            response.headers_mut().insert(RETRY_AFTER, AGAIN_AFTER.into());
        }
        response
    }
}
