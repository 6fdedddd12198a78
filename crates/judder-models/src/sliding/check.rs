//! What `judder check` shows of a sliding case: every key with the value in use, the pair, the limits of its steps.

mod pair;

use super::SlidingSubject;
use super::march::MarchSize;
use crate::error::ModelError;
use crate::estimate::{estimate_json, estimate_text, title};
use crate::sliding::case::SlidingCase;
use crate::sliding::march::settings::MarchAnalysis;
use crate::sliding::system::ReducedPair;
use judder_keys::memory::Memory;
use judder_study::case::text::CaseText;
use judder_study::model::estimates;
use judder_study::resolve::Resolved;
use judder_study::text::{columns, number};
use serde_json::{Map, Value, json};

/// The most values of a list that are shown one by one.
const SHOWN: usize = 8;

/// The keys of a sliding case with their values, and what is known of its pair.
///
/// # Errors
/// Structures that cannot be, or cannot slide on each other, and analyses that would be refused, at their places in the case.
pub(super) fn resolve(file: &CaseText, case: &SlidingCase, resolved: Value) -> Result<Resolved, ModelError> {
    let system = ReducedPair::new(case).map_err(|uncoupled| uncoupled.placed(file))?;
    let estimates = estimates(case, file, |name| SlidingSubject { case, system: &system, name })?;
    let mut text = format!("{}\n\n", title(&case.title));
    let mut rows = Vec::new();
    for section in ["parameters", "structure", "contact", "motion", "observe", "analysis"] {
        add_rows(section, &resolved[section], &mut rows);
    }
    text.push_str(&columns(&rows));
    let known = pair::known(case, &system);
    text.push_str(&known.text);
    text.push_str(&estimate_text(&estimates));
    let (samples, kept) = kept(case, &system);
    text.push_str(&kept);
    for warning in &known.warnings {
        text.push_str(&format!("\nwarning: {warning}\n"));
    }
    let mut document = json!({ "case": resolved, "estimate": estimate_json(&estimates), "samples": samples, "warnings": known.warnings });
    if let (Value::Object(document), Value::Object(pair)) = (&mut document, known.document) {
        document.extend(pair);
    }
    Ok(Resolved { document, text })
}

/// What marches keep in the study folder.
fn kept(case: &SlidingCase, system: &ReducedPair) -> (Value, String) {
    let mut document = Map::new();
    let mut rows = Vec::new();
    for analysis in &case.analyses {
        let Some(march) = analysis.settings::<MarchAnalysis>() else { continue };
        let Some(size) = MarchSize::of(system, march) else { continue };
        let (samples, bytes) = (size.samples as u64, size.stored() as u64);
        let words = [format!("{samples} samples"), format!("{} signals", size.signals)];
        rows.push([vec![analysis.name.clone()], words.to_vec(), vec![Memory { bytes }.to_string()]].concat());
        let told = json!({ "samples": samples, "signals": size.signals, "bytes": bytes });
        document.insert(analysis.name.clone(), told);
    }
    let text =
        if rows.is_empty() { String::new() } else { format!("\nwhat marches keep\n{}", columns(&rows)) };
    (Value::Object(document), text)
}

/// A row a value, with its dotted path.
fn add_rows(path: &str, value: &Value, rows: &mut Vec<Vec<String>>) {
    match value {
        Value::Object(table) if !is_quantity(table) => {
            for (key, value) in table.iter().filter(|(key, _)| *key != "name") {
                add_rows(&format!("{path}.{key}"), value, rows);
            }
        }
        Value::Array(items) if items.iter().any(|item| item.get("name").is_some()) => {
            for item in items {
                let name = item["name"].as_str().unwrap_or_default();
                add_rows(&format!("{path}.{name}"), item, rows);
            }
        }
        value => rows.extend(shown(value).map(|shown| vec![path.to_owned(), shown])),
    }
}

fn is_quantity(table: &Map<String, Value>) -> bool {
    table.contains_key("unit")
}

/// A value in words; `None` where there is none.
fn shown(value: &Value) -> Option<String> {
    match value {
        Value::Null => None,
        Value::String(text) => Some(text.clone()),
        Value::Object(table) if is_quantity(table) => {
            Some(format!("{} {}", number(table["value"].as_f64()?), table["unit"].as_str()?))
        }
        Value::Array(items) if items.is_empty() => None,
        Value::Array(items) if items.len() > SHOWN => {
            Some(format!("{} … {} ({} values)", shown(items.first()?)?, shown(items.last()?)?, items.len()))
        }
        Value::Array(items) => Some(items.iter().filter_map(shown).collect::<Vec<_>>().join(", ")),
        value => Some(value.to_string()),
    }
}
