//! The oscillator paper: Figs. 3–14 and what its text claims about them, with both readings of the friction, both velocity axes of
//! the fitted law, and the law computed anew; section 5 with both of its speeds.

mod by_law;
pub(crate) mod claims;
mod contact_figures;
mod evidence;
mod exhibits;
mod measures;
mod motion_exhibits;
mod motion_figures;
pub(crate) mod page;
mod readings;
pub(crate) mod scoreboard;

use crate::Reproduction;
use crate::summary::KEY;
use claims::motion::Motions;
use evidence::Evidence;
use exhibits::{CONTACT_CASES, EXHIBITS, LAW_FILE, PanelSource};
use judder_keys::file_reference::FileReference;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::law_name::LawName;
use judder_store::{StudyFolder, Summary, content_hash};
use judder_study::Progress;
use judder_study::StudyError;
use judder_study::analyses;
use judder_study::case::file::CaseFile;
use judder_study::kept::KeptLines;
use judder_study::ledger::Study;
use judder_study::maker;
use judder_study::model::{Case, Prepared, Task};
use judder_study::outcome::Outcome;
use judder_study::run::analysis_hash;
use motion_exhibits::{MotionRun, WAYS};
use rayon::prelude::*;
use readings::{READINGS, ReadLaw, Reading};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// An analysis of a case, and the name under which that is kept.
struct Run {
    name: String,
    hash: String,
    file: CaseFile,
    analysis: usize,
}

/// Recomputes Figs. 3–14 and the scoreboard into a folder; `quick` takes fewer points of the curves and maps,
/// and the law of a paraboloid, by the collapse, in place of the sphere's.
///
/// # Errors
/// A folder that cannot be written, a law that cannot be computed, or [`StudyError::Interrupted`]; what was done until then is
/// kept.
pub fn oscillator_paper(
    folder: &Path,
    quick: bool,
    progress: &dyn Progress,
) -> Result<Reproduction, StudyError> {
    let start = Instant::now();
    let store = StudyFolder::create(folder)?;
    let runs = runs(folder, quick)?;
    let names: Vec<String> = runs.iter().map(|run| run.name.clone()).collect();
    let hashes: Vec<&str> = runs.iter().map(|run| run.hash.as_str()).collect();
    let mut study = Study::open(&store, runs.iter().map(|run| (&run.name, &run.hash)))?;
    study.summary.case = json!({ "title": "The oscillator paper", "model": "oscillator", "quick": quick });
    study.summary.case_hash = content_hash(hashes.concat().as_bytes());
    let (steady, moving) = runs.split_at(runs.len() - motion_exhibits::runs().len());
    run_all(&store, &mut study, steady, progress)?;
    run_side_by_side(&store, &mut study, moving, progress)?;
    progress.begin("scoreboard", claims::CLAIMS.len());
    let motions = motions(&store, &study.summary)?;
    let scoreboard = scoreboard::measure(&Evidence::stored(&store, quick, progress)?, &motions, progress)?;
    progress.end();
    study
        .summary
        .extra
        .insert(KEY.to_owned(), json!({ "paper": "oscillator-paper", "scoreboard": scoreboard }));
    study.summary.wall_time_s = start.elapsed().as_secs_f64();
    store.write_summary(&study.summary, None)?;
    let page = page::write(&store, &study.summary)?;
    store.seal(maker())?;
    let lacking = [study.lacking(&names), page.lacking()].concat();
    let columns = READINGS.iter().map(|reading| reading.plain.to_owned()).collect();
    Ok(Reproduction { folder: folder.to_owned(), report: page.path, columns, scoreboard, lacking })
}

/// Runs what is not done yet.
fn run_all(
    store: &StudyFolder,
    study: &mut Study<'_>,
    runs: &[Run],
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    // the contacts of Fig. 3 are those of Fig. 14
    let solved: Mutex<Vec<String>> = Mutex::new(Vec::new());
    let points = || solved.lock().unwrap_or_else(PoisonError::into_inner);
    for Run { name, hash, file, analysis } in runs {
        if store.is_done(name, hash)? {
            continue;
        }
        progress.begin(name, analyses::steps(&file.case, *analysis));
        let began = Instant::now();
        let known = points().clone();
        let keep = |line: &str| points().push(line.to_owned());
        let kept = KeptLines { lines: &known, keep: &keep, place: None };
        let outcome = file
            .case
            .run(*analysis, Task { shared: kept, own: kept, ..Task::alone(&Prepared::NOTHING, progress) })
            .map(without_lists);
        progress.end();
        study.keep(name, hash.clone(), outcome, began.elapsed().as_secs_f64())?;
    }
    Ok(())
}

/// Runs motions that are not done yet, which wait for nothing but their own past, beside each other.
fn run_side_by_side(
    store: &StudyFolder,
    study: &mut Study<'_>,
    runs: &[Run],
    progress: &dyn Progress,
) -> Result<(), StudyError> {
    let mut open = Vec::new();
    for run in runs {
        if !store.is_done(&run.name, &run.hash)? {
            open.push(run);
        }
    }
    progress.begin("motions", open.iter().map(|run| analyses::steps(&run.file.case, run.analysis)).sum());
    let outcomes: Vec<_> = open
        .into_par_iter()
        .map(|run| {
            let began = Instant::now();
            let outcome = analyses::run(&run.file, run.analysis, progress).map(without_lists);
            (run, outcome, began.elapsed().as_secs_f64())
        })
        .collect();
    progress.end();
    let mut is_interrupted = false;
    for (run, outcome, seconds) in outcomes {
        match outcome {
            Err(StudyError::Interrupted) => is_interrupted = true,
            outcome => drop(study.keep(&run.name, run.hash.clone(), outcome, seconds)?),
        }
    }
    if is_interrupted { Err(StudyError::Interrupted) } else { Ok(()) }
}

