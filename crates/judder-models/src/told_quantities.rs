//! Tables of single quantities: what each is, and its value with its unit.

use crate::swept_tables::{table, told};
use judder_report::page::PageTable;
use judder_study::labels::with_unit;
use judder_study::prefixed::PrefixedUnit;
use serde_json::{Map, Value};

/// A quantity of a summary: its key, within tables after dots, what it is, and its unit in SI; `1` of plain numbers, nothing of counts and words.
pub(crate) type ToldQuantity = (&'static str, &'static str, &'static str);

/// Frequencies and levels are told as they are.
const PLAIN: [&str; 4] = ["Hz", "dB", "1/s", "°"];

/// Those that the summary has, texts as they are, numbers in the unit in which they are best read; no table where there are none.
pub(crate) fn quantities(
    caption: &str,
    results: &Map<String, Value>,
    asked: &[ToldQuantity],
) -> Vec<PageTable> {
    let rows = asked.iter().filter_map(|(key, words, unit)| {
        let mut parts = key.split('.');
        let first = results.get(parts.next()?)?;
        let own = parts.try_fold(first, |own, part| own.get(part))?;
        let cell = own.as_str().map(str::to_owned).or_else(|| Some(in_words(own.as_f64()?, unit)))?;
        let has_dash = *unit == "1" && !words.contains('(');
        Some(vec![if has_dash { with_unit(words, unit) } else { (*words).to_owned() }, cell])
    });
    let rows: Vec<Vec<String>> = rows.collect();
    if rows.is_empty() { Vec::new() } else { vec![table(caption.to_owned(), &["quantity", "value"], rows)] }
}

/// A number with its unit.
pub(crate) fn in_words(value: f64, unit: &str) -> String {
    if ["", "1"].contains(&unit) {
        return told(value);
    }
    if PLAIN.contains(&unit) {
        return format!("{} {unit}", told(value));
    }
    let shown = PrefixedUnit::of(unit, value);
    format!("{} {}", told(shown.factor * value), shown.name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_a_summary_lacks_has_no_row() {
        let results = json!({
            "peak_frequency_hz": 45.5, "peak_m_per_n": 1.0e-3, "method": "events", "of": { "steps": 3 }, "ratio": 0.5, "change": 0.25, "unknown": null,
        });
        let asked = [
            ("peak_frequency_hz", "largest at", "Hz"),
            ("peak_m_per_n", "receptance there", "m/N"),
            ("method", "marched by", ""),
            ("of.steps", "steps", ""),
            ("of.none", "none", ""),
            ("ratio", "ratio", "1"),
            ("change", "change (relative)", "1"),
            ("unknown", "unknown", "Hz"),
        ];
        let table = quantities("Peak", results.as_object().unwrap(), &asked).remove(0);
        let rows: Vec<String> = table.rows.iter().map(|row| row.join(": ")).collect();
        assert_eq!(
            rows,
            [
                "largest at: 45.5 Hz",
                "receptance there: 1 mm/N",
                "marched by: events",
                "steps: 3",
                "ratio (−): 0.5",
                "change (relative): 0.25"
            ]
        );
        assert!(quantities("Peak", &Map::new(), &asked).is_empty());
    }
}
