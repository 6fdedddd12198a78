//! Studies end to end: the benchmark cases, results that belong to their case, the scoreboard.

#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used, reason = "a test fails by panicking")]

mod assembly;
mod bare_figures;
mod beyond_friction;
mod cases;
mod checks;
mod computed_law;
mod contact;
mod damaged;
mod global_margin;
mod growing;
mod held;
mod kept;
mod line;
mod live;
mod march;
mod memory;
mod motion;
mod pictures;
mod shown;
mod sliding;
mod sliding_cases;
mod stopping;
mod structure;
mod substrates;
mod sweep;
mod validation;
mod within_law;
mod wrong_arrays;
mod zones;

use judder_memory::MemoryBudget;
use judder_store::StudyFolder;
use judder_study::Silent;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, RunReport, run};
use serde_json::Value;
use std::path::Path;

fn case(name: &str, overrides: &[&str]) -> CaseFile {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name);
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    judder_models::read(path, &overrides).unwrap()
}

fn run_into(folder: &Path, file: &CaseFile, only: &[&str]) -> RunReport {
    let options = RunOptions {
        only: only.iter().map(|o| (*o).to_owned()).collect(),
        fresh: false,
        ..RunOptions::default()
    };
    let report = run(file, folder, &options, &Silent).unwrap();
    let empty = checks::without_numbers(&report.summary);
    assert!(empty.is_empty(), "checks that compared nothing: {empty:?}");
    report
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// Closed form: the modes merge at μ = 3/4 with ω = √2; at μ = 1 the growth rate is Re √(−2 + i/√3).
#[test]
fn the_minimal_mode_coupling_model() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("benchmarks/minimal-mode-coupling.toml", &[]), &[]);
    assert!(report.complete, "{:?}", report.messages);
    let results = &report.summary.results;
    assert!((number(&results["critical"]["critical"][0]) - 0.75).abs() < 1e-12);
    assert!((number(&results["critical"]["frequency"][0]) - 2_f64.sqrt()).abs() < 1e-7);
    let spectrum = &results["spectrum"];
    let at_one = spectrum["value"].as_array().unwrap().iter().position(|v| number(v) == 1.0).unwrap();
    assert!((number(&spectrum["growth_rate"][at_one]) - 0.202_071_768_8).abs() < 1e-10);
}

/// Closed form in the case file: 0.7599882645 for c2 = 0.002, 0.78066 for c2 = 0.02.
#[test]
fn the_damped_hopf_point() {
    for (overrides, exact, tolerance) in
        [(&[][..], 0.759_988_264_5, 1e-10), (&["parameters.c2=0.02"][..], 0.780_66, 1e-8)]
    {
        let folder = tempfile::tempdir().unwrap();
        let report = run_into(folder.path(), &case("benchmarks/damped-hopf.toml", overrides), &["critical"]);
        let found = &report.summary.results["critical"]["critical"];
        assert_eq!(found.as_array().unwrap().len(), 1);
        assert!((number(&found[0]) - exact).abs() < tolerance, "{found}");
    }
}

/// Models share kinds by their names; words and equations of the oscillator paper are of the oscillator alone.
#[test]
fn no_report_speaks_of_another_model() {
    /// Its frequency, its equations, its contact.
    const OF_THE_OSCILLATOR: [&str; 6] = ["nx", "eq. (", "eqs. (", "steady sliding", "substrate", "knock"];
    /// Its frequency, its time, its equations.
    const BEYOND_A_BELT: [&str; 3] = ["nx", "θ", "eq. ("];
    for (text, foreign) in [
        (include_str!("small/two-degrees.toml"), &OF_THE_OSCILLATOR[..]),
        (include_str!("small/belt.toml"), &BEYOND_A_BELT),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let file = judder_models::parse("case.toml", text, &[]).unwrap();
        run_into(folder.path(), &file, &[]);
        let store = StudyFolder::open(folder.path()).unwrap();
        let model = judder_models::REGISTRY.model_of(&file.case.resolved()).unwrap();
        let mut figures = 0;
        for name in file.case.analysis_names() {
            let dataset = store.read_dataset(name).unwrap();
            let figure = model.figure(name, name, &dataset).unwrap();
            figures += usize::from(figure.is_some());
            let long_names = dataset.variables().iter().map(|own| own.long_name.clone());
            let said = format!("{figure:?} {}", long_names.collect::<Vec<_>>().join("; "));
            for word in foreign {
                assert!(!said.contains(word), "{} {name}: {word}", model.name);
            }
        }
        assert!(figures >= 2);
    }
}

#[test]
fn results_of_another_case_do_not_stand_under_this_one() {
    let folder = tempfile::tempdir().unwrap();
    run_into(folder.path(), &case("benchmarks/damped-hopf.toml", &[]), &[]);
    let other =
        run_into(folder.path(), &case("benchmarks/damped-hopf.toml", &["parameters.c1=0.05"]), &["critical"]);
    assert_eq!(other.summary.results.keys().collect::<Vec<_>>(), ["critical"]);
    let page = std::fs::read_to_string(other.report.as_ref().unwrap()).unwrap();
    assert!(!page.contains("figures/map.svg"));
}

#[test]
fn a_second_run_computes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let file = case("oscillator-paper/fig-5.toml", &[]);
    let first = run_into(folder.path(), &file, &[]);
    assert!(first.complete && first.skipped.is_empty());
    let second = run_into(folder.path(), &file, &[]);
    assert_eq!(second.skipped, ["spectrum"]);
    assert_eq!(second.summary.results, first.summary.results);
}

/// Does work in a process that may take some 20 MB: more than small bodies, less than the program with any result.
fn with_little_memory<T>(work: impl FnOnce() -> T) -> T {
    let all = MemoryBudget::of_process().ask(u128::MAX).unwrap_err().budget;
    MemoryBudget::shared(all / 20_000_000, work)
}
