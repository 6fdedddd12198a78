//! The study folder from outside: what is stored, what is refused, what survives a failure.

// Helpers beside the tests may unwrap as the tests do.
#![allow(clippy::unwrap_used, clippy::panic)]

mod datasets;
mod declared;
mod disk_full;
mod folders;
mod manifests;
mod readers;
mod replacement;
mod streams;
mod summaries_and_tables;
mod sweep_damage;
mod sweep_processes;
mod sweeps;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::thread;
use std::time::Duration;

use judder_store::{Dataset, SharedStudy, StoreError, SweepDimension, SweepLayout, SweepQuantity, Variable};

/// A dataset of one variable that holds `value` everywhere.
fn constant(value: f64, points: usize) -> Dataset {
    Dataset::new().with(Variable::new("value", &["point"], &[points], vec![value; points])).unwrap()
}

/// A study shared with others, as soon as nobody holds it alone.
fn joined(folder: &Path) -> SharedStudy {
    loop {
        match SharedStudy::join(folder) {
            Err(StoreError::Locked { .. }) => thread::sleep(Duration::from_millis(1)),
            joined => return joined.unwrap(),
        }
    }
}

/// The names in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// All files below a folder with their content.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut contents = BTreeMap::new();
    for name in names(folder) {
        let path = folder.join(&name);
        if path.is_dir() {
            let below = self::contents(&path);
            contents.extend(below.into_iter().map(|(file, content)| (format!("{name}/{file}"), content)));
        } else {
            contents.insert(name, fs::read(path).unwrap());
        }
    }
    contents
}

/// A sweep named `sweep` over points that are cut into chunks, with two quantities.
fn sweep(hash: &str, dimensions: &[(&str, usize, usize)]) -> SweepLayout {
    let dimensions = dimensions.iter().map(|&(name, length, chunk)| {
        let name = name.to_owned();
        SweepDimension { name, length, chunk }
    });
    let quantities = vec![
        SweepQuantity::new("growth_rate", "1/s", "growth rate, Re(λ)"),
        SweepQuantity::new("verdict", "", "verdict").flags(&[(0, "stable"), (2, "negative damping")]),
    ];
    SweepLayout::new("sweep", hash, dimensions.collect(), quantities).unwrap()
}

/// Values of a chunk of [`sweep`] that tell where they belong.
fn chunk_values(layout: &SweepLayout, chunk: usize) -> Vec<f64> {
    let points = layout.points(chunk).unwrap();
    let value = |point| points.position(point).iter().fold(0.0, |value, &along| value * 100.0 + along as f64);
    (0..points.count()).flat_map(|point| [value(point).sin(), value(point)]).collect()
}
