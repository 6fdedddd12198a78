//! Contact cases end to end, on settings that are quick.

use crate::{case, number, run_into};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_memory::MemoryBudget;
use judder_study::model::{PROGRAM_BYTES, Prepared, Task, placed};
use judder_study::resolve::resolve;
use judder_study::run::{RunOptions, RunReport, run};
use judder_study::{Silent, StudyError};
use serde_json::{Map, Value};
use std::path::Path;

/// Runs a case of this text in a folder, whose files the text may name.
pub(crate) fn run_text(folder: &Path, text: &str) -> RunReport {
    let path = folder.join("case.toml");
    std::fs::write(&path, text).unwrap();
    run_into(&folder.join("out"), &judder_models::read(&path, &[]).unwrap(), &[])
}

fn result<'a>(report: &'a RunReport, name: &str) -> &'a Map<String, Value> {
    &report.summary.results[name]
}

/// What a grid will need is not known before it is refined: 256 × 256 cells fit, and twice as many a side do not.
#[test]
fn grids_are_refined_within_what_the_process_may_take() {
    let text = "model = \"contact\"\n[[analysis]]\nkind = \"contact\"\nvelocity = 1e-1\nindentation = 1e-2\naccuracy = 1e-5\n";
    let file = judder_models::parse("case.toml", text, &[]).unwrap();
    let parts = MemoryBudget::of_whole_process().most() / 80_000_000;
    let task = || file.case.run(0, Task::alone(&Prepared::NOTHING, &Silent));
    let refused = MemoryBudget::shared(parts, task).map(drop).unwrap_err();
    let StudyError::Case(error) = placed(refused, &*file.case, &file, 0) else { panic!("no place") };
    let message = error.to_string();
    assert!(
        message.contains("a contact on 512 × 512 cells: ") && message.contains(" of memory are needed"),
        "{message}"
    );
    assert_eq!(error.place(), "1e-5", "the accuracy is to blame");
}

/// As many contacts of a law at once as there are threads, or as the process may take.
#[test]
fn contacts_of_a_law_share_what_the_process_may_take() {
    let text = "model = \"contact\"\n[[analysis]]\nkind = \"contact-law\"\naccuracy = 1e-4\n\
                velocity = { from = 1e-3, to = 1e2, points = 5 }\nindentation = { from = 1e-3, to = 1e-2, points = 3 }\n";
    let file = judder_models::parse("case.toml", text, &[]).unwrap();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    let told = |parts| {
        let checked = || MemoryBudget::shared(parts, || resolve(&file, &Silent).unwrap().json());
        number(&pool.install(checked)["estimate"][0]["bytes"]) - PROGRAM_BYTES as f64
    };
    let (all, of_three) = (MemoryBudget::of_whole_process().most(), told(1));
    // what is free changes between two looks: no part is near an edge
    let two = told(all / (PROGRAM_BYTES as u64 + (of_three / 3.0 * 2.5) as u64));
    // beside a few kilobytes of the table
    assert!((two / of_three - 2.0 / 3.0).abs() < 1e-4, "{two} of {of_three}");
}

/// One retardation time: tan δ is (E∞/E0 − 1)/(2 √(E∞/E0)) at the most, at ω τ = √(E∞/E0).
#[test]
fn the_loss_tangent_of_figure_13() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("oscillator-paper/fig-13.toml", &[]), &[]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let modulus = result(&report, "modulus");
    assert!((number(&modulus["largest_loss_tangent"]) - 9.0 / (2.0 * 10.0_f64.sqrt())).abs() < 1e-3);
    let at = number(&modulus["frequency_of_largest_loss_tangent"]);
    assert!((at / 10_f64.powf(2.5) - 1.0).abs() < 0.05, "{at}");
}

