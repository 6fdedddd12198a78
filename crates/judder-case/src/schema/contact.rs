//! The schema of a contact case, and of what it shares with an oscillator case.

use serde_json::{Map, Value as Json, json};

use super::{analyses, choice, names, object, reference, table};
use crate::contact_analysis::{
    CELLS, FREQUENCIES, KINDS, LAW_ACCURACY, LAW_INDENTATION, LAW_VELOCITY, LawMethod,
};
use crate::contact_case::ContactCase;
use crate::contact_keys::{CONTACT_KEYS, ContactKey};
use crate::keys::OscillatorKey;
use crate::memory::MEMORY_LIMIT;
use crate::shape::{ROUGH_CELLS, Shape};
use crate::substrate::TERM_LIMIT;
use crate::transient_analysis::{MOTION_NAMES, STEPPING_CELLS, TRANSIENT_CELLS};

/// A contact case.
pub(super) fn case() -> Json {
    let mut substrate = Map::new();
    for entry in ContactCase::KEYS.map(OscillatorKey::entry).iter().filter(|e| e.section() == "substrate") {
        substrate.insert(entry.name().to_owned(), reference(entry.path));
    }
    substrate.extend(self::substrate());
    let indenter = object([("radius", reference("indenter.radius")), ("shape", shape())]);
    let properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "contact" })),
        ("substrate", table("the material that the indenter slides on", substrate, &[])),
        ("indenter", table("the rigid body that slides", indenter, &[])),
        (MEMORY_LIMIT, memory()),
        ("analysis", analyses(&KINDS, setting)),
        ("sweep", reference("sweeps")),
    ]);
    table("a rigid indenter that slides on a viscoelastic substrate", properties, &["model"])
}

/// The keys of a substrate that are not numeric.
pub(super) fn substrate() -> Map<String, Json> {
    let series = |key: &str, weight: &str, doc: &str| {
        let prefix = format!("substrate.{key}.");
        let entries = CONTACT_KEYS.iter().filter(|entry| entry.path.starts_with(&prefix));
        let term = entries.map(|entry| (entry.name().to_owned(), reference(entry.path))).collect();
        let term = table("one term", term, &["time", weight]);
        json!({ "type": "array", "items": term, "minItems": 1, "maxItems": TERM_LIMIT, "description": doc })
    };
    let terms = json!({
        "anyOf": [{ "type": "integer", "minimum": 1, "maximum": TERM_LIMIT }, { "const": "auto" }],
        "default": "auto", "description": "number of terms of the fitted series",
    });
    let dma = object([("file", file("CSV of frequency, storage and loss modulus")), ("terms", terms)]);
    let rule = |name: &str| {
        let prefix = format!("substrate.shift.{name}.");
        let entries: Vec<_> = CONTACT_KEYS.iter().filter(|entry| entry.path.starts_with(&prefix)).collect();
        let names: Vec<_> = entries.iter().map(|entry| entry.name()).collect();
        let keys = entries.iter().map(|entry| (entry.name().to_owned(), reference(entry.path))).collect();
        table("a rule for the shift of times with temperature", keys, &names)
    };
    let mut shift =
        table("one of two rules", object([("wlf", rule("wlf")), ("arrhenius", rule("arrhenius"))]), &[]);
    shift["minProperties"] = json!(1);
    shift["maxProperties"] = json!(1);
    object([
        ("prony", series("prony", "compliance", "terms of the creep compliance: 1/E∞ = 1/E0 − Σ compliance")),
        (
            "relaxation",
            series("relaxation", "modulus", "terms of the relaxation modulus: E∞ = E0 + Σ modulus"),
        ),
        ("continuous", continuous()),
        ("dma", table("a series fitted to measured moduli", dma, &["file"])),
        ("temperature", reference(ContactKey::Temperature.entry().path)),
        ("shift", shift),
    ])
}

/// A continuous spectrum.
fn continuous() -> Json {
    let keys = |prefix: &str| -> Map<String, Json> {
        let entries = CONTACT_KEYS.iter().filter(|entry| entry.path.starts_with(prefix));
        entries.map(|entry| (entry.name().to_owned(), reference(entry.path))).collect()
    };
    let sample = table("𝒞 at one time", keys("substrate.continuous.samples."), &["time", "density"]);
    let of_form = |name: &str, doc: &str, required: &[&str]| {
        table(doc, keys(&format!("substrate.continuous.{name}.")), required)
    };
    let entries = object([
        ("log_normal", of_form("log_normal", "τ𝒞 is a Gaussian in log₁₀ τ", &["median", "width"])),
        ("power_law", of_form("power_law", "𝒞 ∝ τ^(m − 1) between two times", &["from", "to", "exponent"])),
        ("samples", json!({ "type": "array", "items": sample, "minItems": 2, "maxItems": TERM_LIMIT })),
        ("terms", json!({ "type": "integer", "minimum": 1, "maximum": TERM_LIMIT })),
        ("accuracy", reference("substrate.continuous.accuracy")),
    ]);
    table("a continuous spectrum, taken apart into retardation times", entries, &[])
}

