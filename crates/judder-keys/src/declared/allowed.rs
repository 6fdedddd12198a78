//! What a case file may say under a key: the schema and the reference are written from it.

use super::expressed::expression_schema;
use super::rules::{Number, UNLIMITED, Whole};
use crate::numeric_key::Scaled;
use crate::quantity::Quantity;
use crate::schema;
use judder_numerics::words::plain;
use serde_json::{Map, Value as Json, json};
use std::f64::consts::TAU;
use std::ops::Range;

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
    /// To which of the alternatives of its table it belongs; keys of others are refused beside it.
    pub alternative: Option<AlternativePart>,
    /// What its value may be.
    pub form: Allowed,
}

/// To which alternatives a key belongs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AlternativePart {
    /// Of which choice: a table may have several, each for itself.
    pub choice: usize,
    /// One of them, or several in a row.
    pub of: Range<usize>,
}

/// The keys of alternatives, which may be alternatives of their own, of one choice: what stands beside those belongs to each of them.
pub fn alternatives(variants: Vec<Vec<Declaration>>) -> Vec<Declaration> {
    let mut first = 0;
    let mut all = Vec::new();
    for mut keys in variants {
        let inner = keys.iter().filter_map(|key| key.alternative.as_ref());
        debug_assert!(inner.clone().all(|own| own.choice == 0), "an alternative of several choices");
        let next = first + inner.map(|own| own.of.end).max().unwrap_or(1);
        for key in &mut keys {
            let own = key.alternative.take().map(|own| first + own.of.start..first + own.of.end);
            key.alternative = Some(AlternativePart { choice: 0, of: own.unwrap_or(first..next) });
        }
        first = next;
        all.extend(keys);
    }
    all
}

/// The keys of parts of a table, whose choices are independent of each other.
pub fn beside(parts: Vec<Vec<Declaration>>) -> Vec<Declaration> {
    let mut choices = 0;
    let mut all = Vec::new();
    for mut keys in parts {
        let before = choices;
        for own in keys.iter_mut().filter_map(|key| key.alternative.as_mut()) {
            own.choice += before;
            choices = choices.max(own.choice + 1);
        }
        all.extend(keys);
    }
    all
}

/// The keys of each of the alternatives of each choice of a table.
pub(super) fn choices(keys: &[Declaration]) -> Vec<Vec<Vec<&Declaration>>> {
    let parts = || keys.iter().filter_map(|key| Some((key, key.alternative.as_ref()?)));
    let count = parts().map(|(_, own)| own.choice + 1).max().unwrap_or(0);
    let of_choice = |choice: usize| {
        let own = || parts().filter(move |(_, own)| own.choice == choice);
        let count = own().map(|(_, own)| own.of.end).max().unwrap_or(0);
        let of = |index: usize| own().filter(move |(_, own)| own.of.contains(&index)).map(|(key, _)| key);
        (0..count).map(|index| of(index).collect()).collect()
    };
    (0..count).map(of_choice).collect()
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
    // where no key of any is given, the first alternative is meant
    let is_needed = |own: &Vec<Vec<&Declaration>>| own.first().is_some_and(|first| must_be_given(first));
    let mut one_of = choices(keys).into_iter().filter(is_needed).map(|own| {
        let each: Vec<Json> = own.iter().map(|keys| given(keys)).collect();
        json!({ "oneOf": each })
    });
    match (one_of.next(), one_of.next()) {
        (Some(mut only), None) => json["oneOf"] = only["oneOf"].take(),
        (Some(first), Some(second)) => {
            json["allOf"] = [first, second].into_iter().chain(one_of).collect();
        }
        (None, _) => {}
    }
    json
}

/// Whether any of the keys of an alternative must be given.
pub(super) fn must_be_given(keys: &[&Declaration]) -> bool {
    keys.iter().any(|key| key.is_required)
}

/// That all of these keys are given which must be, or one where none must.
fn given(keys: &[&Declaration]) -> Json {
    let (required, others): (Vec<_>, Vec<_>) = keys.iter().partition(|key| key.is_required);
    if required.is_empty() {
        let one = |key: &&Declaration| json!({ "required": [key.name] });
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
    pub(super) fn line(&self, value: &Json) -> String {
        let Json::Object(table) = value else { return value.to_string() };
        let place = |name: &str| self.keys().iter().position(|key| key.name == name).unwrap_or(usize::MAX);
        let mut entries: Vec<_> = table.iter().filter(|(_, value)| !value.is_null()).collect();
        entries.sort_by_key(|(name, _)| (place(name), name.as_str()));
        let entries: Vec<String> = entries.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        format!("{{ {} }}", entries.join(", "))
    }

    /// What may stand there, as the reference says it.
    pub fn words(&self) -> String {
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
