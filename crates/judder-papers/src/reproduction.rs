//! What is left of a paper that was recomputed.

use crate::claim::ClaimLine;
use crate::plain::plain;
use serde_json::{Map, Value, json};
use std::path::PathBuf;

/// What a reproduction left.
#[derive(Debug, Clone)]
pub struct Reproduction {
    /// The study folder.
    pub folder: PathBuf,
    /// Its `report.html`.
    pub report: PathBuf,
    /// Heads of the columns of our numbers.
    pub columns: Vec<String>,
    /// What the paper says, and what we find.
    pub scoreboard: Vec<ClaimLine>,
    /// Results and figures that are not whole, a line each: which, and why.
    pub lacking: Vec<String>,
}

impl Reproduction {
    /// The heads of the numbers of a claim: its own, or those of all.
    #[must_use]
    pub fn columns_of<'a>(&'a self, claim: &'a ClaimLine) -> &'a [String] {
        if claim.columns.is_empty() { &self.columns } else { &claim.columns }
    }

    /// The scoreboard as a document; our numbers under the names of their columns.
    #[must_use]
    pub fn json(&self) -> Value {
        let line = |claim: &ClaimLine| {
            let columns = self.columns_of(claim).iter().cloned();
            let ours: Map<_, _> = columns.zip(claim.ours.iter().map(|ours| json!(plain(ours)))).collect();
            json!({
                "place": claim.place, "says": plain(&claim.says), "ours": ours, "verdict": claim.verdict,
                "why": plain(&claim.why),
            })
        };
        json!({
            "folder": self.folder.display().to_string(),
            "report": self.report.display().to_string(),
            "complete": self.lacking.is_empty(),
            "lacking": self.lacking,
            "scoreboard": self.scoreboard.iter().map(line).collect::<Vec<_>>(),
        })
    }
}
