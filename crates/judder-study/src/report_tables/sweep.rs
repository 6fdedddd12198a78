//! Tables of a sweep: what its quantities are, what decides them, which points have no answer.

use super::short;
use crate::labels::with_unit;
use judder_numerics::order::sort_by_number;
use judder_report::page::PageTable;
use serde_json::{Map, Value};

/// The tables of a sweep; none where the result is of something else.
pub(crate) fn tables(results: &Map<String, Value>) -> Vec<PageTable> {
    let Some(quantities) = results.get("quantities").and_then(Value::as_object) else { return Vec::new() };
    let (classes, numbers): (Vec<_>, Vec<_>) =
        quantities.iter().partition(|(_, told)| told["of"].is_object());
    let mut tables = Vec::new();
    if !numbers.is_empty() {
        tables.push(of_numbers(&numbers));
    }
    if !classes.is_empty() {
        tables.push(of_classes(&classes));
    }
    tables.extend(probabilities(results));
    let sensitivity = results.get("sensitivity").and_then(Value::as_object);
    let known = sensitivity.into_iter().flatten().filter(|(_, told)| told.is_object());
    tables.extend(known.map(|(quantity, told)| indices(quantity, told)));
    let failures = results.get("failures").and_then(Value::as_array).filter(|failures| !failures.is_empty());
    tables.extend(failures.map(|listed| failed(listed, results)));
    tables
}

type ToldScalar<'a> = (&'a String, &'a Value);

fn of_numbers(quantities: &[ToldScalar<'_>]) -> PageTable {
    let head = ["quantity", "points", "smallest", "largest", "mean", "standard deviation"];
    let row = |(name, told): &ToldScalar<'_>| {
        let numbers = ["count", "min", "max", "mean", "standard_deviation"];
        let name = with_unit(name, told["units"].as_str().unwrap_or_default());
        std::iter::once(name).chain(numbers.iter().map(|key| short(&told[*key]))).collect()
    };
    PageTable {
        caption: "Quantities over all points that have them".to_owned(),
        head: head.map(str::to_owned).to_vec(),
        rows: quantities.iter().map(row).collect(),
    }
}

