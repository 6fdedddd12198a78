//! Cases that are run in memory.

use crate::run_into;
use judder_store::{Dataset, StudyFolder, Variable};
use judder_study::case::file::CaseFile;
use judder_study::run::{HeldRun, RunOptions, hold};
use judder_study::{Silent, StudyError};
use std::path::Path;

fn small(name: &str) -> CaseFile {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small").join(format!("{name}.toml"));
    judder_models::read(path, &[]).unwrap()
}

fn held(file: &CaseFile, only: &[&str]) -> Result<Option<HeldRun>, StudyError> {
    let only = only.iter().map(|own| (*own).to_owned()).collect();
    hold(file, &RunOptions { only, ..RunOptions::default() }, &Silent)
}

fn assert_same(found: &Dataset, expected: &Dataset, what: &str) {
    assert_eq!(found.attributes(), expected.attributes(), "{what}");
    assert_eq!(found.variables().len(), expected.variables().len(), "{what}");
    for (found, expected) in found.variables().iter().zip(expected.variables()) {
        assert_eq!((&found.name, found.told()), (&expected.name, expected.told()), "{what}");
        let laid = |own: &Variable| (own.dimensions.clone(), own.shape.clone(), own.is_coordinate);
        assert_eq!(laid(found), laid(expected), "{what}");
        // NaN is NaN here
        assert_eq!(format!("{:?}", found.data), format!("{:?}", expected.data), "{what}: {}", found.name);
    }
}

/// The arrays of a march too, which grow on the disk where there is one.
#[test]
fn a_run_in_memory_leaves_what_a_folder_holds_and_is_taken_up_there() {
    for (name, only) in [("oscillator-dimensional", &[][..]), ("sliding", &["film"]), ("beam", &[])] {
        let file = small(name);
        let HeldRun { study, messages, refused } = held(&file, only).unwrap().unwrap();
        assert!(refused.is_empty());
        let folder = tempfile::tempdir().unwrap();
        let report = run_into(folder.path(), &file, only);
        let store = StudyFolder::open(folder.path()).unwrap();
        let names: Vec<String> = report.summary.analyses.keys().cloned().collect();
        assert_eq!((names.is_empty(), &messages), (false, &report.messages));
        for own in &names {
            let dataset = &study.outcome(own).unwrap().dataset;
            assert_same(dataset, &store.read_dataset(own).unwrap(), &format!("{name}: {own}"));
        }
        for (path, content) in study.files() {
            assert_eq!(std::fs::read(folder.path().join(&path)).unwrap(), content, "{name}: {path}");
        }
        let saved = folder.path().join("saved");
        study.save(&saved, true).unwrap();
        assert!(saved.join("report.html").is_file());
        let mut skipped = run_into(&saved, &file, only).skipped;
        skipped.sort();
        assert_eq!(skipped, names, "{name}");
    }
}

#[test]
fn what_needs_a_folder_is_not_run_in_memory() {
    let (sweeps, sliding) = (small("sweeps"), small("sliding"));
    let swept = sweeps.sweeps[0].name.clone();
    assert!(held(&sweeps, &[&swept]).unwrap().is_none());
    let names = sliding.case.analysis_names();
    let taking_up = names.iter().find(|name| !sliding.case.takes_up(name).is_empty()).unwrap();
    assert!(held(&sliding, &[taking_up]).unwrap().is_none());
    assert!(matches!(held(&sliding, &["none"]), Err(StudyError::UnknownAnalysis { .. })));
}
