use judder_case::CaseError;
use judder_oscillator::OscillatorError;
use judder_report::ReportError;
use judder_store::StoreError;
use thiserror::Error;

/// Why a study has no result.
#[derive(Debug, Error)]
pub enum StudyError {
    /// The case file is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The operating point has no answer.
    #[error("the operating point has no answer: {0}")]
    Oscillator(#[from] OscillatorError),
    /// Reading or writing the study folder failed.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A figure or the page could not be drawn.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// An analysis was asked for that the case does not have.
    #[error("the case has no analysis `{name}`; it has {}", known.join(", "))]
    UnknownAnalysis {
        /// The name that was asked for.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// The command is for oscillator cases.
    #[error("`judder {command}` takes an oscillator case; this one is of model `{model}`")]
    WrongModel {
        /// The command.
        command: &'static str,
        /// The model of the case.
        model: &'static str,
    },
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
