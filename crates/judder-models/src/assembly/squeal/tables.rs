//! The ranking of modes that grow in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// The modes, and what was asked of them besides.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let mut tables = modes(results);
    tables.extend(margins(results));
    tables
}

/// The modes from the loudest cycle on, unstable ones behind, those without a cycle last, by growth.
fn modes(results: &Map<String, Value>) -> Vec<PageTable> {
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
    let caption = "Modes that grow, from the loudest cycle on, unstable ones behind".to_owned();
    let head = heads.map(String::from).to_vec();
    vec![PageTable { caption, head, rows: modes.iter().map(row).collect() }]
}

/// The onsets from the largest margin on.
fn margins(results: &Map<String, Value>) -> Option<PageTable> {
    let margins = results.get("margin")?;
    let mut onsets: Vec<&Value> = margins["onsets"].as_array()?.iter().collect();
    onsets.sort_by_key(|own| own["rank"].as_u64().unwrap_or(u64::MAX));
    let words = |own: &Value| match own {
        Value::Null => String::new(),
        Value::Bool(is_so) => if *is_so { "yes" } else { "no" }.to_owned(),
        Value::String(words) => words.clone(),
        number => short(number),
    };
    let keys = ["onset", "frequency_hz", "mode", "fold", "reaches", "margin", "knock", "end"];
    let row = |own: &&Value| keys.map(|key| words(&own[key])).to_vec();
    let [key, unit] = ["key", "unit"].map(|name| margins[name].as_str().unwrap_or_default());
    let heads = [
        "onset",
        "frequency (Hz)",
        "mode",
        "fold",
        "cycles reach",
        "margin",
        "knock in the case",
        "the branch",
    ];
    let rows: Vec<Vec<String>> = onsets.iter().map(row).collect();
    let head = heads.map(String::from).to_vec();
    let caption = format!("How far before its onset a knock suffices, along {key} ({unit})");
    (!rows.is_empty()).then_some(PageTable { caption, head, rows })
}
