//! The types of keys, as Python annotates them, from their schema; `Any` where it says none.

use serde_json::Value as Json;

/// What a value may be; `definitions` are those of the whole schema.
pub(crate) fn of(schema: &Json, definitions: &Json) -> String {
    union(alternatives(schema, definitions))
}

/// One of some types.
fn union(mut types: Vec<String>) -> String {
    let mut seen = Vec::new();
    types.retain(|own| {
        let is_new = !seen.contains(own);
        seen.push(own.clone());
        is_new
    });
    types.join(" | ")
}

fn alternatives(schema: &Json, definitions: &Json) -> Vec<String> {
    if let Some(name) = schema["$ref"].as_str() {
        return alternatives(&definitions[name.trim_start_matches("#/$defs/")], definitions);
    }
    let items = || {
        let inner = &schema["items"];
        if inner.is_null() { "Any".to_owned() } else { of(inner, definitions) }
    };
    let named = |name: &str| match name {
        "string" => "str".to_owned(),
        "number" => "float".to_owned(),
        "integer" => "int".to_owned(),
        "boolean" => "bool".to_owned(),
        "array" => format!("Sequence[{}]", items()),
        "object" if schema["additionalProperties"].is_object() => {
            format!("Mapping[str, {}]", of(&schema["additionalProperties"], definitions))
        }
        "object" => "Mapping[str, Any]".to_owned(),
        _ => "Any".to_owned(),
    };
    match (&schema["type"], &schema["enum"], &schema["const"]) {
        (Json::String(name), ..) => vec![named(name)],
        (Json::Array(names), ..) => names.iter().filter_map(Json::as_str).map(named).collect(),
        (_, Json::Array(words), _) => vec![literal(words)],
        (.., word @ Json::String(_)) => vec![literal(std::slice::from_ref(word))],
        (.., Json::Bool(_)) => vec!["bool".to_owned()],
        _ => match ["anyOf", "oneOf"].iter().find_map(|key| schema[*key].as_array()) {
            Some(forms) => forms.iter().flat_map(|form| alternatives(form, definitions)).collect(),
            None => vec!["Any".to_owned()],
        },
    }
}

fn literal(words: &[Json]) -> String {
    let words: Vec<String> = words.iter().map(Json::to_string).collect();
    format!("Literal[{}]", words.join(", "))
}
