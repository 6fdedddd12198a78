//! The table of the equivalent damping: where it is negative.

use crate::oscillator::keys::OscillatorKey;
use crate::swept_tables::{along, curves, ends, in_unit_of, key_head, or_none, runs, table, told};
use judder_report::page::PageTable;
use judder_study::registry::ToldAnalysis;

/// The ranges of every curve in which the equivalent damping is negative.
pub(crate) fn report(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let swept = key_head::<OscillatorKey>(&analysis.asked["sweep"]);
    let of_curve = curves(analysis).into_iter().map(|curve| {
        let [values, damping] = along(curve.results, ["value", "equivalent_damping"]);
        let negative: Vec<bool> = damping.iter().map(|own| *own < 0.0).collect();
        let rows = runs(&negative).into_iter().map(|[first, last]| {
            let least = (first..=last).min_by(|a, b| damping[*a].total_cmp(&damping[*b])).unwrap_or(first);
            let [begins, ends] = ends(&values, [first, last]);
            vec![begins, ends, told(damping[least]), told(values[least])]
        });
        let rows: Vec<Vec<String>> = rows.collect();
        let caption = format!("Negative equivalent damping along: {swept}{}", curve.of_family);
        let [begins, ends, at] = ["begins", "ends", "at"].map(|head| in_unit_of(&swept, head));
        let head = [begins.as_str(), &ends, "least $ξ_{eq}$ (−)", &at];
        table(caption, &head, or_none(rows, values.len(), head.len()))
    });
    of_curve.collect()
}
