//! The JSON Schema of case files, so that editors complete and check: generated from the table of keys.

mod contact;
mod motion;
mod sliding;
mod structure;
mod sweep;

pub(crate) use sliding::key_sweep;

use serde_json::{Map, Value as Json, json};

use crate::analysis::Kind;
use crate::belt_case::BELT_KEYS;
use crate::contact_analysis::LawSettings;
use crate::declared::{Declaration, Settings};
use crate::inputs::{FrictionLoad, LawName};
use crate::keys::{KEYS, Key, OscillatorKey, Range};
use crate::motion_analysis::BASIN;
use crate::oscillator_analysis::{LOAD_WITHIN, MARGIN_OF_MAP, MARGIN_OF_THRESHOLDS, SHEAR_STRENGTH_WITHIN};
use crate::oscillator_case::SECTIONS;
use crate::substrate::SubstrateKeys;
use crate::sweep::{MapMethod, Scale};
use crate::swept_keys::OscillatorKeys;
use crate::two_degrees::CRITICAL_POINTS;
use crate::{oscillator_analysis, two_degrees};

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
        definitions[motion::definition(entry.path)] = key(entry);
    }
    let mut json = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A case of judder",
        "type": "object",
        "required": ["model"],
        "oneOf": [
            oscillator(), contact::case(), motion::belt_case(), two_degrees_case(), structure::case(), sliding::case(),
        ],
        "$defs": definitions,
    });
    json.sort_all_objects();
    json
}

/// A table with these keys and no others.
fn table(description: &str, properties: Map<String, Json>, required: &[&str]) -> Json {
    json!({
        "type": "object", "description": description, "properties": properties, "required": required,
        "additionalProperties": false,
    })
}

fn object<const N: usize>(entries: [(&str, Json); N]) -> Map<String, Json> {
    entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

fn names<'a>(names: impl IntoIterator<Item = &'a str>, description: &str) -> Json {
    json!({ "enum": names.into_iter().collect::<Vec<_>>(), "description": description })
}

fn choice<const N: usize>(choices: [&str; N], default: &str, description: &str) -> Json {
    let mut json = names(choices, description);
    json["default"] = json!(default);
    json
}

fn reference(definition: &str) -> Json {
    json!({ "$ref": format!("#/$defs/{definition}") })
}

/// A plain number in a range.
pub(crate) fn plain_number(range: Range) -> Json {
    let mut json = match range {
        Range::Positive => json!({ "exclusiveMinimum": 0.0 }),
        Range::NonNegative => json!({ "minimum": 0.0 }),
        Range::Fraction => json!({ "minimum": 0.0, "exclusiveMaximum": 1.0 }),
        Range::Any => json!({}),
        Range::Interval { above, up_to } => json!({ "exclusiveMinimum": above, "maximum": up_to }),
    };
    json["type"] = json!("number");
    json
}

/// What a numeric key takes: a group, a quantity in quotes, or either.
pub(crate) fn scaled_number<K>(entry: &Key<K>) -> Json {
    let mut forms = Vec::new();
    if let Some(group) = entry.group {
        let mut form = plain_number(entry.range);
        form["description"] = json!(group);
        forms.push(form);
    }
    if !entry.dimension.is_number() {
        let example = entry.example();
        let examples: Vec<_> = example.split("\" or \"").collect();
        forms.push(json!({
            "type": "string", "description": entry.dimension.to_string(), "examples": examples,
        }));
    }
    json!({ "anyOf": forms })
}

/// A numeric key of a table of keys.
fn key<K>(entry: &Key<K>) -> Json {
    let mut json = scaled_number(entry);
    json["description"] = json!(format!("{}: {}", entry.symbol, entry.doc));
    if let Some((text, value)) = entry.default {
        json["default"] = if entry.group.is_some() { json!(value.number) } else { json!(text) };
    }
    json
}

fn oscillator() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "oscillator" })),
        ("analysis", analyses(&oscillator_analysis::KINDS, oscillator_setting)),
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
        ("analysis", analyses(&two_degrees::KINDS, two_degrees_setting)),
        ("sweep", reference("sweeps")),
    ]);
    table("two degrees of freedom with given matrices", properties, &["model", "matrices"])
}

/// The name of an analysis, which is that of its kind where it has none.
fn name_of(kind: &str) -> Json {
    json!({ "type": "string", "pattern": "^[A-Za-z0-9_-][A-Za-z0-9._-]{0,99}$", "default": kind })
}

/// A table of declared settings.
pub(crate) fn declared_table(description: &str, keys: &[Declaration]) -> Json {
    with_declared(description, Map::new(), keys, &[])
}

