//! Every error with its message, place, help and exit code.

use std::any::Any;
use std::fmt::{self, Display};
use std::io;
use std::path::Path;

use judder_examples::ExampleError;
use judder_explorer::ExplorerError;
use judder_keys::error::CaseError;
use judder_models::ModelError;
use judder_study::run::RefusedAnalysis;
use judder_study::{StudyError, fault_told};
use miette::{Diagnostic, Severity};
use serde_json::{Value, json};

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Exit {
    /// Every requested result is there.
    Done,
    /// A requested result is missing. A failed check is a warning and does not make it so.
    Incomplete,
    /// The input is wrong.
    WrongInput,
}

impl Exit {
    /// The exit code.
    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Incomplete => 1,
            Self::WrongInput => 2,
        }
    }
}

/// What is wrong and what would be right, without a place in a file.
#[derive(Debug)]
pub(crate) struct Message {
    severity: Severity,
    text: String,
    help: Option<String>,
}

impl Message {
    pub(crate) fn error(text: impl Into<String>) -> Self {
        Self { severity: Severity::Error, text: text.into(), help: None }
    }

    pub(crate) fn warning(text: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, text: text.into(), help: None }
    }

    pub(crate) fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// A sentence that says what is wrong and, after its last semicolon, what would be right.
    pub(crate) fn from_sentence(error: &impl Display) -> Self {
        let text = error.to_string();
        match text.rsplit_once("; ") {
            Some((wrong, right)) => Self::error(wrong).with_help(right),
            None => Self::error(text),
        }
    }
}

impl Display for Message {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.text)
    }
}

impl std::error::Error for Message {}

impl Diagnostic for Message {
    fn severity(&self) -> Option<Severity> {
        Some(self.severity)
    }

    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn Display>)
    }
}

/// Why a command has no result.
#[derive(Debug)]
pub(crate) struct Failure {
    /// How the command ends.
    pub(crate) exit: Exit,
    diagnostic: Box<dyn Diagnostic>,
    /// What else is wrong with the same input.
    pub(crate) others: Vec<Failure>,
}

impl Failure {
    /// The input is wrong, and how to mend it.
    pub(crate) fn wrong_input(text: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            exit: Exit::WrongInput,
            diagnostic: Box::new(Message::error(text).with_help(help)),
            others: Vec::new(),
        }
    }

    /// The result could not be computed or kept.
    pub(crate) fn missing(message: Message) -> Self {
        Self { exit: Exit::Incomplete, diagnostic: Box::new(message), others: Vec::new() }
    }

    /// All of these as one: the first, and what else is wrong.
    pub(crate) fn all(failures: impl IntoIterator<Item = Self>) -> Option<Self> {
        let mut failures = failures.into_iter();
        let first = failures.next()?;
        Some(Self {
            others: first.others.into_iter().chain(failures.flat_map(Self::each)).collect(),
            ..first
        })
    }

    /// Each thing that is wrong by itself.
    fn each(mut self) -> Vec<Self> {
        let others = std::mem::take(&mut self.others);
        std::iter::once(self).chain(others).collect()
    }

    /// A panic of the program.
    pub(crate) fn fault(panic: &(dyn Any + Send)) -> Self {
        let help = "please report it, with the command and its case";
        Self::missing(Message::error(fault_told(panic)).with_help(help))
    }

    /// Standard output could not be written.
    pub(crate) fn output(source: io::Error) -> Self {
        Self::missing(Message::error(format!("standard output could not be written: {source}")))
    }

    /// The error as it is drawn.
    pub(crate) fn diagnostic(&self) -> &dyn Diagnostic {
        &*self.diagnostic
    }

    /// The error as a document: `place` is null where the error has none, `line` and `column` count from 1; `others` are what else is wrong.
    pub(crate) fn json(&self) -> Value {
        let mut json = json!({ "error": self.own_json() });
        if !self.others.is_empty() {
            json["error"]["others"] = self.others.iter().map(Self::own_json).collect();
        }
        json
    }

    fn own_json(&self) -> Value {
        let error = &self.diagnostic;
        let mut message = error.to_string();
        let mut cause = error.source();
        while let Some(source) = cause {
            message = format!("{message}: {source}");
            cause = source.source();
        }
        let help = error.help().map(|help| help.to_string());
        json!({ "message": message, "place": place(&**error), "help": help })
    }
}

/// Where in which text an error lies.
fn place(error: &dyn Diagnostic) -> Option<Value> {
    let label = error.labels()?.next()?;
    let found = error.source_code()?.read_span(label.inner(), 0, 0).ok()?;
    Some(json!({
        "source": found.name(),
        "line": found.line() + 1,
        "column": found.column() + 1,
        "text": String::from_utf8_lossy(found.data()),
    }))
}

impl Failure {
    /// Why an analysis of a case was refused. An error that has no place in the case file is told with its analysis.
    pub(crate) fn of_analysis(case: &Path, refused: RefusedAnalysis) -> Self {
        match refused.error {
            StudyError::Case(error) => error.into(),
            error => {
                let sentence = format!("{}, analysis `{}`: {error}", case.display(), refused.name);
                Self {
                    exit: Exit::WrongInput,
                    diagnostic: Box::new(Message::from_sentence(&sentence)),
                    others: Vec::new(),
                }
            }
        }
    }
}

impl From<CaseError> for Failure {
    fn from(error: CaseError) -> Self {
        let (error, others) = error.split();
        let others = others.into_iter().map(Self::from).collect();
        Self { exit: Exit::WrongInput, diagnostic: Box::new(error), others }
    }
}

impl From<ExampleError> for Failure {
    fn from(error: ExampleError) -> Self {
        let message = Message::from_sentence(&error);
        match error {
            ExampleError::Unknown { .. } | ExampleError::Exists { .. } => {
                Self { exit: Exit::WrongInput, diagnostic: Box::new(message), others: Vec::new() }
            }
            _ => Self::missing(message),
        }
    }
}

impl From<ExplorerError> for Failure {
    fn from(error: ExplorerError) -> Self {
        match error {
            ExplorerError::Case(error) => error.into(),
            ExplorerError::Study(error) => error.into(),
            error @ ExplorerError::Bind { .. } => Self {
                exit: Exit::WrongInput,
                diagnostic: Box::new(Message::from_sentence(&error)),
                others: Vec::new(),
            },
            error => Self::missing(Message::from_sentence(&error)),
        }
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        let exit = if error.is_wrong_input() { Exit::WrongInput } else { Exit::Incomplete };
        let message = match error {
            StudyError::Case(error) => return error.into(),
            StudyError::NoResults { folder } => Message::error(format!("{folder}: no results here yet"))
                .with_help(format!("`judder run CASE.toml -o {folder}` makes some")),
            StudyError::UnknownAnalysis { name, known } => Message::error(format!(
                "the case has no analysis or sweep `{name}`"
            ))
            .with_help(match known.len() {
                0 => "it has none at all".to_owned(),
                _ => format!("it has {}", known.join(", ")),
            }),
            error => match ModelError::of(&error) {
                Some(wrong @ ModelError::WrongModel { .. }) => {
                    Message::error(wrong.to_string()).with_help("`judder check` and `judder run` take it")
                }
                _ => Message::from_sentence(&error),
            },
        };
        Self { exit, diagnostic: Box::new(message), others: Vec::new() }
    }
}

impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        StudyError::from(error).into()
    }
}
