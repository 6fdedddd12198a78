//! The structure case.

use serde_json::{Map, Value as Json, json};

use super::{analyses, choice, object, reference, sweep, table};
use crate::structure::analysis::{COMPARED, KINDS, MODES, MODES_LIMIT};
use crate::structure::body::{BlockElement, ELEMENTS, EndCondition, PlaneSection};
use crate::structure::matrices::Triangle;
use crate::structure::reduction::{FIXED_MODES, FIXED_MODES_LIMIT};
use crate::structure_keys::{STRUCTURE_KEYS, StructureKey};

pub(super) fn case() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "structure" })),
        ("parameters", json!({ "type": "object", "additionalProperties": { "type": "number" } })),
        ("structure", table("elements with materials and supports", body(), &[])),
        ("matrices", matrices()),
        ("damping", damping()),
        ("reduction", reduction(&["kept"])),
        ("analysis", analyses(&KINDS, setting)),
        ("sweep", reference("sweeps")),
    ]);
    properties["parameters"]["description"] = json!("numbers that factors of matrices use and sweeps vary");
    let mut json = table("one linear structure alone", properties, &["model"]);
    json["oneOf"] = json!([{ "required": ["structure"] }, { "required": ["matrices"] }]);
    json
}

/// The number of this key, by its definition.
pub(super) fn number(key: StructureKey) -> Json {
    reference(key.entry().path)
}

pub(super) fn list(items: Json, [least, most]: [usize; 2], description: &str) -> Json {
    json!({ "type": "array", "items": items, "minItems": least, "maxItems": most, "description": description })
}

pub(super) fn text(description: &str) -> Json {
    json!({ "type": "string", "description": description })
}

pub(super) fn whole([from, to]: [usize; 2], default: Option<usize>, description: &str) -> Json {
    let mut json = json!({ "type": "integer", "minimum": from, "maximum": to, "description": description });
    if let Some(default) = default {
        json["default"] = json!(default);
    }
    json
}

fn directions(description: &str) -> Json {
    list(json!({ "enum": ["x", "y", "z"] }), [0, 3], description)
}

/// The numeric keys whose path is this table and one name.
fn numbers(section: &str) -> Map<String, Json> {
    let own = STRUCTURE_KEYS.iter().filter(|entry| {
        entry.path.strip_prefix(section).and_then(|rest| rest.strip_prefix('.')) == Some(entry.name())
    });
    own.map(|entry| (entry.name().to_owned(), reference(entry.path))).collect()
}

/// The keys of a body.
pub(super) fn body() -> Map<String, Json> {
    let element = |description: &str| whole([ELEMENTS.0, ELEMENTS.1], None, description);
    let mut beam = numbers("structure.beam");
    let end = || choice(EndCondition::ALL.map(|(name, _)| name), "free", "how this end is held");
    beam.extend(object([
        ("elements", list(element("elements along and across"), [2, 2], "along and across")),
        ("origin", list(number(StructureKey::BeamOrigin), [2, 2], "where the middle of its start lies")),
        ("start", end()),
        ("end", end()),
    ]));
    let block = object([
        (
            "element",
            json!({ "enum": BlockElement::ALL.map(|(name, _)| name), "description": "the shape of its elements" }),
        ),
        ("size", list(number(StructureKey::BlockSize), [2, 3], "its lengths")),
        ("cells", list(element("cells along a side"), [2, 3], "cells along each side")),
    ]);
    let material = || {
        let keys = ["youngs_modulus", "poisson_ratio", "density"];
        table("an isotropic linear elastic material", numbers("structure.material"), &keys)
    };
    let support = object([
        ("set", text("a set of nodes")),
        ("fixed", directions("directions in which they are held")),
        ("tied", directions("directions in which they move as one")),
    ]);
    let mut properties = numbers("structure");
    properties.extend(object([
        ("beam", table("a straight beam of eight-node quadrilaterals", beam, &["length", "thickness", "elements"])),
        ("block", table("a rectangle or box of equal cells", block, &["size", "cells"])),
        ("mesh", text("a mesh file, .msh or .inp, relative to the case file")),
        ("section", choice(PlaneSection::ALL.map(|(name, _)| name), "plane-stress", "how the third direction of the plane is meant")),
        ("material", material()),
        ("materials", json!({ "type": "object", "additionalProperties": material(), "description": "materials by the names of a mesh file" })),
        ("supports", json!({ "type": "array", "items": table("what holds a set of nodes", support, &["set"]) })),
    ]));
    properties
}

pub(super) fn matrices() -> Json {
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

pub(super) fn damping() -> Json {
    let pair = table(
        "a frequency and its damping ratio",
        numbers("damping.rayleigh.ratios"),
        &["frequency", "ratio"],
    );
    let mut rayleigh = numbers("damping.rayleigh");
    rayleigh
        .insert("ratios".to_owned(), list(pair, [2, 2], "two damping ratios, in place of alpha and beta"));
    let structural = table(
        "structural damping, met at one frequency",
        numbers("damping.structural"),
        &["loss_factor", "reference_frequency"],
    );
    let properties =
        object([("rayleigh", table("C = α M + β K", rayleigh, &[])), ("structural", structural)]);
    table("the damping of a body; none by default", properties, &[])
}

pub(super) fn reduction(required: &[&str]) -> Json {
    let kept = object([
        ("set", text("a set of nodes of a body")),
        (
            "nodes",
            json!({ "type": "array", "items": { "type": "integer", "minimum": 0 }, "description": "nodes of the table of freedoms" }),
        ),
        ("directions", directions("directions in which they are kept; all by default")),
    ]);
    let mut properties = numbers("reduction");
    properties.extend(object([
        (
            "kept",
            json!({ "type": "array", "items": table("freedoms that are kept", kept, &[]), "minItems": 1 }),
        ),
        ("count", whole([1, FIXED_MODES_LIMIT], Some(FIXED_MODES), "fixed-interface modes that are kept")),
    ]));
    table("what a Craig–Bampton reduction keeps", properties, required)
}

fn setting(kind: &str, key: &str) -> Json {
    let range = |description: &str| list(json!({ "type": "number" }), [2, 2], description);
    match key {
        "count" if kind == "reduction" => {
            whole([1, MODES_LIMIT], Some(COMPARED), "frequencies that are compared")
        }
        "count" => whole([1, MODES_LIMIT], Some(MODES), "modes from the lowest on"),
        "band" => {
            list(number(StructureKey::Band), [2, 2], "all modes between two frequencies, in place of count")
        }
        "region" => {
            let properties =
                object([("re", range("growth rates, 1/s")), ("im", range("angular frequencies, rad/s"))]);
            table("the rectangle in which eigenvalues are sought", properties, &["re", "im"])
        }
        "sweep" => {
            let name = json!({ "type": "string", "description": "parameters.NAME" });
            let values = json!({ "type": "array", "items": { "type": "number" }, "minItems": 2 });
            let entries = object([("key", name.clone()), ("values", values)]);
            let of_list = table("a parameter with a list of values", entries, &["key", "values"]);
            let of_range = sweep(name, &json!({ "type": "number" }), "a parameter over a range", None);
            json!({ "oneOf": [of_range, of_list] })
        }
        "family" => {
            let values = json!({ "type": "array", "items": { "type": "number" }, "minItems": 1 });
            let name = json!({ "type": "string", "description": "parameters.NAME" });
            table(
                "one curve a value of another parameter",
                object([("key", name), ("values", values)]),
                &["key", "values"],
            )
        }
        "tolerance" => number(StructureKey::Tolerance),
        _ => choice(["full", "projected"], "full", "how each point is solved"),
    }
}
