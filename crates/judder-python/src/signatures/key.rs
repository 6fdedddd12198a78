//! A key as docstrings tell it: what it is, what it may be, what it is where it is left out, the keys of its table.

use judder_keys::declared::{Declaration, ToldKey};
use serde_json::Value as Json;

/// The columns of a line.
const COLUMNS: usize = 140;

/// A key and what is said of it.
pub(crate) struct SignatureKey {
    /// Its name in a case file.
    pub(crate) name: String,
    /// Whether it must be given, whatever else is.
    pub(crate) is_required: bool,
    /// Its schema.
    pub(crate) schema: Json,
    /// What is said of it.
    pub(crate) told: KeyDocumentation,
}

/// What docstrings say of a key.
pub(crate) struct KeyDocumentation {
    name: String,
    /// In one line.
    pub(crate) words: String,
    keys: Vec<KeyDocumentation>,
}

impl SignatureKey {
    /// A key as it is declared.
    pub(crate) fn declared(told: &ToldKey<'_>) -> Self {
        Self {
            name: told.key.name.to_owned(),
            is_required: told.key.must_stand(),
            schema: told.key.schema(),
            told: KeyDocumentation::declared(told),
        }
    }

    /// A key of a case, by its schema where it is none of those that its model declares.
    pub(crate) fn of_case(
        name: &str,
        schema: &Json,
        case: &Json,
        definitions: &Json,
        declared: &[ToldKey<'_>],
    ) -> Self {
        let schema = resolved(schema, definitions).clone();
        let found = declared.iter().find(|own| own.key.name == name);
        let told = found.map_or_else(
            || KeyDocumentation::of_schema(name, &schema, definitions),
            KeyDocumentation::declared,
        );
        Self { name: name.to_owned(), is_required: is_required(name, case), schema, told }
    }

    /// Its name as a parameter of Python.
    pub(crate) fn parameter(&self) -> String {
        // the words of the language that a key could be
        let is_word = ["from", "in", "is", "as", "with", "for", "lambda", "class"].contains(&&*self.name);
        if is_word { format!("{}_", self.name) } else { self.name.clone() }
    }

    /// The entry of a docstring.
    pub(crate) fn entry(&self, indent: usize) -> String {
        let mut entry = wrapped(&format!("{}: {}", self.parameter(), self.told.words), indent, indent + 4);
        self.told.list(&mut entry, indent + 4);
        entry
    }
}

/// Whether a table must have a key.
fn is_required(name: &str, table: &Json) -> bool {
    table["required"].as_array().is_some_and(|required| required.iter().any(|own| own == name))
}

/// The definition that a schema refers to, or itself.
fn resolved<'a>(schema: &'a Json, definitions: &'a Json) -> &'a Json {
    match schema["$ref"].as_str() {
        Some(name) => &definitions[name.trim_start_matches("#/$defs/")],
        None => schema,
    }
}

impl KeyDocumentation {
    fn declared(told: &ToldKey<'_>) -> Self {
        let Declaration { name, symbol, doc, form, .. } = told.key;
        let doc = if symbol.is_empty() { (*doc).to_owned() } else { format!("{symbol}: {doc}") };
        let absent = where_left_out(&told.default);
        Self {
            name: (*name).to_owned(),
            words: sentence(&[&doc, &form.words(), &absent, &told.needed]),
            keys: told.keys.iter().map(Self::declared).collect(),
        }
    }

    fn of_schema(name: &str, schema: &Json, definitions: &Json) -> Self {
        let table = table_in(schema, definitions);
        let keys = table["properties"].as_object().into_iter().flatten().map(|(name, schema)| {
            let own = resolved(schema, definitions);
            let mut told = Self::of_schema(name, own, definitions);
            if is_required(name, table) {
                told.words += "; must be given";
            }
            told
        });
        let doc = schema["description"].as_str().unwrap_or_default();
        let doc = match (doc, schema["type"].as_str()) {
            ("", Some("object")) => "a table",
            ("", Some("array")) => "a list of tables",
            ("", Some("string")) => "a text",
            _ => doc,
        };
        let default = match &schema["default"] {
            Json::Null => String::new(),
            own => where_left_out(&own.to_string()),
        };
        Self {
            name: name.to_owned(),
            words: sentence(&[doc, &examples(schema), &default]),
            keys: keys.collect(),
        }
    }

    fn list(&self, text: &mut String, indent: usize) {
        for key in &self.keys {
            *text += &wrapped(&format!("- ``{}``: {}", key.name, key.words), indent, indent + 2);
            key.list(text, indent + 2);
        }
    }
}

/// The table that a value is, or that the items of a list are.
fn table_in<'a>(schema: &'a Json, definitions: &'a Json) -> &'a Json {
    let of = |schema: &'a Json| resolved(schema, definitions);
    let forms = [&schema["anyOf"], &schema["oneOf"]];
    let tables = forms.into_iter().filter_map(Json::as_array).flatten().map(of);
    let found = std::iter::once(schema).chain([of(&schema["items"])]).chain(tables);
    found.into_iter().find(|form| form["properties"].is_object()).unwrap_or(&Json::Null)
}

/// That a key has this value where it is left out; nothing where it has none.
fn where_left_out(default: &str) -> String {
    if default.is_empty() { String::new() } else { format!("`{default}` where left out") }
}

/// What is said of a key in one line.
fn sentence(parts: &[&str]) -> String {
    let parts: Vec<&str> = parts.iter().copied().filter(|part| !part.is_empty()).collect();
    parts.join("; ").replace('`', "``")
}

/// Values with their units, where the schema has some.
fn examples(schema: &Json) -> String {
    let forms = schema["anyOf"].as_array().into_iter().flatten();
    let mut of_forms = std::iter::once(schema).chain(forms).filter_map(|form| form["examples"].as_array());
    let Some(examples) = of_forms.next() else { return String::new() };
    let examples: Vec<String> = examples.iter().map(Json::to_string).collect();
    format!("such as `{}`", examples.join("` or `"))
}

/// Lines of at most so many columns; the first and those below it begin at these.
pub(crate) fn wrapped(text: &str, first: usize, below: usize) -> String {
    let (mut lines, mut line) = (String::new(), " ".repeat(first));
    let mut is_empty = true;
    for word in text.split_whitespace() {
        if !is_empty && line.chars().count() + 1 + word.chars().count() > COLUMNS {
            lines.extend([line.as_str(), "\n"]);
            (line, is_empty) = (" ".repeat(below), true);
        }
        if !is_empty {
            line.push(' ');
        }
        line.push_str(word);
        is_empty = false;
    }
    lines + &line + "\n"
}

/// The same as the beginning of a sentence.
pub(crate) fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
