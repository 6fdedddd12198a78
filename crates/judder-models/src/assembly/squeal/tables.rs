//! The ranking of modes that grow in the report.

use super::cures::per_cent;
use crate::assembly::meant_mode::mode_at;
use judder_report::page::PageTable;
use judder_study::report_tables::short;
use judder_study::shown::{SHOWN_UNIT, ShownValues};
use serde_json::{Map, Value};

/// The modes, and what was asked of them besides.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let mut tables = modes(results);
    tables.extend([margins(results), knocks(results), cures(results)].into_iter().flatten());
    tables
}

/// The modes from the loudest cycle on, unstable ones behind, those without a cycle last, by growth.
fn modes(results: &Map<String, Value>) -> Vec<PageTable> {
    let Some(modes) = results.get("modes").and_then(Value::as_array) else { return Vec::new() };
    let mut modes: Vec<&Value> = modes.iter().collect();
    let band = results.get("band_hz").unwrap_or(&Value::Null);
    let [from, to] = [0, 1].map(|end| short(&band[end]));
    if modes.is_empty() {
        let caption = "Modes that grow".to_owned();
        let none = format!("none from {from} to {to} Hz; others are not sought");
        let rows = std::iter::once(none).chain(quiet(results)).map(|row| vec![row]).collect();
        return vec![PageTable { caption, head: vec![String::new()], rows }];
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
        "stick (−)",
        "slip (−)",
        "lift-off (−)",
        "motions nearby",
        "left out (−)",
        "converged",
    ];
    let row = |mode: &&Value| {
        let told = |key: &str| words(&mode[key]);
        let numbers =
            ["rank_by_level", "rank_by_growth", "mode_frequency_hz", "mode_growth_rate", "frequency_hz"];
        let rest = ["stick_share", "slip_share", "open_share", "stability", "left_out", "converged"];
        let level = mode["level_db"].as_f64().map_or_else(String::new, |level| format!("{level:.1}"));
        [numbers.map(told).to_vec(), vec![level], rest.map(told).to_vec()].concat()
    };
    let caption =
        format!("Modes from {from} to {to} Hz that grow, from the loudest cycle on, unstable ones behind");
    let head = heads.map(String::from).to_vec();
    vec![PageTable { caption, head, rows: modes.iter().map(row).collect() }]
}

/// The onsets from the largest margin on.
fn margins(results: &Map<String, Value>) -> Option<PageTable> {
    let margins = results.get("margin")?;
    let mut onsets: Vec<&Value> = margins["onsets"].as_array()?.iter().collect();
    onsets.sort_by_key(|own| own["rank"].as_u64().unwrap_or(u64::MAX));
    let keys = [
        "rank",
        "tied",
        "onset",
        "frequency_hz",
        "mode",
        "fold",
        "fold_error",
        "reaches",
        "margin",
        "margin_error",
        "knock",
        "end",
        "stability",
    ];
    let shown = ShownValues::of(margins);
    let cell = |own: &Value, key: &str| match key {
        "fold_error" if own[key].is_null() && !own["fold"].is_null() => "unknown".to_owned(),
        "margin_error" if own[key].is_null() && !own["margin"].is_null() => "unknown".to_owned(),
        _ if own[key].is_null() => String::new(),
        "onset" | "fold" | "reaches" => shown.value(&own[key]),
        "fold_error" => shown.error(&own[key]),
        _ => words(&own[key]),
    };
    let row = |own: &&Value| keys.map(|key| cell(own, key)).to_vec();
    let along = shown.head(margins["key"].as_str().unwrap_or_default());
    let [onset, fold, fold_error, reaches] =
        ["onset", "fold", "fold may be off", "cycles reach"].map(|own| shown.head(own));
    let heads = [
        "place",
        "not told from so many others",
        &onset,
        "frequency (Hz)",
        "mode",
        &fold,
        &fold_error,
        &reaches,
        "margin (−)",
        "margin may be off (−)",
        "knock in the case",
        "the branch",
        "motions near its cycles",
    ];
    let rows: Vec<Vec<String>> = onsets.iter().map(row).collect();
    let head = heads.map(String::from).to_vec();
    let caption = format!("How far before its onset cycles of it exist already, along {along}");
    (!rows.is_empty()).then_some(PageTable { caption, head, rows })
}

