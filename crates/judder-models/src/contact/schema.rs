//! The schema of a contact case, and of what it shares with an oscillator case.

use serde_json::{Map, Value as Json, json};

use crate::contact::KINDS;
use crate::contact::case::{ContactCase, ContactKeys, IndenterKeys};
use crate::oscillator::keys::OscillatorKey;
use crate::substrate::SubstrateKeys;
use judder_keys::declared::Settings;
use judder_keys::schema::{object, reference, with_declared};
use judder_study::case::schema::analyses;

/// A contact case.
pub(crate) fn case() -> Json {
    let mut substrate = Map::new();
    for entry in ContactCase::KEYS.map(OscillatorKey::entry).iter().filter(|e| e.section() == "substrate") {
        substrate.insert(entry.name().to_owned(), reference(entry.path));
    }
    let indenter = object([("radius", reference("indenter.radius"))]);
    let shape = IndenterKeys::declarations();
    let properties = object([
        ("model", json!({ "const": "contact" })),
        (
            "substrate",
            with_declared(
                "the material that the indenter slides on",
                substrate,
                &SubstrateKeys::declarations(),
                &[],
            ),
        ),
        ("indenter", with_declared("the rigid body that slides", indenter, &shape, &[])),
        ("analysis", analyses(&KINDS)),
        ("sweep", reference("sweeps")),
    ]);
    let keys = ContactKeys::declarations();
    with_declared("a rigid indenter that slides on a viscoelastic substrate", properties, &keys, &["model"])
}

/// A path.
pub(crate) fn file(description: &str) -> Json {
    json!({ "type": "string", "description": format!("{description}; a path relative to the case file") })
}
