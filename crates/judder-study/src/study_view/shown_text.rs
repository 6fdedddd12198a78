//! Texts that a study holds, cut to what a page shows of them: a folder may come from anybody, and a label of 100 kB stops a browser.

use judder_report::page::PageTable;
use judder_store::{Variable, VariableValues};
use serde_json::{Map, Value};

/// Letters that are shown of a text, at most: more than any of ours has, the meanings of all codes of a map among them.
const LETTERS: usize = 4000;

/// A text, cut with an ellipsis where it is longer than a page shows.
#[must_use]
pub fn shown_text(text: &str) -> String {
    match text.char_indices().nth(LETTERS) {
        None => text.to_owned(),
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
    }
}

/// All texts of a list.
pub(super) fn shown_texts(texts: &[String]) -> Vec<String> {
    texts.iter().map(|text| shown_text(text)).collect()
}

/// All texts of a table with its keys, however deep.
pub(super) fn shown_table(table: &Map<String, Value>) -> Map<String, Value> {
    table.iter().map(|(key, value)| (shown_text(key), shown_value(value))).collect()
}

fn shown_value(value: &Value) -> Value {
    match value {
        Value::String(text) => shown_text(text).into(),
        Value::Array(items) => items.iter().map(shown_value).collect(),
        Value::Object(table) => shown_table(table).into(),
        other => other.clone(),
    }
}

/// What is told of a variable, and its labels.
pub(super) fn shown_variable(variable: Variable) -> Variable {
    let data = match variable.data {
        VariableValues::Text(labels) => VariableValues::Text(shown_texts(&labels)),
        numbers => numbers,
    };
    Variable {
        data,
        dimensions: shown_texts(&variable.dimensions),
        units: shown_text(&variable.units),
        long_name: shown_text(&variable.long_name),
        attributes: shown_table(&variable.attributes),
        ..variable
    }
}

/// A table of the report.
pub(super) fn shown_page_table(table: &PageTable) -> PageTable {
    PageTable {
        caption: shown_text(&table.caption),
        head: shown_texts(&table.head),
        rows: table.rows.iter().map(|row| shown_texts(row)).collect(),
    }
}
