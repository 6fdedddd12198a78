//! Maps of assemblies that are interrupted.

use super::marches::left;
use crate::stopping::Stopping;
use judder_study::run::{RunOptions, RunReport, run};
use judder_study::{Silent, StudyError};
use std::fs;
use std::path::Path;

#[test]
fn an_interrupted_map_goes_on_to_the_bit() {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small/assembly.toml"));
    let file = judder_models::read(path, &[]).unwrap();
    let options = RunOptions { only: vec!["map".to_owned()], ..RunOptions::default() };
    let (whole, study) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let at_once = run(&file, whole.path(), &options, &Silent).unwrap();
    let stopped = run(&file, study.path(), &options, &Stopping::at(5));
    assert!(matches!(stopped, Err(StudyError::Interrupted)), "{stopped:?}");
    let kept = fs::read_to_string(study.path().join(".scratch-of-map")).unwrap();
    // the hash, then a line a point
    assert!((2..10).contains(&kept.lines().count()), "{kept}");
    let resumed = run(&file, study.path(), &options, &Silent).unwrap();
    let told = |report: &RunReport| {
        let mut told = report.summary.results["map"].clone();
        told.remove("seconds");
        told
    };
    assert_eq!(told(&resumed), told(&at_once));
    assert!(left(study.path()) == left(whole.path()));
}