fn of_classes(quantities: &[ToldScalar<'_>]) -> PageTable {
    let rows = quantities.iter().flat_map(|(name, told)| {
        let points = told["count"].as_f64().unwrap_or(0.0);
        let classes = told["of"].as_object().into_iter().flatten();
        classes.map(move |(class, count)| {
            let share = 100.0 * count.as_f64().unwrap_or(0.0) / points.max(1.0);
            vec![(*name).clone(), class.replace('_', " "), short(count), format!("{share:.2} %")]
        })
    });
    PageTable {
        caption: "Classes".to_owned(),
        head: ["quantity", "class", "points", "share"].map(str::to_owned).to_vec(),
        rows: rows.collect(),
    }
}

/// The share of the points at which each condition holds, with its interval.
pub(crate) fn probabilities(results: &Map<String, Value>) -> Option<PageTable> {
    let told = results.get("probabilities")?.as_array()?;
    let row = |own: &Value| {
        let condition = own["condition"].as_str().unwrap_or_default().to_owned();
        let counts = ["holds", "count", "unknown"].map(|key| short(&own[key]));
        [vec![condition, short_index(&own["value"]), interval(own)], counts.to_vec()].concat()
    };
    let head = ["condition", "probability", "95 %", "holds", "of", "not known"];
    Some(PageTable {
        caption: "How probable it is, with the keys evenly distributed over their ranges".to_owned(),
        head: head.map(str::to_owned).to_vec(),
        rows: told.iter().map(row).collect(),
    })
}

/// First-order and total index of every key, the largest total first.
fn indices(quantity: &str, told: &Value) -> PageTable {
    let mut keys: Vec<&String> =
        told["total"].as_object().into_iter().flatten().map(|(key, _)| key).collect();
    let total = |key: &str| told["total"][key]["value"].as_f64().unwrap_or(f64::NEG_INFINITY);
    sort_by_number(&mut keys, |own| -total(own));
    let with_interval = |own: &Value| [short_index(&own["value"]), interval(own)];
    let row = |key: &&String| {
        let [first, first_interval] = with_interval(&told["first"][key.as_str()]);
        let [total, total_interval] = with_interval(&told["total"][key.as_str()]);
        vec![(*key).clone(), first, first_interval, total, total_interval]
    };
    let left_out = match told["left_out"].as_u64() {
        Some(rows) if rows > 0 => format!(", {rows} rows without an answer left out"),
        _ => String::new(),
    };
    let percent = 100.0 * told["confidence"].as_f64().unwrap_or(f64::NAN);
    PageTable {
        caption: format!(
            "Sensitivity of {quantity}: Sobol' indices from {} rows{left_out}",
            short(&told["rows"])
        ),
        head: vec![
            "key".to_owned(),
            "first order".to_owned(),
            format!("{percent} %"),
            "total".to_owned(),
            format!("{percent} %"),
        ],
        rows: keys.iter().map(row).collect(),
    }
}

/// An index to three decimals, which is more than it is known to.
pub(crate) fn short_index(value: &Value) -> String {
    let Some(value) = value.as_f64() else { return "–".to_owned() };
    let text = format!("{value:.3}");
    if text == "-0.000" { "0.000".to_owned() } else { text.replace('-', "−") }
}

/// The confidence interval of an index.
pub(crate) fn interval(own: &Value) -> String {
    format!("{} … {}", short_index(&own["from"]), short_index(&own["to"]))
}

fn failed(listed: &[Value], results: &Map<String, Value>) -> PageTable {
    let count = |key: &str| results.get(key).and_then(Value::as_u64).unwrap_or(0);
    let all = count("failed") + count("doubtful");
    let at = |own: &Value| {
        let values = own["at"].as_object().into_iter().flatten();
        values.map(|(key, value)| format!("{key} = {}", short(value))).collect::<Vec<_>>().join(", ")
    };
    let row = |own: &Value| vec![at(own), own["reason"].as_str().unwrap_or_default().to_owned()];
    let more = if (listed.len() as u64) < all {
        format!(", the first {} of {all}", listed.len())
    } else {
        String::new()
    };
    PageTable {
        caption: format!("Points without an answer, or with a doubtful one{more}"),
        head: ["where", "why"].map(str::to_owned).to_vec(),
        rows: listed.iter().map(row).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn rows(results: Value) -> Vec<Vec<Vec<String>>> {
        let Value::Object(results) = results else { unreachable!() };
        tables(&results).into_iter().map(|table| table.rows).collect()
    }

    #[test]
    fn a_sweep_is_told_in_tables() {
        let index = |value: f64| json!({ "value": value, "from": value - 0.1, "to": value + 0.1 });
        let told = rows(json!({
            "points": 8, "failed": 1, "doubtful": 30,
            "quantities": {
                "growth_rate": { "count": 7, "min": -1e-9, "max": 2.0, "mean": 0.5, "standard_deviation": null, "units": "1/s" },
                "verdict": { "count": 8, "of": { "stable": 6, "unstable": 2 } },
            },
            "sensitivity": {
                "growth_rate": {
                    "rows": 2, "left_out": 1, "confidence": 0.9,
                    "first": { "a": index(-0.05), "b": index(0.2) }, "total": { "a": index(0.1), "b": index(0.7) },
                },
                "verdict": null,
            },
            "failures": [{ "at": { "a": 0.1, "b": 1e-9 }, "reason": "no steady sliding" }],
        }));
        assert_eq!(told[0], [["growth_rate (1/s)", "7", "−1e−9", "2", "0.5", "–"]]);
        assert_eq!(told[1][1], ["verdict", "unstable", "2", "25.00 %"]);
        assert_eq!(told[2][0], ["b", "0.200", "0.100 … 0.300", "0.700", "0.600 … 0.800"]);
        assert_eq!(told[2][1][1], "−0.050");
        assert_eq!(short_index(&json!(-1e-9)), "0.000");
        assert_eq!(told[3], [["a = 0.1, b = 1e−9", "no steady sliding"]]);
    }

    #[test]
    fn other_results_are_not_told_so() {
        assert!(rows(json!({ "points": 3, "failures": [] })).is_empty());
    }
}
