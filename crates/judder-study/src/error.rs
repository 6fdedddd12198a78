use judder_keys::error::CaseError;
use judder_memory::BeyondMemory;
use judder_report::ReportError;
use judder_store::{StoreError, Variable, VariableValues};
use std::any::Any;
use std::error::Error;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// What a model finds wrong, whole: who knows the model takes it back with its variants and fields.
pub trait ModelFault: Any + Error + Send + Sync {
    /// Whether the input is to blame, as of [`StudyError::is_wrong_input`].
    fn is_wrong_input(&self) -> bool;
}

impl Error for Box<dyn ModelFault> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        (**self).source()
    }
}

/// A stored array that is not what judder writes.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "{}the array `{array}` is {found}, where {expected} is right; `judder run --fresh` computes it anew",
    place(study, analysis)
)]
pub struct WrongArray {
    /// The study folder, as far as known.
    pub study: PathBuf,
    /// The analysis or sweep, as far as known.
    pub analysis: String,
    /// The array.
    pub array: String,
    /// What it is: its values, its dimensions.
    pub found: String,
    /// What would be right.
    pub expected: String,
}

impl WrongArray {
    /// An array that is not what it should be, of whichever study.
    #[must_use]
    pub fn of(array: &Variable, expected: String) -> Self {
        let kind = match array.data {
            VariableValues::F64(_) => "real numbers",
            VariableValues::Complex(_) => "complex numbers",
            VariableValues::I64(_) => "whole numbers",
            VariableValues::U8(_) => "codes",
            VariableValues::Text(_) => "words",
        };
        let axes: Vec<String> = array
            .dimensions
            .iter()
            .zip(&array.shape)
            .map(|(name, length)| format!("{name}: {length}"))
            .collect();
        let found = format!("one of {kind} over ({})", axes.join(", "));
        Self { study: PathBuf::new(), analysis: String::new(), array: array.name.clone(), found, expected }
    }

    /// The same, of this analysis of a study.
    #[must_use]
    pub fn in_study(self, study: &Path, analysis: &str) -> Self {
        Self { study: study.to_owned(), analysis: analysis.to_owned(), ..self }
    }
}

/// The place of an array, as far as known.
fn place(study: &Path, analysis: &str) -> String {
    match (study.as_os_str().is_empty(), analysis) {
        (true, "") => String::new(),
        (true, analysis) => format!("analysis `{analysis}`: "),
        (false, analysis) => format!("{}: analysis `{analysis}`: ", study.display()),
    }
}

