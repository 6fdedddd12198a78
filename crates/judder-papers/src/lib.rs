//! The papers, recomputed: their figures, and what their text claims, with a scoreboard.
//!
//! - `paper`: which papers there are. `reproduction`: what is left of one that was recomputed.
//! - `claim`: a claim, what it is measured on, its line of the scoreboard. `plain`: its words for a terminal.
//! - `summary`: what the summary of a reproduction says. `drawn`: figures from several analyses, of which one may be damaged.
//! - `oscillator`: a sphere on rubber with two degrees of freedom.
//! - `beams`: two beams in sliding contact.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod beams;
mod claim;
mod drawn;
mod oscillator;
mod paper;
mod plain;
mod reproduction;
mod summary;

use judder_study::report::{self, WrittenPage};
use judder_study::{StudyError, maker};
use std::path::Path;
use summary::KEY;

pub use beams::beams_paper;
pub use claim::ClaimLine;
pub use oscillator::oscillator_paper;
pub use paper::Paper;
pub use plain::plain;
pub use reproduction::Reproduction;

/// Rebuilds figures and `report.html` of any study folder from its stored results, there or in another folder.
///
/// # Errors
/// A folder without results, damaged results, or a folder that cannot be written.
pub fn rebuild(folder: &Path, output: Option<&Path>) -> Result<WrittenPage, StudyError> {
    let (store, summary) = match output {
        None => report::stored(folder),
        Some(output) => report::stored_for(folder, output),
    }?;
    let paper = summary.extra.get(KEY).map(|own| own.get("paper").and_then(serde_json::Value::as_str));
    let page = match paper {
        None => report::write(judder_models::REGISTRY, &store, &summary),
        Some(Some(beams::PAPER)) => beams::page::write(&store, &summary),
        Some(_) => oscillator::page::write(&store, &summary),
    }?;
    store.seal_as_before(maker())?;
    Ok(page)
}
