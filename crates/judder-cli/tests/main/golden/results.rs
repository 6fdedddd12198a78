//! The studies of the small cases: summary, arrays, tables, files, the words of the report.

use super::agreement::{FLOAT_HASH, Numbers};
use super::{case_files, declared, file, small_cases, snapshot};
use crate::desk::{Desk, files_below};
use judder_store::{StudyFolder, content_hash};
use judder_study::Silent;
use judder_study::case::file::CaseFile;
use judder_study::run::{RunOptions, RunReport, run};
use judder_study::study_view::StudyView;
use rayon::prelude::*;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Keys of a summary that tell of the machine, its clock or the version.
const OF_THE_MACHINE: [&str; 3] = ["version", "wall_time_s", "seconds"];
/// Words that begin such lines of a report.
const LINES_OF_THE_MACHINE: [&str; 3] = ["judder 0", "wall time", "seconds "];

/// What is frozen of a study.
fn frozen(file: &CaseFile, report: &RunReport) -> Value {
    let folder = &report.folder;
    let mut summary = serde_json::to_value(&report.summary).unwrap();
    without(&mut summary, &OF_THE_MACHINE);
    let study = summary["study"].as_object_mut().unwrap();
    assert_eq!(study.remove("source").unwrap(), file.text.as_str());
    study.remove("file").unwrap();
    let refused = report.refused.iter().map(|refused| format!("{}: {}", refused.name, refused.error));
    json!({
        "summary": snapshot::document(&summary),
        "said": {
            "complete": report.complete, "tables": report.tables, "notes": report.notes, "messages": report.messages,
            "refused": refused.collect::<Vec<_>>(),
        },
        "datasets": datasets(folder, &report.summary.analyses),
        "files": files(folder),
        "report": words_of_report(folder),
    })
}

/// Removes these keys wherever they are.
fn without(value: &mut Value, keys: &[&str]) {
    match value {
        Value::Object(table) => {
            table.retain(|key, _| !keys.contains(&key.as_str()));
            table.values_mut().for_each(|own| without(own, keys));
        }
        Value::Array(items) => items.iter_mut().for_each(|item| without(item, keys)),
        _ => (),
    }
}

fn datasets<T>(folder: &Path, names: &BTreeMap<String, T>) -> Map<String, Value> {
    let store = StudyFolder::open(folder).unwrap();
    let read =
        |name: &String| store.read_dataset(name).map(|dataset| (name.clone(), snapshot::dataset(&dataset)));
    names.keys().filter_map(|name| read(name).ok()).collect()
}

/// Every file of a study by its path: tables and documents with what they hold, others by their hash, figures and pages by their path alone.
fn files(folder: &Path) -> Map<String, Value> {
    let mut files = Map::new();
    for path in files_below(folder).iter().filter(|path| path.is_file()) {
        let name = path.strip_prefix(folder).unwrap().to_str().unwrap().replace('\\', "/");
        let content = std::fs::read(path).unwrap();
        let ending = name.rsplit('.').next().unwrap_or_default();
        let held = match (name.as_str(), ending) {
            (".judder.lock", _) => continue,
            ("summary.json" | "manifest.json" | "report.html", _) | (_, "svg" | "png") => json!({}),
            (name, _) if name.starts_with("results.zarr/") => json!({}),
            (_, "csv") if !name.starts_with("fields/") => {
                snapshot::table(&String::from_utf8(content).unwrap())
            }
            (_, "json") => snapshot::document(&serde_json::from_slice(&content).unwrap()),
            _ => json!({ FLOAT_HASH: content_hash(&content) }),
        };
        files.insert(name, held);
    }
    files
}

/// What the report says of results, in headings, captions and tables.
fn words_of_report(folder: &Path) -> Vec<String> {
    let page = std::fs::read_to_string(folder.join("report.html")).unwrap();
    let mut words = snapshot::words(&page);
    words.retain(|line| !LINES_OF_THE_MACHINE.iter().any(|start| line.starts_with(start)));
    words
}

/// Model and kind of everything that the schema knows.
fn known_kinds() -> BTreeSet<(String, String)> {
    let schema = Desk::new().succeed(&["schema"]).json();
    let word = |value: &Value| value.as_str().unwrap().to_owned();
    let models = schema["oneOf"].as_array().unwrap().iter().map(|model| &model["properties"]);
    let kinds = models.flat_map(|model| {
        let kinds = model["analysis"]["items"]["oneOf"].as_array().unwrap();
        kinds.iter().map(|kind| (word(&model["model"]["const"]), word(&kind["properties"]["kind"]["const"])))
    });
    kinds.collect()
}