/// Why a study has no result.
#[derive(Debug, Error)]
pub enum StudyError {
    /// The case file is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// What the model of the case finds wrong.
    #[error(transparent)]
    Model(Box<dyn ModelFault>),
    /// Reading or writing the study folder failed.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A figure or the page could not be drawn.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// An analysis or a sweep was asked for that the case does not have.
    #[error("the case has no analysis or sweep `{name}`; it has {}", known.join(", "))]
    UnknownAnalysis {
        /// The name that was asked for.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// A part was asked for where there is nothing to part.
    #[error("only sweeps have parts, and none is asked for; the case has {}", sweeps(known))]
    NoParts {
        /// The sweeps that there are.
        known: Vec<String>,
    },
    /// The folder to which a case file goes holds the study of another.
    #[error(
        "{}: holds the study of {}, another case file of this name; name another folder with -o, or replace that study with --fresh",
        folder.display(), owner.display()
    )]
    OtherCase {
        /// The folder.
        folder: PathBuf,
        /// The case file whose study it holds.
        owner: PathBuf,
    },
    /// A run without a folder would hold more than it may.
    #[error(
        "analysis `{name}`: with it the results take {:.1} MB, and {:.1} MB may be held in memory; a folder as `output` holds any number",
        *bytes as f64 / 1e6, *limit as f64 / 1e6
    )]
    HeldTooMuch {
        /// The analysis.
        name: String,
        /// Bytes of the arrays up to its own.
        bytes: u64,
        /// Bytes that may be held.
        limit: u64,
    },
    /// Something would take more memory than there is for it.
    #[error("{what}: {source}; {}", source.remedy())]
    Memory {
        /// What would take it.
        what: String,
        /// How much, and how much there is.
        source: BeyondMemory,
    },
    /// A file that the case names could not be used.
    #[error("{}: {reason}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A file that the case names could not be read.
    #[error("{}: the file cannot be read: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A file that the case names is another one than when the run began.
    #[error(
        "{}: the file has changed while the case was computed; what was computed before is kept under its old content: run again",
        path.display()
    )]
    FileChanged {
        /// The file.
        path: PathBuf,
    },
    /// More values of one variable are asked for than are read at once.
    #[error(
        "`{variable}` has {rows} rows of {width} values there, more than {most} values: ask for fewer rows, or for their extremes"
    )]
    TooManyValues {
        /// The variable.
        variable: String,
        /// Rows that are asked for.
        rows: usize,
        /// Values of a row.
        width: usize,
        /// Values that are read at most.
        most: usize,
    },
    /// The arrays of an analysis are more than are read at once for its figure.
    #[error(
        "analysis `{name}` has {values} values, and a figure is drawn here of {most} at most; `judder report` draws it"
    )]
    TooManyToDraw {
        /// The analysis.
        name: String,
        /// Values of all its arrays.
        values: usize,
        /// Values that are read at most.
        most: usize,
    },
    /// What is needed is held by a process that seems to have stopped.
    #[error(
        "{held}, has shown no sign of life for {seconds} s; let that process go on, or end it, then run again: what is done is kept"
    )]
    NoSignOfLife {
        /// The file that is locked, and who holds it.
        held: String,
        /// For how long, s.
        seconds: u64,
    },
    /// A stored array is not what judder writes.
    #[error(transparent)]
    WrongArray(Box<WrongArray>),
    /// The folder holds no results to report on.
    #[error("{folder} holds no results yet: run `judder run CASE.toml -o {folder}` first")]
    NoResults {
        /// The folder.
        folder: String,
    },
    /// Stopped by the user; what was done is kept.
    #[error("interrupted; what was done is kept, and the same command goes on from there")]
    Interrupted,
}

impl From<WrongArray> for StudyError {
    fn from(wrong: WrongArray) -> Self {
        Self::WrongArray(Box::new(wrong))
    }
}

impl StudyError {
    /// Whether the input is to blame: what the case, its files or the arguments say cannot be. Otherwise a result that could be
    /// is missing.
    #[must_use]
    pub fn is_wrong_input(&self) -> bool {
        match self {
            Self::Case(_)
            | Self::UnknownAnalysis { .. }
            | Self::NoParts { .. }
            | Self::OtherCase { .. }
            | Self::File { .. }
            | Self::Unreadable { .. }
            | Self::FileChanged { .. }
            | Self::TooManyValues { .. }
            | Self::TooManyToDraw { .. }
            | Self::HeldTooMuch { .. }
            | Self::Memory { .. }
            | Self::NoResults { .. } => true,
            Self::Model(fault) => fault.is_wrong_input(),
            Self::Store(error) => is_wrong_folder(error),
            Self::Report(_) | Self::WrongArray(_) | Self::NoSignOfLife { .. } | Self::Interrupted => false,
        }
    }
}

impl StudyError {
    /// What memory was refused for it, whichever error says so in the end.
    #[must_use]
    pub fn beyond_memory(&self) -> Option<BeyondMemory> {
        let mut error: Option<&(dyn Error + 'static)> = Some(self);
        while let Some(own) = error {
            let boxed = || own.downcast_ref::<Box<BeyondMemory>>().map(|boxed| **boxed);
            if let Some(beyond) = own.downcast_ref::<BeyondMemory>().copied().or_else(boxed) {
                return Some(beyond);
            }
            error = own.source();
        }
        None
    }
}

/// Whether the folder that was named is to blame.
fn is_wrong_folder(error: &StoreError) -> bool {
    matches!(
        error,
        StoreError::NotAFolder { .. }
            | StoreError::PathNotText { .. }
            | StoreError::HoldsStudy { .. }
            | StoreError::ForeignFolder { .. }
            | StoreError::ForeignSweep { .. }
            | StoreError::OtherBuild { .. }
            | StoreError::OtherLayout { .. }
            | StoreError::ForeignChunk { .. }
            | StoreError::NoStudy { .. }
            | StoreError::SummaryUnreadable { .. }
    )
}

fn sweeps(known: &[String]) -> String {
    if known.is_empty() { "no sweep".to_owned() } else { format!("the sweeps {}", known.join(", ")) }
}
