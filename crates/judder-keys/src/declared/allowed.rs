//! What a case file may say under a key: the schema and the reference are written from it.

use super::expressed::expression_schema;
use super::rules::{Number, UNLIMITED, Whole};
use crate::numeric_key::Scaled;
use crate::quantity::Quantity;
use crate::schema;
use judder_numerics::words::plain;
use serde_json::{Map, Value as Json, json};
use std::f64::consts::TAU;

/// A key and what is said of it.
#[derive(Debug, Clone)]
pub struct Declaration {
    /// Its name in a case file.
    pub name: &'static str,
    /// What it is.
    pub doc: &'static str,
    /// The symbol of its quantity; empty where it has none.
    pub symbol: &'static str,
    /// What it is where it is left out, in the canonical form.
    pub default: Option<Json>,
    /// Whether it must be given; among alternatives, with those of its own.
    pub is_required: bool,
    /// To which of the alternatives of its table it belongs; those of another are refused beside it.
    pub alternative: Option<usize>,
    /// What its value may be.
    pub form: Allowed,
}

/// The keys of alternatives, which may be alternatives of their own.
pub fn alternatives(variants: Vec<Vec<Declaration>>) -> Vec<Declaration> {
    let mut next = 0;
    let mut all = Vec::new();
    for mut keys in variants {
        let first = next;
        for key in &mut keys {
            let own = first + key.alternative.unwrap_or(0);
            key.alternative = Some(own);
            next = next.max(own);
        }
        next += 1;
        all.extend(keys);
    }
    all
}

/// What a value may be.
#[derive(Debug, Clone)]
pub enum Allowed {
    /// A number, with a unit where it has a dimension.
    Number(Number),
    /// A whole number.
    Whole(Whole),
    /// `true` or `false`.
    Flag,
    /// Any text.
    Text,
    /// The path of a file.
    File,
    /// A number, or an expression of parameters.
    Expression,
    /// A number of this form, or an expression of parameters in its place, with the unit of its value.
    Expressed(Box<Allowed>),
    /// A number, or a quantity whose unit another key decides.
    Quantity,
    /// One of a few words, each with what it means.
    Choice {
        /// The words.
        words: &'static [(&'static str, &'static str)],
    },
    /// A list of so many values of a form.
    List {
        /// What each may be.
        of: Box<Allowed>,
        /// The fewest and the most.
        length: [usize; 2],
    },
    /// A table of settings, and what it is.
    Table {
        /// What it is.
        doc: &'static str,
        /// Its keys.
        keys: Vec<Declaration>,
    },
    /// A table whose keys are names.
    Named(Box<Allowed>),
    /// One of several forms.
    Either(Vec<Allowed>),
    /// A number that is a dimensionless group, or has a unit.
    Scaled(Scaled),
    /// What a type or a model tells of itself: the schema, the words of the reference, the keys of its tables.
    Told {
        /// The schema.
        schema: Json,
        /// The words.
        words: String,
        /// The keys.
        keys: Vec<Declaration>,
    },
}

impl Allowed {
    /// What a line with the key would be.
    pub fn example(&self, key: &str, doc: &str) -> String {
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
            Self::Either(forms) => forms.first().map_or(String::new(), |form| form.example(key, doc)),
            Self::Expressed(of) => of.example(key, doc),
            Self::File => format!("{key} = \"…\", a path relative to the case file"),
            Self::Expression | Self::Quantity | Self::Scaled(_) | Self::Told { .. } => {
                format!("{key} = …, {doc}")
            }
            Self::Table { keys, .. } => {
                let keys: Vec<&str> =
                    keys.iter().filter(|key| key.must_stand()).map(|key| key.name).collect();
                format!("{key} = {{ {} }}", keys.join(", "))
            }
        }
    }

    /// The JSON Schema of a value.
    pub fn schema(&self) -> Json {
        match self {
            Self::Number(number) => number.schema(),
            Self::Whole(Whole { from, to: UNLIMITED }) => json!({ "type": "integer", "minimum": from }),
            Self::Whole(Whole { from, to }) => json!({ "type": "integer", "minimum": from, "maximum": to }),
            Self::Flag => json!({ "type": "boolean" }),
            Self::Text | Self::File => json!({ "type": "string" }),
            Self::Expression | Self::Quantity => json!({ "type": ["number", "string"] }),
            Self::Expressed(of) => {
                let forms = [vec![of.schema()], expression_schema(of)].concat();
                json!({ "anyOf": forms })
            }
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
            Self::Table { doc, keys } => declared_table(doc, keys),
            Self::Named(of) => json!({ "type": "object", "additionalProperties": of.schema() }),
            Self::Either(forms) => json!({ "anyOf": forms.iter().map(Self::schema).collect::<Vec<_>>() }),
            Self::Scaled(scaled) => schema::scaled_number(scaled),
            Self::Told { schema, .. } => schema.clone(),
        }
    }
}

