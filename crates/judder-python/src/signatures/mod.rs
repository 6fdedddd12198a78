//! The models as Python sees them: a class each, a method for every kind of analysis, with the names, types and docs that follow from the
//! declarations by which case files are read.

pub(crate) mod annotation;
pub(crate) mod key;

use judder_keys::declared::told as told_keys;
use judder_models::{declared_of, kinds_of, schema};
use judder_study::case::analysis::KindEntry;
use key::{SignatureKey, capitalised, wrapped};
use serde_json::{Value as Json, json};

/// A class, or a method.
pub(crate) struct Callable {
    /// Its name in Python.
    pub(crate) name: String,
    /// The model, or the kind of analysis.
    pub(crate) of: String,
    /// Its docs: what it is, in a sentence, then what it takes.
    pub(crate) doc: String,
    /// What it takes besides what all take.
    pub(crate) parameters: Vec<KeywordArgument>,
    /// The methods of a class.
    pub(crate) methods: Vec<Callable>,
}

/// A key as a keyword argument.
pub(crate) struct KeywordArgument {
    /// Its name in Python.
    pub(crate) name: String,
    /// Its name in a case file.
    pub(crate) key: String,
    /// Its type; that of one that may be left out allows `None`.
    pub(crate) annotation: String,
    /// Whether it must be given.
    pub(crate) is_required: bool,
}

/// The classes, in the order of the schema.
pub(crate) fn classes() -> Vec<Callable> {
    let schema = schema();
    let cases = schema["oneOf"].as_array().into_iter().flatten();
    cases.map(|case| class(case, &schema["$defs"])).collect()
}

/// What stands before the keys of a case.
const CASE: &str = "        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
";

fn class(case: &Json, definitions: &Json) -> Callable {
    let model = case["properties"]["model"]["const"].as_str().unwrap_or_default();
    let properties = case["properties"].as_object().into_iter().flatten().filter(|(key, _)| *key != "model");
    let declared = declared_of(model);
    let keys = told_keys(&declared);
    let sections: Vec<SignatureKey> = properties
        .map(|(key, schema)| SignatureKey::of_case(key, schema, case, definitions, &keys))
        .collect();
    let told: String = sections.iter().map(|section| section.entry(8)).collect();
    let summary = format!("{}.", capitalised(case["description"].as_str().unwrap_or_default()));
    Callable {
        name: model.split('-').map(capitalised).collect(),
        of: model.to_owned(),
        doc: format!("{}\n    Args:\n{CASE}{told}", wrapped(&summary, 4, 4)),
        // a case may begin with what it must have
        parameters: sections.iter().map(|section| parameter(section, false, definitions)).collect(),
        methods: kinds_of(model).map(|kind| method(&kind, definitions)).collect(),
    }
}

fn method(kind: &KindEntry, definitions: &Json) -> Callable {
    let declared = (kind.declared)();
    let keys: Vec<SignatureKey> = told_keys(&declared).iter().map(SignatureKey::declared).collect();
    let told: String = keys.iter().map(|key| key.entry(12)).collect();
    let summary = format!("{}.", capitalised(kind.doc));
    let head = wrapped(&summary, 8, 8);
    Callable {
        name: kind.name.replace('-', "_"),
        of: kind.name.to_owned(),
        doc: format!(
            "{head}\n        Args:\n{told}            threads, progress: as of :func:`judder.run`.\n"
        ),
        parameters: keys.iter().map(|key| parameter(key, key.is_required, definitions)).collect(),
        methods: Vec::new(),
    }
}

fn parameter(key: &SignatureKey, is_required: bool, definitions: &Json) -> KeywordArgument {
    let annotation = annotation::of(&key.schema, definitions);
    KeywordArgument {
        name: key.parameter(),
        key: key.name.clone(),
        annotation: if is_required { annotation } else { format!("{annotation} | None") },
        is_required,
    }
}

impl Callable {
    /// As a document.
    pub(crate) fn document(&self) -> Json {
        let parameter = |own: &KeywordArgument| json!([own.name, own.key, own.annotation, own.is_required]);
        json!({
            "name": self.name, "of": self.of, "doc": self.doc,
            "parameters": self.parameters.iter().map(parameter).collect::<Vec<_>>(),
            "methods": self.methods.iter().map(Self::document).collect::<Vec<_>>(),
        })
    }
}
