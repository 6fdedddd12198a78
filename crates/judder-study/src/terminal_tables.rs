//! Tables that a run shows on the terminal, beside the report.

use crate::registry::{Registry, ToldAnalysis};
use crate::report_tables::{interval, probabilities, short_index};
use crate::text::columns;
use judder_store::Summary;
use serde_json::{Map, Value};

/// What the analyses of these names have to show, each below its name.
pub(crate) fn tables(registry: Registry, summary: &Summary, names: &[String]) -> Vec<String> {
    let table = |name: &String| {
        let result = summary.results.get(name)?;
        let of_kind = registry
            .tables(&summary.case, name)
            .and_then(|(tables, asked)| tables.on_terminal(ToldAnalysis { asked, results: result }));
        let text = of_kind.map(|text| format!("{name}:\n{}", text.trim_end()));
        text.or_else(|| sweep(name, result))
    };
    names.iter().filter_map(table).collect()
}

/// How many points of a sweep have an answer, and what decides its quantities; `None` of anything else.
fn sweep(name: &str, result: &Map<String, Value>) -> Option<String> {
    result.get("quantities")?;
    let count = |key: &str| result.get(key).and_then(Value::as_u64);
    let (points, failed, doubtful) = (count("points")?, count("failed")?, count("doubtful")?);
    let mut text = format!("{name}: {points} points, {failed} failed, {doubtful} doubtful");
    if let Some(told) = probabilities(result) {
        let rows: Vec<Vec<String>> = std::iter::once(told.head).chain(told.rows).collect();
        text.push_str(&format!("\n{}", columns(&rows).trim_end()));
    }
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