/// That a knock makes it loud although nothing grows.
fn quiet(results: &Map<String, Value>) -> Option<String> {
    let vibrate = results.get("knocks").and_then(|own| own["vibrate"].as_u64()).unwrap_or(0);
    let reaches = results.get("margin").is_some_and(|own| own["knock"] == true);
    match vibrate {
        0 if reaches => Some("but cycles exist there, to which a knock may lead".to_owned()),
        0 => None,
        _ => Some("but knocks suffice: after some of them it keeps vibrating".to_owned()),
    }
}

/// A line each of margins, knocks and cures.
pub(crate) fn lines(results: &Map<String, Value>) -> Vec<String> {
    [margin_line(results), knocks_line(results), cures_line(results)].into_iter().flatten().collect()
}

fn margin_line(results: &Map<String, Value>) -> Option<String> {
    let margin = results.get("margin").filter(|own| own.is_object())?;
    let shown = ShownValues::of(margin);
    let key = words(&margin["key"]);
    let largest = match margin["largest"].is_null() {
        true => "unknown".to_owned(),
        false => words(&margin["largest"]),
    };
    let onsets = margin["onsets"].as_array()?;
    let first = onsets.iter().find(|own| own["margin"] == margin["largest"] && !own["fold"].is_null());
    let from = first.map_or_else(String::new, |own| {
        let unit = shown.unit().map_or_else(String::new, |unit| format!(" {unit}"));
        format!(", from the onset at {} to {}{unit}", shown.value(&own["onset"]), shown.value(&own["fold"]))
    });
    let knock = match margin["knock_reason"].as_str().filter(|own| !own.is_empty()) {
        None => "a knock may suffice".to_owned(),
        Some(reason) => format!("whether a knock suffices is not known: {reason}"),
    };
    Some(format!("margin along {key}: {largest}{from}; {knock}"))
}

fn knocks_line(results: &Map<String, Value>) -> Option<String> {
    let knocks = results.get("knocks").filter(|own| own.is_object())?;
    let told = |key: &str| words(&knocks[key]);
    let [low, high] = [0, 1].map(|end| words(&knocks["interval"][end]));
    let smallest = match knocks["smallest_that_vibrates"].is_null() {
        true => String::new(),
        false => format!(" from {} N s on", told("smallest_that_vibrates")),
    };
    Some(format!(
        "knocks at {}: of {} {} keep vibrating{smallest}, {} settle, {} undecided; share {low} … {high}; small motions {}",
        told("at"),
        told("samples"),
        told("vibrate"),
        told("settle"),
        told("undecided"),
        told("small_motions")
    ))
}

fn cures_line(results: &Map<String, Value>) -> Option<String> {
    let cures = results.get("cures").filter(|own| own.is_object())?;
    if let Some(reason) = cures["reason"].as_str().filter(|own| !own.is_empty()) {
        return Some(format!("cures: none is listed: {reason}"));
    }
    let keys = cures["keys"].as_array()?;
    let first = keys.first()?;
    let change = first["change"].as_f64().map_or_else(|| "no change".to_owned(), per_cent);
    let more = match keys.len() {
        1 => String::new(),
        count => format!("; {} more in the report", count - 1),
    };
    let mode = mode_at(cures["frequency_hz"].as_f64().unwrap_or(f64::NAN));
    let then = [words(&first["at_change"]), words(&first["reason"])].concat();
    Some(format!("cures of the {mode}: {} by {change}: {then}{more}", words(&first["key"])))
}

/// A value as a table shows it.
fn words(own: &Value) -> String {
    match own {
        Value::Null => String::new(),
        Value::Bool(is_so) => if *is_so { "yes" } else { "no" }.to_owned(),
        Value::String(words) => words.clone(),
        number => short(number),
    }
}