/// The name of a panel's analysis with a reading.
fn analysis_name(source: &PanelSource, reading: &Reading) -> String {
    format!("{}-{}", source.name, reading.slug)
}

/// Every case to run: the contact computation first, because the oscillators use its law.
fn runs(folder: &Path, quick: bool) -> Result<Vec<Run>, StudyError> {
    let mut runs = Vec::new();
    for (name, text) in CONTACT_CASES {
        let mut file = judder_models::parse(name, text, &[])?;
        if quick {
            exhibits::thin_out(&mut file.case);
        }
        let hash = analysis_hash(&file.case, &file.case.resolved(), 0);
        runs.push(Run { name: name.to_owned(), hash, file, analysis: 0 });
    }
    // a computed law is what its case and this version make it: their hash names it before it is there
    let law_hash = runs[0].hash.clone();
    for source in EXHIBITS.iter().flat_map(|exhibit| exhibit.sources) {
        for reading in &READINGS {
            let mut file = oscillator_case(source, reading)?;
            if quick {
                exhibits::thin_out(&mut file.case);
            }
            let mut resolved = file.case.resolved();
            if reading.law == ReadLaw::Computed {
                resolved["files"][LAW_FILE] = json!(law_hash);
                use_law(&mut file.case, folder.join(LAW_FILE));
            }
            let hash = analysis_hash(&file.case, &resolved, 0);
            runs.push(Run { name: analysis_name(source, reading), hash, file, analysis: 0 });
        }
    }
    runs.extend(motion_runs(quick)?);
    Ok(runs)
}

/// The motions of section 5, and one cycle by three engines.
fn motion_runs(quick: bool) -> Result<Vec<Run>, StudyError> {
    let run = |MotionRun { name, case_name, case, analysis, overrides }| {
        let mut file = judder_models::parse(case_name, case, &overrides)?;
        if quick {
            exhibits::thin_out(&mut file.case);
        }
        let hash = analysis_hash(&file.case, &file.case.resolved(), analysis);
        Ok(Run { name, hash, file, analysis })
    };
    motion_exhibits::runs().into_iter().map(run).collect()
}

/// What is stored of the motions of section 5, for every way to read it.
fn motions(store: &StudyFolder, summary: &Summary) -> Result<Vec<Option<Motions>>, StudyError> {
    WAYS.iter().map(|way| Motions::stored(store, summary, way)).collect()
}

fn oscillator_case(source: &PanelSource, reading: &Reading) -> Result<CaseFile, StudyError> {
    let mut overrides = vec![
        format!("contact.law={}", reading.law.key()),
        format!("contact.friction_load={}", reading.friction_load),
    ];
    overrides.extend(source.overrides.iter().map(|o| (*o).to_owned()));
    Ok(judder_models::parse(source.case_name, source.case, &overrides)?)
}

/// Puts the law of a file in place of the case's own; the file is there by the time the case runs.
fn use_law(case: &mut Case, path: PathBuf) {
    if let Some(case) = case.of_mut::<OscillatorCase>() {
        case.law = LawName::File;
        case.law_file = Some(FileReference { given: LAW_FILE.to_owned(), path });
    }
}

/// The outcome without the lists that its arrays hold anyway: dozens of curves would make the summary unreadable.
fn without_lists(mut outcome: Outcome) -> Outcome {
    const LISTS: [&str; 13] = [
        "value",
        "curves",
        "eigenvalues",
        "conservative_eigenvalues",
        "growth_rate",
        "full",
        "conservative",
        "direction",
        "becomes",
        "rms",
        "period",
        "stick_fraction",
        "lift_off_fraction",
    ];
    outcome.scalars.retain(|name, value| !value.is_array() || !LISTS.contains(&name.as_str()));
    outcome
}

/// What the law of a reproduction is computed for, in words.
fn computed_for(summary: &Summary) -> &'static str {
    if summary.case.get("quick").is_some_and(|quick| quick == true) {
        "a paraboloid in place of the sphere (a quick run)"
    } else {
        "a sphere"
    }
}

/// The lines of the scoreboard about motions, from those of a quick run.
#[cfg(test)]
fn quick_motions(folder: &Path) -> Result<Vec<crate::ClaimLine>, StudyError> {
    let store = StudyFolder::create(folder)?;
    let mut runs = motion_runs(true)?;
    runs.retain(|run| run.name != motion_exhibits::ENGINES);
    let mut study = Study::open(&store, runs.iter().map(|run| (&run.name, &run.hash)))?;
    run_side_by_side(&store, &mut study, &runs, &judder_study::Silent)?;
    Ok(scoreboard::of_motions(&motions(&store, &study.summary)?))
}
