//! What the engine asks of a model and of an analysis; nothing else of them is known here.

mod analysed;
mod case;
mod needed_memory;
mod operating_quantity;

pub use analysed::{Analysed, Analyses, Analysis, wanted};
pub use case::Case;
pub use needed_memory::{MemoryBound, NeededMemory, PROGRAM_BYTES, admit, estimates};
pub use operating_quantity::OperatingQuantity;

use crate::case::study_sweep::{StudySweep, SweptKey};
use crate::case::text::CaseText;
use crate::error::StudyError;
use crate::kept::KeptLines;
use crate::labels::{self, SweptQuantity};
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::resolve::Resolved;
use dyn_clone::{DynClone, clone_trait_object};
use judder_keys::cause::Cause;
use judder_keys::error::CaseError;
use judder_keys::file_reference::FileReference;
use serde_json::Value;
use std::any::Any;
use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

/// A case of a model.
pub trait Model: Analyses + Any + DynClone + fmt::Debug + Send + Sync {
    /// The files that it names: results depend on what they hold.
    fn files(&self) -> Vec<&FileReference> {
        Vec::new()
    }

    /// Its canonical form, defaults filled in.
    fn resolved(&self) -> Value;

    /// A canonical form with what is used in place of its numbers, where something else decides them; no part of any hash.
    ///
    /// # Errors
    /// Data that cannot be read or fitted.
    fn with_used(&self, resolved: Value) -> Result<Value, StudyError> {
        Ok(resolved)
    }

    /// Whether two numbers of the case, by their dotted paths, are one quantity.
    fn is_one_quantity(&self, _first: &str, _second: &str) -> bool {
        false
    }

    /// Whether setting these keys is all that reading the case anew at their values does, as these cases show that were read so.
    fn is_set_by(&self, _keys: &[SweptKey], _tried: &[Case]) -> bool {
        false
    }

    /// How a swept key is called that [`Model::is_set_by`] holds for.
    fn swept_label(&self, key: &SweptKey) -> SweptQuantity {
        labels::any_key(&key.path, key.dimension)
    }

    /// What its analyses share that takes time to make.
    ///
    /// # Errors
    /// Files that cannot be read, structures that cannot be.
    fn prepared(&self) -> Result<Prepared, StudyError> {
        Ok(Prepared::NOTHING)
    }

    /// The same, with the place in the case file of what is wrong; and what the wanted analyses are known beforehand to be refused for: too
    /// much memory, too deep, too long.
    ///
    /// # Errors
    /// As [`Model::prepared`], and the first refusal.
    fn preflight(&self, _file: &CaseText, _is_wanted: &dyn Fn(&str) -> bool) -> Result<Prepared, StudyError> {
        self.prepared()
    }

    /// The same of a case that differs from that of which `known` is prepared by the values of these swept keys alone: what they do not
    /// concern is not made again.
    ///
    /// # Errors
    /// As [`Model::preflight`].
    fn preflight_at(
        &self,
        file: &CaseText,
        is_wanted: &dyn Fn(&str) -> bool,
        _known: &Prepared,
        _keys: &[&str],
    ) -> Result<Prepared, StudyError> {
        self.preflight(file, is_wanted)
    }

    /// Runs an analysis.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`], and what the analysis is refused for.
    fn run(&self, index: usize, task: Task<'_>) -> Result<Outcome, StudyError>;

    /// What `judder check` shows; `resolved` is its canonical form, with what is used as of [`Model::with_used`].
    ///
    /// # Errors
    /// What a run would refuse.
    fn resolve(&self, file: &CaseText, resolved: Value) -> Result<Resolved, StudyError>;

    /// The operating points of a sweep at which the case need not be read anew; `None` where it must be.
    ///
    /// # Errors
    /// A law or data that cannot be, [`StudyError::Interrupted`].
    fn operating_points(
        &self,
        _sweep: &StudySweep,
        _progress: &dyn Progress,
    ) -> Result<Option<Box<dyn OperatingPoints>>, StudyError> {
        Ok(None)
    }

    /// These quantities of the operating point of the case itself, and why they are doubtful.
    ///
    /// # Errors
    /// No operating point, [`StudyError::Interrupted`].
    fn operating_point(
        &self,
        _wanted: &[OperatingQuantity],
        _progress: &dyn Progress,
    ) -> Result<(Vec<f64>, Vec<String>), StudyError> {
        Ok((Vec::new(), Vec::new()))
    }

    /// What an operating point of a sweep takes.
    fn operating_work(&self, _sweep: &StudySweep, _wanted: &[OperatingQuantity]) -> OperatingWork {
        OperatingWork::Search
    }

    /// What a finished sweep has to say of points at which the case was read anew; `at` reads it, none where there is no such case.
    fn told_of_sweep(&self, _sweep: &StudySweep, _at: &dyn Fn(&[f64]) -> Option<Case>) -> Option<String> {
        None
    }

    /// What of the resolved case that depends on which all analyses share and which takes long to compute; `None` where nothing does.
    fn shared(&self, _resolved: &Value) -> Option<Vec<Value>> {
        None
    }
}

clone_trait_object!(Model);

/// Operating points that share what takes time to make.
pub trait OperatingPoints: Send + Sync {
    /// These quantities where the swept keys have these values.
    ///
    /// # Errors
    /// No operating point.
    fn at(&self, values: &[f64], wanted: &[OperatingQuantity]) -> Result<Vec<f64>, StudyError>;