/// What becomes of knocks.
fn knocks(results: &Map<String, Value>) -> Option<PageTable> {
    let knocks = results.get("knocks").filter(|own| own.is_object())?;
    let rows = [
        ("impulses (N s)", format!("{} … {}", words(&knocks["impulse"][0]), words(&knocks["impulse"][1]))),
        ("knocks", words(&knocks["samples"])),
        ("small motions", words(&knocks["small_motions"])),
        ("settle to steady sliding", words(&knocks["settle"])),
        ("keep vibrating", words(&knocks["vibrate"])),
        ("undecided", words(&knocks["undecided"])),
        ("share that keeps vibrating (−)", words(&knocks["share"])),
        (
            "its 95 % interval (−)",
            format!("{} … {}", words(&knocks["interval"][0]), words(&knocks["interval"][1])),
        ),
        ("smallest that keeps vibrating (N s)", words(&knocks["smallest_that_vibrates"])),
        ("largest that settles (N s)", words(&knocks["largest_that_settles"])),
    ];
    let rows = rows.map(|(name, value)| vec![name.to_owned(), value]).to_vec();
    let caption = format!("Knocks at {}, from steady sliding", words(&knocks["at"]));
    Some(PageTable { caption, head: vec![String::new(); 2], rows })
}

/// What would keep the leading mode from growing.
fn cures(results: &Map<String, Value>) -> Option<PageTable> {
    let cures = results.get("cures").filter(|own| own.is_object())?;
    if let Some(reason) = cures["reason"].as_str().filter(|own| !own.is_empty()) {
        let caption = "What would keep a mode from growing".to_owned();
        let rows = vec![vec![format!("none is listed: {reason}")]];
        return Some(PageTable { caption, head: vec![String::new()], rows });
    }
    let row = |own: &Value| {
        let change = own["change"].as_f64().map_or_else(String::new, per_cent);
        let rest = ["at_change", "growth_by_change", "reason"].map(|key| words(&own[key]));
        let value = ShownValues::of(own).value(&own["value"]);
        [vec![words(&own["key"]), value, words(&own[SHOWN_UNIT]), change], rest.to_vec()].concat()
    };
    let heads = [
        "number",
        "value",
        "unit",
        "change at first order",
        "with that change, solved anew",
        "growth rate by relative change (1/s)",
        "",
    ];
    let mode = mode_at(cures["frequency_hz"].as_f64().unwrap_or(f64::NAN));
    let caption = format!("What would keep the {mode} from growing");
    let rows = cures["keys"].as_array()?.iter().map(row).collect();
    Some(PageTable { caption, head: heads.map(String::from).to_vec(), rows })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// A case in which nothing grows, but cycles exist and knocks lead to them.
    #[test]
    fn margins_knocks_and_cures_have_a_line_each() {
        let onset = json!({ "onset": 1.04, "fold": 1.557, "margin": 0.4975 });
        let told = json!({
            "band_hz": [0.1, 0.4],
            "modes": [],
            "margin": {
                "key": "contact.belt.sliding.velocity", "shown_unit": "m/s", "largest": 0.4975, "knock": true, "knock_reason": "",
                "onsets": [onset]
            },
            "knocks": {
                "at": "mass.x", "samples": 40, "vibrate": 11, "settle": 29, "undecided": 0, "interval": [0.16, 0.43],
                "smallest_that_vibrates": 0.864, "small_motions": "decay at all frequencies"
            },
            "cures": { "reason": "no mode grows" }
        });
        let told = told.as_object().unwrap();
        assert_eq!(
            lines(told),
            [
                "margin along contact.belt.sliding.velocity: 0.4975, from the onset at 1.04 to 1.557 m/s; a knock may suffice",
                "knocks at mass.x: of 40 11 keep vibrating from 0.864 N s on, 29 settle, 0 undecided; share 0.16 … 0.43; small motions decay at all frequencies",
                "cures: none is listed: no mode grows"
            ]
        );
        let rows = modes(told)[0].rows.concat();
        assert!(rows.len() == 2 && rows[1].starts_with("but knocks suffice"), "{rows:?}");
        assert!(lines(json!({ "modes": [] }).as_object().unwrap()).is_empty());
    }
}
