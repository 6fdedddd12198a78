//! What an analysis leaves.

use judder_store::{Dataset, Table};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};

/// Scalars, arrays, a table, checks and warnings of one analysis.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// What `summary.json` shows of it.
    pub scalars: Map<String, Value>,
    /// Every array, with coordinates and units.
    pub dataset: Dataset,
    /// Whether the arrays are in the study folder already: they grew there while the analysis ran.
    pub is_stored: bool,
    /// What a spreadsheet wants, where the result is a table.
    pub table: Option<Table>,
    /// The comparisons that were made.
    pub checks: Vec<CheckRecord>,
    /// Files beside arrays and table, each with its path in the study folder: fields, laws.
    pub files: Vec<(String, Vec<u8>)>,
    /// What the user has to know before trusting the numbers.
    pub warnings: Vec<String>,
    /// Requested results that are missing (unresolved points, failed searches); any makes the run exit with 1.
    pub missing: usize,
}

/// A number doubted by another number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckRecord {
    /// What is checked.
    pub name: String,
    /// What was compared with what, and how often.
    pub compared: String,
    /// The largest disagreement; infinite where one side was missing.
    #[serde(deserialize_with = "number_or_infinite")]
    pub figure: f64,
    /// What it may be at most.
    pub limit: f64,
}

impl CheckRecord {
    /// Whether the disagreement is within its limit.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.figure <= self.limit
    }
}

/// JSON has no infinity and writes `null` for it.
fn number_or_infinite<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or(f64::INFINITY))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_check_without_a_number_stays_a_failed_check() {
        let check =
            CheckRecord { name: String::new(), compared: String::new(), figure: f64::INFINITY, limit: 1.0 };
        let text = serde_json::to_string(&check).unwrap();
        let kept: CheckRecord = serde_json::from_str(&text).unwrap();
        assert!(kept == check && !kept.passed());
    }
}
