//! The table of a spectrum: where along the swept key steady sliding grows.

use crate::oscillator::curves::SpectrumLabels;
use crate::swept_tables::{ToldCurve, along, curves, ends, in_unit_of, numbers, or_none, runs, table, told};
use judder_report::page::PageTable;
use judder_study::registry::ToldAnalysis;
use serde_json::Value;

/// The unstable ranges of every curve.
pub(crate) fn unstable_ranges(
    analysis: ToldAnalysis<'_>,
    swept: &str,
    heads: &SpectrumLabels,
) -> Vec<PageTable> {
    curves(analysis).iter().map(|curve| of_curve(curve, swept, heads)).collect()
}

fn of_curve(curve: &ToldCurve<'_>, swept: &str, heads: &SpectrumLabels) -> PageTable {
    let [values, growth] = along(curve.results, ["value", "growth_rate"]);
    let unstable: Vec<bool> = growth.iter().map(|rate| *rate > 0.0).collect();
    let in_si = ["growth_rate_per_s", "frequency_hz"].map(|key| curve.results.get(key));
    let rows = runs(&unstable).into_iter().map(|[first, last]| {
        let fastest = (first..=last).max_by(|a, b| growth[*a].total_cmp(&growth[*b])).unwrap_or(first);
        let frequency = curve.results.get("eigenvalues").map_or(f64::NAN, |all| frequency(&all[fastest]));
        let [begins, ends] = ends(&values, [first, last]);
        let si = in_si.iter().flatten().map(|all| told(all[fastest].as_f64().unwrap_or(f64::NAN)));
        let groups = [growth[fastest], values[fastest], frequency].map(told);
        [begins, ends].into_iter().chain(groups).chain(si).collect()
    });
    let rows: Vec<Vec<String>> = rows.collect();
    let caption = format!("Unstable ranges along: {swept}{}", curve.of_family);
    let [begins, ends, at] = ["begins", "ends", "at"].map(|head| in_unit_of(swept, head));
    let mut head = vec![begins.as_str(), &ends, heads.growth, &at, heads.frequency];
    if in_si.iter().all(Option::is_some) {
        head.extend(["growth rate (1/s)", "frequency (Hz)"]);
    }
    let known = growth.iter().filter(|rate| rate.is_finite()).count();
    table(caption, &head, or_none(rows, known, head.len()))
}

/// The frequency of the fastest growing of the eigenvalues at a value.
fn frequency(eigenvalues: &Value) -> f64 {
    let parts = eigenvalues.as_array().into_iter().flatten().map(|own| numbers(Some(own)));
    let fastest = parts.filter(|own| own.len() == 2).max_by(|a, b| a[0].total_cmp(&b[0]));
    fastest.map_or(f64::NAN, |own| own[1].abs())
}