/// Closed forms: Hertz with E0, and μ = (1 − E0/E∞) v τ/R.
#[test]
fn slow_sliding_is_hertz_with_a_known_friction() {
    let folder = tempfile::tempdir().unwrap();
    let text = r#"
        model = "contact"
        [[analysis]]
        kind = "contact"
        velocity = 1e-6
        indentation = 1e-2
        accuracy = 2e-3
    "#;
    let report = run_text(folder.path(), text);
    assert!(report.complete, "{:?}", report.messages);
    let contact = result(&report, "contact");
    assert!((number(&contact["force"]) / (4.0 / 3.0 * 1e-3) - 1.0).abs() < 1e-3);
    assert!((number(&contact["friction"]) / 0.9e-6 - 1.0).abs() < 1e-2);
    assert_eq!(contact["converged"], true);
    for file in ["fields/contact.vtu", "contact.csv", "figures/contact.svg"] {
        assert!(folder.path().join("out").join(file).is_file(), "{file}");
    }
    let again = run_text(folder.path(), text);
    assert_eq!(again.skipped, ["contact"]);
}

/// Wang and Knothe (1993): 78.74 N/mm² at a creep time of 9 ms.
#[test]
fn the_cylinders_of_wang_and_knothe() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("benchmarks/wang-knothe.toml", &[]), &[]);
    assert!(report.complete, "{:?}", report.messages);
    let line = result(&report, "line");
    let peak = number(&line["peak_pressure_pascal"]);
    assert!((peak / 78.74e6 - 1.0).abs() < 1e-3, "{peak}");
    assert!(number(&line["friction_difference"]) < 1e-2, "{line:?}");
    assert!(number(&line["area_error"]) < 5e-3 && number(&line["friction_error"]) < 5e-3, "{line:?}");
    for file in ["fields/line.vtu", "line.csv", "figures/line.svg"] {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
}

#[test]
fn grids_far_from_each_other_do_not_count_as_converged() {
    for (cells, said) in [(64, "are not known on 64 × 64 cells"), (128, "is not met on 128 × 128 cells")] {
        let folder = tempfile::tempdir().unwrap();
        let text = format!(
            "model = \"contact\"\n[[analysis]]\nkind = \"contact\"\nvelocity = 1e-1\nload = 1e-3\ncells = {cells}\naccuracy = 1e-6\n"
        );
        let report = run_text(folder.path(), &text);
        assert!(!report.complete);
        assert_eq!(result(&report, "contact")["converged"], false);
        assert!(report.messages.iter().any(|message| message.contains(said)), "{:?}", report.messages);
    }
}

/// A law goes from its case into a file, and from there into an oscillator; the fit finds the paper's shape.
#[test]
fn a_law_serves_an_oscillator_and_a_fit() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_text(
        folder.path(),
        r#"
        model = "contact"
        [[analysis]]
        name = "law"
        kind = "contact-law"
        velocity = { from = 1e-4, to = 1e2, points = 9 }
        indentation = { from = 1e-3, to = 1e-1, points = 5 }
        accuracy = 0.05
        [[analysis]]
        kind = "fit"
        velocity = { from = 1e-6, to = 1e4, points = 21 }
        indentation = { from = 1e-3, to = 1e-1, points = 7 }
        accuracy = 0.05
        "#,
    );
    assert!(report.complete, "{:?}", report.messages);
    let fit = result(&report, "fit");
    for (name, least) in [("force", 0.999), ("area", 0.99), ("friction", 0.98)] {
        assert!(number(&fit[name]["r2"]) > least, "{name}: {}", fit[name]);
    }
    // appendix B, c1 = 0.450; the paraboloid's is a little below the sphere's
    assert!((number(&fit["friction"]["coefficients"][0]) / 0.45 - 1.0).abs() < 0.08);
    let law = folder.path().join("out/law.json");
    assert!(law.is_file());
    std::fs::copy(&law, folder.path().join("law.json")).unwrap();
    let oscillator = run_text(
        folder.path(),
        r#"
        model = "oscillator"
        contact = { law = { file = "law.json" } }
        [[analysis]]
        kind = "equivalent-damping"
        sweep = { key = "operation.velocity", from = 1e-6, to = 1.0, points = 7, scale = "log" }
        "#,
    );
    assert!(oscillator.complete, "{:?}", oscillator.messages);
}

