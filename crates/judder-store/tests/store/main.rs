//! The study folder from outside: what is stored, what is refused, what survives a failure.

// Helpers beside the tests may unwrap as the tests do.
#![allow(clippy::unwrap_used, clippy::panic)]

mod datasets;
mod disk_full;
mod folders;
mod replacement;
mod streams;
mod summaries_and_tables;

use judder_store::{Dataset, Variable};

/// A dataset of one variable that holds `value` everywhere.
fn constant(value: f64, points: usize) -> Dataset {
    Dataset::new().with(Variable::new("value", &["point"], &[points], vec![value; points])).unwrap()
}

/// The names in a folder, sorted.
fn names(folder: &std::path::Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}
