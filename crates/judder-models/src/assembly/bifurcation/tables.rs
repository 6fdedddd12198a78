//! The bifurcations of a branch in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::{listed, short};
use judder_study::shown::{SHOWN_UNIT, ShownValues};
use serde_json::{Map, Value};

/// A row a bifurcation, in the order along the branch.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let told = |key: &str| results.get(key).and_then(Value::as_str).unwrap_or_default();
    let Some(all) = results.get("bifurcations").and_then(Value::as_array).filter(|all| !all.is_empty())
    else {
        return Vec::new();
    };
    let shown = ShownValues::called(results.get(SHOWN_UNIT).and_then(Value::as_str));
    let key = shown.head(told("key"));
    let [error, between] = ["may be off", "between"].map(|own| shown.head(own));
    let heads = [
        "",
        &key,
        &error,
        &between,
        "frequency (Hz)",
        "velocity along the slip, rms (m/s)",
        "what motions become",
    ];
    let harmonics = short(results.get("harmonics").unwrap_or(&Value::Null));
    let caption = format!(
        "Bifurcations, in the order along the branch, of cycles with {harmonics} harmonics; frequency and velocity are those of the cycle before"
    );
    let row = |_, own: &Value| {
        let kind = own["kind"].as_str().unwrap_or_default().to_owned();
        let (value, error) = (shown.value(&own["value"]), shown.error(&own["error"]));
        let [frequency, rms] = ["frequency_hz", "rms"].map(|name| short(&own[name]));
        let between = format!("{} … {}", shown.value(&own["between"][0]), shown.value(&own["between"][1]));
        let motion = own["motion"].as_str().unwrap_or_default().to_owned();
        vec![kind, value, error, between, frequency, rms, motion]
    };
    vec![listed(&caption, &heads, all, row)]
}