/// A table of declared settings.
pub fn declared_table(description: &str, keys: &[Declaration]) -> Json {
    with_declared(description, Map::new(), keys, &[])
}

/// A table of declared settings beside other keys.
pub fn with_declared(
    description: &str,
    mut properties: Map<String, Json>,
    keys: &[Declaration],
    required: &[&str],
) -> Json {
    properties.extend(keys.iter().map(|key| (key.name.to_owned(), key.schema())));
    let own = keys.iter().filter(|key| key.must_stand()).map(|key| key.name);
    let required: Vec<&str> = required.iter().copied().chain(own).collect();
    let mut json = schema::table(description, properties, &required);
    let of_alternative = |index: usize| keys.iter().filter(move |key| key.alternative == Some(index));
    // where no key of any is given, the first alternative is meant
    if of_alternative(0).any(|key| key.is_required) {
        let last = keys.iter().filter_map(|key| key.alternative).max().unwrap_or(0);
        json["oneOf"] = (0..=last).map(|index| given(of_alternative(index))).collect();
    }
    json
}

/// That all of these keys are given which must be, or one where none must.
fn given<'a>(keys: impl Iterator<Item = &'a Declaration>) -> Json {
    let (required, others): (Vec<_>, Vec<_>) = keys.partition(|key| key.is_required);
    if required.is_empty() {
        let one = |key: &Declaration| json!({ "required": [key.name] });
        return json!({ "anyOf": others.into_iter().map(one).collect::<Vec<_>>() });
    }
    json!({ "required": required.iter().map(|key| key.name).collect::<Vec<_>>() })
}

/// A canonical value as a case file has it: quantities in quotes.
pub(super) fn as_written(canonical: &Json) -> Json {
    match canonical {
        Json::Object(own) => match (own.get("value"), own.get("unit")) {
            (Some(Json::Number(value)), Some(Json::String(unit))) => {
                json!(briefly(value.as_f64().unwrap_or(f64::NAN), unit))
            }
            _ => own.iter().map(|(key, value)| (key.clone(), as_written(value))).collect(),
        },
        Json::Array(items) => items.iter().map(as_written).collect(),
        other => other.clone(),
    }
}

/// The shortest of the ways in which a quantity in SI units can be written, but for rounding.
fn briefly(value: f64, unit: &str) -> String {
    let (value_in, units) = match unit {
        "rad/s" => (value / TAU, ["Hz", "kHz", "rad/s"].map(str::to_owned)),
        _ => (value, [unit.to_owned(), format!("m{unit}"), format!("k{unit}")]),
    };
    let ways = units.iter().flat_map(|unit| {
        let scales = [value_in, value_in * 1e3, value_in * 1e-3, value];
        scales.map(|number| format!("{} {unit}", plain(number)))
    });
    let is_same = |way: &String| {
        Quantity::parse(way).is_ok_and(|read| (read.number - value).abs() <= 1e-15 * value.abs())
    };
    ways.filter(is_same).min_by_key(String::len).unwrap_or_else(|| format!("{value} {unit}"))
}

impl Declaration {
    /// Whether it must be given, whatever else is.
    pub fn must_stand(&self) -> bool {
        self.is_required && self.alternative.is_none()
    }

    /// The JSON Schema of one of these keys.
    pub fn find(all: &[Self], name: &str) -> Json {
        all.iter().find(|own| own.name == name).map_or(Json::Null, Self::schema)
    }

