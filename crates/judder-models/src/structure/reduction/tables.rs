//! The tables of a reduction: what it costs, mode by mode, and to where it may be trusted.

use crate::told_quantities::{ToldQuantity, quantities};
use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short, uncertainty};
use serde_json::{Map, Value};

const TOLD: &[ToldQuantity] = &[
    ("limit_hz", "trusted below", "Hz"),
    ("static_compliance_error", "error of the compliance at rest (relative)", "1"),
    ("dynamic_compliance.error", "error of the compliance in motion (relative)", "1"),
    ("dynamic_compliance.frequency_hz", "told at", "Hz"),
    ("kept_freedoms", "freedoms of the interface", ""),
    ("fixed_interface_modes", "modes with the interface held", ""),
    ("reduced_freedoms", "freedoms of the reduction", ""),
    ("degrees_of_freedom", "freedoms of the structure", ""),
];

/// Frequencies full and reduced, with their errors and what the reduction says of them; what else it says.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let mut tables = quantities("The reduction", results, TOLD);
    let full = results.get("full_hz").and_then(Value::as_array).filter(|list| !list.is_empty());
    let head = ["mode", "full (Hz)", "reduced (Hz)", "error (relative)", "said to be at most (relative)"];
    tables.extend(full.map(|full| {
        listed("Frequencies", &head, full, |mode, own| {
            let beside = |key: &str| results.get(key).and_then(|list| list.get(mode - 1));
            let of = |key: &str| beside(key).unwrap_or(&Value::Null);
            let errors = ["errors", "bounds"].map(|key| uncertainty(of(key)));
            [mode.to_string(), short(own), short(of("reduced_hz"))].into_iter().chain(errors).collect()
        })
    }));
    tables
}
