//! One budget of memory for every kind of analysis.

use crate::{number, with_little_memory};
use judder_models::REGISTRY;
use judder_study::case::file::CaseFile;
use judder_study::model::PROGRAM_BYTES;
use judder_study::resolve::resolve;
use judder_study::run::{RunOptions, run};
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

/// A belt whose motion changes its state 288 606 times, for which the process was measured to take 64 MB beside what a short motion takes.
#[test]
fn changes_of_state_are_counted() {
    let belt = |duration: &str| {
        let text = format!(
            "model = \"belt\"\n[oscillator]\ndamping = 0.05\n[friction]\nat_rest = 1.0\nat_speed = 0.5\ndecay_speed = 0.5\n\
             [operation]\nvelocity = 0.5\nnormal_force = 1.0\n[[analysis]]\nkind = \"motion\"\n\
             start = {{ x = 1.0, velocity_x = 1.5 }}\nduration = {duration}\ntransient = 0\npoints = 100\nsteps = 100000000\n"
        );
        let file = judder_models::parse("case.toml", &text, &[]).unwrap();
        number(&resolve(&file, &Silent).unwrap().json()["estimate"][0]["bytes"])
    };
    let changes = belt("1e6") - belt("100");
    assert!((changes / 64e6 - 1.0).abs() < 0.2, "{changes}");
}

/// A number of `/proc/self/status`, in bytes.
#[cfg(target_os = "linux")]
fn status(name: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find_map(|line| line.strip_prefix(name)).unwrap();
    line.split_whitespace().next().unwrap().parse::<f64>().unwrap() * 1024.0
}

#[cfg(target_os = "linux")]
const BAR: &str = "model = \"structure\"\n[structure]\nblock = { element = \"hexahedron20\", size = [\"200 mm\", \"20 mm\", \"10 mm\"], cells = [30, 8, 4] }\n\
    material = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\" }\n\
    supports = [{ set = \"x-min\", fixed = [\"x\", \"y\", \"z\"] }]\n[[analysis]]\nkind = \"modes\"\ncount = 12\n";

/// Holds what is told beside the program of a case that takes much more than it against what the peak of this process grows by.
#[cfg(target_os = "linux")]
fn is_told_as_taken(text: &str) {
    let file = judder_models::parse("case.toml", text, &[]).unwrap();
    let checked = resolve(&file, &Silent).unwrap().json();
    let told = number(&checked["estimate"][0]["bytes"]) - PROGRAM_BYTES as f64;
    let folder = tempfile::tempdir().unwrap();
    // the peak from here on
    std::fs::write("/proc/self/clear_refs", "5").unwrap();
    let before = status("VmRSS:");
    run(&file, folder.path(), &RunOptions::default(), &Silent).unwrap();
    let ratio = told / (status("VmHWM:") - before);
    eprintln!("{}: told {:.0} MB, {ratio:.2} of what was taken", file.case.kind_name(0), told / 1e6);
    assert!((0.7..1.4).contains(&ratio), "{ratio}");
}

#[cfg(target_os = "linux")]
#[test]
#[ignore = "half a minute, in a process of its own: the peak is that of all its threads"]
fn what_is_told_is_what_is_taken() {
    for text in [BAR, "model = \"oscillator\"\n[[analysis]]\nkind = \"motion\"\npoints = 1000000\n"] {
        is_told_as_taken(text);
    }
}

/// Whose factors hold far more than those of a bar of as many freedoms.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "half a minute, in a process of its own: the peak is that of all its threads"]
fn what_is_told_of_a_cube_is_what_is_taken() {
    is_told_as_taken(&BAR.replace("hexahedron20", "hexahedron8").replace("[30, 8, 4]", "[18, 18, 18]"));
}
