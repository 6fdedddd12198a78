//! What the report shows of analyses of assemblies, as the page gets it.

use crate::client::{Frame, Served};
use judder_store::{Dataset, StudyFolder, Variable};
use judder_study::Silent;
use judder_study::run::{RunOptions, run};
use judder_study::study_view::MOST_VALUES;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The study of the assembly of a case file, with these analyses in place of its own.
fn study(case: &str, set: &[&str], analyses: &str) -> TempDir {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/assembly").join(case);
    let text = fs::read_to_string(&path).unwrap();
    let (own, _) = text.split_once("[[analysis]]").unwrap();
    let set: Vec<String> = set.iter().map(|option| (*option).to_owned()).collect();
    let file = judder_models::parse(case, &format!("{own}[[analysis]]\n{analyses}"), &set).unwrap();
    let folder = tempfile::tempdir().unwrap();
    run(&file, folder.path(), &RunOptions::default(), &Silent).unwrap();
    folder
}

fn reported(folder: &Path, analysis: &str) -> Frame {
    let served = Served::of(None, Some(folder));
    let mut frames = served.post("/api/study/report", &json!({ "analysis": analysis })).frames();
    frames.swap_remove(0)
}

/// The figure, which is the very one of the report, with the captions of the tables.
fn shown(folder: &Path, analysis: &str) -> (Value, Vec<String>) {
    let Frame { header, .. } = reported(folder, analysis);
    assert_eq!((&header["kind"], &header["undrawn"]), (&json!("report"), &Value::Null));
    let text = header["figure"].as_str().unwrap();
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert!(page.contains(text), "{analysis}: the figure is not that of the report");
    let tables = header["tables"].as_array().unwrap();
    let captions = tables.iter().map(|table| {
        assert!(table["rows"].as_array().is_some_and(|rows| !rows.is_empty()), "{table}");
        table["caption"].as_str().unwrap().to_owned()
    });
    (serde_json::from_str(text).unwrap(), captions.collect())
}

/// The words of the panels: their titles, or what stands at their ordinates.
fn panels(figure: &Value) -> Vec<String> {
    let words = |panel: &Value| panel["title"].as_str().or(panel["y"]["label"].as_str()).unwrap().to_owned();
    figure["panels"].as_array().unwrap().iter().map(words).collect()
}

fn labels(panel: &Value) -> Vec<&str> {
    let layers = panel["layers"].as_array().unwrap().iter().filter_map(Value::as_object);
    layers.flat_map(|layer| layer.values()).filter_map(|layer| layer["label"].as_str()).collect()
}

#[test]
fn a_limit_cycle_has_its_portrait_its_states_and_its_levels() {
    let analyses = "name = \"cycle\"\nkind = \"limit-cycle\"\nharmonics = 7\n";
    let folder = study("lumped-brake.toml", &[], analyses);
    let (figure, tables) = shown(folder.path(), "cycle");
    let panels = panels(&figure);
    for words in ["contact point 1", "stiffening: states of the points", "linear: states of the points"] {
        assert!(panels.iter().any(|panel| panel == words), "{words}: {panels:?}");
    }
    assert!(tables.iter().any(|caption| caption == "Accelerations of the observed points"), "{tables:?}");
    assert!(figure["caption"].as_str().unwrap().contains("portrait"), "{}", figure["caption"]);
}

#[test]
fn a_bifurcation_diagram_has_its_branches_and_where_they_fold() {
    let analyses = "name = \"speed\"\nkind = \"bifurcation\"\nharmonics = 7\n\
                    sweep = { key = \"contact.belt.sliding.velocity\", from = \"0.7 m/s\", to = \"1.6 m/s\", points = 5 }\n";
    let folder = study("mass-on-falling-belt.toml", &["contact.belt.sliding.velocity=0.9 m/s"], analyses);
    let (figure, tables) = shown(folder.path(), "speed");
    assert_eq!(figure["panels"].as_array().unwrap().len(), 2);
    let labels = labels(&figure["panels"][0]);
    for label in ["stable cycles", "unstable cycles", "fold", "Hopf point"] {
        assert!(labels.contains(&label), "{label}: {labels:?}");
    }
    assert!(tables[0].starts_with("Bifurcations"), "{tables:?}");
}

#[test]
fn a_ranking_of_squeal_has_its_levels_and_its_modes() {
    let analyses = "name = \"squeal\"\nkind = \"squeal\"\nband = [\"0.1 Hz\", \"0.4 Hz\"]\n\
                    knocks = { at = \"mass.x\", impulse = [\"0 N s\", \"1.2 N s\"], samples = 2, step = \"50 ms\", duration = \"250 s\" }\n";
    let slow = ["contact.belt.sliding.velocity=0.9 m/s"];
    let folder = study("mass-on-falling-belt.toml", &slow, analyses);
    let (figure, tables) = shown(folder.path(), "squeal");
    let panels = panels(&figure);
    for words in ["how loud they are where they are loudest", "what is left of the energy of knocks"] {
        assert!(panels.iter().any(|panel| panel == words), "{words}: {panels:?}");
    }
    assert!(tables[0].contains("from the loudest cycle on"), "{tables:?}");
}

#[test]
fn a_frequency_response_has_its_curves() {
    let analyses = "name = \"response\"\nkind = \"frequency-response\"\nfrequency = [\"150 rad/s\", \"250 rad/s\"]\n\
                    forces = [{ structure = \"blade\", set = \"mass\", direction = \"x\", amplitude = \"123.024 N\" }]\nharmonics = 3\n";
    let folder = study("friction-damper.toml", &[], analyses);
    let (figure, tables) = shown(folder.path(), "response");
    assert_eq!(figure["panels"].as_array().unwrap().len(), 3);
    assert!(labels(&figure["panels"][0]).contains(&"mass.x"));
    assert!(!tables.is_empty());
}

#[test]
fn more_than_a_page_reads_is_not_drawn_and_its_tables_stay() {
    let analyses = "name = \"cycle\"\nkind = \"limit-cycle\"\nharmonics = 7\n";
    let folder = study("lumped-brake.toml", &[], analyses);
    let before = reported(folder.path(), "cycle");
    let many = Variable::new("state", &["phase"], &[MOST_VALUES + 1], vec![0_u8; MOST_VALUES + 1]);
    let dataset = Dataset::new().with(many).and_then(|own| own.attribute("kind", "limit-cycle")).unwrap();
    StudyFolder::open(folder.path()).unwrap().write_dataset("cycle", "hash", &dataset).unwrap();
    let Frame { header, .. } = reported(folder.path(), "cycle");
    assert_eq!((&header["figure"], &header["tables"]), (&Value::Null, &before.header["tables"]));
    let [message, help] = ["message", "help"].map(|part| header["undrawn"][part].as_str().unwrap());
    assert!(message.contains("16777217 values") && help.contains("judder report"), "{message}; {help}");
}

#[test]
fn only_analyses_of_the_study_are_told() {
    let analyses = "name = \"cycle\"\nkind = \"limit-cycle\"\nharmonics = 3\n";
    let folder = study("lumped-brake.toml", &[], analyses);
    for analysis in ["none", "../cycle", "", "cycle\u{0}"] {
        let frame = reported(folder.path(), analysis);
        assert_eq!(frame.kind(), "error", "{analysis}");
    }
    let served = Served::of(None, Some(folder.path()));
    assert_eq!(served.post("/api/study/report", &json!({ "analysis": "cycle", "file": "x" })).status, 400);
    assert_eq!(Served::new().post("/api/study/report", &json!({ "analysis": "cycle" })).status, 404);
}
