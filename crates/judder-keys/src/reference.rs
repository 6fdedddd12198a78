//! Pieces of the reference of the book: rows and tables of keys, as Markdown.

use crate::declared::Declaration;
use crate::numeric_key::{Key, Range};
use std::collections::HashSet;

/// One row of a table of keys.
pub fn row<K>(key: &Key<K>) -> String {
    let number = match (key.group, key.dimension.is_number()) {
        (Some(group), _) => group.to_owned(),
        (None, true) => "the number".to_owned(),
        (None, false) => "not allowed".to_owned(),
    };
    let string = match key.dimension.is_number() {
        true => "not allowed".to_owned(),
        false => key.example().replace("\" or \"", " or "),
    };
    let default = key.default.map_or(String::new(), |(text, _)| format!("`{text}`"));
    let (range, doc) = (allowed(key.range), key.doc);
    format!("| `{}` | {} | {number} | {string} | {default} | {range} | {doc} |\n", key.path, key.symbol)
}

/// The numbers of a range, in signs.
pub fn allowed(range: Range) -> String {
    match range {
        Range::Positive => "> 0".to_owned(),
        Range::NonNegative => "≥ 0".to_owned(),
        Range::Fraction => "≥ 0, < 1".to_owned(),
        Range::Any => "any".to_owned(),
        Range::Interval { above, up_to } => format!("> {above}, ≤ {up_to}").replace('-', "−"),
    }
}

/// The keys of declared settings.
pub fn settings(name: &str, keys: &[Declaration]) -> String {
    let head = "| key | symbol | may be | where left out | what it is |\n| --- | --- | --- | --- | --- |\n";
    let rows: String = keys.iter().map(|key| key.rows("")).collect();
    format!("\nKeys of `{name}`:\n\n{head}{rows}")
}

/// Leaves out the keys of a table that stand further above, as those of a sweep do.
pub fn without_repetition(page: &str) -> String {
    let is_inner =
        |line: &str| line.starts_with("| `") && line.split('`').nth(1).is_some_and(|key| key.contains('.'));
    let mut before = HashSet::new();
    page.split_inclusive('\n').filter(|line| !is_inner(line) || before.insert(line.to_owned())).collect()
}
