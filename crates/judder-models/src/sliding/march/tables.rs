//! The table of a march in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short};
use serde_json::{Map, Value};

/// Bursts with the growth that was measured and that of the zone which they passed.
const BURSTS: [(&str, &str); 7] = [
    ("time_s", "time (s)"),
    ("position_m", "position (m)"),
    ("frequency_hz", "frequency (Hz)"),
    ("peak", "peak (m/s²)"),
    ("duration_s", "duration (s)"),
    ("measured_amplification", "growth of its mode, ln (−)"),
    ("expected_amplification", "∫ $σ$ d$t$ of its zone (−)"),
];

/// Its bursts, where it has any.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let bursts = results.get("bursts").and_then(Value::as_array).filter(|bursts| !bursts.is_empty());
    let row = |_: usize, burst: &Value| BURSTS.map(|(key, _)| short(&burst[key])).to_vec();
    bursts.map(|bursts| listed("Bursts", &BURSTS.map(|(_, head)| head), bursts, row)).into_iter().collect()
}
