//! The schema of an oscillator case.

use super::KINDS;
use super::case::SECTIONS;
use super::inputs::{FrictionLoad, LawName};
use super::keys::KEYS;
use crate::contact::schema::file;
use crate::contact::settings::LawSettings;
use crate::substrate::SubstrateKeys;
use judder_keys::declared::{Declaration, Settings};
use judder_keys::schema::{choice, key, names, object, reference, table};
use judder_study::case::schema::analyses;
use serde_json::{Map, Value as Json, json};

/// The definitions that other parts of the schema name.
pub(super) fn definitions() -> Vec<(String, Json)> {
    let all = names(KEYS.iter().map(|entry| entry.path), "dotted path of a numeric key");
    let each = KEYS.iter().map(|entry| (entry.path.to_owned(), key(entry)));
    each.chain([("oscillator-key".to_owned(), all)]).collect()
}

pub(super) fn case() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "oscillator" })),
        ("analysis", analyses(&KINDS)),
        ("sweep", reference("sweeps")),
    ]);
    for section in SECTIONS {
        let entries = KEYS.iter().filter(|entry| entry.section() == section);
        let mut keys: Map<_, _> =
            entries.map(|entry| (entry.name().to_owned(), reference(entry.path))).collect();
        match section {
            "substrate" => {
                let declared = SubstrateKeys::declarations();
                keys.extend(declared.iter().map(|key| (key.name.to_owned(), key.schema())));
            }
            "contact" => {
                let words = choice(LawName::ALL.map(|(name, _)| name), "oscillator-paper", "contact law");
                let file = object([("file", file("a law that was computed earlier"))]);
                let file = table("a law from a file", file, &["file"]);
                let computed = object([
                    ("computed", json!({ "const": true })),
                    ("accuracy", Declaration::find(&LawSettings::declarations(), "accuracy")),
                ]);
                let computed = table("the law `bem`, with its accuracy", computed, &["computed"]);
                let laws = json!({ "anyOf": [words, file, computed], "default": "oscillator-paper" });
                let loads = FrictionLoad::ALL.map(|(name, _)| name);
                let loads = choice(loads, "normal-load", "the force that μ_visc multiplies");
                keys.extend(object([("law", laws), ("friction_load", loads)]));
            }
            _ => (),
        }
        properties.insert(section.to_owned(), table("", keys, &[]));
    }
    table("the oscillator of the oscillator paper", properties, &["model"])
}
