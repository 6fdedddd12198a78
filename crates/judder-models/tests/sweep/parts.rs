//! What parts, merges and damage make of a sweep.

use super::{GRID, HEAD, file};
use crate::run_into;
use judder_store::StoreError;
use judder_study::run::{RunOptions, SweepWork, run};
use judder_study::{Progress, Silent, StudyError};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

/// Every file of the results, by its path.
fn stored(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.join("results.zarr")];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().display().to_string();
                found.insert(name, std::fs::read(&path).unwrap());
            }
        }
    }
    found
}

#[test]
fn parts_in_any_order_make_the_whole() {
    let (whole, parts) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let file = file(GRID);
    let report = run_into(whole.path(), &file, &[]);
    assert!(report.complete && report.report.is_some(), "{:?}", report.messages);
    for part in ["3/3", "1/3", "2/3"] {
        let sweeps = SweepWork::Part(part.parse().unwrap());
        let options = RunOptions { sweeps, ..RunOptions::default() };
        let report = run(&file, parts.path(), &options, &Silent).unwrap();
        assert!(report.complete && report.report.is_none());
    }
    let options = RunOptions { sweeps: SweepWork::Merge, ..RunOptions::default() };
    let merged = run(&file, parts.path(), &options, &Silent).unwrap();
    assert!(merged.complete && merged.report.is_some(), "{:?}", merged.notes);
    assert_eq!(stored(whole.path()), stored(parts.path()));
    assert_eq!(report.summary.results, merged.summary.results);
}

#[test]
fn a_merge_before_its_time_says_what_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let file = file(GRID);
    let options = RunOptions { sweeps: SweepWork::Part("2/4".parse().unwrap()), ..RunOptions::default() };
    run(&file, folder.path(), &options, &Silent).unwrap();
    let options = RunOptions { sweeps: SweepWork::Merge, ..RunOptions::default() };
    let merged = run(&file, folder.path(), &options, &Silent).unwrap();
    assert!(!merged.complete && merged.report.is_none());
    assert!(merged.lacking == ["grid: 3 of 4 chunks are missing"], "{:?}", merged.lacking);
}

#[test]
fn a_second_run_computes_no_chunk_and_a_damaged_one_is_computed_anew() {
    let folder = tempfile::tempdir().unwrap();
    let file = file(GRID);
    run_into(folder.path(), &file, &[]);
    let before = stored(folder.path());
    let again = run_into(folder.path(), &file, &[]);
    assert!(again.complete && again.skipped == ["grid"], "{:?}", again.skipped);
    let chunk = folder.path().join("results.zarr/grid/values/c.2.0.0");
    let bytes = std::fs::read(&chunk).unwrap();
    std::fs::write(&chunk, &bytes[..bytes.len() - 7]).unwrap();
    assert!(!folder.path().join(".sweep-grid").exists(), "a study that is done stays as it is");
    let mended = run_into(folder.path(), &file, &[]);
    assert!(mended.notes.iter().any(|note| note.contains("1 damaged chunk")), "{:?}", mended.notes);
    assert_eq!(stored(folder.path()), before);
}

#[test]
fn a_merge_and_a_part_find_a_damaged_chunk() {
    let folder = tempfile::tempdir().unwrap();
    let file = file(GRID);
    let options = RunOptions { sweeps: SweepWork::Merge, ..RunOptions::default() };
    let nowhere = folder.path().join("nowhere");
    let refused = run(&file, &nowhere, &options, &Silent).unwrap_err();
    assert!(
        matches!(refused, StudyError::Store(StoreError::NoStudy { .. })) && !nowhere.exists(),
        "{refused}"
    );
    run_into(folder.path(), &file, &[]);
    let before = stored(folder.path());
    let chunk = folder.path().join("results.zarr/grid/values/c.2.0.0");
    std::fs::write(&chunk, "").unwrap();
    let options = RunOptions { sweeps: SweepWork::Merge, ..RunOptions::default() };
    let merged = run(&file, folder.path(), &options, &Silent).unwrap();
    assert!(!merged.complete && merged.report.is_none());
    assert!(merged.lacking == ["grid: 1 chunk is damaged"], "{:?}", merged.lacking);
    let part =
        |part: &str| RunOptions { sweeps: SweepWork::Part(part.parse().unwrap()), ..RunOptions::default() };
    run(&file, folder.path(), &part("1/4"), &Silent).unwrap();
    assert_eq!(std::fs::read(&chunk).unwrap(), b"", "not of this part");
    run(&file, folder.path(), &part("3/4"), &Silent).unwrap();
    assert_eq!(stored(folder.path()), before);
}

/// Asks to stop once it has heard of the summary of a sweep.
#[derive(Default)]
struct StoppingAtSummary(AtomicBool);

impl Progress for StoppingAtSummary {
    fn begin(&self, name: &str, _steps: usize) {
        self.0.fetch_or(name.ends_with(", summary"), Ordering::Relaxed);
    }
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {}
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

#[test]
fn an_interrupted_completion_goes_on_without_computing_a_chunk() {
    let folder = tempfile::tempdir().unwrap();
    let whole = tempfile::tempdir().unwrap();
    let file = file(GRID);
    run_into(whole.path(), &file, &[]);
    let stopped = run(&file, folder.path(), &RunOptions::default(), &StoppingAtSummary::default());
    assert!(matches!(stopped, Err(StudyError::Interrupted)), "{stopped:?}");
    let merge = RunOptions { sweeps: SweepWork::Merge, ..RunOptions::default() };
    assert!(run(&file, folder.path(), &merge, &Silent).unwrap().complete);
    assert_eq!(stored(folder.path()), stored(whole.path()));
}

#[test]
fn a_folder_with_a_sweep_of_another_case_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    run_into(folder.path(), &file(GRID), &[]);
    let summary = std::fs::read(folder.path().join("summary.json")).unwrap();
    let other =
        judder_models::parse("sweeps.toml", &format!("{HEAD}{GRID}"), &["oscillator.damping_x=0.02".into()]);
    let refused = run(&other.unwrap(), folder.path(), &RunOptions::default(), &Silent).unwrap_err();
    assert!(matches!(refused, StudyError::Store(StoreError::ForeignSweep { .. })), "{refused}");
    assert_eq!(std::fs::read(folder.path().join("summary.json")).unwrap(), summary, "left as it is");
    let fresh = RunOptions { fresh: true, ..RunOptions::default() };
    let other =
        judder_models::parse("sweeps.toml", &format!("{HEAD}{GRID}"), &["oscillator.damping_x=0.02".into()]);
    assert!(run(&other.unwrap(), folder.path(), &fresh, &Silent).unwrap().complete);
}
