//! The table of critical values in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short};
use serde_json::{Map, Value};

/// Where modes begin or cease to grow: of the one curve, or of each; of contacts as they are, and with every point held closed.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let of_curves = results.get("curves").and_then(Value::as_array).into_iter().flatten().enumerate();
    let curves = of_curves.map(|(curve, told)| {
        let family = &results["family"];
        let value = short(&family["values"][curve]);
        critical(
            &format!("Critical values, {} = {value}", family["key"].as_str().unwrap_or_default()),
            told.get("onsets"),
            None,
        )
    });
    [
        critical("Critical values", results.get("onsets"), results.get("onset_reduction_errors")),
        critical(
            "Critical values with every contact point held closed",
            results.get("onsets_all_closed"),
            None,
        ),
    ]
    .into_iter()
    .chain(curves)
    .flatten()
    .collect()
}

fn critical(caption: &str, onsets: Option<&Value>, of_reduction: Option<&Value>) -> Option<PageTable> {
    let onsets = onsets?.as_array().filter(|onsets| !onsets.is_empty())?;
    let of_reduction = of_reduction.filter(|errors| errors.is_array());
    let mut head = vec!["value", "error", "frequency (Hz)", "what happens", "the spectrum"];
    if of_reduction.is_some() {
        head.push("error of the reduction");
    }
    Some(listed(caption, &head, onsets, |number, onset| {
        let happens = match (onset["gains"] == true, onset["kind"] == "divergence") {
            (false, false) => "flutter begins",
            (true, false) => "flutter ends",
            (false, true) => "divergence begins",
            (true, true) => "divergence ends",
        };
        let spectrum = match onset["jumps"] == true {
            true => "jumps: contact points open or close, or pass a corner of a table",
            false => "runs through",
        };
        let mut row: Vec<String> =
            ["value", "error", "frequency_hz"].iter().map(|key| short(&onset[*key])).collect();
        row.extend([happens, spectrum].map(str::to_owned));
        row.extend(of_reduction.map(|errors| short(&errors[number - 1])));
        row
    }))
}
