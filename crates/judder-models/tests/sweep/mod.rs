//! Sweeps of whole studies: what a point holds, what fails, what parts and processes make of it.

mod parts;
mod probabilities;

use crate::{number, run_into};
use judder_models::oscillator::case::OscillatorCase;
use judder_models::point;
use judder_store::StoredChunk;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, SweepWork, plans, run};
use judder_study::sweep::{Evaluator, SweepPlan};
use judder_study::{Silent, StudyError};
use std::path::Path;

const HEAD: &str = "model = \"oscillator\"\n[operation]\nvelocity = 1e-3\nnormal_load = 1e-4\n[contact]\nshear_strength = 0.05\n";

fn file(sweeps: &str) -> CaseFile {
    judder_models::parse("sweeps.toml", &format!("{HEAD}{sweeps}"), &[]).unwrap()
}

/// All chunks of the first sweep of a case, computed without a folder.
fn computed(file: &CaseFile) -> (SweepPlan, Vec<StoredChunk>) {
    let plan = plans(file, &[]).unwrap().remove(0);
    let evaluator = Evaluator::new(&plan, &Silent).unwrap();
    let chunk = |chunk| {
        let content = evaluator.chunk(chunk, &Silent).unwrap();
        StoredChunk { values: content.values, failures: content.failures }
    };
    let chunks = (0..plan.layout().chunk_count()).map(chunk).collect();
    drop(evaluator);
    (plan, chunks)
}

fn oscillator(file: &CaseFile) -> &OscillatorCase {
    file.case.of::<OscillatorCase>().unwrap()
}

const GRID: &str = r#"
[[sweep]]
name = "grid"
over = [
  { key = "operation.velocity", from = 1e-5, to = 1e-1, points = 4, scale = "log" },
  { key = "contact.shear_strength", values = [0.01, 0.05, 0.3] },
]
quantities = ["growth_rate", "frequency", "verdict", "critical_shear_strength"]
chunk = 5
"#;

/// The same numbers as `judder point`, bit by bit: once by setting the inputs, once by reading the case anew.
#[test]
fn a_point_of_a_sweep_is_the_point_of_its_case() {
    let file = file(GRID);
    let (plan, chunks) = computed(&file);
    let sweep = plan.sweep();
    assert_eq!((sweep.points(), chunks.len()), (12, 4), "a chunk takes the last key whole");
    let rows: Vec<&[f64]> = chunks.iter().flat_map(|chunk| chunk.values.chunks_exact(4)).collect();
    for (index, row) in rows.iter().enumerate() {
        let here = file.at(sweep, &sweep.values_of(index as u64)).unwrap();
        let point = point::point(oscillator(&here)).unwrap();
        let verdicts = ["stable", "marginal", "unstable"];
        let verdict = verdicts.iter().position(|own| point.json()["verdict"] == **own).unwrap();
        let frequency =
            point.steady.eigenvalues.iter().max_by(|a, b| a.re.total_cmp(&b.re)).unwrap().im.abs();
        assert_eq!(row[..3], [point.steady.growth_rate(), frequency, verdict as f64], "{index}");
        let threshold = point.critical_shear_strength.first().copied().unwrap_or(f64::NAN);
        assert_eq!(row[3].to_bits(), threshold.to_bits(), "{index}");
    }
}

