//! `summary.json`: what was run, what came of it, and what need not be run again.

use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::Path;

use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Map, Value};

use crate::{FileDamage, LARGEST_DOCUMENT, StoreError, plain};

/// The name of the summary in a study folder.
pub(crate) const FILE: &str = "summary.json";

/// The content of `summary.json`.
///
/// JSON has no NaN and no infinity: in `results` and `extra` they are written as `null`, which reads "no finite value"
/// (see [`number`]); the arrays in `results.zarr` keep them as they are. The times must be finite.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// The hash of the case, by [`content_hash`](crate::content_hash).
    pub case_hash: String,
    /// The version of judder that ran last.
    pub version: String,
    /// Wall time of the last run, in seconds.
    #[serde(serialize_with = "finite")]
    pub wall_time_s: f64,
    /// Analysis name → its scalars and short tables.
    pub results: BTreeMap<String, Map<String, Value>>,
    /// Analysis name → how it ended.
    #[serde(default)]
    pub analyses: BTreeMap<String, AnalysisRecord>,
    /// Warnings that concern the case as a whole.
    #[serde(default)]
    pub warnings: Vec<String>,
    /// The resolved case, as JSON; null where it was not kept.
    #[serde(default)]
    pub case: Value,
    /// Whatever else a caller keeps here, at the top level of the file.
    #[serde(flatten)]
    pub extra: Map<String, Value>,
}

/// How one analysis ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AnalysisRecord {
    /// The hash of all that the analysis depends on; another hash means: run it again.
    pub hash: String,
    /// How it ended.
    #[serde(flatten)]
    pub status: Status,
    /// Its wall time, in seconds.
    #[serde(serialize_with = "finite")]
    pub wall_time_s: f64,
    /// Its warnings.
    #[serde(default)]
    pub warnings: Vec<String>,
}

/// Whether an analysis has an answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "status", rename_all = "lowercase")]
pub enum Status {
    /// It has; an empty list of roots is one.
    Done,
    /// It has not, and why.
    Failed {
        /// The error, with its causes.
        reason: String,
    },
}

/// A number for a summary: `null` where it is NaN or infinite, which JSON cannot hold.
#[must_use]
pub fn number(value: f64) -> Value {
    Value::from(value)
}

fn finite<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() {
        serializer.serialize_f64(*value)
    } else {
        Err(serde::ser::Error::custom(format_args!("a wall time must be finite, not {value}")))
    }
}

/// Reads the summary of a study; `None` where there is none yet.
pub(crate) fn read(study: &Path) -> Result<Option<Summary>, StoreError> {
    let path = study.join(FILE);
    if let Some(other) = plain::other_than_file(&path) {
        return Err(StoreError::Damaged { path, damage: FileDamage::Other(other) });
    }
    match plain::read_json(&path) {
        Ok(content) => serde_json::from_slice(&content)
            .map(Some)
            .map_err(|source| StoreError::SummaryUnreadable { path, source }),
        Err(source) if source.kind() == ErrorKind::NotFound => Ok(None),
        Err(source) => Err(StoreError::read(&path, source)),
    }
}

/// The content of the file of the summary of a study.
pub(crate) fn content(study: &Path, summary: &Summary) -> Result<Vec<u8>, StoreError> {
    let mut content = serde_json::to_vec_pretty(summary)
        .map_err(|source| StoreError::SummaryUnwritable { path: study.join(FILE), source })?;
    content.push(b'\n');
    let path = study.join(FILE);
    plain::check_size(content.len() as u64, LARGEST_DOCUMENT)
        .map_err(|source| StoreError::read(&path, source))?;
    Ok(content)
}
