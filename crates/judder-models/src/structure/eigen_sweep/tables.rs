//! The table of critical values in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short};
use judder_study::shown::{SHOWN_UNIT, ShownValues};
use serde_json::{Map, Value};

/// Where modes begin or cease to grow: of the one curve, or of each; of contacts as they are, and with every point held closed.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    // a structure alone has parameters, plain numbers
    let shown = ShownValues::called(results.get(SHOWN_UNIT).map_or(Some("1"), Value::as_str));
    let of_curves = results.get("curves").and_then(Value::as_array).into_iter().flatten().enumerate();
    let curves = of_curves.map(|(curve, told)| {
        let family = &results["family"];
        let value = short(&family["values"][curve]);
        critical(
            &format!("Critical values, {} = {value}", family["key"].as_str().unwrap_or_default()),
            told.get("onsets"),
            None,
            &shown,
        )
    });
    [
        critical("Critical values", results.get("onsets"), results.get("onset_reduction_errors"), &shown),
        critical(
            "Critical values with every contact point held closed",
            results.get("onsets_all_closed"),
            None,
            &shown,
        ),
    ]
    .into_iter()
    .chain(curves)
    .flatten()
    .collect()
}

fn critical(
    caption: &str,
    onsets: Option<&Value>,
    of_reduction: Option<&Value>,
    shown: &ShownValues,
) -> Option<PageTable> {
    let onsets = onsets?.as_array().filter(|onsets| !onsets.is_empty())?;
    let of_reduction = of_reduction.filter(|errors| errors.is_array());
    let [value, error, reduction] = ["value", "error", "error of the reduction"].map(|own| shown.head(own));
    let mut head = vec![value.as_str(), &error, "frequency (Hz)", "what happens", "the spectrum"];
    if of_reduction.is_some() {
        head.push(&reduction);
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
        let mut row =
            vec![shown.value(&onset["value"]), shown.error(&onset["error"]), short(&onset["frequency_hz"])];
        row.extend([happens, spectrum].map(str::to_owned));
        row.extend(of_reduction.map(|errors| shown.error(&errors[number - 1])));
        row
    }))
}
