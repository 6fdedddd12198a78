//! `judder._keys`: what functions on arrays take that are keys of a case.

use crate::signatures::annotation;
use crate::signatures::key::{SignatureKey, capitalised, wrapped};
use judder_keys::keys::Keys;
use judder_keys::memory::Memory;
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::{kinds_of, schema};
use serde_json::Value as Json;
use std::collections::BTreeMap;

const HEAD: &str = r#""""What functions on arrays take that are keys of a case.

The tests write it from the declarations by which case files are read: ``JUDDER_GOLDEN=write cargo nextest run -p judder-python``.
"""

from __future__ import annotations

from typing import Final, Literal, TypeAlias, TypedDict

"#;

/// What the reference says that a key of a file may be.
const FILE_WORDS: &str = "a path relative to the case file";
const FILES_DOC: &str = r#""""The keys of each model that name a file, by their dotted paths, ``*`` for an item or a name; and what may stand beside a key ``file``.""""#;
const ROWS_DOC: &str = r#""""Lists of tables of nothing but numbers, by their dotted paths.""""#;

/// Defaults that functions on arrays share with keys of analyses: model, kind, key.
const DEFAULTS: [(&str, [&str; 3]); 5] = [
    ("CONTACT_ACCURACY", ["contact", "contact", "accuracy"]),
    ("CONTACT_MEMORY", ["contact", "contact", "memory_limit"]),
    ("LOCUS_CONFIGURATION", ["sliding", "locus", "configuration"]),
    ("LOCUS_COUNT", ["sliding", "locus", "count"]),
    ("LOCUS_DAMPING", ["sliding", "locus", "damping"]),
];

/// The sections of an oscillator case whose numbers are arguments by their last names.
const SECTIONS: [&str; 5] = ["operation", "contact", "oscillator", "indenter", "substrate"];

/// The module.
pub(super) fn module() -> String {
    let schema = schema();
    let definitions = &schema["$defs"];
    let sections = &schema["oneOf"][0]["properties"];
    let keys = |section: &str| sections[section]["properties"].as_object().unwrap();
    let is_swept =
        |section: &str, name: &str| OscillatorKey::of_section(section).any(|own| own.name() == name);
    let of_section = |section: &&'static str| {
        keys(section).iter().filter(|(name, _)| is_swept(section, name)).collect::<Vec<_>>()
    };
    let numbers = SECTIONS.iter().flat_map(of_section);
    let fields: String = numbers
        .map(|(name, schema)| {
            let key = SignatureKey::of_case(name, schema, &Json::Null, definitions, &[]);
            let doc = format!("\"\"\"{}.\"\"\"", key.told.words);
            format!("    {name}: {}\n{}", annotation::of(&key.schema, definitions), wrapped(&doc, 4, 4))
        })
        .collect();
    let contact = keys("contact");
    let configuration = &declared(["sliding", "locus", "configuration"]);
    let [method, predictor] = &["method", "predictor"].map(|key| declared(["sliding", "march", key]));
    let aliases: String = [
        ("LawName", &contact["law"]["anyOf"][0], &contact["law"]),
        ("FrictionLoad", &contact["friction_load"], &contact["friction_load"]),
        ("Configuration", configuration, configuration),
        ("MarchMethod", method, method),
        ("Predictor", predictor, predictor),
    ]
    .map(|(name, schema, said)| {
        let doc = capitalised(said["description"].as_str().unwrap()).replace('`', "``");
        format!("{name}: TypeAlias = {}\n\"\"\"{doc}.\"\"\"\n", annotation::of(schema, definitions))
    })
    .concat();
    let defaults: String = DEFAULTS
        .map(|(name, key)| format!("{name}: Final = {}\n", literal(&declared(key)["default"])))
        .concat();
    let words = "\"\"\"The numeric keys of an oscillator case, by their last names.\"\"\"";
    let inputs = files_and_rows(&schema);
    format!(
        "{HEAD}{aliases}{defaults}{inputs}\n\nclass Keys(TypedDict, total=False):\n    {words}\n\n{fields}"
    )
}

/// Where objects of Python may stand in the place of files, and columns in the place of lists of tables, model by model.
fn files_and_rows(schema: &Json) -> String {
    let (mut files, mut rows) = (String::new(), String::new());
    for case in schema["oneOf"].as_array().unwrap() {
        let model = case["properties"]["model"]["const"].as_str().unwrap();
        let keys = judder_models::keys(model).unwrap();
        let keys: BTreeMap<&str, &Json> =
            keys.as_array().unwrap().iter().map(|key| (key["path"].as_str().unwrap(), key)).collect();
        let named = keys.iter().filter(|(_, key)| key["words"] == FILE_WORDS);
        let named: String = named
            .map(|(path, _)| {
                let beside = path.strip_suffix("file").map(|table| beside(table, &keys)).unwrap_or_default();
                format!("        \"{path}\": {},\n", tuple(&beside))
            })
            .collect();
        files += &match named.as_str() {
            "" => format!("    \"{model}\": {{}},\n"),
            _ => format!("    \"{model}\": {{\n{named}    }},\n"),
        };
        let lists = keys.iter().filter(|(_, key)| is_of_numbers(&key["form"])).map(|(path, _)| *path);
        rows += &format!("    \"{model}\": {},\n", tuple(&lists.collect::<Vec<_>>()));
    }
    format!(
        "FILES: Final[dict[str, dict[str, tuple[str, ...]]]] = {{\n{files}}}\n{FILES_DOC}\nROWS: Final[dict[str, tuple[str, ...]]] = {{\n{rows}}}\n{ROWS_DOC}\n"
    )
}

/// The other keys of a table, whose path ends with a point.
fn beside<'a>(table: &str, keys: &BTreeMap<&'a str, &Json>) -> Vec<&'a str> {
    let names = keys.keys().filter_map(|path| path.strip_prefix(table));
    names.filter(|name| *name != "file" && !name.contains('.')).collect()
}

/// Whether a form is that of a list of tables with nothing but numbers in them.
fn is_of_numbers(form: &Json) -> bool {
    let keys =
        form["of"]["keys"].as_array().filter(|_| form["kind"] == "list" && form["of"]["kind"] == "table");
    keys.is_some_and(|keys| keys.iter().all(|key| key["form"]["kind"] == "number"))
}

/// Texts as a tuple of Python.
fn tuple(texts: &[&str]) -> String {
    let comma = if texts.len() == 1 { "," } else { "" };
    let texts: Vec<String> = texts.iter().map(|text| format!("\"{text}\"")).collect();
    format!("({}{comma})", texts.join(", "))
}

/// The schema of a key of a kind of analysis.
fn declared([model, kind, key]: [&str; 3]) -> Json {
    let kind = kinds_of(model).find(|own| own.name == kind).unwrap();
    (kind.declared)().iter().find(|own| own.name == key).unwrap().schema()
}

/// A value as Python writes it; an amount of memory is a number of bytes.
fn literal(value: &Json) -> String {
    match value {
        Json::Bool(true) => "True".to_owned(),
        Json::Bool(false) => "False".to_owned(),
        Json::String(text) => {
            Memory::parse(text).map_or(value.to_string(), |memory| memory.bytes.to_string())
        }
        other => other.to_string(),
    }
}
