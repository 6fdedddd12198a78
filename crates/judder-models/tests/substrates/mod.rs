//! What is shown of a substrate is what is used, however it is given; and what is told of a contact that is not in step with the motion.

use crate::contact::run_text;
use crate::number;
use crate::within_law::{from_file, law_file};
use judder_models::bridge::with_material;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::keys::OscillatorKey;
use judder_study::Silent;
use judder_study::resolve::resolve;
use judder_study::run::{RunOptions, run};
use serde_json::Value;
use std::f64::consts::TAU;
use std::path::Path;

/// A sweep of moduli over four decades: E∞ = 10 MPa, two retardation times.
fn write_dma(folder: &Path) {
    let line = |k: i32| {
        let frequency = 10_f64.powf(f64::from(k) / 4.0);
        let part = |time: f64, compliance: f64| {
            let turn = TAU * frequency * time;
            [compliance / (1.0 + turn * turn), compliance * turn / (1.0 + turn * turn)]
        };
        let [slow, fast] = [part(0.1, 5e-7), part(1e-3, 3e-7)];
        let [re, im] = [1e-7 + slow[0] + fast[0], slow[1] + fast[1]];
        let size = re * re + im * im;
        format!("{frequency:e},{:e},{:e}\n", re / size, im / size)
    };
    let lines: String = (-8..=16).map(line).collect();
    std::fs::write(folder.join("dma.csv"), format!("f [Hz],E' [Pa],E'' [Pa]\n{lines}")).unwrap();
}

const TEMPERATURE: &str = "temperature = \"30 degC\"\nshift = { wlf = { c1 = 12.0, c2 = \"120 K\", reference_temperature = \"25 degC\" } }\n";

/// Every way to give a substrate.
const SOURCES: [&str; 9] = [
    "rubbery_modulus = \"2 MPa\"\nglassy_modulus = \"9 MPa\"\nretardation_time = \"3 ms\"\n",
    "relaxation_time = \"0.5 ms\"\n",
    "prony = [{ time = \"3 ms\", compliance = \"4e-7 1/Pa\" }]\n",
    "prony = [{ time = \"3 ms\", compliance = \"4e-7 1/Pa\" }, { time = \"30 ms\", compliance = \"3e-7 1/Pa\" }]\n",
    "relaxation = [{ time = \"3 ms\", modulus = \"4 MPa\" }, { time = \"30 ms\", modulus = \"1 MPa\" }]\n",
    "continuous = { log_normal = { median = \"3 ms\", width = 1.0 }, terms = 4 }\n",
    "continuous = { samples = [{ time = \"1 ms\", density = \"1e-4 1/Pa/s\" }, { time = \"10 ms\", density = \"1e-5 1/Pa/s\" }], terms = 3 }\n",
    "dma = { file = \"dma.csv\" }\n",
    "rubbery_modulus = \"1.05 MPa\"\ndma = { file = \"dma.csv\", terms = 3 }\n",
];

/// The SI value of an entry; `None` where it is not shown.
fn value(entry: &Value) -> Option<f64> {
    entry.get("value").and_then(Value::as_f64)
}

#[test]
fn what_is_shown_of_a_substrate_is_what_is_used() {
    let folder = tempfile::tempdir().unwrap();
    write_dma(folder.path());
    let keys = [
        ("rubbery_modulus", OscillatorKey::RubberyModulus),
        ("glassy_modulus", OscillatorKey::GlassyModulus),
        ("retardation_time", OscillatorKey::RetardationTime),
    ];
    for source in SOURCES {
        for temperature in ["", TEMPERATURE] {
            let text = format!(
                "model = \"oscillator\"\n[substrate]\n{source}{temperature}[contact]\nlaw = \"hertz\"\n\
                 [[analysis]]\nkind = \"equivalent-damping\"\nsweep = {{ key = \"operation.velocity\", from = 1e-6, to = 1e-2, points = 3 }}\n"
            );
            let summary = run_text(folder.path(), &text).summary;
            let file = judder_models::read(folder.path().join("case.toml"), &[]).unwrap();
            let checked = resolve(&file, &Silent).unwrap();
            let case = file.case.of::<OscillatorCase>().unwrap();
            let taken = with_material(case).unwrap().inputs;
            for shown in [&summary.case["substrate"], &checked.json()["case"]["substrate"]] {
                let used = &shown["used"];
                for (name, key) in keys {
                    let taken = taken.number(key);
                    let same = |shown: f64| (shown / taken - 1.0).abs() < 1e-9;
                    match (value(&used[name]), value(&shown[name])) {
                        (Some(used), _) => assert!(same(used), "{text}{name}: {used} for {taken}"),
                        (None, Some(given)) => assert!(same(given), "{text}{name}: {given} for {taken}"),
                        (None, None) => panic!("{text}{name} is not shown"),
                    }
                    // what stands beside it is at the reference temperature
                    let factor = used["time_factor"].as_f64().unwrap_or(1.0);
                    let at_reference = if name == "retardation_time" { taken / factor } else { taken };
                    if let Some(given) = value(&shown[name]) {
                        assert!((given / at_reference - 1.0).abs() < 1e-9, "{text}{name}: {given}");
                    }
                }
                if source.contains("dma") {
                    assert_eq!(used["file"]["name"], "dma.csv");
                    assert_eq!(used["file"]["hash"], summary.case["files"]["dma.csv"]);
                    let terms = used["terms"].as_array().unwrap();
                    let compliance: f64 = terms.iter().filter_map(|term| value(&term["compliance"])).sum();
                    let [rubbery, glassy] =
                        ["rubbery_modulus", "glassy_modulus"].map(|name| value(&used[name]).unwrap());
                    assert!((compliance / (1.0 / rubbery - 1.0 / glassy) - 1.0).abs() < 1e-9);
                }
            }
        }
    }
}

