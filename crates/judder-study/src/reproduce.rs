//! The oscillator paper: Figs. 4–10 and what its text claims about them, with both readings of the friction and both velocity
//! axes of the fitted law.

mod claims;
mod exhibits;
mod measures;
mod page;
mod readings;
mod scoreboard;

use crate::analyses;
use crate::error::StudyError;
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::run::{Study, analysis_hash};
use exhibits::{EXHIBITS, Source};
use judder_case::CaseFile;
use judder_store::{Status, StudyFolder, Summary, content_hash};
use readings::READINGS;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::Instant;

pub use scoreboard::ClaimLine;

/// Where a summary keeps that it is a reproduction, and its scoreboard.
pub(crate) const KEY: &str = "reproduction";

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

/// Recomputes Figs. 4–10 and the scoreboard into a folder; `quick` takes fewer points.
///
/// # Errors
/// A folder that cannot be written, or [`StudyError::Interrupted`]; what was done until then is kept.
pub fn oscillator_paper(
    folder: &Path,
    quick: bool,
    progress: &dyn Progress,
) -> Result<Reproduction, StudyError> {
    let start = Instant::now();
    let store = StudyFolder::create(folder)?;
    let runs = runs(quick)?;
    let names: Vec<String> = runs.iter().map(|(name, _)| name.clone()).collect();
    let hashes: Vec<String> = runs.iter().map(|(_, file)| analysis_hash(&file.case.resolved(), 0)).collect();
    let mut study = Study::open(&store, names.iter().zip(&hashes))?;
    study.summary.case = json!({ "title": "The oscillator paper", "model": "oscillator", "quick": quick });
    study.summary.case_hash = content_hash(hashes.concat().as_bytes());
    for ((name, file), hash) in runs.iter().zip(hashes) {
        if store.is_done(name, &hash)? {
            continue;
        }
        progress.begin(name, analyses::steps(&file.case, 0));
        let began = Instant::now();
        let outcome = analyses::run(&file.case, 0, progress).map(without_lists);
        progress.end();
        study.keep(name, hash, outcome, began.elapsed().as_secs_f64())?;
    }
    progress.begin("scoreboard", claims::CLAIMS.len());
    let scoreboard = scoreboard::measure(progress)?;
    progress.end();
    study
        .summary
        .extra
        .insert(KEY.to_owned(), json!({ "paper": "oscillator-paper", "scoreboard": scoreboard }));
    study.summary.wall_time_s = start.elapsed().as_secs_f64();
    store.write_summary(&study.summary)?;
    let report = page::write(&store, &study.summary)?;
    let complete = study.is_complete(&names);
    let columns = READINGS.iter().map(|reading| reading.plain.to_owned()).collect();
    Ok(Reproduction { folder: folder.to_owned(), report, columns, scoreboard, complete })
}

/// Rebuilds figures and page of a reproduction from what is stored.
pub(crate) fn write_report(store: &StudyFolder, summary: &Summary) -> Result<PathBuf, StudyError> {
    page::write(store, summary)
}

/// The name of a panel's analysis with a reading.
fn analysis_name(source: &Source, reading: &readings::Reading) -> String {
    format!("{}-{}", source.name, reading.slug)
}

/// Every case to run, with the name under which its one analysis is kept.
fn runs(quick: bool) -> Result<Vec<(String, CaseFile)>, StudyError> {
    let mut runs = Vec::new();
    for source in EXHIBITS.iter().flat_map(|exhibit| exhibit.sources) {
        for reading in &READINGS {
            let mut overrides = vec![
                format!("contact.law={}", reading.law),
                format!("contact.friction_load={}", reading.friction_load),
            ];
            overrides.extend(source.overrides.iter().map(|o| (*o).to_owned()));
            let mut file = CaseFile::parse(source.case_name, source.case, &overrides)?;
            if quick {
                exhibits::thin_out(&mut file.case);
            }
            runs.push((analysis_name(source, reading), file));
        }
    }
    Ok(runs)
}

/// The outcome without the lists that its arrays hold anyway: dozens of curves would make the summary unreadable.
fn without_lists(mut outcome: Outcome) -> Outcome {
    let lists =
        ["value", "curves", "eigenvalues", "conservative_eigenvalues", "growth_rate", "full", "conservative"];
    outcome.scalars.retain(|name, _| !lists.contains(&name.as_str()));
    outcome
}

/// Whether an analysis of a summary has its result.
fn is_done(summary: &Summary, name: &str) -> bool {
    summary.analyses.get(name).is_some_and(|record| record.status == Status::Done)
}
