//! The table of steady sliding in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// What each contact carries.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let head = [
        "contact",
        "normal force (N)",
        "friction force (N)",
        "closed",
        "open",
        "largest pressure (Pa)",
        "centre (m)",
    ];
    let vector = |value: &Value| {
        let parts = value.as_array().into_iter().flatten().map(short);
        format!("({})", parts.collect::<Vec<_>>().join(", "))
    };
    let row = |(name, told): (&String, &Value)| {
        vec![
            name.clone(),
            short(&told["normal_force"]),
            vector(&told["tangential_force"]),
            short(&told["closed"]),
            short(&told["open"]),
            short(&told["pressure_max"]),
            vector(&told["centre"]),
        ]
    };
    let contacts = results.get("contacts").and_then(Value::as_object);
    let rows: Vec<Vec<String>> = contacts.into_iter().flatten().map(row).collect();
    vec![PageTable { caption: "Contacts".to_owned(), head: head.map(String::from).to_vec(), rows }]
}
