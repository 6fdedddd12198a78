//! Every example stands alone: written into an empty folder it is read, with all files that it names.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use judder_examples::{ExampleError, ExampleKind, example, examples};
use std::fs;

#[test]
fn every_case_is_read_where_it_is_written() {
    let all = examples();
    assert!(all.len() > 50, "{}", all.len());
    for own in &all {
        assert!(!own.title.is_empty() && own.title.len() < 200, "{}: {}", own.name, own.title);
        let folder = tempfile::tempdir().unwrap();
        let path = own.write(&folder.path().join("new")).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), own.text);
        if own.kind == ExampleKind::Case {
            judder_models::read(&path, &[]).unwrap_or_else(|error| panic!("{}: {error}", own.name));
        }
    }
}

#[test]
fn names_are_whole_or_their_last_part() {
    let whole = example("tutorials/own-rubber").unwrap();
    assert_eq!(whole.title, "A rubber of one's own");
    assert_eq!(whole.files.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["rubber-dma.csv"]);
    assert_eq!(example("mode-coupling").unwrap().name, "assembly/mode-coupling");
    assert_eq!(example("assembly/mode-coupling.toml").unwrap().name, "assembly/mode-coupling");
    let message = |name| example(name).unwrap_err().to_string();
    assert!(
        message("coupling").contains("is assembly/mode-coupling or benchmarks/minimal-mode-coupling meant?")
    );
    assert_eq!(message("nope"), "there is no example `nope`; `judder examples` lists them");
    assert_eq!(message(""), "there is no example ``; `judder examples` lists them");
    assert!(matches!(example("benchmarks/disc-brake"), Err(ExampleError::Unknown { .. })));
}

#[test]
fn a_file_of_ones_own_stays() {
    let own = example("tutorials/own-rubber").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = own.write(folder.path()).unwrap();
    assert_eq!(own.write(folder.path()).unwrap(), path);
    fs::write(&path, "mine").unwrap();
    fs::remove_file(folder.path().join("rubber-dma.csv")).unwrap();
    assert!(matches!(own.write(folder.path()), Err(ExampleError::Exists { .. })));
    assert_eq!(fs::read_to_string(&path).unwrap(), "mine");
    assert!(!folder.path().join("rubber-dma.csv").exists());
}