/// Model and kind of every analysis of a resolved case.
fn kinds_of(case: &Value) -> impl Iterator<Item = (String, String)> {
    let analyses = case["analysis"].as_array().unwrap();
    analyses
        .iter()
        .map(|own| (case["model"].as_str().unwrap().to_owned(), own["kind"].as_str().unwrap().to_owned()))
}

/// How what the analyses left in the summary differs from what they declare.
fn declared_otherwise(file: &CaseFile, report: &RunReport) -> Vec<String> {
    let kinds = kinds_of(&report.summary.case);
    let analyses = file.case.analysis_names().into_iter().zip(kinds).enumerate();
    let misfits = analyses.filter_map(|(index, (name, (model, kind)))| {
        let results = report.summary.results.get(name)?;
        Some(declared::misfits(&format!("{model} {kind}"), &file.case.summary_keys(index), results))
    });
    misfits.flatten().collect()
}

/// Columns of numbers of tables of analyses whose head has no unit, neither has the row's; `unit` is a column of its own.
fn bare_heads(report: &RunReport) -> Vec<String> {
    let view = StudyView::open(judder_models::REGISTRY, &report.folder).unwrap();
    let is_number = |cell: &String| cell.replace('−', "-").parse::<f64>().is_ok_and(|own| own.fract() != 0.0);
    let bare = |caption: &str, head: &[String], rows: &[Vec<String>]| {
        let has_unit = |text: &String| text.contains('(');
        let lacks = |column: usize| {
            let lack = |row: &Vec<String>| is_number(&row[column]) && !has_unit(&row[0]);
            rows.iter().any(lack) && !has_unit(&head[column.min(head.len() - 1)])
        };
        let columns = rows.first().map_or(0, Vec::len);
        let lacking = (0..columns).filter(|column| !head.contains(&"unit".to_owned()) && lacks(*column));
        lacking.map(|column| format!("{caption}: {:?}", head.get(column))).collect::<Vec<_>>()
    };
    let of_analysis = |name: &String| {
        let tables = view.reported(name, &Silent).unwrap().tables;
        tables.iter().flat_map(|own| bare(&own.caption, &own.head, &own.rows)).collect::<Vec<_>>()
    };
    let names = report.summary.analyses.keys().filter(|name| {
        report.summary.results.get(*name).is_some_and(|results| !results.contains_key("quantities"))
    });
    names.flat_map(of_analysis).collect()
}

/// A small case that was run.
struct Compared {
    /// Model and kind of its analyses.
    kinds: Vec<(String, String)>,
    /// How its study differs from the frozen one.
    difference: Option<String>,
    /// How its results differ from what is declared of them.
    misfits: Vec<String>,
    /// Heads of tables that lack a unit.
    bare_heads: Vec<String>,
}

fn compared(path: &Path) -> Compared {
    let case = judder_models::read(path, &[]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let report = run(&case, folder.path(), &RunOptions::default(), &Silent).unwrap();
    let name = format!("studies/{}.json", case.name);
    let numbers = match report.summary.case["model"].as_str() {
        Some("assembly" | "structure") => Numbers::Factored,
        _ => Numbers::Close,
    };
    let difference = file::difference(&name, &frozen(&case, &report), numbers);
    let kinds = kinds_of(&report.summary.case).collect();
    Compared {
        kinds,
        difference,
        misfits: declared_otherwise(&case, &report),
        bare_heads: bare_heads(&report),
    }
}

#[test]
fn studies_of_small_cases_hold_what_they_held() {
    let compared: Vec<_> = case_files(&small_cases()).par_iter().map(|path| compared(path)).collect();
    let kinds: BTreeSet<_> = compared.iter().flat_map(|own| own.kinds.iter().cloned()).collect();
    let missing: Vec<_> = known_kinds().difference(&kinds).cloned().collect();
    assert!(missing.is_empty(), "no small case has {missing:?}");
    let differences: Vec<&str> = compared.iter().filter_map(|own| own.difference.as_deref()).collect();
    assert!(differences.is_empty(), "{}", differences.join("\n"));
    let misfits: Vec<&str> = compared.iter().flat_map(|own| own.misfits.iter().map(String::as_str)).collect();
    assert!(misfits.is_empty(), "{}", misfits.join("\n"));
    let bare: Vec<&str> = compared.iter().flat_map(|own| own.bare_heads.iter().map(String::as_str)).collect();
    assert!(bare.is_empty(), "heads of numbers without a unit:\n{}", bare.join("\n"));
}
