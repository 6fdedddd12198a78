//! The table of undamped modes.

use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short};
use judder_study::text::number;
use serde_json::{Map, Value};

/// A column of the table: its key, its head, and a value in words.
type ModeColumn = (&'static str, &'static str, fn(&Value) -> String);

/// A column that there is: its head, a value in words, its values.
type GivenColumn<'a> = (&'static str, fn(&Value) -> String, &'a Vec<Value>);

const ALONE: &[ModeColumn] =
    &[("frequencies_hz", "frequency (Hz)", short), ("damping_ratios", "damping ratio (−)", short)];
/// Beside a reduction, which differs in digits that a frequency alone does not need.
const BESIDE_REDUCED: &[ModeColumn] = &[
    ("frequencies_hz", "full (Hz)", digits),
    ("damping_ratios", "damping ratio (−)", short),
    ("reduced_hz", "reduced (Hz)", digits),
    ("reduction_errors", "reduced less full", percent),
];

/// Frequencies, with what damping and a reduction there are; those of rigid motions are rounding.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let list = |key: &str| results.get(key).and_then(Value::as_array).filter(|list| !list.is_empty());
    let asked = if list("reduced_hz").is_some() { BESIDE_REDUCED } else { ALONE };
    let columns = asked.iter().filter_map(|(key, head, words)| Some((*head, *words, list(key)?)));
    let columns: Vec<GivenColumn<'_>> = columns.collect();
    let rigid = results.get("rigid_modes").and_then(Value::as_u64).unwrap_or(0);
    let Some(frequencies) = list("frequencies_hz") else { return Vec::new() };
    let head: Vec<&str> = ["mode"].into_iter().chain(columns.iter().map(|(head, ..)| *head)).collect();
    vec![listed("Modes", &head, frequencies, |mode, _| {
        let cell = |(place, (_, words, values)): (usize, &GivenColumn<'_>)| {
            if place == 0 && mode as u64 <= rigid {
                return "0, a rigid motion".to_owned();
            }
            values.get(mode - 1).map_or_else(String::new, words)
        };
        let cells = columns.iter().enumerate().map(cell);
        [mode.to_string()].into_iter().chain(cells).collect()
    })]
}

fn digits(value: &Value) -> String {
    value.as_f64().map_or_else(|| "none".to_owned(), number)
}

fn percent(value: &Value) -> String {
    value.as_f64().map_or_else(String::new, |error| format!("{:.4} %", 100.0 * error))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn rows(results: Value) -> (Vec<String>, Vec<Vec<String>>) {
        let table = report(results.as_object().unwrap()).remove(0);
        (table.head, table.rows)
    }

    #[test]
    fn a_rigid_motion_has_no_frequency_of_its_own() {
        let (head, rows) = rows(json!({ "frequencies_hz": [1.4e-3, 511.07], "rigid_modes": 1 }));
        assert_eq!(head, ["mode", "frequency (Hz)"]);
        assert_eq!(rows, [["1", "0, a rigid motion"], ["2", "511.07"]]);
    }

    #[test]
    fn a_reduction_that_lacks_a_mode_has_none() {
        let (head, rows) = rows(json!({
            "frequencies_hz": [45.0, 286.0], "rigid_modes": 0, "reduced_hz": [45.1, null], "reduction_errors": [2e-3, null],
        }));
        assert_eq!(head[1..], ["full (Hz)", "reduced (Hz)", "reduced less full"]);
        assert_eq!(rows[0], ["1", "45.0000000", "45.1000000", "0.2000 %"]);
        assert_eq!(rows[1][2..], ["none", ""]);
    }
}
