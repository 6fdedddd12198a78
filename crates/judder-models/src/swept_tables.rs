//! What tables of analyses along a swept key have in common: heads, curves of a family, ranges in which something holds.

use crate::labels;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::Form;
use judder_report::page::PageTable;
use judder_study::registry::ToldAnalysis;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// A curve of a family, what of the family it is, and its scalars.
pub(crate) struct ToldCurve<'a> {
    /// Empty where there is no family, else `, KEY = VALUE`.
    pub(crate) of_family: String,
    pub(crate) results: &'a Map<String, Value>,
}

/// The curves of an analysis: the whole where there is no family.
pub(crate) fn curves(told: ToldAnalysis<'_>) -> Vec<ToldCurve<'_>> {
    let Some(curves) = told.results.get("curves").and_then(Value::as_array) else {
        return vec![ToldCurve { of_family: String::new(), results: told.results }];
    };
    let family = &told.asked["family"];
    let values = &family["values"];
    let of_family = |k: usize| format!(", {} = {}", word(&family["key"]), with_unit(&values[k]));
    let told = curves
        .iter()
        .enumerate()
        .filter_map(|(k, own)| own.as_object().map(|results| ToldCurve { of_family: of_family(k), results }));
    told.collect()
}

/// A canonical value in words.
fn with_unit(value: &Value) -> String {
    match value.get("unit").and_then(Value::as_str) {
        Some(unit) => format!("{} {unit}", short(&value["value"])),
        None => short(value),
    }
}

/// The form in which the ends of a canonical range are.
pub(crate) fn form_of(range: &Value) -> Form {
    if range["from"].is_object() { Form::Si } else { Form::Group }
}

/// The head of a swept key of a model: words, symbol and unit, as at an axis.
pub(crate) fn key_head<K: Keys>(axis: &Value) -> String {
    let path = word(&axis["key"]);
    let entry = K::ALL.iter().find(|entry| entry.path == path);
    entry.map_or_else(|| path.to_owned(), |entry| labels::key(entry.key, form_of(axis)).label)
}

/// The head of a swept parameter.
pub(crate) fn parameter_head(axis: &Value) -> String {
    labels::parameter(word(&axis["key"]).trim_start_matches("parameters.")).label
}

/// A head of values of the key that `swept` is the head of, with the unit at its end.
pub(crate) fn in_unit_of(swept: &str, head: &str) -> String {
    match swept.strip_suffix(')').and_then(|own| own.rsplit_once(" (")) {
        Some((_, unit)) => format!("{head} ({unit})"),
        None => head.to_owned(),
    }
}

/// A word, nothing where it is none.
pub(crate) fn word(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

/// The numbers of a list, NaN where there is none.
pub(crate) fn numbers(list: Option<&Value>) -> Vec<f64> {
    list.and_then(Value::as_array).into_iter().flatten().map(|own| own.as_f64().unwrap_or(f64::NAN)).collect()
}

/// Two lists that go together, as long as the shorter.
pub(crate) fn along(results: &Map<String, Value>, keys: [&str; 2]) -> [Vec<f64>; 2] {
    let mut lists = keys.map(|key| numbers(results.get(key)));
    let points = lists[0].len().min(lists[1].len());
    lists.iter_mut().for_each(|list| list.truncate(points));
    lists
}

/// A number for a table.
pub(crate) fn told(value: f64) -> String {
    short(&Value::from(value))
}

/// Neighbouring places of a sweep at which something holds: the first and the last.
pub(crate) fn runs(holds: &[bool]) -> Vec<[usize; 2]> {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for place in (0..holds.len()).filter(|place| holds[*place]) {
        match runs.last_mut() {
            Some(run) if run[1] + 1 == place => run[1] = place,
            _ => runs.push([place, place]),
        }
    }
    runs
}

/// The ends of a run along a sweep in words: between which values it begins and ends; where it lies at an end of the sweep that end alone is known.
pub(crate) fn ends(values: &[f64], [first, last]: [usize; 2]) -> [String; 2] {
    let between = |one: usize, other: usize| format!("{} … {}", told(values[one]), told(values[other]));
    let begins = if first > 0 { between(first - 1, first) } else { format!("{} or before", told(values[0])) };
    let ends = match last + 1 < values.len() {
        true => between(last, last + 1),
        false => format!("{} or beyond", told(values[last])),
    };
    [begins, ends]
}

/// The rows of what was found in ranges; one that says so where there is none.
pub(crate) fn or_none(rows: Vec<Vec<String>>, values: usize, columns: usize) -> Vec<Vec<String>> {
    if !rows.is_empty() {
        return rows;
    }
    let mut none = vec![format!("none at {values} values")];
    none.resize(columns, String::new());
    vec![none]
}

/// A table with this caption, head and rows.
pub(crate) fn table(caption: String, head: &[&str], rows: Vec<Vec<String>>) -> PageTable {
    PageTable { caption, head: head.iter().map(|word| (*word).to_owned()).collect(), rows }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heads_have_the_unit_of_the_swept_key() {
        assert_eq!(in_unit_of("Speed $v$ (mm/s)", "from"), "from (mm/s)");
        assert_eq!(in_unit_of("Speed over $R/τ$", "from"), "from");
    }

    #[test]
    fn runs_are_told_with_what_is_known_of_their_ends() {
        let values = [1.0, 2.0, 3.0, 4.0, 5.0];
        let found = runs(&[true, true, false, true, false]);
        assert_eq!(found, [[0, 1], [3, 3]]);
        assert_eq!(ends(&values, found[0]), ["1 or before", "2 … 3"]);
        assert_eq!(ends(&values, found[1]), ["3 … 4", "4 … 5"]);
        assert_eq!(ends(&values, [4, 4])[1], "5 or beyond");
        assert!(runs(&[false; 3]).is_empty());
    }
}
