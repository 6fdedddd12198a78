//! The table of steady sliding in the report.

use super::uniqueness::table;
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
    let contacts = PageTable { caption: "Contacts".to_owned(), head: head.map(String::from).to_vec(), rows };
    std::iter::once(contacts).chain(spheres(results)).chain(table(results)).collect()
}

/// The contacts that are a sphere.
fn spheres(results: &Map<String, Value>) -> Option<PageTable> {
    let spheres = results.get("spheres")?.as_object()?;
    let row = |(name, told): (&String, &Value)| {
        let keys = ["velocity", "indentation", "area", "viscoelastic_friction", "normal_load"];
        let numbers = keys.map(|key| short(&told[key]));
        [vec![name.clone()], numbers.to_vec()].concat()
    };
    (!spheres.is_empty()).then(|| PageTable {
        caption: "Spheres on the substrate".to_owned(),
        head: [
            "contact",
            "speed v τ/R (−)",
            "indentation y/R (−)",
            "area (m²)",
            "μ_visc (−)",
            "load F_n (N)",
        ]
        .map(String::from)
        .to_vec(),
        rows: spheres.iter().map(row).collect(),
    })
}
