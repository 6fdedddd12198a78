//! What is told where friction is not known, and where its fall is exactly as large as the damping.

use crate::run_into;
use judder_study::Silent;
use judder_study::case::file::CaseFile;
use judder_study::resolve::resolve;
use serde_json::Value;
use std::path::Path;

/// A mass on a belt whose friction falls by a table, and its analyses.
fn belt(velocity: &str, damping: f64, analyses: &str) -> CaseFile {
    let text = format!(
        "model = \"belt\"\n[oscillator]\ndamping = {damping}\n[friction]\nvelocity = [0.5, 1.0]\ncoefficient = [0.6, 0.58]\n\
         [operation]\nvelocity = {velocity}\nnormal_force = 1.0\n{analyses}"
    );
    judder_models::parse("case.toml", &text, &[]).unwrap()
}

fn point(file: &CaseFile) -> Value {
    resolve(file, &Silent).unwrap().document["point"].clone()
}

/// Every warning of every analysis that is asked for.
fn warnings(file: &CaseFile, only: &[&str]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let analyses = run_into(folder.path(), file, only).summary.analyses;
    analyses.into_values().flat_map(|record| record.warnings).collect()
}

#[track_caller]
fn assert_beyond(told: &[String], expected: &[&str]) {
    let beyond: Vec<&String> =
        told.iter().filter(|own| own.contains("beyond the table of friction")).collect();
    assert_eq!(beyond.len(), expected.len(), "{told:?}");
    for (own, expected) in beyond.iter().zip(expected) {
        assert!(own.contains(expected), "{own}");
    }
}

/// μ falls by 0.02 over 0.5, which is twice ξ = 0.02: steady sliding neither grows nor decays, and every swing about it stays as it is.
#[test]
fn damping_that_friction_takes_away_to_the_last_digit_is_marginal() {
    let cycle = "[[analysis]]\nname = \"cycle\"\nkind = \"limit-cycle\"\n";
    let file = belt("0.85", 0.02, cycle);
    let at = point(&file);
    assert_eq!((&at["verdict"], at["equivalent_damping"].as_f64()), (&Value::from("marginal"), Some(0.0)));
    for (damping, verdict) in [(0.019, "unstable"), (0.021, "stable")] {
        assert_eq!(point(&belt("0.85", damping, ""))["verdict"], verdict);
    }
    let folder = tempfile::tempdir().unwrap();
    let report = run_into(folder.path(), &file, &[]);
    assert!(report.summary.results["cycle"]["stable"].is_null(), "{:?}", report.summary.results);
    let told = &report.summary.analyses["cycle"].warnings;
    let neutral = |own: &String| own.starts_with("motions beside this cycle neither come to it nor leave it");
    assert!(told.iter().any(neutral), "{told:?}");
}

#[test]
fn a_belt_faster_than_its_table_is_told() {
    let cycle = belt("1.5", 0.05, "[[analysis]]\nname = \"cycle\"\nkind = \"limit-cycle\"\n");
    let told = resolve(&cycle, &Silent).unwrap().document["warnings"][0].to_string();
    assert!(told.contains("in steady sliding: the slip speed 1.5 lies beyond"), "{told}");
    let folder = tempfile::tempdir().unwrap();
    let failed = run_into(folder.path(), &cycle, &[]).messages.join("\n");
    assert!(
        failed.contains("the motion comes to steady sliding")
            && failed.contains("the slip speed 1.5 lies beyond"),
        "{failed}"
    );
    let motion = "[[analysis]]\nkind = \"motion\"\nduration = 20\ntransient = 5\n\
                  [[analysis]]\nkind = \"basin\"\nwithin = { x = [0.5, 0.7] }\nsamples = 2\n";
    let told =
        "in steady sliding: the slip speed 1.5 lies beyond the table of friction, which goes from 0.5 to 1:";
    assert_beyond(&warnings(&belt("1.5", 0.05, motion), &[]), &[told, told]);
    assert_beyond(&warnings(&belt("0.8", 0.05, motion), &[]), &[]);
    let swing =
        "[[analysis]]\nkind = \"motion\"\nstart = { disturbance = 1.0 }\nduration = 20\ntransient = 0\n";
    assert_beyond(&warnings(&belt("0.8", 0.05, swing), &[]), &["instants, for one: the slip speed "]);
    let diagram = "[[analysis]]\nkind = \"bifurcation\"\nsweep = { key = \"operation.velocity\", from = 0.75, to = 1.5, points = 4 }\n";
    assert_beyond(
        &warnings(&belt("0.8", 0.05, diagram), &[]),
        &["at 2 of 4 values, for one: the slip speed 1.25 "],
    );
}

/// A table in place of the friction of a case.
const TABLE: &str = "{ velocity = [\"10 mm/s\", \"200 mm/s\"], coefficient = [0.4, 0.3] }";

fn small(name: &str, overrides: &[String]) -> CaseFile {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small").join(name);
    judder_models::read(path, overrides).unwrap()
}

#[test]
fn a_pair_faster_than_its_table_is_told() {
    let with = |more: &[&str]| {
        let own = [format!("contact.friction_coefficient={TABLE}")];
        let more = more.iter().map(|own| (*own).to_owned());
        small("sliding.toml", &own.into_iter().chain(more).collect::<Vec<_>>())
    };
    let beyond =
        "the slip speed 0.3 m/s lies beyond the table of friction, which goes from 0.01 m/s to 0.2 m/s";
    assert_beyond(&warnings(&with(&[]), &["locus"]), &[beyond]);
    assert_beyond(&warnings(&with(&["motion.velocity=\"150 mm/s\""]), &["locus"]), &[]);
    let sweep = "analysis.locus-friction.sweep={ key = \"motion.velocity\", from = \"100 mm/s\", to = \"400 mm/s\", points = 3 }";
    // the speed of the case is none of the sweep
    let swept = with(&[sweep]);
    assert_beyond(&warnings(&swept, &["locus-friction"]), &["at 2 of 3 values the slip speed 0.25 m/s"]);
}

#[test]
fn an_interface_faster_than_its_table_is_told() {
    let file = small("assembly.toml", &[format!("contact.sole.friction_coefficient={TABLE}")]);
    let told = warnings(&file, &["steady", "modes"]);
    let expected = "`sole`: at 5 of 5 closed points the slip speed 1 m/s lies beyond";
    assert_beyond(&told, &[expected, expected]);
}

#[test]
fn an_oscillator_beyond_its_law_is_told_of_motions_too() {
    let told = warnings(&small("oscillator.toml", &["operation.velocity=10.0".to_owned()]), &["motion"]);
    assert!(told.iter().any(|own| own.starts_with("outside the law's range in steady sliding")), "{told:?}");
}
