//! The ranking of modes that grow in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// The modes from the loudest cycle on, unstable ones behind, those without a cycle last, by growth.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let mut modes: Vec<&Value> =
        results.get("modes").and_then(Value::as_array).into_iter().flatten().collect();
    if modes.is_empty() {
        return Vec::new();
    }
    let place = |mode: &Value, key: &str| mode[key].as_u64().unwrap_or(u64::MAX);
    modes.sort_by_key(|mode| (place(mode, "rank_by_level"), place(mode, "rank_by_growth")));
    let heads = [
        "by level",
        "by growth",
        "mode (Hz)",
        "growth rate (1/s)",
        "cycle (Hz)",
        "level (dB re 1 µm/s²)",
        "stick",
        "slip",
        "lift-off",
        "motions nearby",
        "left out",
    ];
    let row = |mode: &&Value| {
        let told = |key: &str| match &mode[key] {
            Value::Null => String::new(),
            Value::String(words) => words.clone(),
            number => short(number),
        };
        let numbers =
            ["rank_by_level", "rank_by_growth", "mode_frequency_hz", "mode_growth_rate", "frequency_hz"];
        let rest = ["stick_share", "slip_share", "open_share", "stability", "left_out"];
        let level = mode["level_db"].as_f64().map_or_else(String::new, |level| format!("{level:.1}"));
        [numbers.map(told).to_vec(), vec![level], rest.map(told).to_vec()].concat()
    };
    vec![PageTable {
        caption: "Modes that grow, from the loudest cycle on, unstable ones behind".to_owned(),
        head: heads.map(String::from).to_vec(),
        rows: modes.iter().map(row).collect(),
    }]
}
