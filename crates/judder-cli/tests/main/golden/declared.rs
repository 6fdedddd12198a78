//! Whether what analyses leave in a summary is what they declare.

use judder_store::{Declared, ValueKind};
use serde_json::{Map, Value};

/// What of a table at a place is not declared, what that is declared is missing, and what is of another kind.
pub(super) fn misfits(place: &str, declared: &[Declared], table: &Map<String, Value>) -> Vec<String> {
    let is_declared = |key: &str| declared.iter().any(|own| own.name == key);
    let undeclared = table.keys().filter(|key| !is_declared(key));
    let undeclared = undeclared.map(|key| format!("{place}.{key} is not declared"));
    let of_declared = declared.iter().flat_map(|Declared { name, kind, is_optional, .. }| {
        let place = format!("{place}.{name}");
        match table.get(name) {
            Some(value) => misfits_of(&place, kind, value),
            None if *is_optional => Vec::new(),
            None => vec![format!("{place} is missing")],
        }
    });
    undeclared.chain(of_declared).collect()
}

fn misfits_of(place: &str, kind: &ValueKind, value: &Value) -> Vec<String> {
    match (kind, value) {
        (_, Value::Null)
        | (ValueKind::Number | ValueKind::Count, Value::Number(_))
        | (ValueKind::Truth, Value::Bool(_))
        | (ValueKind::Word, Value::String(_)) => Vec::new(),
        (ValueKind::List(own), Value::Array(items)) => {
            items.iter().flat_map(|item| misfits_of(place, own, item)).collect()
        }
        (ValueKind::ByName(own), Value::Object(table)) => {
            table.values().flat_map(|item| misfits_of(place, own, item)).collect()
        }
        (ValueKind::Object(keys), Value::Object(table)) => misfits(place, keys, table),
        _ => vec![format!("{place} is declared as {kind:?}, but is {value}")],
    }
}