/// A temperature moves the times of the substrate: nothing of it stays as it was in the case of the file.
#[test]
fn a_swept_substrate_is_read_anew() {
    let text = r#"
model = "oscillator"
[operation]
velocity = "1 mm/s"
normal_load = 1e-4
[contact]
shear_strength = 0.05
[substrate]
prony = [{ time = "10 ms", compliance = "8e-7 1/Pa" }]
temperature = "30 degC"
shift = { wlf = { c1 = 8.86, c2 = "101.6 K", reference_temperature = "20 degC" } }
[[sweep]]
name = "warmth"
over = [{ key = "substrate.temperature", values = ["10 degC", "30 degC", "50 degC"] }]
quantities = ["growth_rate"]
"#;
    let file = judder_models::parse("warmth.toml", text, &[]).unwrap();
    let (plan, chunks) = computed(&file);
    let growth: Vec<f64> = chunks.iter().flat_map(|chunk| chunk.values.clone()).collect();
    for (index, value) in growth.iter().enumerate() {
        let here = file.at(plan.sweep(), &plan.sweep().values_of(index as u64)).unwrap();
        assert_eq!(*value, point::point(oscillator(&here)).unwrap().steady.growth_rate(), "{index}");
    }
    assert!(growth[0] < growth[2] && growth[2] < growth[1], "{growth:?}");
    let told: Vec<&str> =
        chunks.iter().flat_map(|chunk| &chunk.failures).map(|own| own.reason.as_str()).collect();
    assert!(
        told.len() == 3 && told.iter().all(|own| own.starts_with("doubtful: ") && own.contains("E∞/E0 = 5")),
        "{told:?}"
    );
}

const CYCLES: &str = r#"
[[analysis]]
name = "cycle"
kind = "limit-cycle"
[[sweep]]
name = "cycles"
method = "list"
over = [{ key = "contact.shear_strength", values = [0.05, 0.055] }]
quantities = ["growth_rate", "cycle.rms", "cycle.floquet_multipliers.count", "cycle.floquet_multipliers.0.0"]
"#;

/// A scalar of an analysis is what a run of the case at that point says.
#[test]
fn a_scalar_of_a_sweep_is_that_of_a_run() {
    let file = file(CYCLES);
    let (_, chunks) = computed(&file);
    let row = &chunks.last().unwrap().values[chunks.last().unwrap().values.len() - 5..];
    let folder = tempfile::tempdir().unwrap();
    let overrides = ["contact.shear_strength=0.055".to_owned()];
    let alone = judder_models::parse("alone.toml", &file.text, &overrides).unwrap();
    let report = run_into(folder.path(), &alone, &["cycle"]);
    let cycle = &report.summary.results["cycle"];
    assert_eq!(row[0], 0.055);
    assert_eq!(row[2..], [number(&cycle["rms"]), 4.0, number(&cycle["floquet_multipliers"][0][0])]);
}

/// A load under which there is no steady sliding: recorded with the reason, and no other point suffers.
#[test]
fn a_point_that_fails_is_recorded_and_the_others_are_done() {
    let sweep = r#"
[[sweep]]
name = "loads"
over = [{ key = "operation.normal_load", values = [1e-4, 1e12, 1e-3] }]
quantities = ["growth_rate", "verdict"]
chunk = 2
"#;
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file(sweep), &[]);
    assert!(!report.complete);
    let told = &report.summary.results["loads"];
    assert_eq!((&told["failed"], &told["quantities"]["growth_rate"]["count"]), (&1.into(), &2.into()));
    let failure = &told["failures"][0];
    assert_eq!(number(&failure["at"]["operation.normal_load"]), 1e12);
    assert!(failure["reason"].as_str().unwrap().contains("no steady sliding"), "{failure}");
    assert!(report.messages.iter().any(|message| message.contains("1 of 3 points failed")));
}

/// A speed at which steady sliding is stable has no cycle, and a growth rate all the same.
#[test]
fn an_analysis_that_fails_leaves_the_other_quantities() {
    let sweep = r#"
[[analysis]]
name = "cycle"
kind = "limit-cycle"
[[sweep]]
name = "cycles"
method = "list"
over = [{ key = "operation.velocity", values = [1e2, 1e-3] }]
quantities = ["growth_rate", "cycle.rms"]
chunk = 2
"#;
    let (_, chunks) = computed(&file(sweep));
    let rows: Vec<&[f64]> = chunks[0].values.chunks_exact(3).collect();
    let failures: Vec<(usize, &str)> =
        chunks[0].failures.iter().map(|failure| (failure.index, failure.reason.as_str())).collect();
    assert!(rows[0][1] < 0.0 && rows[0][2].is_nan(), "stable, and without a cycle: {rows:?}");
    assert!(matches!(failures[..], [(0, reason)] if reason.starts_with("cycle: ")), "{failures:?}");
    assert!(rows[1][1] > 0.0 && rows[1][2] > 0.0, "{rows:?}");
}