/// Appendix B, (35), (37), (39), and its r²: the fit of Fig. 14 finds all coefficients within 3 %, a5 within 0.05.
#[test]
fn the_fit_finds_the_papers_coefficients() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("oscillator-paper/fig-14.toml", &[]), &[]);
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let fit = result(&report, "fit");
    let lines = fit["beside_the_paper"].as_array().unwrap();
    assert_eq!(lines.len(), 14);
    for line in lines {
        let (figure, bar) =
            if line["name"] == "a5" { ("deviation", 0.05) } else { ("relative_deviation", 0.03) };
        assert!(number(&line[figure]).abs() < bar, "{line}");
    }
    for (found, expected) in fit["r2"].as_array().unwrap().iter().zip([0.9999, 0.9995, 0.9954]) {
        assert!((number(found) - expected).abs() < 1e-4, "{}", fit["r2"]);
    }
    // every point of the plane is a sample, but only the solved contacts are independent
    assert_eq!(fit["sample_count"], 1600);
    assert!(number(&fit["contacts_solved"]) < 200.0, "{}", fit["contacts_solved"]);
}

#[test]
fn a_law_file_that_is_none_is_named() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("law.json"), "{}").unwrap();
    let path = folder.path().join("case.toml");
    let text = r#"
        model = "oscillator"
        contact = { law = { file = "law.json" } }
        [[analysis]]
        kind = "equivalent-damping"
        sweep = { key = "operation.velocity", from = 1e-6, to = 1.0, points = 7, scale = "log" }
        "#;
    std::fs::write(&path, text).unwrap();
    let out = folder.path().join("out");
    let file = judder_models::read(&path, &[]).unwrap();
    let refused = run(&file, &out, &RunOptions::default(), &Silent).unwrap_err();
    assert!(refused.to_string().contains("law.json: "), "{refused}");
    assert!(!out.join("summary.json").exists());
}

#[test]
fn measured_moduli_become_a_series() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &case("tutorials/own-rubber.toml", &[]), &["modulus"]);
    let modulus = result(&report, "modulus");
    assert!(number(&modulus["storage_deviation"]) < 0.05 && number(&modulus["storage_r2"]) > 0.999);
}

#[test]
fn a_rough_surface_touches_with_its_peaks() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_text(
        folder.path(),
        r#"
        model = "contact"
        [substrate]
        retardation_time = "0.1 ms"
        [indenter]
        radius = "1 mm"
        shape = { rough = { period = "1 mm", cells = 32, hurst = 0.8, rms_height = "5 um", seed = 1 } }
        [[analysis]]
        kind = "contact"
        velocity = "10 mm/s"
        load = "20 mN"
        accuracy = 1e-2
        [[analysis]]
        name = "as-deep"
        kind = "contact"
        velocity = "10 mm/s"
        indentation = "4 um"
        accuracy = 1e-2
        "#,
    );
    assert!(report.complete, "{:?}", report.messages);
    let contact = result(&report, "contact");
    let fraction = number(&contact["contact_fraction"]);
    assert!(fraction > 0.0 && fraction < 1.0 && number(&contact["friction"]) > 0.0, "{contact:?}");
    assert!(number(&contact["friction_difference"]) < 1e-2, "{contact:?}");
    assert!(number(&contact["cells"]) > 32.0 && number(&contact["area_error"]) < 5e-2, "{contact:?}");
    let deep = result(&report, "as-deep");
    assert!((number(&deep["indentation_metre"]) / 4e-6 - 1.0).abs() < 1e-12);
    assert!(number(&deep["force_error"]) < 1e-2 && number(&deep["mean_gap"]) > 0.0, "{deep:?}");
}

