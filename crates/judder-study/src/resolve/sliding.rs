//! What `judder check` shows of a sliding case: every key with the value in use.

use super::{Resolved, title};
use crate::text::{columns, number};
use judder_case::{CaseFile, SlidingCase};
use serde_json::{Map, Value, json};

/// The most values of a list that are shown one by one.
const SHOWN: usize = 8;

/// The keys of a sliding case with their values.
pub(super) fn resolve(file: &CaseFile, case: &SlidingCase) -> Resolved {
    let resolved = file.case.resolved();
    let mut text = format!("{}\n\n", title(&case.title));
    let mut rows = Vec::new();
    for section in ["parameters", "structure", "contact", "motion", "observe", "analysis"] {
        add_rows(section, &resolved[section], &mut rows);
    }
    text.push_str(&columns(&rows));
    Resolved { document: json!({ "case": resolved }), text }
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
