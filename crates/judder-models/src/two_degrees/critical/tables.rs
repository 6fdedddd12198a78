//! The table of critical values.

use crate::swept_tables::{numbers, or_none, parameter_head, table, told};
use crate::two_degrees::LABELS;
use judder_report::page::PageTable;
use judder_study::registry::ToldAnalysis;

/// A row a value at which stability changes.
pub(crate) fn report(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let sweep = &analysis.asked["sweep"];
    let [values, frequencies] = ["critical", "frequency"].map(|key| numbers(analysis.results.get(key)));
    let [from, to] = ["from", "to"].map(|end| told(sweep[end].as_f64().unwrap_or(f64::NAN)));
    let caption = format!("Where stability changes, from {from} to {to}");
    let rows = values.into_iter().zip(frequencies).map(|(value, own)| vec![told(value), told(own)]);
    let samples = sweep["points"].as_u64().unwrap_or(0) as usize;
    let rows = or_none(rows.collect(), samples, 2);
    vec![table(caption, &[&parameter_head(sweep), LABELS.frequency], rows)]
}
