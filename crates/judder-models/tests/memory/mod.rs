//! One budget of memory for every kind of analysis.

use crate::with_little_memory;
use judder_models::REGISTRY;
use judder_study::case::file::CaseFile;
use judder_study::resolve::resolve;
use judder_study::{Silent, StudyError};
use miette::Diagnostic;
use std::collections::BTreeSet;
use std::path::Path;

/// Small cases that have every kind between them.
fn small_cases() -> impl Iterator<Item = CaseFile> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let cases = paths.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
    cases.map(|path| judder_models::read(path, &[]).unwrap())
}

/// What a case is refused for, with the place and what would help.
fn refusal(refused: StudyError) -> (String, String, String) {
    let StudyError::Case(error) = refused else { panic!("{refused} has no place") };
    let help = error.help().map(|help| help.to_string()).unwrap_or_default();
    (error.to_string(), error.place().to_owned(), help)
}

/// Refused by what is prepared for a run and by what is checked, in the same words.
fn is_refused(file: &CaseFile, index: usize) -> bool {
    let names = file.case.analysis_names();
    let of_run = file.case.preflight(file, &|name| name == names[index]);
    let (message, place, help) = refusal(of_run.map(drop).unwrap_err());
    assert!(message.contains(" of memory are needed, and "), "{}: {message}", names[index]);
    assert!(
        message.contains("to be had") && help.contains("--memory"),
        "{}: {message}; {help}",
        names[index]
    );
    assert!(!place.is_empty(), "{}: {message}", names[index]);
    if index == 0 {
        // what is free changes between two looks
        let needed = |message: &str| message.split_once(" are needed").map(|(before, _)| before.to_owned());
        let (checked, ..) = refusal(resolve(file, &Silent).map(drop).unwrap_err());
        assert_eq!(needed(&checked), needed(&message));
    }
    // bodies that are too large themselves tell nothing of the analysis
    !message.starts_with("this structure: ")
}

#[test]
fn every_kind_is_held_against_the_budget() {
    let mut missing: BTreeSet<(&str, &str)> = REGISTRY
        .models()
        .iter()
        .flat_map(|model| (model.kinds)().into_iter().map(|kind| (model.name, kind.name)))
        .collect();
    for file in small_cases() {
        for index in 0..file.case.analysis_names().len() {
            let kind = (file.case.model(), file.case.kind_name(index));
            if missing.contains(&kind) && with_little_memory(|| is_refused(&file, index)) {
                missing.remove(&kind);
            }
        }
    }
    assert!(missing.is_empty(), "no case asks for {missing:?}");
}
