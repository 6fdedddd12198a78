//! `judder.models`: a class a model, a method a kind of analysis.

use super::annotation;
use super::key::{Key, capitalised, wrapped};
use judder_models::{kinds_of, schema};
use judder_study::case::analysis::KindEntry;
use serde_json::Value as Json;

const HEAD: &str = r#""""The models, a class each, and in it a method for every kind of analysis: all that a case file can say, as keyword arguments.

The tests write it from the declarations by which case files are read: ``JUDDER_GOLDEN=write cargo nextest run -p judder-cli -E 'test(/golden/)'``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from judder._model import Model, Result
from judder.progress import Progress
from judder.study import CaseLike

"#;

/// The module.
pub(super) fn module() -> String {
    let schema = schema();
    let models: Vec<(String, String)> =
        schema["oneOf"].as_array().unwrap().iter().map(|case| class(case, &schema["$defs"])).collect();
    let mut names: Vec<String> = models.iter().map(|(name, _)| format!("    \"{name}\",\n")).collect();
    names.extend(["Model", "Result"].map(|name| format!("    \"{name}\",\n")));
    names.sort();
    let classes: String = models.iter().map(|(_, class)| format!("\n\n{class}")).collect();
    format!("{HEAD}__all__ = [\n{}]\n{classes}", names.concat())
}

/// The name of the class of a model, and the class.
fn class(case: &Json, definitions: &Json) -> (String, String) {
    let model = case["properties"]["model"]["const"].as_str().unwrap();
    let name: String = model.split('-').map(capitalised).collect();
    let properties = case["properties"].as_object().unwrap().iter().filter(|(key, _)| *key != "model");
    let sections: Vec<Key> =
        properties.map(|(key, schema)| Key::of_schema(key, schema, case, definitions)).collect();
    let doc = wrapped(&format!("\"\"\"{}.", capitalised(case["description"].as_str().unwrap())), 4, 4);
    let told: String = sections.iter().map(|section| section.entry(8)).collect();
    let parameters: String = sections.iter().map(|section| parameter(section, true, definitions)).collect();
    let methods: String = kinds_of(model).map(|kind| format!("\n{}", method(&kind, definitions))).collect();
    let class = format!(
        "class {name}(Model):\n{doc}\n    Args:\n{CASE}{told}    \"\"\"\n\n    _name = \"{model}\"\n\n    def __init__(\n        self,\n        \
         case: CaseLike | None = None,\n        *,\n        set: Mapping[str, Any] | None = None,\n{parameters}    ) -> None:\n        \
         keys: dict[str, Any] = {}\n        super().__init__(case, set, keys)\n{methods}",
        arguments(&sections)
    );
    (name, class)
}

const CASE: &str = "        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
";

/// The method of a kind of analysis.
fn method(kind: &KindEntry, definitions: &Json) -> String {
    let keys: Vec<Key> = (kind.declared)().iter().map(Key::declared).collect();
    let parameters: String = keys.iter().map(|key| parameter(key, !key.is_required, definitions)).collect();
    let told: String = keys.iter().map(|key| key.entry(12)).collect();
    let doc = wrapped(&format!("\"\"\"{}.", capitalised(kind.doc)), 8, 8);
    format!(
        "    def {}(\n        self,\n        *,\n{parameters}        threads: int | None = None,\n        progress: Progress | None = None,\n    \
         ) -> Result:\n{doc}\n        Args:\n{told}            threads, progress: as of :func:`judder.run`.\n        \"\"\"\n        \
         keys: dict[str, Any] = {}\n        return self._computed(\"{}\", keys, threads, progress)\n",
        kind.name.replace('-', "_"),
        arguments(&keys),
        kind.name
    )
}

/// A parameter; one that may be left out is `None` then.
fn parameter(key: &Key, is_optional: bool, definitions: &Json) -> String {
    let annotation = annotation::of(&key.schema, definitions);
    let tail = if is_optional { " | None = None" } else { "" };
    format!("        {}: {annotation}{tail},\n", key.parameter())
}

/// The keys with what was given for them, as a dictionary.
fn arguments(keys: &[Key]) -> String {
    let entry = |key: &Key| format!("            \"{}\": {},\n", key.name, key.parameter());
    format!("{{\n{}        }}", keys.iter().map(entry).collect::<String>())
}
