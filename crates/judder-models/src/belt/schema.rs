//! The schema of a belt case.

use super::case::{BELT_KEYS, BELT_SECTIONS, KINDS};
use judder_keys::schema::{key, names, object, reference, table};
use judder_study::case::schema::analyses;
use serde_json::{Value as Json, json};

/// The definitions that other parts of the schema name.
pub(super) fn definitions() -> Vec<(String, Json)> {
    let all = names(BELT_KEYS.iter().map(|entry| entry.path), "dotted path of a key");
    let each = BELT_KEYS.iter().map(|entry| (belt_definition(entry.path), key(entry)));
    each.chain([("belt-key".to_owned(), all)]).collect()
}

pub(super) fn case() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "belt" })),
        ("analysis", analyses(&KINDS)),
        ("sweep", reference("sweeps")),
    ]);
    for section in BELT_SECTIONS {
        let entries = BELT_KEYS.iter().filter(|entry| entry.section() == section);
        let keys =
            entries.map(|entry| (entry.name().to_owned(), reference(&belt_definition(entry.path)))).collect();
        properties.insert(section.to_owned(), table("", keys, &[]));
    }
    table("one mass on a moving belt, friction that falls with speed", properties, &["model"])
}

/// The name of a belt's key among the definitions: it shares paths with the oscillator's.
fn belt_definition(path: &str) -> String {
    format!("belt.{path}")
}
