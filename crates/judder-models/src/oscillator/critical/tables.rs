//! The table of thresholds.

use super::run::label;
use crate::oscillator::keys::OscillatorKey;
use crate::oscillator::settings::SoughtThresholds;
use crate::swept_tables::{ToldCurve, curves, form_of, in_unit_of, key_head, numbers, table, told, word};
use judder_report::page::PageTable;
use judder_study::registry::ToldAnalysis;
use serde_json::Value;

/// A row a threshold, and one a value that has none.
pub(crate) fn report(sought: SoughtThresholds, analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let within = &analysis.asked["within"];
    let threshold = label(sought, form_of(within)).0;
    let swept = key_head::<OscillatorKey>(&analysis.asked["sweep"]);
    let of_curve = curves(analysis).into_iter().map(|curve| of_curve(&curve, &swept, threshold));
    of_curve.collect()
}

fn of_curve(curve: &ToldCurve<'_>, swept: &str, threshold: &str) -> PageTable {
    let has_margin = curve.results.contains_key("reaches");
    let [undamped, fold, reaches] =
        ["without damping", "least known fold", "motions known to"].map(|head| in_unit_of(threshold, head));
    let mut head = vec![swept, threshold, &undamped, "onset", "stable side"];
    if has_margin {
        head.extend([fold.as_str(), &reaches]);
    }
    let of = |key: &str, value: usize| curve.results.get(key).map_or(&Value::Null, |all| &all[value]);
    let mut rows = Vec::new();
    for (place, value) in numbers(curve.results.get("value")).into_iter().enumerate() {
        let roots = numbers(Some(of("full", place)));
        let undamped: Vec<String> = numbers(Some(of("conservative", place))).into_iter().map(told).collect();
        let undamped = if undamped.is_empty() { "none".to_owned() } else { undamped.join(", ") };
        if roots.is_empty() {
            rows.push(vec![told(value), "none".to_owned(), undamped.clone()]);
        }
        for (number, root) in roots.into_iter().enumerate() {
            let of_root = |key: &str| &of(key, place)[number];
            let mut row = vec![told(value), told(root), undamped.clone()];
            row.extend(["criticality", "stable_side"].map(|key| word(of_root(key)).to_owned()));
            if has_margin {
                row.extend(["fold", "reaches"].map(|key| told(of_root(key).as_f64().unwrap_or(f64::NAN))));
            }
            rows.push(row);
        }
    }
    for row in &mut rows {
        row.resize(head.len(), String::new());
    }
    table(format!("Thresholds{}", curve.of_family), &head, rows)
}
