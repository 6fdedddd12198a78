//! The tables of complex modes about steady sliding in the report.

use crate::structure::eigen::tables;
use judder_report::page::PageTable;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// Eigenvalues, and why those grow that do.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let growing = results.get("growing").and_then(Value::as_array);
    let grows = growing.into_iter().flatten().map(grows);
    tables::report(results).into_iter().chain(grows).chain(beyond_laws(results)).collect()
}

/// The modes that are too fast for the law of a sphere.
fn beyond_laws(results: &Map<String, Value>) -> Option<PageTable> {
    let beyond = results.get("beyond_quasi_steady")?.as_array()?;
    let row = |told: &Value| {
        let contact = told["contact"].as_str().unwrap_or_default().to_owned();
        let figures = ["quasi_steady_figure", "quasi_steady_longest", "quasi_steady_memory"];
        let figures = figures.map(|key| short(&told[key]));
        [vec![short(&told["mode"]), contact], figures.to_vec()].concat()
    };
    (!beyond.is_empty()).then(|| PageTable {
        caption: "Modes that are too fast for the law of a sphere: figures that are to be small against 1"
            .to_owned(),
        head: ["mode", "contact", "ω τ (−)", "of the longest time (−)", "ω T (−)"].map(String::from).to_vec(),
        rows: beyond.iter().map(row).collect(),
    })
}

/// What each damping and each contact adds to the growth rate of a mode, and of which modes of frictionless contact it is made.
fn grows(told: &Value) -> PageTable {
    let growth = told["growth"].as_object().into_iter().flatten();
    let adds = growth.map(|(name, growth)| vec![name.clone(), short(growth)]);
    let parents = told["parents"].as_array().into_iter().flatten().map(|parent| {
        let of = format!("mode of frictionless contact at {} Hz: share", short(&parent["frequency_hz"]));
        vec![of, short(&parent["share"])]
    });
    PageTable {
        caption: format!("Why mode {} grows", told["mode"]),
        head: ["what", "growth (1/s), or share (−)"].map(String::from).to_vec(),
        rows: adds.chain(parents).collect(),
    }
}