/// The verdict of a sweep over keys that leave the substrate alone, and over its temperature, is that of each point alone.
#[test]
fn a_sweep_with_measured_moduli_is_its_points_alone() {
    let folder = tempfile::tempdir().unwrap();
    write_dma(folder.path());
    let text = |sweep: &str| {
        format!(
            "model = \"oscillator\"\n[substrate]\ndma = {{ file = \"dma.csv\" }}\n{TEMPERATURE}[contact]\nlaw = \"hertz\"\nshear_strength = \"20 kPa\"\n\
             [operation]\nvelocity = \"3 mm/s\"\nnormal_load = \"10 mN\"\n[[sweep]]\nname = \"s\"\nmethod = \"grid\"\nover = [{sweep}]\n\
             quantities = [\"growth_rate\", \"indentation\"]\n"
        )
    };
    for (sweep, key, values) in [
        (
            "{ key = \"operation.velocity\", values = [\"1 mm/s\", \"5 mm/s\"] }",
            "operation.velocity",
            ["1 mm/s", "5 mm/s"],
        ),
        (
            "{ key = \"substrate.temperature\", values = [\"10 degC\", \"40 degC\"] }",
            "substrate.temperature",
            ["10 degC", "40 degC"],
        ),
    ] {
        let own = tempfile::tempdir_in(folder.path()).unwrap();
        write_dma(own.path());
        let report = run_text(own.path(), &text(sweep));
        assert!(report.complete, "{:?}", report.messages);
        let store = judder_store::StudyFolder::open(own.path().join("out")).unwrap();
        let stored = store.read_dataset("s").unwrap();
        let judder_store::VariableValues::F64(found) = &stored.variable("values").unwrap().data else {
            panic!()
        };
        for (value, found) in values.iter().zip(found.chunks_exact(2)) {
            let set = [format!("{key}=\"{value}\"")];
            let file = judder_models::read(own.path().join("case.toml"), &set).unwrap();
            let case = file.case.of::<OscillatorCase>().unwrap();
            let point = judder_models::point::point(case).unwrap();
            let alone = [point.steady.growth_rate(), point.steady.equilibrium.indentation];
            for (found, alone) in found.iter().zip(alone) {
                assert!((found / alone - 1.0).abs() < 1e-12, "{key} {value}: {found} for {alone}");
            }
        }
    }
}

