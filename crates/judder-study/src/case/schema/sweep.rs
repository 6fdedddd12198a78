//! Sweeps of the whole case.

use serde_json::{Value as Json, json};

use crate::case::study_sweep::design::POINTS_LIMIT;
use crate::case::study_sweep::read::{CHUNK_LIMIT, RESAMPLES_LIMITS, SEED, SENSITIVITY};
use crate::case::study_sweep::{Design, SEEDS};
use judder_keys::schema::{choice, object, reference, table};

/// The list of sweeps, of any model.
pub(super) fn sweeps() -> Json {
    let name = json!({
        "type": "string", "pattern": "^[A-Za-z0-9_-]([A-Za-z0-9._-]{0,98}[A-Za-z0-9_-])?$",
        "description": "under which results are kept; no analysis and no other sweep has it",
    });
    let whole = |[from, to]: [usize; 2], description: &str| json!({ "type": "integer", "minimum": from, "maximum": to, "description": description });
    let most = POINTS_LIMIT as usize;
    let mut seed =
        whole([SEEDS.from, SEEDS.to], "of \"latin-hypercube\" and \"sobol\": which of all such points");
    seed["default"] = json!(SEED);
    let path = json!({ "type": "string", "pattern": r"^[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*$" });
    let quantities = json!({
        "type": "array", "items": path, "minItems": 1, "uniqueItems": true,
        "description": "what is kept of every point: a quantity of the operating point, or ANALYSIS.PATH into the results of an analysis",
    });
    let mut properties = object([
        ("name", name),
        ("method", choice(Design::NAMES, Design::NAMES[0], "how points are chosen")),
        ("seed", seed),
        ("quantities", quantities),
        ("chunk", whole([1, CHUNK_LIMIT], "points of a unit of work; chosen by the program by default")),
        ("sensitivity", sensitivity()),
    ]);
    properties.extend(object([
        ("points", whole([2, most], "of \"latin-hypercube\" and \"sobol\": how many points; with sensitivity how many rows of k + 2 points for k keys")),
        ("over", json!({ "type": "array", "items": swept_key(most), "minItems": 1, "description": "the swept keys" })),
    ]));
    let sweep = table("the whole case at many points", properties, &["name", "over", "quantities"]);
    json!({ "type": "array", "items": sweep, "description": "the whole case at many points" })
}

fn swept_key(most: usize) -> Json {
    let value =
        json!({ "type": ["number", "string"], "description": "a number, or a quantity with the key's unit" });
    let values = json!({ "type": "array", "items": value, "minItems": 1, "description": "of \"grid\" and \"list\": in place of a range" });
    let points = json!({ "type": "integer", "minimum": 2, "maximum": most, "description": "of \"grid\": how many values, both ends included" });
    let entries = object([
        (
            "key",
            json!({ "type": "string", "description": "dotted path of any number of the case; an item of a list goes by its name" }),
        ),
        ("from", value.clone()),
        ("to", value),
        ("points", points),
        ("scale", reference("scale")),
        ("values", values),
    ]);
    table("a number that varies", entries, &["key"])
}

fn sensitivity() -> Json {
    let [from, to] = RESAMPLES_LIMITS;
    let entries = object([
        (
            "confidence",
            json!({
                "type": "number", "exclusiveMinimum": 0.0, "maximum": 0.9999, "default": SENSITIVITY.confidence,
                "description": "of the intervals",
            }),
        ),
        (
            "resamples",
            json!({
                "type": "integer", "minimum": from, "maximum": to, "default": SENSITIVITY.resamples,
                "description": "of the bootstrap",
            }),
        ),
    ]);
    json!({
        "anyOf": [{ "type": "boolean" }, table("with these settings", entries, &[])], "default": false,
        "description": "of \"latin-hypercube\" and \"sobol\": first-order and total Sobol' indices of every quantity",
    })
}
