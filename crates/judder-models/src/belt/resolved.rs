//! The canonical form of a belt case.

use super::case::{BELT_KEYS, BeltCase};
use judder_study::case::resolved::analyses;
use judder_study::model::Analysis;
use serde_json::{Value as Json, json};

pub(super) fn case(case: &BeltCase) -> Json {
    let mut json = json!({
        "model": "belt",
        "title": case.title,
        "analysis": analyses(&case.analyses, Analysis::write),
    });
    for entry in &BELT_KEYS {
        json[entry.section()][entry.name()] = json!(case.inputs.number(entry.key));
    }
    json
}
