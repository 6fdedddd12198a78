//! What a case file may say under a key: the schema and the reference are written from it.

use super::values::{Number, Whole};
use crate::keys::Key;
use crate::reference::allowed;
use crate::schema;
use serde_json::{Value as Json, json};

/// A key and what is said of it.
#[derive(Debug, Clone)]
pub(crate) struct Declaration {
    pub(crate) name: &'static str,
    pub(crate) doc: &'static str,
    pub(crate) symbol: &'static str,
    pub(crate) default: Option<Json>,
    pub(crate) is_required: bool,
    pub(crate) form: Form,
}

/// What a value may be.
#[derive(Debug, Clone)]
pub(crate) enum Form {
    /// A number, with a unit where it has a dimension.
    Number(Number),
    /// A whole number.
    Whole(Whole),
    /// `true` or `false`.
    Flag,
    /// Any text.
    Text,
    /// One of a few words, each with what it means.
    Choice { words: &'static [(&'static str, &'static str)] },
    /// A list of so many values of a form.
    List { of: Box<Form>, length: [usize; 2] },
    /// A table of settings, and what it is.
    Table { doc: &'static str, keys: Vec<Declaration> },
    /// A table whose keys are names.
    Named(Box<Form>),
}

impl Form {
    /// What a line with the key would be.
    pub(crate) fn example(&self, key: &str, doc: &str) -> String {
        match self {
            Self::Number(number) if number.dimension.is_number() => format!("{key} = …, {doc}"),
            Self::Number(number) => format!("{key} = \"{}\"", number.dimension.example()),
            Self::Whole(Whole { from, .. }) => format!("{key} = {from}, an integer"),
            Self::Flag => format!("{key} = true"),
            Self::Text => format!("{key} = \"…\""),
            Self::Choice { words } => {
                let words: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
                format!("{key} = \"…\", one of {}", words.join(", "))
            }
            Self::List { .. } => format!("{key} = [ … ]"),
            Self::Named(_) => format!("{key} = {{ NAME = … }}"),
            Self::Table { keys, .. } => {
                let keys: Vec<&str> = keys.iter().filter(|key| key.is_required).map(|key| key.name).collect();
                format!("{key} = {{ {} }}", keys.join(", "))
            }
        }
    }

    /// The JSON Schema of a value.
    fn schema(&self) -> Json {
        match self {
            Self::Number(number) => number.schema(),
            Self::Whole(Whole { from, to }) => json!({ "type": "integer", "minimum": from, "maximum": to }),
            Self::Flag => json!({ "type": "boolean" }),
            Self::Text => json!({ "type": "string" }),
            Self::Choice { words } => {
                json!({ "enum": words.iter().map(|(word, _)| *word).collect::<Vec<_>>() })
            }
            Self::List { of, length: [least, most] } => {
                let mut json = json!({ "type": "array", "items": of.schema(), "minItems": least });
                if *most < usize::MAX {
                    json["maxItems"] = json!(most);
                }
                json
            }
            Self::Table { doc, keys } => schema::declared_table(doc, keys),
            Self::Named(of) => json!({ "type": "object", "additionalProperties": of.schema() }),
        }
    }
}

/// A canonical value as a case file has it: quantities in quotes.
fn as_written(canonical: &Json) -> Json {
    match canonical {
        Json::Object(own) => match (own.get("value"), own.get("unit")) {
            (Some(Json::Number(value)), Some(Json::String(unit))) => {
                json!(format!("{} {unit}", value.as_f64().unwrap_or(f64::NAN)))
            }
            _ => own.iter().map(|(key, value)| (key.clone(), as_written(value))).collect(),
        },
        Json::Array(items) => items.iter().map(as_written).collect(),
        other => other.clone(),
    }
}

impl Declaration {
    /// The JSON Schema of one of these keys.
    pub(crate) fn find(all: &[Self], name: &str) -> Json {
        all.iter().find(|own| own.name == name).map_or(Json::Null, Self::schema)
    }

    /// The JSON Schema of the key.
    pub(crate) fn schema(&self) -> Json {
        let mut json = self.form.schema();
        json["description"] = match self.symbol {
            "" => json!(self.doc),
            symbol => json!(format!("{symbol}: {}", self.doc)),
        };
        if let Some(default) = self.default.as_ref().filter(|default| !default.is_null()) {
            json["default"] = as_written(default);
        }
        json
    }

    /// The row of the reference, and below it those of the keys of its table.
    pub(crate) fn rows(&self, prefix: &str) -> String {
        let Self { name, symbol, doc, form, .. } = self;
        let absent = match &self.default {
            Some(default) => format!("`{}`", as_written(default)),
            None if self.is_required => "must be given".to_owned(),
            None => String::new(),
        };
        let path = format!("{prefix}{name}");
        let row = format!("| `{path}` | {symbol} | {} | {absent} | {doc} |\n", form.words());
        let inner = if matches!(form, Form::Named(_)) { format!("{path}.NAME.") } else { format!("{path}.") };
        form.keys().iter().fold(row, |rows, key| rows + &key.rows(&inner))
    }
}

impl Form {
    /// The keys of a table, or of the tables of a list.
    fn keys(&self) -> &[Declaration] {
        match self {
            Self::Table { keys, .. } => keys,
            Self::List { of, .. } | Self::Named(of) => of.keys(),
            _ => &[],
        }
    }

    /// What may stand there, as the reference says it.
    fn words(&self) -> String {
        match self {
            Self::Number(number) if number.dimension.is_number() => {
                format!("a number, {}", allowed(number.range))
            }
            Self::Number(number) => {
                let example = number.dimension.example().replace("\" or \"", " or ");
                format!("{} such as {example}, {}", number.dimension, allowed(number.range))
            }
            Self::Whole(Whole { from, to }) => format!("an integer from {from} to {to}"),
            Self::Flag => "`true` or `false`".to_owned(),
            Self::Text => "a text".to_owned(),
            Self::Choice { words } => {
                let word = |(word, doc): &(&str, &str)| match *doc {
                    "" => format!("`\"{word}\"`"),
                    doc => format!("`\"{word}\"` ({doc})"),
                };
                words.iter().map(word).collect::<Vec<String>>().join(", ")
            }
            Self::List { of, length: [_, usize::MAX] } => format!("a list, each {}", of.words()),
            Self::List { of, length: [least, most] } if least == most => {
                format!("a list of {least}, each {}", of.words())
            }
            Self::List { of, length: [least, most] } => {
                format!("a list of {least} to {most}, each {}", of.words())
            }
            Self::Named(of) => format!("a table of names, each {}", of.words()),
            Self::Table { keys, .. } => {
                let keys: Vec<&str> = keys.iter().map(|key| key.name).collect();
                format!("a table `{{ {} }}`", keys.join(", "))
            }
        }
    }
}

impl Number {
    /// The entry of a table of keys that reads as this number does.
    pub(super) fn entry(&self) -> Key<()> {
        Key {
            key: (),
            path: "",
            symbol: "",
            dimension: self.dimension,
            group: self.dimension.is_number().then_some(""),
            difference: false,
            range: self.range,
            default: None,
            doc: "",
        }
    }

    fn schema(&self) -> Json {
        if !self.dimension.is_number() {
            let example = self.dimension.example();
            let examples: Vec<&str> = example.split("\" or \"").collect();
            return json!({ "type": "string", "examples": examples });
        }
        schema::plain_number(self.range)
    }
}
