//! The tables of complex modes in the report.

use crate::structure::undamped::words_of;
use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short, uncertainty};
use serde_json::{Map, Value};

/// The numbers of an eigenvalue.
const NUMBERS: [(&str, &str); 6] = [
    ("re", "Re $λ$ (1/s)"),
    ("im", "Im $λ$ (1/s)"),
    ("frequency_hz", "frequency (Hz)"),
    ("damping_ratio", "damping ratio (−)"),
    ("error", "error (1/s)"),
    ("residual", "residual (−)"),
];

/// Eigenvalues, and why those grow that were diagnosed.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let list = |key: &str| results.get(key).and_then(Value::as_array).filter(|list| !list.is_empty());
    let diagnoses = list("diagnosis").into_iter().flatten().map(diagnosis);
    let shapes = list("shapes").into_iter().flatten().map(shape);
    list("eigenvalues").map(|values| eigenvalues(values)).into_iter().chain(shapes).chain(diagnoses).collect()
}

/// The largest displacements of a shape that has no places to be drawn at.
fn shape(told: &Value) -> PageTable {
    let freedoms = told["freedoms"].as_array().map_or(&[][..], Vec::as_slice);
    let caption = format!("Shape of mode {} at {} Hz", told["mode"], short(&told["frequency_hz"]));
    listed(&caption, &["freedom", "modulus, of the largest (−)", "phase (°)"], freedoms, |number, name| {
        let part = |key: &str| short(&told[key][number - 1]);
        vec![word(name).to_owned(), part("modulus"), part("phase_deg")]
    })
}

fn eigenvalues(values: &[Value]) -> PageTable {
    let head: Vec<&str> =
        ["mode"].into_iter().chain(NUMBERS.map(|(_, head)| head)).chain(["verdict"]).collect();
    listed("Eigenvalues", &head, values, |mode, value| {
        let numbers = NUMBERS.iter().map(|(key, _)| match *key {
            "error" | "residual" => uncertainty(&value[*key]),
            _ => short(&value[*key]),
        });
        [mode.to_string()].into_iter().chain(numbers).chain([word(&value["verdict"]).to_owned()]).collect()
    })
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
            words_of(told["component_modes_of"].as_str()),
            short(&own["frequency_hz"])
        );
        row(name, short(&own["share"]), String::new());
    }
    let head = ["what", "growth (1/s), or share (−)", "change of the growth rate per unit (1/s)"];
    PageTable {
        caption: format!("Why mode {} at {} Hz grows", told["mode"], short(&told["frequency_hz"])),
        head: head.map(String::from).to_vec(),
        rows,
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