/// ω_nx τ = 2π 60 · 0.3 ≈ 113: told by the check, the point, every analysis and its report, with the time that makes it.
#[test]
fn a_contact_that_is_not_in_step_is_told_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    let text = |time: &str| {
        format!(
            "model = \"oscillator\"\n[substrate]\nretardation_time = \"{time}\"\n[oscillator]\nnatural_frequency = \"60 Hz\"\n\
             [[analysis]]\nkind = \"stability-map\"\nboundaries = false\n\
             x = {{ key = \"operation.velocity\", from = 1e-6, to = 1e-2, points = 3, scale = \"log\" }}\n\
             y = {{ key = \"contact.shear_strength\", from = 1e-3, to = 1e-1, points = 3, scale = \"log\" }}\n\
             [[analysis]]\nkind = \"motion\"\nduration = 50\npoints = 16\n\
             [[analysis]]\nkind = \"spectrum\"\nsweep = {{ key = \"oscillator.natural_frequency\", from = \"1 Hz\", to = \"60 Hz\", points = 3 }}\n"
        )
    };
    let figure = TAU * 60.0 * 0.3;
    let report = run_text(folder.path(), &text("300 ms"));
    for name in ["stability-map", "motion", "spectrum"] {
        let told = number(&report.summary.results[name]["quasi_steady_figure"]);
        assert!((told / figure - 1.0).abs() < 1e-12, "{name}: {told}");
        let warnings = &report.summary.analyses[name].warnings;
        assert!(warnings.iter().any(|w| w.contains("ω_nx τ = 113.1 with τ = 0.3 s")), "{warnings:?}");
    }
    let page = std::fs::read_to_string(report.report.unwrap()).unwrap();
    assert!(page.contains("ω_nx τ = 113.1 with τ = 0.3 s"));
    let read = || judder_models::read(folder.path().join("case.toml"), &[]).unwrap();
    let checked = resolve(&read(), &Silent).unwrap();
    assert!(checked.text().contains("113.1, broken") && checked.text().contains("warning: eq. (3)"));
    let case = read().case.of::<OscillatorCase>().unwrap().clone();
    let point = judder_models::point::point(&case).unwrap();
    assert!((number(&point.json()["quasi_steady"]["figure"]) / figure - 1.0).abs() < 1e-12);
    assert_eq!(point.json()["quasi_steady"]["standing"], "broken");
    assert!(
        point.warnings.iter().any(|w| w.starts_with("eq. (3)")) && point.text().contains("113.1, broken")
    );
    // the paper's 0.4 is shown as borderline, without a warning
    std::fs::write(folder.path().join("case.toml"), "model = \"oscillator\"\n").unwrap();
    let checked = resolve(&read(), &Silent).unwrap();
    assert!(checked.text().contains("0.4, borderline") && !checked.text().contains("eq. (3), the condition"));
}

/// What `judder check` and a run say of the measured band.
fn of_band(folder: &Path, text: &str) -> [Vec<String>; 2] {
    let path = folder.join("case.toml");
    std::fs::write(&path, text).unwrap();
    let file = judder_models::read(&path, &[]).unwrap();
    let checked = resolve(&file, &Silent).unwrap().json();
    let warnings = checked["warnings"].as_array().unwrap().iter();
    let checked = warnings.map(|warning| warning.as_str().unwrap().to_owned()).collect();
    let study = folder.join("study");
    let messages =
        run(&file, &study, &RunOptions { fresh: true, ..RunOptions::default() }, &Silent).unwrap().messages;
    [checked, messages].map(|told: Vec<String>| {
        told.into_iter().filter(|told| told.contains("sliding excites the substrate")).collect()
    })
}

/// f = v/(2π √(R δ)) against 0.01 to 10⁴ Hz: 5·10⁻⁴ Hz is 1.3 decades below, 5 Hz within, and at −20 °C, where a_T = 10^7.2, 3.9 above.
#[test]
fn a_contact_outside_the_measured_band_says_by_how_many_decades() {
    let folder = tempfile::tempdir().unwrap();
    write_dma(folder.path());
    let cold = TEMPERATURE.replace("30 degC", "-20 degC");
    for (velocity, temperature, expected) in [
        ("1 um/s", "", Some("1.3 decades below")),
        ("10 mm/s", "", None),
        ("10 mm/s", cold.as_str(), Some("3.9 decades above")),
    ] {
        let text = format!(
            "model = \"contact\"\n[substrate]\ndma = {{ file = \"dma.csv\" }}\n{temperature}[indenter]\nradius = \"10 mm\"\n\
             [[analysis]]\nname = \"c\"\nkind = \"contact\"\nvelocity = \"{velocity}\"\nindentation = \"10 um\"\naccuracy = 0.1\n"
        );
        for told in of_band(folder.path(), &text) {
            match expected {
                Some(expected) => {
                    assert!(told.len() == 1 && told[0].contains(expected), "{velocity}: {told:?}");
                }
                None => assert!(told.is_empty(), "{velocity}: {told:?}"),
            }
        }
    }
}

/// Through a law the oscillator stands on the same moduli; a formula was not made from them.
#[test]
fn an_oscillator_outside_the_measured_band_says_so() {
    let folder = tempfile::tempdir().unwrap();
    write_dma(folder.path());
    let law = from_file(&law_file(folder.path(), 0.0, [61, 33]));
    for (law, velocity, is_told) in
        [(law.as_str(), "0.1 um/s", true), (law.as_str(), "1 mm/s", false), ("\"hertz\"", "0.1 um/s", false)]
    {
        let text = format!(
            "model = \"oscillator\"\n[substrate]\ndma = {{ file = \"dma.csv\" }}\n[contact]\nlaw = {law}\n[operation]\nvelocity = \"{velocity}\"\n\
             [[analysis]]\nname = \"m\"\nkind = \"motion\"\nduration = 20\npoints = 64\n"
        );
        for told in of_band(folder.path(), &text) {
            assert_eq!(told.len(), usize::from(is_told), "{law} {velocity}: {told:?}");
            assert!(told.iter().all(|told| told.contains("decades below")), "{told:?}");
        }
    }
}