/// Deeper than the paper's law was computed for: told once, with how many of the points looked at.
#[test]
fn points_beyond_the_range_of_the_law_are_told() {
    let sweep = r#"
[[sweep]]
name = "loads"
over = [{ key = "operation.normal_load", from = 1e-6, to = 1.0, points = 7, scale = "log" }]
quantities = ["growth_rate"]
"#;
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file(sweep), &[]);
    let told =
        |message: &String| message.contains("outside the law's range at") && message.contains("of 7 points");
    assert!(report.messages.iter().any(told), "{:?}", report.messages);
}

/// The paper's law was fitted for E∞/E0 = 10.
#[test]
fn a_swept_substrate_that_departs_from_that_of_the_law_is_told() {
    let sweep = r#"
[[sweep]]
name = "moduli"
over = [{ key = "substrate.glassy_modulus", values = ["10 MPa", "12 MPa", "13 MPa"] }]
quantities = ["growth_rate"]
"#;
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file(sweep), &[]);
    let told = |message: &String| {
        message.contains("at 2 of 3 points looked at, for one: the law `oscillator-paper` was fitted for E∞/E0 = 10, this substrate has E∞/E0 = 12")
    };
    assert!(report.messages.iter().any(told), "{:?}", report.messages);
}

/// Hertz's contact on a grid of knots, and the same with a slightly larger force.
fn law_files() -> [String; 2] {
    let velocities = [1e-6, 1e-3, 1.0];
    let indentations: Vec<f64> = (0..20).map(|k| 1e-5 * 2f64.powi(k)).collect();
    let knots = |of: &dyn Fn(f64) -> f64| -> Vec<f64> {
        indentations.iter().flat_map(|depth| [of(*depth); 3]).collect()
    };
    [1.0, 1.01].map(|factor| {
        let values = serde_json::json!({
            "force": knots(&|depth| factor * 4.0 / 3.0 * depth.powf(1.5)),
            "area": knots(&|depth| std::f64::consts::PI * depth),
            "friction": knots(&|_| 0.0),
        });
        serde_json::json!({
            "format": "judder-sampled-law", "version": 1, "source": "Hertz",
            "velocities": velocities, "indentations": indentations, "values": values,
        })
        .to_string()
    })
}

/// What a chunk holds stands under the content of the files as it was when the sweep was planned.
#[test]
fn a_file_that_changes_while_it_is_swept_stops_the_sweep() {
    let folder = tempfile::tempdir().unwrap();
    let law = folder.path().join("law.json");
    let [data, changed] = law_files();
    std::fs::write(&law, data).unwrap();
    let text = format!("{}law = {{ file = {:?} }}\n{CYCLES}", HEAD, law.to_str().unwrap());
    let file = judder_models::parse("law.toml", &text, &[]).unwrap();
    let plan = plans(&file, &[]).unwrap().remove(0);
    let evaluator = Evaluator::new(&plan, &Silent).unwrap();
    evaluator.chunk(0, &Silent).unwrap();
    std::fs::write(&law, changed).unwrap();
    let refused = evaluator.chunk(0, &Silent).unwrap_err();
    assert!(matches!(&refused, StudyError::FileChanged { path } if *path == law), "{refused}");
    std::fs::remove_file(&law).unwrap();
    let refused = evaluator.chunk(0, &Silent).unwrap_err();
    assert!(matches!(&refused, StudyError::Unreadable { .. }), "of the run, not of the point: {refused}");
}

