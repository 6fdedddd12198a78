//! The tables of complex modes about steady sliding in the report.

use crate::structure::eigen::tables;
use judder_report::page::PageTable;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// Eigenvalues, and why those grow that do.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let growing = results.get("growing").and_then(Value::as_array);
    let grows = growing.into_iter().flatten().map(grows);
    tables::report(results).into_iter().chain(grows).collect()
}

/// What each damping and each contact adds to the growth rate of a mode, and of which modes of frictionless contact it is made.
fn grows(told: &Value) -> PageTable {
    let growth = told["growth"].as_object().into_iter().flatten();
    let adds = growth.map(|(name, growth)| vec![format!("{name} (1/s)"), short(growth)]);
    let parents = told["parents"].as_array().into_iter().flatten().map(|parent| {
        let of = format!("mode of frictionless contact at {} Hz: share", short(&parent["frequency_hz"]));
        vec![of, short(&parent["share"])]
    });
    PageTable {
        caption: format!("Why mode {} grows", told["mode"]),
        head: ["what", "growth, or share"].map(String::from).to_vec(),
        rows: adds.chain(parents).collect(),
    }
}
