//! The JSON Schema of case files, so that editors complete and check.

use crate::case::analysis::KindEntry;
use crate::case::study_sweep::asked::SweepKeys;
use crate::registry::{ModelKind, Registry};
use judder_keys::declared::{Settings, declared_table, with_declared};
use judder_keys::schema::{names, object, reference};
use serde_json::{Value as Json, json};

/// The JSON Schema (draft 2020-12) of case files of all models, with descriptions and defaults.
///
/// It knows names, types, signs and defaults; units and conditions between keys are checked by reading the case.
pub fn schema(registry: Registry) -> Json {
    let mut definitions = json!({ "sweeps": sweeps() });
    for model in registry.models() {
        let paths = (model.swept)();
        if !paths.is_empty() {
            definitions[swept_keys(model.name)] = names(paths, "dotted path of a key");
        }
    }
    let mut json = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A case of judder",
        "type": "object",
        "required": ["model"],
        "oneOf": registry.models().iter().map(|model| of_model(model)).collect::<Vec<_>>(),
        "$defs": definitions,
    });
    json.sort_all_objects();
    json
}

/// The schema of the cases of a model.
fn of_model(model: &ModelKind) -> Json {
    let properties = object([
        ("title", json!({ "type": "string", "description": "the title", "default": "" })),
        ("model", json!({ "const": model.name })),
        ("analysis", analyses(&(model.kinds)())),
        ("sweep", reference("sweeps")),
    ]);
    with_declared(model.doc, properties, &(model.declared)(), &["model"])
}

/// The definition that lists what the analyses of a model vary.
pub fn swept_keys(model: &str) -> String {
    format!("{model}-key")
}

/// The name of an analysis, which is that of its kind where it has none.
fn name_of(kind: &str) -> Json {
    json!({ "type": "string", "pattern": "^[A-Za-z0-9_-][A-Za-z0-9._-]{0,99}$", "default": kind })
}

/// The list of analyses: one alternative a kind.
fn analyses(kinds: &[KindEntry]) -> Json {
    let alternatives = kinds.iter().map(|kind| {
        let own = [("kind", json!({ "const": kind.name })), ("name", name_of(kind.name))];
        with_declared(kind.doc, object(own), &(kind.declared)(), &["kind"])
    });
    json!({ "type": "array", "items": { "oneOf": alternatives.collect::<Vec<_>>() } })
}

/// The list of sweeps, of any model.
fn sweeps() -> Json {
    let sweep = declared_table(SweepKeys::DOC, &SweepKeys::declarations());
    json!({ "type": "array", "items": sweep, "description": SweepKeys::DOC })
}
