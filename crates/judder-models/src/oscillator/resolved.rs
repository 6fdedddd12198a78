//! The canonical form of an oscillator case.

use super::case::OscillatorCase;
use super::inputs::LawName;
use super::keys::KEYS;
use crate::substrate::resolved::substrate;
use judder_study::case::resolved::{analyses, number};
use serde_json::{Value as Json, json};

pub(super) fn case(case: &OscillatorCase) -> Json {
    let mut json = json!({
        "model": "oscillator",
        "title": case.title,
        "contact": { "law": case.law.name(), "friction_load": case.friction_load.name() },
        "analysis": analyses(&case.analyses, |kind, json| kind.write(json)),
    });
    if let Some(file) = &case.law_file {
        json["contact"]["law"] = json!({ "file": file.given });
    }
    if case.law == LawName::Bem {
        json["contact"]["law"] = json!({ "computed": true, "accuracy": case.law_accuracy });
    }
    json["substrate"] = substrate(&case.substrate, case.inputs.time_form());
    for entry in KEYS.iter().filter(|entry| case.substrate.takes(entry.key)) {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
}
