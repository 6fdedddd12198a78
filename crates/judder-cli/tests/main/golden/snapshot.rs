//! What a study folder holds, as a document small enough to keep: short arrays whole, long ones by samples and a hash.

use super::agreement::FLOAT_HASH;
use judder_store::{Dataset, Variable, VariableValues, content_hash};
use serde_json::{Map, Number, Value, json};

/// The longest array that is kept whole.
const WHOLE: usize = 48;
/// How many values are kept of a longer one.
const SAMPLES: usize = 48;
/// The longest column of a table that is kept whole, and how many cells of a longer one: the arrays have its numbers too.
const CELLS: usize = 8;

/// A dataset with its attributes and every array.
pub(super) fn dataset(dataset: &Dataset) -> Value {
    let variables: Vec<Value> = dataset.variables().iter().map(variable).collect();
    json!({ "attributes": document(&Value::Object(dataset.attributes().clone())), "variables": variables })
}

fn variable(variable: &Variable) -> Value {
    let mut json = json!({
        "name": variable.name,
        "dimensions": variable.dimensions,
        "shape": variable.shape,
        "units": variable.units,
        "long_name": variable.long_name,
        "coordinate": variable.is_coordinate,
        "attributes": document(&Value::Object(variable.attributes.clone())),
    });
    let (kind, values) = match &variable.data {
        VariableValues::F64(values) => ("f64", values.iter().map(|value| number(*value)).collect()),
        VariableValues::Complex(values) => {
            ("complex", values.iter().map(|value| json!([number(value.re), number(value.im)])).collect())
        }
        VariableValues::I64(values) => ("i64", values.iter().map(|value| json!(value)).collect()),
        VariableValues::U8(values) => ("u8", values.iter().map(|value| json!(value)).collect()),
        VariableValues::Text(values) => ("text", values.iter().map(|value| json!(value)).collect()),
    };
    let is_float = matches!(variable.data, VariableValues::F64(_) | VariableValues::Complex(_));
    json["type"] = json!(kind);
    let kept = kept(values, (WHOLE, SAMPLES), is_float);
    kept.into_iter().for_each(|(key, value)| json[key] = value);
    json
}

/// A number, or the word for one that JSON does not know.
fn number(value: f64) -> Value {
    Number::from_f64(value).map_or_else(|| json!(value.to_string()), Value::Number)
}

/// The values of a short list; of a longer one some of them, evenly over it, and a hash of all.
fn kept(values: Vec<Value>, (whole, samples): (usize, usize), is_float: bool) -> Map<String, Value> {
    let mut kept = Map::new();
    if values.len() <= whole {
        kept.insert("values".to_owned(), json!(values));
        return kept;
    }
    let key = if is_float { FLOAT_HASH } else { "hash" };
    kept.insert(key.to_owned(), json!(content_hash(json!(values).to_string().as_bytes())));
    let last = values.len() - 1;
    let places = (0..samples).map(|sample| sample * last / (samples - 1));
    kept.insert("samples".to_owned(), places.map(|place| values[place].clone()).collect());
    kept
}

/// A document whose long lists of numbers are shortened.
pub(super) fn document(value: &Value) -> Value {
    match value {
        Value::Object(table) => table.iter().map(|(key, own)| (key.clone(), document(own))).collect(),
        Value::Array(items) if items.len() > WHOLE && items.iter().all(Value::is_number) => {
            let is_float = items.iter().any(Value::is_f64);
            let mut kept = kept(items.clone(), (WHOLE, SAMPLES), is_float);
            kept.insert("count".to_owned(), json!(items.len()));
            Value::Object(kept)
        }
        Value::Array(items) => items.iter().map(document).collect(),
        other => other.clone(),
    }
}

/// A table of comma-separated values, column by column.
pub(super) fn table(text: &str) -> Value {
    let mut lines = text.lines().map(cells);
    let heads = lines.next().unwrap_or_default();
    let rows: Vec<Vec<String>> = lines.collect();
    let column = |(index, head): (usize, &String)| {
        let cells: Vec<&str> = rows.iter().map(|row| row[index].as_str()).collect();
        let is_float =
            cells.iter().any(|cell| cell.contains(['.', 'e'])) && cells.iter().all(|cell| is_number(cell));
        let cell = |cell: &&str| match is_float {
            true => cell.parse().map_or(Value::Null, number),
            false => json!(cell),
        };
        let mut kept = kept(cells.iter().map(cell).collect(), (CELLS, CELLS), is_float);
        kept.insert("name".to_owned(), json!(head));
        Value::Object(kept)
    };
    let columns: Vec<Value> = heads.iter().enumerate().map(column).collect();
    json!({ "rows": rows.len(), "columns": columns })
}

/// Whether a cell holds a number or none.
fn is_number(cell: &str) -> bool {
    cell.is_empty() || cell.parse::<f64>().is_ok()
}

/// The cells of a line; a quoted one may hold commas.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut is_quoted) = (vec![String::new()], false);
    for letter in line.chars() {
        match letter {
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => cells.push(String::new()),
            other => cells.last_mut().unwrap().push(other),
        }
    }
    cells
}

/// The words of a page, a line a line: no drawings, no scripts, no styles, no text of the case.
pub(super) fn words(page: &str) -> Vec<String> {
    let mut page = page.to_owned();
    for element in ["script", "style", "svg", "pre"] {
        let (open, close) = (format!("<{element}"), format!("</{element}>"));
        while let Some(start) = page.find(&open) {
            let end = page[start..].find(&close).map_or(page.len(), |end| start + end + close.len());
            page.replace_range(start..end, "");
        }
    }
    // powers of ten as numbers are written elsewhere
    let page = page.replace("\u{a0}×\u{a0}10<sup>−", "e-").replace("\u{a0}×\u{a0}10<sup>", "e");
    let words = page.lines().map(without_tags);
    words.filter(|line| !line.is_empty()).collect()
}

/// A line with a blank for every run of tags.
fn without_tags(line: &str) -> String {
    let mut text = String::new();
    let mut rest = line;
    while let Some((before, tag)) = rest.split_once('<') {
        text.push_str(before);
        text.push(' ');
        rest = tag.split_once('>').map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
