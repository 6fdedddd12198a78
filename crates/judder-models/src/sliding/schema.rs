//! The sliding case.

use serde_json::{Value as Json, json};

use crate::sliding::KINDS;
use crate::sliding::case::SystemKeys;
use crate::sliding::case::plain_name::PlainName;
use crate::structure::case::body::BodyKeys;
use crate::structure::schema::{damping, list, matrices, reduction};
use judder_keys::declared::{Setting, Settings};
use judder_keys::schema::{object, reference, table, with_declared};
use judder_study::case::schema::analyses;

pub(super) fn case() -> Json {
    let parameters = json!({
        "type": "object", "additionalProperties": { "type": "number" },
        "description": "numbers that factors of matrices use and sweeps vary",
    });
    let properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "sliding" })),
        ("parameters", parameters),
        ("structure", list(structure(), [2, 2], "the two structures")),
        ("analysis", analyses(&KINDS)),
        ("sweep", reference("sweeps")),
    ]);
    let required = ["model", "structure"];
    let words = "one structure slides along another";
    with_declared(words, properties, &SystemKeys::declarations(), &required)
}

fn structure() -> Json {
    let mut own = object([
        ("name", PlainName::form(&"structure").schema()),
        ("matrices", matrices()),
        ("damping", damping()),
        ("reduction", reduction(&[])),
    ]);
    own["name"]["description"] = json!("by which keys call this structure");
    let words = "one of the two structures: a beam, a block, a mesh or matrices";
    with_declared(words, own, &BodyKeys::declarations(), &["name"])
}

/// A key over a range, or with a list of values.
pub(crate) fn key_sweep() -> Json {
    let end =
        json!({ "type": ["number", "string"], "description": "a number, or a quantity with the key's unit" });
    let key = json!({ "type": "string", "description": "dotted path of a number of structures, contact, motion or parameters" });
    let values = json!({ "type": "array", "items": end, "minItems": 2 });
    let of_list = object([("key", key.clone()), ("values", values)]);
    let of_list = table("a key with a list of values", of_list, &["key", "values"]);
    json!({ "oneOf": [judder_study::case::schema::sweep(key, &end, "a key over a range"), of_list] })
}
