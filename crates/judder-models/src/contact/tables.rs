//! The tables of contact analyses: coefficients, terms, errors of a law.

use crate::swept_tables::{table, told, word};
use judder_report::page::PageTable;
use judder_study::registry::ToldAnalysis;
use judder_study::report_tables::listed;
use judder_study::shown::{SHOWN_UNIT, ShownValues};
use serde_json::Value;

/// A number of a row.
fn number(row: &Value, key: &str) -> String {
    told(row[key].as_f64().unwrap_or(f64::NAN))
}

/// The items of a list; nothing where there are none.
fn list<'a>(analysis: ToldAnalysis<'a>, key: &str) -> Option<&'a Vec<Value>> {
    analysis.results.get(key).and_then(Value::as_array).filter(|items| !items.is_empty())
}

/// The fitted coefficients beside the paper's.
pub(crate) fn fit(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    const NUMBERS: [&str; 5] = ["value", "standard_error", "paper", "deviation", "relative_deviation"];
    let head = [
        "coefficient",
        "fitted (−)",
        "standard error (−)",
        "the paper's (−)",
        "deviation (−)",
        "deviation (relative)",
    ];
    let of = |items: &Vec<Value>| {
        listed("Coefficients beside the paper's", &head, items, |_, own| {
            let numbers = NUMBERS.iter().map(|key| number(own, key));
            [word(&own["name"]).to_owned()].into_iter().chain(numbers).collect()
        })
    };
    list(analysis, "beside_the_paper").map(of).into_iter().collect()
}

/// The terms of the creep form.
pub(crate) fn modulus(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let shown = ShownValues::called(analysis.results.get(SHOWN_UNIT).and_then(Value::as_str));
    let head = [&*shown.head("retardation time"), "compliance (1/Pa)"];
    let of = |items: &Vec<Value>| {
        listed("Terms of the creep form", &head, items, |_, own| {
            vec![shown.value(&own["time_second"]), number(own, "compliance_per_pascal")]
        })
    };
    list(analysis, "prony").map(of).into_iter().collect()
}

/// What the law is known to.
pub(crate) fn law(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let rows = [("interpolation_error", "between its knots"), ("solver_error", "of the solved contacts")];
    let rows = rows.into_iter().filter_map(|(key, words)| {
        let own = analysis.results.get(key)?;
        let numbers = ["force", "area", "friction"].map(|key| number(own, key));
        Some([words.to_owned()].into_iter().chain(numbers).collect())
    });
    let rows: Vec<Vec<String>> = rows.collect();
    let head = ["error", "force (relative)", "area (relative)", "friction (relative)"];
    if rows.is_empty() { Vec::new() } else { vec![table("What the law is known to".to_owned(), &head, rows)] }
}

/// The errors of one contact.
pub(crate) fn single(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let errors = analysis.results.get("errors").and_then(Value::as_object);
    let of = |errors: &serde_json::Map<String, Value>| {
        let rows = errors.iter().map(|(name, error)| {
            let value = analysis.results.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN);
            vec![name.replace('_', " "), told(value), told(error.as_f64().unwrap_or(f64::NAN))]
        });
        table("The contact".to_owned(), &["quantity", "in groups (−)", "error (relative)"], rows.collect())
    };
    errors.map(of).into_iter().collect()
}
