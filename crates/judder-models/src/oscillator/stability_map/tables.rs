//! The tables of a map: how much of it is what, and its boundaries.

use crate::swept_tables::{numbers, table, told};
use judder_numerics::order::sort_by_number;
use judder_report::page::PageTable;
use judder_study::registry::ToldAnalysis;
use serde_json::{Map, Value};

/// The shares of the classes, largest first, and the boundaries.
pub(crate) fn report(analysis: ToldAnalysis<'_>, frequency: &str) -> Vec<PageTable> {
    let part = |key: &str| analysis.results.get(key).and_then(Value::as_object);
    let classes = part("fractions").map(classes);
    let boundaries = part("boundaries").filter(|own| !own.is_empty());
    classes.into_iter().chain(boundaries.map(|own| boundary_table(own, frequency))).collect()
}

fn classes(fractions: &Map<String, Value>) -> PageTable {
    let mut shares: Vec<(&String, f64)> =
        fractions.iter().map(|(name, share)| (name, share.as_f64().unwrap_or(f64::NAN))).collect();
    shares.retain(|(_, share)| *share != 0.0);
    sort_by_number(&mut shares, |own| -own.1);
    let rows = shares.into_iter().map(|(name, share)| vec![name.replace('-', " "), told(100.0 * share)]);
    table("Zones".to_owned(), &["zone", "share of the map (%)"], rows.collect())
}

fn boundary_table(boundaries: &Map<String, Value>, frequency: &str) -> PageTable {
    let rows = boundaries.iter().map(|(name, own)| {
        let ends: Vec<String> = numbers(own.get("frequency")).into_iter().map(told).collect();
        let count = |key: &str| own[key].to_string();
        vec![name.replace('_', " "), count("curves"), count("points"), ends.join(" … ")]
    });
    table("Boundaries".to_owned(), &["boundary", "curves", "points", frequency], rows.collect())
}
