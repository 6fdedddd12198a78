//! The canonical form of a contact case.

use super::case::ContactCase;
use crate::oscillator::keys::OscillatorKey;
use crate::substrate::resolved::substrate;
use judder_keys::declared::Setting;
use judder_study::case::resolved::{analyses, number};
use serde_json::{Value as Json, json};

pub(super) fn case(case: &ContactCase) -> Json {
    let mut json = json!({
        "model": "contact",
        "title": case.title,
        "indenter": { "shape": Setting::write(&case.shape, &()) },
        "analysis": analyses(&case.analyses, |kind, json| kind.write(json)),
    });
    json["substrate"] = substrate(&case.substrate, case.inputs.time_form());
    let keys = ContactCase::KEYS.into_iter().filter(|key| case.substrate.takes(*key));
    for entry in keys.map(OscillatorKey::entry) {
        let value = case.inputs.get(entry.key);
        json[entry.section()][entry.name()] = number(value.number, value.form, entry.dimension);
    }
    json
}
