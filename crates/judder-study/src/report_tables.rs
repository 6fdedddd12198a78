//! Tables of the report beside the scalars: eigenvalues, why modes grow, bursts, what a sweep says.

mod sweep;

pub(crate) use sweep::{interval, short_index};

use judder_report::PageBlock;
use judder_report::page::PageTable;
use serde_json::{Map, Value};

/// Rows that a table shows; all are in the CSV file.
const ROWS: usize = 40;

/// The tables of an analysis that has complex modes or bursts, and of a sweep.
pub(crate) fn tables(results: &Map<String, Value>) -> Vec<PageBlock> {
    let mut blocks = complex_modes(results);
    let listed = results.get("bursts").and_then(Value::as_array).filter(|listed| !listed.is_empty());
    blocks.extend(listed.map(|listed| PageBlock::Table(bursts(listed))));
    blocks.extend(sweep::tables(results));
    blocks
}

/// Bursts with the growth that was measured and that of the zone which they passed.
fn bursts(listed: &[Value]) -> PageTable {
    let keys = [
        "time_s",
        "position_m",
        "frequency_hz",
        "peak",
        "duration_s",
        "measured_amplification",
        "expected_amplification",
    ];
    let head = [
        "time (s)",
        "position (m)",
        "frequency (Hz)",
        "peak",
        "duration (s)",
        "growth of its mode, ln",
        "∫ $σ$ d$t$ of its zone",
    ];
    let more =
        if listed.len() > ROWS { format!(", the first {ROWS} of {}", listed.len()) } else { String::new() };
    PageTable {
        caption: format!("Bursts{more}"),
        head: head.map(String::from).to_vec(),
        rows: listed.iter().take(ROWS).map(|own| keys.map(|key| short(&own[key])).to_vec()).collect(),
    }
}

fn complex_modes(results: &Map<String, Value>) -> Vec<PageBlock> {
    let is_list = |value: &&Vec<Value>| value.first().is_some_and(|first| first.get("verdict").is_some());
    let Some(values) = results.get("eigenvalues").and_then(Value::as_array).filter(is_list) else {
        return Vec::new();
    };
    let mut blocks = vec![PageBlock::Table(eigenvalues(values))];
    let diagnoses = results.get("diagnosis").and_then(Value::as_array);
    blocks.extend(diagnoses.into_iter().flatten().map(|told| PageBlock::Table(diagnosis(told))));
    blocks
}

fn eigenvalues(values: &[Value]) -> PageTable {
    let row = |(k, value): (usize, &Value)| {
        let numbers = ["re", "im", "frequency_hz", "damping_ratio", "error", "residual"];
        let mut cells = vec![(k + 1).to_string()];
        cells.extend(numbers.iter().map(|name| short(&value[*name])));
        cells.push(value["verdict"].as_str().unwrap_or_default().to_owned());
        cells
    };
    let more =
        if values.len() > ROWS { format!(", the first {ROWS} of {}", values.len()) } else { String::new() };
    let head = [
        "mode",
        "Re $λ$ (1/s)",
        "Im $λ$ (1/s)",
        "frequency (Hz)",
        "damping ratio",
        "error (1/s)",
        "residual",
        "verdict",
    ];
    PageTable {
        caption: format!("Eigenvalues{more}"),
        head: head.map(String::from).to_vec(),
        rows: values.iter().enumerate().take(ROWS).map(row).collect(),
    }
}

/// What each matrix adds to the growth rate of a mode, which undamped modes take part, what changes it.
fn diagnosis(told: &Value) -> PageTable {
    let mut rows = Vec::new();
    let mut row = |what: String, value: String, change: String| rows.push(vec![what, value, change]);
    for own in told["matrices"].as_array().into_iter().flatten() {
        let name = format!("{} ({})", word(&own["name"]), word(&own["part"]));
        row(name, short(&own["growth"]), short(&own["sensitivity"][0]));
    }
    row(energy_words(told), short(&told["sum"]), String::new());
    for own in told["parameters"].as_array().into_iter().flatten() {
        row(format!("parameter {}", word(&own["name"])), String::new(), short(&own["sensitivity"][0]));
    }
    for own in told["component_modes"].as_array().into_iter().flatten() {
        let name = format!(
            "undamped mode {}{} at {} Hz: share of the kinetic energy",
            own["mode"],
            modes_of(told["component_modes_of"].as_str()),
            short(&own["frequency_hz"])
        );
        row(name, short(&own["share"]), String::new());
    }
    let head = ["what", "growth (1/s), or share", "change of the growth rate per unit (1/s)"];
    PageTable {
        caption: format!("Why mode {} at {} Hz grows", told["mode"], short(&told["frequency_hz"])),
        head: head.map(String::from).to_vec(),
        rows,
    }
}

/// Of what undamped modes are, where they are not those of the matrices as they are.
pub fn modes_of(name: Option<&str>) -> &'static str {
    match name {
        Some("frictionless") => " without friction",
        Some("symmetric-part") => " of the symmetric part",
        _ => "",
    }
}

/// What the growths sum to, and what the energy by which they are divided makes of them.
fn energy_words(told: &Value) -> String {
    let energy = &told["energy"];
    let share = || short(&energy["share"]);
    match energy["sign"].as_str() {
        Some("none") => {
            format!("no sum: the energy is zero, {} of its parts: the mode grows without work", share())
        }
        Some("negative") => format!(
            "sum: the growth rate; the energy is negative, {} of its parts: what takes energy out lets the mode grow; relative error of the growths {}",
            share(),
            short(&energy["growth_error"])
        ),
        Some(_) => {
            format!("sum: the growth rate; relative error of the growths {}", short(&energy["growth_error"]))
        }
        // stored before energies were
        None => "sum: the growth rate".to_owned(),
    }
}

fn word(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

/// A number to six digits; a dash where there is none.
fn short(value: &Value) -> String {
    match value.as_f64() {
        None => "–".to_owned(),
        Some(value) => {
            let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
            let plain = value == 0.0 || (1e-3..1e7).contains(&value.abs());
            if plain { format!("{rounded}") } else { format!("{rounded:e}") }.replace('-', "−")
        }
    }
}