    /// The JSON Schema of the key.
    pub fn schema(&self) -> Json {
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
    pub fn rows(&self, prefix: &str) -> String {
        let Self { name, symbol, doc, form, .. } = self;
        let absent = match &self.default {
            Some(default) => format!("`{}`", form.line(&as_written(default))),
            None if self.must_stand() => "must be given".to_owned(),
            None => String::new(),
        };
        let path = format!("{prefix}{name}");
        let row = format!("| `{path}` | {symbol} | {} | {absent} | {doc} |\n", form.words());
        let inner =
            if matches!(form, Allowed::Named(_)) { format!("{path}.NAME.") } else { format!("{path}.") };
        let mut rows = vec![row];
        // of several tables that a key may be, the keys of each; one that more than one has is one
        for key in form.alternatives().iter().flat_map(Allowed::keys) {
            let mut has_path = rows.iter().filter_map(|row| row.split('|').nth(1));
            let own = format!(" `{inner}{}` ", key.name);
            if !has_path.any(|path| path == own) {
                rows.extend(key.rows(&inner).split_inclusive('\n').map(str::to_owned));
            }
        }
        rows.concat()
    }
}

impl Allowed {
    /// The keys of a table, or of the tables of a list.
    pub fn keys(&self) -> &[Declaration] {
        match self {
            Self::Table { keys, .. } | Self::Told { keys, .. } => keys,
            Self::List { of, .. } | Self::Named(of) => of.keys(),
            Self::Either(forms) => forms.iter().map(Self::keys).find(|keys| !keys.is_empty()).unwrap_or(&[]),
            _ => &[],
        }
    }

    /// What a key may be, each alone.
    pub(super) fn alternatives(&self) -> &[Self] {
        match self {
            Self::Either(forms) => forms,
            form => std::slice::from_ref(form),
        }
    }

    /// A value as a case file says it in one line, the keys of a table in the order in which they are declared.
    fn line(&self, value: &Json) -> String {
        let Json::Object(table) = value else { return value.to_string() };
        let place = |name: &str| self.keys().iter().position(|key| key.name == name).unwrap_or(usize::MAX);
        let mut entries: Vec<_> = table.iter().filter(|(_, value)| !value.is_null()).collect();
        entries.sort_by_key(|(name, _)| (place(name), name.as_str()));
        let entries: Vec<String> = entries.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        format!("{{ {} }}", entries.join(", "))
    }

    /// What may stand there, as the reference says it.
    pub(super) fn words(&self) -> String {
        match self {
            Self::Number(number) if number.dimension.is_number() => {
                format!("a number, {}", number.range.signs())
            }
            Self::Number(number) => {
                let example = number.dimension.example().replace("\" or \"", " or ");
                format!("{} such as {example}, {}", number.dimension, number.range.signs())
            }
            Self::Whole(Whole { from, to: UNLIMITED }) => format!("an integer, ≥ {from}"),
            Self::Whole(Whole { from, to }) => format!("an integer from {from} to {to}"),
            Self::Flag => "`true` or `false`".to_owned(),
            Self::Text => "a text".to_owned(),
            Self::File => "a path relative to the case file".to_owned(),
            Self::Expression => "a number, or an expression of the parameters in quotes".to_owned(),
            Self::Expressed(of) => of.words(),
            Self::Quantity => "a number, or a quantity with the key's unit".to_owned(),
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
            Self::Either(forms) => forms.iter().map(Self::words).collect::<Vec<String>>().join("; or "),
            Self::Scaled(scaled) => scaled.words(),
            Self::Told { words, .. } => words.clone(),
            Self::Table { keys, .. } => {
                let keys: Vec<&str> = keys.iter().map(|key| key.name).collect();
                format!("a table `{{ {} }}`", keys.join(", "))
            }
        }
    }
}

impl Number {
    /// The number with a unit, or without one, that reads as this does.
    pub fn scaled(&self) -> Scaled {
        let group = if self.dimension.is_number() { Some("") } else { None };
        Scaled { dimension: self.dimension, group, range: self.range, is_difference: false }
    }

    fn schema(&self) -> Json {
        if !self.dimension.is_number() {
            let example = self.dimension.example();
            return json!({ "type": "string", "examples": schema::examples(&example) });
        }
        schema::plain_number(self.range)
    }
}
