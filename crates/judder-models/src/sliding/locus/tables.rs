//! The table of critical values of a locus in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short};
use serde_json::{Map, Value};

/// Where modes begin to grow along the axis, and where they cease to.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let zones = results.get("unstable").and_then(Value::as_array).filter(|zones| !zones.is_empty());
    let Some(zones) = zones else { return Vec::new() };
    let is_over_positions = zones.iter().any(|zone| zone.get("from_m").is_some());
    let (unit, ends) =
        if is_over_positions { (" (m)", ["from_m", "to_m", "peak_m"]) } else { ("", ["from", "to", "peak"]) };
    let head = [
        format!("from{unit}"),
        "there".to_owned(),
        format!("to{unit}"),
        "there".to_owned(),
        "frequency (Hz)".to_owned(),
        "largest growth rate (1/s)".to_owned(),
        format!("at{unit}"),
    ];
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let end = |zone: &Value, side: usize| zone["ends"][side].as_str().unwrap_or_default().to_owned();
    let row = |_: usize, zone: &Value| {
        let number = |key: &str| short(&zone[key]);
        vec![
            number(ends[0]),
            end(zone, 0),
            number(ends[1]),
            end(zone, 1),
            number("frequency_hz"),
            number("max_growth_rate"),
            number(ends[2]),
        ]
    };
    vec![listed("Critical values: unstable zones", &head, zones, row)]
}
