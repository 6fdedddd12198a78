//! The papers, recomputed: their figures, and what their text claims, with a scoreboard.
//!
//! - `claim`: a claim, what it is measured on, its line of the scoreboard.
//! - `summary`: what the summary of a reproduction says.
//! - `oscillator`: a sphere on rubber with two degrees of freedom.
//! - `beams`: two beams in sliding contact.

mod beams;
mod claim;
mod oscillator;
mod summary;

use judder_study::{StudyError, report};
use std::path::{Path, PathBuf};
use summary::KEY;

pub use beams::beams_paper;
pub use claim::ClaimLine;
pub use oscillator::oscillator_paper;

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
    /// Whether every result is there.
    pub complete: bool,
}

/// Rebuilds figures and `report.html` of any study folder from its stored results; returns the page's path.
///
/// # Errors
/// A folder without results, damaged results, or a folder that cannot be written.
pub fn rebuild(folder: &Path) -> Result<PathBuf, StudyError> {
    let (store, summary) = report::stored(folder)?;
    let Some(own) = summary.extra.get(KEY) else {
        return report::write(judder_models::REGISTRY, &store, &summary);
    };
    match own.get("paper").and_then(serde_json::Value::as_str) {
        Some(beams::PAPER) => beams::page::write(&store, &summary),
        _ => oscillator::page::write(&store, &summary),
    }
}