    /// What a finished sweep has to say of them.
    ///
    /// # Errors
    /// Data that cannot be read.
    fn told(&self, sweep: &StudySweep) -> Result<Vec<String>, StudyError>;
}

/// What an operating point takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OperatingWork {
    /// A contact law of its own.
    Law,
    /// A search, or the case read anew.
    Search,
    /// Microseconds.
    Point,
}

/// Samples that an analysis shows while it runs, one behind the other: the arrays of its dataset, as far as they go.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SampleBlock {
    /// Where the samples lie, in time as the dataset has it.
    pub time: Vec<f64>,
    /// Each number of a sample with its name in the dataset and its values.
    pub numbers: Vec<(&'static str, Vec<f64>)>,
    /// The class of each sample, by its code in the dataset.
    pub classes: Vec<u8>,
}

/// How an analysis is run.
pub struct Task<'a> {
    /// What the analyses of the case share.
    pub prepared: &'a Prepared,
    /// What an interrupted run has left of what the analyses of the case share.
    pub shared: KeptLines<'a>,
    /// What it has left of this analysis.
    pub own: KeptLines<'a>,
    /// Who is told how far it is, and may stop it.
    pub progress: &'a dyn Progress,
    /// Who sees samples while they are computed.
    pub watch: Option<&'a mut dyn FnMut(SampleBlock)>,
}

impl<'a> Task<'a> {
    /// Of nothing that is known before and nothing that is kept.
    pub fn alone(prepared: &'a Prepared, progress: &'a dyn Progress) -> Self {
        Self { prepared, shared: KeptLines::NOTHING, own: KeptLines::NOTHING, progress, watch: None }
    }
}

/// What the analyses of a case share.
#[derive(Clone)]
pub struct Prepared(Option<Arc<dyn Any + Send + Sync>>);

impl Prepared {
    /// Nothing.
    pub const NOTHING: Self = Self(None);

    /// This.
    pub fn new<T: Any + Send + Sync>(made: Arc<T>) -> Self {
        Self(Some(made))
    }

    /// What was made, where it is of this type.
    pub fn get<T: Any + Send + Sync>(&self) -> Option<Arc<T>> {
        Arc::clone(self.0.as_ref()?).downcast().ok()
    }
}

/// An analysis in its case file.
#[derive(Clone, Copy)]
pub struct AnalysisPlace<'a> {
    /// The text of the case file.
    pub file: &'a CaseText,
    /// The position of the analysis.
    pub index: usize,
    /// Its name.
    pub name: &'a str,
}

/// Where a case is to blame, and why.
pub enum Refusal {
    /// The first of these keys that the analysis has.
    Keys(&'static [&'static str], Box<Cause>),
    /// A key of the analysis, by its dotted path.
    Key(Cow<'static, str>, Box<Cause>),
    /// Any key of the case, by its dotted path.
    Path(&'static str, Box<Cause>),
}

impl Refusal {
    /// The first of these keys that the analysis has is to blame.
    pub fn keys(keys: &'static [&'static str], cause: impl Into<Cause>) -> Self {
        Self::Keys(keys, Box::new(cause.into()))
    }

    /// A key of the analysis is to blame, by its dotted path; the analysis where it is empty.
    pub fn key(key: impl Into<Cow<'static, str>>, cause: impl Into<Cause>) -> Self {
        Self::Key(key.into(), Box::new(cause.into()))
    }

    /// A key of the case is to blame, by its dotted path.
    pub fn path(path: &'static str, cause: impl Into<Cause>) -> Self {
        Self::Path(path, Box::new(cause.into()))
    }

    /// As an error at its place in the case file.
    pub fn placed(self, AnalysisPlace { file, index, name }: AnalysisPlace<'_>) -> CaseError {
        match self {
            Self::Keys(keys, cause) => file.analysis_error(index, keys, *cause),
            Self::Key(key, cause) if key.is_empty() => file.error(&format!("analysis.{name}"), *cause),
            Self::Key(key, cause) => file.error(&format!("analysis.{name}.{key}"), *cause),
            Self::Path(path, cause) => file.error(path, *cause),
        }
    }
}

/// What a run found wrong with an analysis of a case, at its place in the text where a key is to blame.
pub fn placed(
    error: StudyError,
    case: &(impl Analyses + ?Sized),
    file: &CaseText,
    index: usize,
) -> StudyError {
    let names = case.analysis_names();
    let Some(name) = names.get(index) else { return error };
    case.blamed(&error, AnalysisPlace { file, index, name }).map_or(error, StudyError::from)
}
