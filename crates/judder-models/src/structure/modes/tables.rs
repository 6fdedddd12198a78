//! The table of modes on the terminal.

use judder_study::text::number;
use serde_json::{Map, Value};

/// What a reduction costs: frequencies of the full structure and of the reduced one; `None` where there is no reduction.
pub(crate) fn terminal(results: &Map<String, Value>) -> Option<Vec<Vec<String>>> {
    let list = |key: &str| results.get(key).and_then(Value::as_array);
    let (full, reduced, errors) = (list("frequencies_hz")?, list("reduced_hz")?, list("reduction_errors")?);
    let mut rows =
        vec![["mode", "full (Hz)", "reduced (Hz)", "reduced less full"].map(str::to_owned).to_vec()];
    let frequency = |value: &Value| value.as_f64().map_or_else(|| "none".to_owned(), number);
    for (k, ((full, reduced), error)) in full.iter().zip(reduced).zip(errors).enumerate() {
        let error = error.as_f64().map_or_else(String::new, |error| format!("{:.4} %", 100.0 * error));
        rows.push(vec![(k + 1).to_string(), frequency(full), frequency(reduced), error]);
    }
    Some(rows)
}
