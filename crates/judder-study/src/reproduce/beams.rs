//! The beams paper: Figs. 2–6 and what its text claims, from one run of its case.

mod claims;
mod figures;
mod found;
mod page;
mod passage;

use super::{KEY, Reproduction};
use crate::error::StudyError;
use crate::progress::Progress;
use crate::run::{self, Computed, RunOptions};
use found::Found;
use judder_case::{CaseFile, template};
use judder_store::{StudyFolder, Summary};
use serde_json::json;
use std::path::{Path, PathBuf};

/// The paper's name in a summary.
pub(super) const PAPER: &str = "beams-paper";
/// What is computed in place of the template's analyses.
const ANALYSES: &str = include_str!("beams/analyses.toml");
/// The marches of the path, and where a quick one starts: the last quarter.
const MARCHES: [&str; 5] = ["subs", "subs-static-slope", "ensubs", "film", "residual-flexibility"];
const QUICK_START: &str = "76 mm";

/// Recomputes Figs. 2–6 and the scoreboard into a folder; `quick` marches over the last quarter of the path.
///
/// # Errors
/// A folder that cannot be written, or [`StudyError::Interrupted`]; what was done until then is kept.
pub fn beams_paper(folder: &Path, quick: bool, progress: &dyn Progress) -> Result<Reproduction, StudyError> {
    let file = case(quick)?;
    let Computed { store, mut summary, complete, .. } =
        run::compute(&file, folder, &RunOptions::default(), progress)?;
    let scoreboard = claims::lines(&Found::stored(&store, &summary)?);
    summary.extra.insert(KEY.to_owned(), json!({ "paper": PAPER, "quick": quick, "scoreboard": scoreboard }));
    store.write_summary(&summary)?;
    let report = page::write(&store, &summary)?;
    let columns = vec!["ours".to_owned()];
    Ok(Reproduction { folder: folder.to_owned(), report, columns, scoreboard, complete })
}

/// Rebuilds figures and page from what is stored.
pub(super) fn write_report(store: &StudyFolder, summary: &Summary) -> Result<PathBuf, StudyError> {
    page::write(store, summary)
}

/// The template's structures, contact and motion with the analyses of the reproduction.
fn case(quick: bool) -> Result<CaseFile, StudyError> {
    let template = template(PAPER)?;
    let system = template.split_once("[[analysis]]").map_or(template.as_str(), |(system, _)| system);
    let text = format!("{system}{ANALYSES}");
    let start = |march: &&str| format!("analysis.{march}.from={QUICK_START}");
    let overrides: Vec<String> = if quick { MARCHES.iter().map(start).collect() } else { Vec::new() };
    Ok(CaseFile::parse(PAPER, &text, &overrides)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_case_of_the_reproduction_is_sound() {
        let full = case(false).unwrap();
        let quick = case(true).unwrap();
        assert_ne!(full.case.resolved(), quick.case.resolved());
        let names = crate::analyses::names(&full.case);
        assert!(MARCHES.iter().all(|march| names.iter().any(|name| name == march)));
    }
}