/// The same where the law is read once for all points: it is that of the hash, or none.
#[test]
fn a_law_that_changes_before_it_is_read_stops_the_sweep() {
    let folder = tempfile::tempdir().unwrap();
    let law = folder.path().join("law.json");
    let [data, changed] = law_files();
    std::fs::write(&law, data).unwrap();
    let text = format!("{HEAD}law = {{ file = {:?} }}\n{GRID}", law.to_str().unwrap());
    let file = judder_models::parse("law.toml", &text, &[]).unwrap();
    let plan = plans(&file, &[]).unwrap().remove(0);
    std::fs::write(&law, changed).unwrap();
    let refused = Evaluator::new(&plan, &Silent).map(drop).unwrap_err();
    assert!(matches!(&refused, StudyError::FileChanged { path } if *path == law), "{refused}");
}

/// Points that take long are cut small enough for many threads.
#[test]
fn a_few_long_points_are_many_chunks() {
    let chunks = |count: usize, quantity: &str| {
        let sweep = format!(
            "[[analysis]]\nname = \"cycle\"\nkind = \"limit-cycle\"\n[[sweep]]\nname = \"s\"\nover = [{{ key = \"contact.shear_strength\", from = 0.01, to = 0.1, points = {count} }}]\nquantities = [\"{quantity}\"]\n"
        );
        plans(&file(&sweep), &[]).unwrap()[0].layout().chunk_count()
    };
    assert_eq!((chunks(100, "cycle.rms"), chunks(10_000, "cycle.rms")), (15, 157));
    assert_eq!((chunks(1024, "threshold_load"), chunks(100_000, "threshold_load")), (4, 25));
    assert_eq!((chunks(100, "growth_rate"), chunks(1_000_000, "growth_rate")), (1, 16));
}

#[test]
fn a_part_of_no_sweep_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let options = |part: &str, only: &[&str]| RunOptions {
        sweeps: SweepWork::Part(part.parse().unwrap()),
        only: only.iter().map(|name| (*name).to_owned()).collect(),
        ..RunOptions::default()
    };
    let refused = run(&file(CYCLES), folder.path(), &options("1/2", &["cycle"]), &Silent).unwrap_err();
    assert!(
        refused.is_wrong_input() && refused.to_string().ends_with("the case has the sweeps cycles"),
        "{refused}"
    );
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "nothing is begun");
}

/// A dry run says what would fail.
#[test]
fn a_dry_run_tells_of_points_that_fail() {
    let sweep = "[[sweep]]\nname = \"loads\"\nover = [{ key = \"operation.normal_load\", values = [1e12, 2e12] }]\nquantities = [\"growth_rate\"]\n";
    let folder = tempfile::tempdir().unwrap();
    let told =
        judder_study::run::dry_run(&file(sweep), folder.path(), &RunOptions::default(), &Silent).unwrap();
    let text = told[0].text();
    assert!(told[0].failed == told[0].tried && text.contains("no steady sliding"), "{text}");
}

/// Growth of the minimal model depends on μ alone when c2 = 0: its index is one, that of the other parameter zero.
#[test]
fn sensitivity_finds_the_key_that_decides() {
    let text = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/benchmarks/minimal-mode-coupling.toml"),
    );
    let text = text
        .unwrap()
        .replace("[parameters]", "[parameters]\nidle = 1.0")
        .replace("4*mu/3", "4*mu/3 + 0*idle");
    let sweep = r#"
[[sweep]]
name = "which"
method = "sobol"
points = 256
over = [{ key = "parameters.mu", from = 0.8, to = 1.2 }, { key = "parameters.idle", from = 0.0, to = 1.0 }]
quantities = ["growth_rate"]
sensitivity = true
"#;
    let file = judder_models::parse("which.toml", &format!("{text}{sweep}"), &[]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file, &["which"]);
    let told = &report.summary.results["which"]["sensitivity"]["growth_rate"];
    for order in ["first", "total"] {
        assert!((number(&told[order]["parameters.mu"]["value"]) - 1.0).abs() < 0.02, "{told}");
        assert!(number(&told[order]["parameters.idle"]["value"]).abs() < 1e-12, "{told}");
    }
}
