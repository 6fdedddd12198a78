//! Pieces of a JSON Schema: tables, words, numbers with their ranges and units, declared settings.

use crate::numeric_key::{Range, Scaled};
use serde_json::{Map, Value as Json, json};

/// A table with these keys and no others.
pub fn table(description: &str, properties: Map<String, Json>, required: &[&str]) -> Json {
    json!({
        "type": "object", "description": description, "properties": properties, "required": required,
        "additionalProperties": false,
    })
}

/// The keys of a table.
pub fn object<const N: usize>(entries: [(&str, Json); N]) -> Map<String, Json> {
    entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

/// One of some words.
pub fn names<'a>(names: impl IntoIterator<Item = &'a str>, description: &str) -> Json {
    json!({ "enum": names.into_iter().collect::<Vec<_>>(), "description": description })
}

/// One of some words, of which one is meant where none is given.
pub fn choice<const N: usize>(choices: [&str; N], default: &str, description: &str) -> Json {
    let mut json = names(choices, description);
    json["default"] = json!(default);
    json
}

/// A definition, by its name.
pub fn reference(definition: &str) -> Json {
    json!({ "$ref": format!("#/$defs/{definition}") })
}

/// A plain number in a range.
pub fn plain_number(range: Range) -> Json {
    let mut json = match range {
        Range::Positive => json!({ "exclusiveMinimum": 0.0 }),
        Range::NonNegative => json!({ "minimum": 0.0 }),
        Range::Fraction => json!({ "minimum": 0.0, "exclusiveMaximum": 1.0 }),
        Range::Any => json!({}),
        Range::Interval { above, up_to } => json!({ "exclusiveMinimum": above, "maximum": up_to }),
        Range::Closed { from, to } => json!({ "minimum": from, "maximum": to }),
    };
    json["type"] = json!("number");
    json
}

/// A group, a quantity in quotes, or either.
pub fn scaled_number(number: &Scaled) -> Json {
    let mut forms = Vec::new();
    if let Some(group) = number.group {
        let mut form = plain_number(number.range);
        form["description"] = json!(group);
        forms.push(form);
    }
    if !number.dimension.is_number() {
        forms.push(json!({
            "type": "string", "description": number.dimension.to_string(), "examples": examples(&number.example()),
        }));
    }
    match (number.group, forms.pop()) {
        (None, Some(quantity)) => quantity,
        (_, last) => json!({ "anyOf": forms.into_iter().chain(last).collect::<Vec<_>>() }),
    }
}

/// Examples that are told in one text.
pub(crate) fn examples(told: &str) -> Vec<&str> {
    told.split("\" or \"").collect()
}
