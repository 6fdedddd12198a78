//! Results that a run shows on the terminal, beside the report.

use crate::report_tables::{interval, short_index};
use crate::text::{columns, number};
use judder_store::Summary;
use serde_json::{Map, Value};

/// What the analyses of these names have to show, each below its name.
pub(crate) fn tables(summary: &Summary, names: &[String]) -> Vec<String> {
    let table = |name: &String| {
        let result = summary.results.get(name)?;
        reduction(name, result).or_else(|| sweep(name, result))
    };
    names.iter().filter_map(table).collect()
}

/// What a reduction costs: frequencies of the full structure and of the reduced one; `None` where there is no reduction.
fn reduction(name: &str, result: &Map<String, Value>) -> Option<String> {
    let list = |key: &str| result.get(key).and_then(Value::as_array);
    let (full, reduced, errors) = (list("frequencies_hz")?, list("reduced_hz")?, list("reduction_errors")?);
    let mut rows =
        vec![["mode", "full (Hz)", "reduced (Hz)", "reduced less full"].map(str::to_owned).to_vec()];
    let frequency = |value: &Value| value.as_f64().map_or_else(|| "none".to_owned(), number);
    for (k, ((full, reduced), error)) in full.iter().zip(reduced).zip(errors).enumerate() {
        let error = error.as_f64().map_or_else(String::new, |error| format!("{:.4} %", 100.0 * error));
        rows.push(vec![(k + 1).to_string(), frequency(full), frequency(reduced), error]);
    }
    Some(format!("{name}:\n{}", columns(&rows).trim_end()))
}

/// How many points of a sweep have an answer, and what decides its quantities; `None` of anything else.
fn sweep(name: &str, result: &Map<String, Value>) -> Option<String> {
    result.get("quantities")?;
    let count = |key: &str| result.get(key).and_then(Value::as_u64);
    let (points, failed, doubtful) = (count("points")?, count("failed")?, count("doubtful")?);
    let mut text = format!("{name}: {points} points, {failed} failed, {doubtful} doubtful");
    let sensitivity = result.get("sensitivity").and_then(Value::as_object);
    for (quantity, told) in sensitivity.into_iter().flatten() {
        let (Some(first), Some(confidence)) = (told["first"].as_object(), told["confidence"].as_f64()) else {
            continue;
        };
        let percent = format!("{} %", 100.0 * confidence);
        let head = [quantity, "first order", &percent, "total", &percent];
        let mut rows = vec![head.map(str::to_owned).to_vec()];
        for (key, own) in first {
            let total = &told["total"][key];
            rows.push(vec![
                key.clone(),
                short_index(&own["value"]),
                interval(own),
                short_index(&total["value"]),
                interval(total),
            ]);
        }
        text.push_str(&format!("\n{}", columns(&rows).trim_end()));
    }
    Some(text)
}
