//! The JSON Schema of case files, so that editors complete and check: generated from the table of keys.

mod contact;
mod sliding;
mod structure;
mod sweep;

pub(crate) use sliding::key_sweep;

use serde_json::{Map, Value as Json, json};

use crate::case::analysis::Kind;
use crate::models::belt::case as belt_case;
use crate::models::belt::case::{BELT_KEYS, BELT_SECTIONS};
use crate::models::contact::settings::LawSettings;
use crate::models::oscillator;
use crate::models::oscillator::case::SECTIONS;
use crate::models::oscillator::inputs::{FrictionLoad, LawName};
use crate::models::oscillator::keys::KEYS;
use crate::models::substrate::SubstrateKeys;
use crate::models::sweep::Scale;
use crate::models::two_degrees::case as two_degrees;
use judder_keys::declared::{Declaration, Settings};
use judder_keys::schema::{choice, key, names, object, reference, table, with_declared};

/// The JSON Schema (draft 2020-12) of case files of all models, with descriptions and defaults.
///
/// It knows names, types, signs and defaults; units and conditions between keys are checked by reading the case.
pub fn schema() -> Json {
    let mut definitions = json!({
        "points": { "type": "integer", "minimum": 2, "description": "number of points, both ends included" },
        "oscillator-key": names(KEYS.iter().map(|entry| entry.path), "dotted path of a numeric key"),
        "scale": choice(Scale::ALL.map(|(name, _)| name), "linear", "spacing of the points"),
        "sweeps": sweep::sweeps(),
    });
    for entry in &KEYS {
        definitions[entry.path] = key(entry);
    }
    definitions["belt-key"] = names(BELT_KEYS.iter().map(|entry| entry.path), "dotted path of a key");
    for entry in &BELT_KEYS {
        definitions[belt_definition(entry.path)] = key(entry);
    }
    let mut json = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A case of judder",
        "type": "object",
        "required": ["model"],
        "oneOf": [
            oscillator(), contact::case(), belt(), two_degrees_case(), structure::case(), sliding::case(),
        ],
        "$defs": definitions,
    });
    json.sort_all_objects();
    json
}

fn oscillator() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "oscillator" })),
        ("analysis", analyses(&oscillator::KINDS)),
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
                let file = object([("file", contact::file("a law that was computed earlier"))]);
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

fn belt() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "belt" })),
        ("analysis", analyses(&belt_case::KINDS)),
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

fn two_degrees_case() -> Json {
    let entry = json!({ "type": ["number", "string"] });
    let row = json!({ "type": "array", "items": entry, "minItems": 2, "maxItems": 2 });
    let matrix = |description: &str| json!({ "type": "array", "items": row, "minItems": 2, "maxItems": 2, "description": description });
    let matrices = object([
        ("mass", matrix("M, 2×2 numbers or expressions; the identity by default")),
        ("damping", matrix("C; zero by default")),
        ("stiffness", matrix("K")),
    ]);
    let properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "two-degrees" })),
        ("parameters", json!({ "type": "object", "additionalProperties": { "type": "number" } })),
        ("matrices", table("M, C and K", matrices, &["stiffness"])),
        ("analysis", analyses(&two_degrees::KINDS)),
        ("sweep", reference("sweeps")),
    ]);
    table("two degrees of freedom with given matrices", properties, &["model", "matrices"])
}

/// The name of an analysis, which is that of its kind where it has none.
fn name_of(kind: &str) -> Json {
    json!({ "type": "string", "pattern": "^[A-Za-z0-9_-][A-Za-z0-9._-]{0,99}$", "default": kind })
}

/// The list of analyses: one alternative a kind.
fn analyses<S, T>(kinds: &[Kind<S, T>]) -> Json {
    let alternatives = kinds.iter().map(|kind| {
        let own = [("kind", json!({ "const": kind.name })), ("name", name_of(kind.name))];
        with_declared(kind.doc, object(own), &(kind.declared)(), &["kind"])
    });
    json!({ "type": "array", "items": { "oneOf": alternatives.collect::<Vec<_>>() } })
}

/// A key over a range.
fn sweep(key: Json, end: &Json, description: &str) -> Json {
    let entries = [
        ("key", key),
        ("from", end.clone()),
        ("to", end.clone()),
        ("points", reference("points")),
        ("scale", reference("scale")),
    ];
    table(description, object(entries), &["key", "from", "to", "points"])
}
