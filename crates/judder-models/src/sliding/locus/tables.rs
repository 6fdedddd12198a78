//! The table of critical values of a locus in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short};
use judder_study::shown::{SHOWN_UNIT, ShownValues};
use serde_json::{Map, Value};

/// Where modes begin to grow along the axis, and where they cease to.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let zones = results.get("unstable").and_then(Value::as_array).filter(|zones| !zones.is_empty());
    let Some(zones) = zones else { return Vec::new() };
    let is_over_positions = zones.iter().any(|zone| zone.get("from_m").is_some());
    let (unit, ends) = match is_over_positions {
        true => (Some("m"), ["from_m", "to_m", "peak_m"]),
        false => (results.get(SHOWN_UNIT).and_then(Value::as_str), ["from", "to", "peak"]),
    };
    let shown = ShownValues::called(unit);
    let head = [
        shown.head("from"),
        "there".to_owned(),
        shown.head("to"),
        "there".to_owned(),
        "frequency (Hz)".to_owned(),
        "largest growth rate (1/s)".to_owned(),
        shown.head("at"),
    ];
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let end = |zone: &Value, side: usize| zone["ends"][side].as_str().unwrap_or_default().to_owned();
    let row = |_: usize, zone: &Value| {
        let number = |key: &str| short(&zone[key]);
        let [from, to, peak] = ends.map(|key| shown.value(&zone[key]));
        vec![from, end(zone, 0), to, end(zone, 1), number("frequency_hz"), number("max_growth_rate"), peak]
    };
    vec![listed("Critical values: unstable zones", &head, zones, row)]
}
