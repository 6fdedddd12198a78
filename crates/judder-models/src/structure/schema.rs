//! The structure case.

use serde_json::{Map, Value as Json, json};

use crate::structure::KINDS;
use crate::structure::case::body::BodyKeys;
use crate::structure::case::damping::Damping;
use crate::structure::case::matrices::Triangle;
use crate::structure::case::reduction::Reduction;
use judder_keys::declared::{Allowed, Declaration, Settings};
use judder_keys::schema::{choice, declared_table, object, reference, table, with_declared};
use judder_study::case::schema::analyses;

pub(crate) fn case() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "structure" })),
        ("parameters", json!({ "type": "object", "additionalProperties": { "type": "number" } })),
        ("structure", declared_table(BodyKeys::DOC, &BodyKeys::declarations())),
        ("matrices", matrices()),
        ("damping", damping()),
        ("reduction", reduction(&["kept"])),
        ("analysis", analyses(&KINDS)),
        ("sweep", reference("sweeps")),
    ]);
    properties["parameters"]["description"] = json!("numbers that factors of matrices use and sweeps vary");
    let mut json = table("one linear structure alone", properties, &["model"]);
    json["oneOf"] = json!([{ "required": ["structure"] }, { "required": ["matrices"] }]);
    json
}

/// The tables of a body.
pub(super) fn declared() -> Vec<Declaration> {
    let table = |name: &'static str, doc: &'static str, keys: Vec<Declaration>| Declaration {
        name,
        doc,
        symbol: "",
        default: None,
        is_required: false,
        alternative: None,
        form: Allowed::Table { doc, keys },
    };
    vec![
        table("structure", BodyKeys::DOC, BodyKeys::declarations()),
        table("damping", Damping::DOC, Damping::declarations()),
        table("reduction", Reduction::DOC, Reduction::declarations()),
    ]
}

pub(crate) fn list(items: Json, [least, most]: [usize; 2], description: &str) -> Json {
    json!({ "type": "array", "items": items, "minItems": least, "maxItems": most, "description": description })
}

fn text(description: &str) -> Json {
    json!({ "type": "string", "description": description })
}

pub(crate) fn matrices() -> Json {
    let triangle =
        || choice(Triangle::ALL.map(|(name, _)| name), "both", "what of a symmetric matrix a file holds");
    let sum = |description: &str| {
        let factor = json!({ "type": ["number", "string"], "default": 1, "description": "a number or an expression of the parameters" });
        let term = object([
            ("file", text("a matrix file, .mtx, .mat or .npz, relative to the folder")),
            ("factor", factor),
            ("triangle", triangle()),
        ]);
        let term = table("a matrix times a factor", term, &["file"]);
        json!({ "type": "array", "items": term, "minItems": 1, "description": description })
    };
    let properties = object([
        ("folder", text("the folder of the files, relative to the case file")),
        ("mass", sum("M")),
        ("damping", sum("C; zero by default")),
        ("stiffness", sum("K")),
        ("freedoms", text("a table with node, direction and place of every degree of freedom")),
        ("triangle", triangle()),
    ]);
    table("M, C and K that another program assembled", properties, &["mass", "stiffness"])
}

/// The keys of a damping.
pub(crate) fn damping() -> Json {
    declared_table(Damping::DOC, &Damping::declarations())
}

pub(crate) fn reduction(required: &[&str]) -> Json {
    with_declared(Reduction::DOC, Map::new(), &Reduction::declarations(), required)
}