/// A memory limit.
fn memory() -> Json {
    json!({
        "type": "string", "examples": ["4 GiB", "512 MiB"], "default": "4 GiB",
        "description": "what the largest grid of one contact may take",
    })
}

/// A path.
pub(super) fn file(description: &str) -> Json {
    json!({ "type": "string", "description": format!("{description}; a path relative to the case file") })
}

fn shape() -> Json {
    let whole = |[from, to]: [usize; 2]| json!({ "type": "integer", "minimum": from, "maximum": to });
    let heights = object([
        ("heights", file("npy, text matrix or NetCDF")),
        ("spacing", reference("indenter.shape.spacing")),
        ("variable", json!({ "type": "string", "description": "which one, where a file holds several" })),
        ("unit", reference("indenter.shape.unit")),
        ("periodic", json!({ "type": "boolean", "default": false })),
        (
            "turned_over",
            json!({
                "type": "boolean", "default": false, "description": "whether large heights point towards the substrate",
            }),
        ),
    ]);
    let mut rough = object([
        ("cells", whole(ROUGH_CELLS)),
        ("seed", json!({ "type": "integer", "minimum": 0, "default": 0 })),
    ]);
    for entry in CONTACT_KEYS.iter().filter(|entry| entry.path.starts_with("indenter.shape.rough.")) {
        rough.insert(entry.name().to_owned(), reference(entry.path));
    }
    let rough = table("a generated self-affine surface", rough, &["period", "cells", "hurst"]);
    json!({
        "anyOf": [
            choice(Shape::WORDS.map(|(word, _)| word), "paraboloid", "shape of the indenter"),
            table("a height map", heights, &["heights"]),
            table("a rough surface", object([("rough", rough)]), &["rough"]),
        ],
        "default": "paraboloid",
    })
}

fn setting(kind: &str, key: &str) -> Json {
    let span = |path: &str, default: Option<(f64, f64, usize)>, points: usize| {
        let end = reference(path);
        let points = json!({ "type": "integer", "minimum": 2, "default": points });
        let entries = object([("from", end.clone()), ("to", end), ("points", points)]);
        let mut json = table("a range, with equal ratios between its points", entries, &["from", "to"]);
        if let Some((from, to, points)) = default {
            json["default"] = json!({ "from": from, "to": to, "points": points });
        }
        json
    };
    let is_one = matches!(kind, "contact" | "transient");
    match key {
        "velocity" if !is_one => span("analysis.velocity", Some(LAW_VELOCITY), LAW_VELOCITY.2),
        "indentation" if !is_one => span("analysis.indentation", Some(LAW_INDENTATION), LAW_INDENTATION.2),
        "motion" => names(MOTION_NAMES, "how the indenter moves along the surface"),
        "oscillation" => {
            let entries = ["amplitude", "frequency"].map(|key| (key, reference(&format!("analysis.{key}"))));
            table("an oscillation of the indentation", object(entries), &["amplitude", "frequency"])
        }
        "cells" if kind == "transient" => json!({
            "type": "integer", "minimum": STEPPING_CELLS[0], "maximum": STEPPING_CELLS[1], "default": TRANSIENT_CELLS,
            "description": "cells a side of the window that moves with the indenter",
        }),
        "frequency" if kind == "modulus" => span("analysis.frequency", None, FREQUENCIES),
        "accuracy" if !is_one => {
            json!({ "$ref": "#/$defs/analysis.accuracy", "default": LAW_ACCURACY })
        }
        "cells" => json!({
            "type": "integer", "minimum": CELLS[0], "maximum": CELLS[1], "multipleOf": 2,
            "description": "cells along a side, an even number; chosen from the accuracy by default",
        }),
        MEMORY_LIMIT => memory(),
        "method" => choice(LawMethod::ALL.map(|(name, _)| name), "collapse", "how the plane is covered"),
        _ => reference(&format!("analysis.{key}")),
    }
}
