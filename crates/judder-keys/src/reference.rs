//! Pieces of the reference of the book: rows and tables of keys, as Markdown.

use crate::declared::{Declaration, rows};
use std::collections::HashSet;

/// The keys of declared settings, under their name.
pub fn settings(name: &str, keys: &[Declaration]) -> String {
    format!("\nKeys of `{name}`:\n\n{}", table(keys))
}

/// The keys of declared settings, those of their tables below them.
pub fn table(keys: &[Declaration]) -> String {
    let head = "| key | symbol | may be | where left out | what it is |\n| --- | --- | --- | --- | --- |\n";
    head.to_owned() + &rows(keys)
}

/// Leaves out the keys of a table that stand further above, as those of a sweep do.
pub fn without_repetition(page: &str) -> String {
    let is_inner =
        |line: &str| line.starts_with("| `") && line.split('`').nth(1).is_some_and(|key| key.contains('.'));
    let mut before = HashSet::new();
    page.split_inclusive('\n').filter(|line| !is_inner(line) || before.insert(line.to_owned())).collect()
}
