//! The tables of a response in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// The peaks of the observed coordinates, and where the frequency turns.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let table = |caption: &str, head: &[&str], rows: Vec<Vec<String>>| {
        let head = head.iter().map(|own| (*own).to_owned()).collect();
        (!rows.is_empty()).then(|| PageTable { caption: caption.to_owned(), head, rows })
    };
    let peaks = results.get("peaks").and_then(Value::as_object).into_iter().flatten();
    let row = |(name, told): (&String, &Value)| {
        let keys = [
            "amplitude",
            "frequency_hz",
            "rms",
            "rms_frequency_hz",
            "largest",
            "largest_frequency_hz",
            "left_out",
            "between_samples",
        ];
        let beyond = if told["at_end"].as_bool() == Some(true) { " (at an end)" } else { "" };
        [vec![format!("{name}{beyond}")], keys.map(|key| short(&told[key])).to_vec()].concat()
    };
    let heads = [
        "",
        "amplitude (m)",
        "at (Hz)",
        "root mean square (m)",
        "at (Hz)",
        "largest magnitude (m)",
        "at (Hz)",
        "left out of the swing of the forces (−)",
        "off the laws between samples (N)",
    ];
    let folds = results.get("folds").and_then(Value::as_array).into_iter().flatten();
    let folds: Vec<Vec<String>> =
        folds.zip(1..).map(|(own, number)| vec![number.to_string(), short(&own["frequency_hz"])]).collect();
    let changes = results.get("stability_changes").and_then(Value::as_array).into_iter().flatten();
    let change = |own: &Value| {
        let [one, other] = [0, 1].map(|end| short(&own["between_hz"][end]));
        vec![own["kind"].as_str().unwrap_or_default().to_owned(), one, other]
    };
    [
        table("Peaks of the observed points", &heads, peaks.map(row).collect()),
        table("Folds, in the order along the branch", &["", "frequency (Hz)"], folds),
        table(
            "Changes of stability, in the order along the branch",
            &["", "between (Hz)", "and (Hz)"],
            changes.map(change).collect(),
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}
