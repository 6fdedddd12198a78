//! The schema of a two-degrees case.

use super::case::KINDS;
use judder_keys::schema::{object, reference, table};
use judder_study::case::schema::analyses;
use serde_json::{Value as Json, json};

pub(super) fn case() -> Json {
    let entry = json!({ "type": ["number", "string"] });
    let row = json!({ "type": "array", "items": entry, "minItems": 2, "maxItems": 2 });
    let matrix = |description: &str| json!({ "type": "array", "items": row, "minItems": 2, "maxItems": 2, "description": description });
    let matrices = object([
        ("mass", matrix("M, 2×2 numbers or expressions; the identity by default")),
        ("damping", matrix("C; zero by default")),
        ("stiffness", matrix("K")),
    ]);
    let properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "two-degrees" })),
        ("parameters", json!({ "type": "object", "additionalProperties": { "type": "number" } })),
        ("matrices", table("M, C and K", matrices, &["stiffness"])),
        ("analysis", analyses(&KINDS)),
        ("sweep", reference("sweeps")),
    ]);
    table("two degrees of freedom with given matrices", properties, &["model", "matrices"])
}