/// Sneddon (1965): a small oscillation of the depth at rest meets a flat punch of the contact's radius, c_y = 2 a E″(ω)/ω.
#[test]
fn a_trembling_indenter_has_the_damper_of_a_flat_punch() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_text(
        folder.path(),
        r#"
        model = "contact"
        [[analysis]]
        kind = "transient"
        motion = "rest"
        indentation = 1e-2
        oscillation = { amplitude = 2e-4, frequency = 0.4 }
        duration = 32
        cells = 32
        "#,
    );
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let result = result(&report, "transient");
    // E(ω)/E0 = (1 + iωτ)/(1 + iωτ E0/E∞)
    let loss = 0.4 * 0.9 / (1.0 + 0.04_f64.powi(2));
    let damper = number(&result["c_y"]);
    assert!((damper / (2.0 * 0.1 * loss / 0.4) - 1.0).abs() < 3e-2, "{damper}");
    let cycle = number(&result["work_per_cycle"]);
    assert!((cycle / (std::f64::consts::PI * 4e-8 * 0.4 * damper) - 1.0).abs() < 1e-2, "{cycle}");
    // E0* R τ is 4/3 MPa · 10 mm · 10 ms
    assert!((number(&result["c_y_newton_second_per_metre"]) / damper / (4e2 / 3.0) - 1.0).abs() < 1e-9);
    for file in ["transient.csv", "figures/transient.svg"] {
        assert!(folder.path().join("out").join(file).is_file(), "{file}");
    }
}

/// The long-time limit of a start is steady sliding; a loop of friction over position encloses the work of a cycle.
#[test]
fn a_start_becomes_steady_and_a_reciprocation_dissipates() {
    let folder = tempfile::tempdir().unwrap();
    let report = run_text(
        folder.path(),
        r#"
        model = "contact"
        [[analysis]]
        name = "start"
        kind = "transient"
        motion = "start"
        velocity = 0.1
        indentation = 1e-2
        duration = 6
        cells = 32
        [[analysis]]
        name = "to-and-fro"
        kind = "transient"
        motion = "reciprocation"
        amplitude = 0.05
        frequency = 1
        load = 1.5e-3
        duration = 13
        cells = 24
        "#,
    );
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let start = result(&report, "start");
    assert!((number(&start["force"]) / number(&start["steady_force"]) - 1.0).abs() < 2e-2);
    let checks = report.summary.extra["study"]["checks"]["start"].to_string();
    assert!(checks.contains("the end of the start is steady sliding"), "{checks}");
    assert!(number(&result(&report, "to-and-fro")["work_per_cycle"]) > 0.0);
}

/// A law at the default accuracy, on both ways of covering the plane.
#[test]
#[ignore = "expensive: run by make validate"]
fn laws_of_the_default_accuracy_converge() {
    for shape in ["paraboloid", "sphere"] {
        let folder = tempfile::tempdir().unwrap();
        let text = format!(
            "model = \"contact\"\nindenter = {{ shape = \"{shape}\" }}\n[[analysis]]\nname = \"law\"\nkind = \"contact-law\"\n"
        );
        let report = run_text(folder.path(), &text);
        let law = result(&report, "law");
        assert_eq!(law["converged"], true, "{shape}: {law:?}");
        assert!(report.complete && report.messages.is_empty(), "{shape}: {:?}", report.messages);
    }
}

/// Strips are one row, and the heights of a surface that repeats itself are the coarsest of its grids.
#[test]
fn a_check_knows_the_grid_of_strips_and_of_heights() {
    let folder = tempfile::tempdir().unwrap();
    let heights = "0 1 0 1 0 1 0 1\n1 0 1 0 1 0 1 0\n".repeat(2);
    std::fs::write(folder.path().join("heights.txt"), heights).unwrap();
    let file = "{ heights = \"heights.txt\", spacing = \"1 um\", unit = \"1 um\", periodic = true }";
    // so slowly that the wake ends within a period of the heights
    for (shape, velocity, bytes) in [
        ("\"cylinder\"", 1e-2, SlidingOperator::memory_bytes(2048, 1)),
        (file, 1e-4, SlidingOperator::memory_bytes(128, 64)),
    ] {
        let path = folder.path().join("case.toml");
        let text = format!(
            "model = \"contact\"\nindenter = {{ shape = {shape} }}\n[[analysis]]\nkind = \"contact\"\nvelocity = {velocity}\nload = 1e-4\n"
        );
        std::fs::write(&path, text).unwrap();
        let checked =
            resolve(&judder_models::read(&path, &[]).unwrap(), &judder_study::Silent).unwrap().json();
        // the program, and 2.3 times what the operator takes
        assert_eq!(checked["estimate"][0]["bytes"], PROGRAM_BYTES as u64 + bytes * 23 / 10, "{checked}");
    }
}