/// A table of declared settings beside other keys.
fn with_declared(
    description: &str,
    mut properties: Map<String, Json>,
    keys: &[Declaration],
    required: &[&str],
) -> Json {
    properties.extend(keys.iter().map(|key| (key.name.to_owned(), key.schema())));
    let own = keys.iter().filter(|key| key.must_stand()).map(|key| key.name);
    let required: Vec<&str> = required.iter().copied().chain(own).collect();
    let mut json = table(description, properties, &required);
    let of_alternative = |index: usize| -> Vec<&str> {
        let own = keys.iter().filter(|key| key.is_required && key.alternative == Some(index));
        own.map(|key| key.name).collect()
    };
    // where no key of any is given, the first alternative is meant
    if !of_alternative(0).is_empty() {
        let last = keys.iter().filter_map(|key| key.alternative).max().unwrap_or(0);
        json["oneOf"] = (0..=last).map(|index| json!({ "required": of_alternative(index) })).collect();
    }
    json
}

/// The list of analyses: one alternative a kind.
fn analyses<S, T>(kinds: &[Kind<S, T>], setting: impl Fn(&str, &str) -> Json) -> Json {
    let alternatives = kinds.iter().map(|kind| {
        let own = [("kind", json!({ "const": kind.name })), ("name", name_of(kind.name))];
        if let Some(declared) = kind.declared {
            return with_declared(kind.doc, object(own), &declared(), &["kind"]);
        }
        let mut properties = object(own);
        properties.extend(kind.keys.iter().map(|key| ((*key).to_owned(), setting(kind.name, key))));
        let needed = |key: &&&str| match (kind.name, **key) {
            ("eigen-sweep", "region") | (_, "sweep" | "x" | "y") => true,
            (name, key) => key == "within" && name == BASIN.name,
        };
        let required: Vec<_> = ["kind"].iter().chain(kind.keys.iter().filter(needed)).copied().collect();
        table(kind.doc, properties, &required)
    });
    json!({ "type": "array", "items": { "oneOf": alternatives.collect::<Vec<_>>() } })
}

/// A setting that both models share.
fn map_setting(key: &str) -> Json {
    match key {
        "method" => choice(MapMethod::ALL.map(|(name, _)| name), "adaptive", "how points are decided"),
        _ => {
            json!({ "type": "boolean", "default": true, "description": "trace the boundary curves as well" })
        }
    }
}

fn sweep(key: Json, end: &Json, description: &str, points: Option<usize>) -> Json {
    let entries = [
        ("key", key),
        ("from", end.clone()),
        ("to", end.clone()),
        ("points", reference("points")),
        ("scale", reference("scale")),
    ];
    let required: &[&str] =
        if points.is_some() { &["key", "from", "to"] } else { &["key", "from", "to", "points"] };
    let mut properties = object(entries);
    if let Some(points) = points {
        properties["points"]["default"] = json!(points);
    }
    table(description, properties, required)
}

fn oscillator_setting(kind: &str, key: &str) -> Json {
    let end =
        json!({ "type": ["number", "string"], "description": "a group, or a quantity with the key's unit" });
    if let Some(setting) = motion::setting::<OscillatorKeys>(kind, key) {
        return setting;
    }
    match key {
        "sweep" | "x" | "y" => sweep(reference("oscillator-key"), &end, "a numeric key over a range", None),
        "family" => {
            let values = json!({ "type": "array", "items": end, "minItems": 1 });
            let entries = object([("key", reference("oscillator-key")), ("values", values)]);
            table("one curve a value of another key", entries, &["key", "values"])
        }
        "within" => {
            let (sought, default) = match kind {
                "critical-load" => (OscillatorKey::NormalLoad, LOAD_WITHIN),
                _ => (OscillatorKey::ShearStrength, SHEAR_STRENGTH_WITHIN),
            };
            let end = reference(sought.entry().path);
            let mut json = table(
                "where roots are sought",
                object([("from", end.clone()), ("to", end)]),
                &["from", "to"],
            );
            json["default"] = json!({ "from": default.0, "to": default.1 });
            json
        }
        "global_margin" => {
            let default = if kind == "stability-map" { MARGIN_OF_MAP } else { MARGIN_OF_THRESHOLDS };
            let description = "follow the cycles from subcritical thresholds back to their fold";
            json!({ "type": "boolean", "default": default, "description": description })
        }
        _ => map_setting(key),
    }
}

fn two_degrees_setting(kind: &str, key: &str) -> Json {
    let name = json!({ "type": "string", "description": "parameters.NAME" });
    let points = (kind == "critical").then_some(CRITICAL_POINTS);
    match key {
        "sweep" | "x" | "y" => sweep(name, &json!({ "type": "number" }), "a parameter over a range", points),
        _ => map_setting(key),
    }
}