/// The paraboloid z = ±r²/2R, R = 10 mm, as heights over 33 × 33 points that are 0.1 mm apart.
fn write_heights(folder: &Path, name: &str, sign: f64) {
    let height = |row: i32, column: i32| {
        let squared = 1e-8 * f64::from((row - 16).pow(2) + (column - 16).pow(2));
        (sign * squared / 2e-2).to_string()
    };
    let line = |row: i32| (0..33).map(|column| height(row, column)).collect::<Vec<_>>().join(" ");
    std::fs::write(folder.join(name), (0..33).map(line).collect::<Vec<_>>().join("\n")).unwrap();
}

#[test]
fn a_topography_turned_over_is_its_mirror_image() {
    let folder = tempfile::tempdir().unwrap();
    write_heights(folder.path(), "valley.txt", 1.0);
    write_heights(folder.path(), "peak.txt", -1.0);
    let run = |shape: &str| {
        let text = format!(
            "model = \"contact\"\n[indenter]\nshape = {{ {shape}, spacing = \"0.1 mm\" }}\n[[analysis]]\n\
             kind = \"contact\"\nvelocity = 1e-3\nindentation = 1e-3\ncells = 64\naccuracy = 0.1\n"
        );
        run_text(folder.path(), &text)
    };
    let force = |shape: &str| number(&result(&run(shape), "contact")["force"]);
    let valley = force("heights = \"valley.txt\"");
    assert!((valley / force("heights = \"peak.txt\", turned_over = true") - 1.0).abs() < 1e-9);
    // as it stands, its corners touch first
    let error = run("heights = \"peak.txt\"").refused.remove(0).error.to_string();
    assert!(error.contains("reaches the edge of the heights"), "{error}");
}

/// Samples of a box, τ𝒞 even in ln τ: 1/E0 − 1/E∞ = τ𝒞 ln(τ_2/τ_1).
#[test]
fn a_continuous_spectrum_is_taken_apart_with_its_error_shown() {
    let folder = tempfile::tempdir().unwrap();
    let run = |continuous: &str| {
        run_text(
            folder.path(),
            &format!(
                "model = \"contact\"\nsubstrate = {{ continuous = {{ {continuous} }} }}\n[[analysis]]\nkind = \"modulus\"\n"
            ),
        )
    };
    let box_of = |terms: &str| {
        let decades = 3.0 * std::f64::consts::LN_10;
        let density = |time: f64| 0.9e-6 / decades / time;
        let sample =
            |time: f64| format!("{{ time = \"{time} s\", density = \"{:e} 1/Pa/s\" }}", density(time));
        format!("samples = [{}, {}, {}], {terms}", sample(1e-3), sample(1e-2), sample(1.0))
    };
    let report = run(&box_of("accuracy = 1e-4"));
    assert!(report.complete && report.messages.is_empty(), "{:?}", report.messages);
    let fine = result(&report, "modulus").clone();
    assert!((number(&fine["glassy_modulus_pascal"]) / 1e7 - 1.0).abs() < 1e-9);
    assert!(number(&fine["spectrum_error"]) <= 1e-4);
    let same = run("power_law = { from = \"1 ms\", to = \"1 s\", exponent = 0 }, accuracy = 1e-4");
    let same = result(&same, "modulus");
    assert_eq!(fine["terms"], same["terms"]);
    let (a, b) = (number(&fine["largest_loss_tangent"]), number(&same["largest_loss_tangent"]));
    assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    // two terms for three decades are too few, which a check says
    let coarse = run(&box_of("terms = 2"));
    assert!(number(&result(&coarse, "modulus")["spectrum_error"]) > 1e-2);
    assert!(coarse.messages.iter().any(|m| m.contains("the terms stand for the continuous spectrum")));
}
