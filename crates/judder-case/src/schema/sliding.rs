//! The sliding case.

use serde_json::{Map, Value as Json, json};

use super::structure::{damping, list, matrices, reduction, text, whole};
use super::{analyses, choice, names, object, reference, table, with_declared};
use crate::declared::{Declaration, Settings};
use crate::sliding::analysis::KINDS;
use crate::sliding::contact::Interpolation;
use crate::sliding::locus::{Configuration, POSITIONS, POSITIONS_LIMIT};
use crate::sliding::march::{CHECKPOINT_RANGE, CHECKPOINT_STEPS, MarchWord, Predictor};
use crate::sliding::motion::{Axis, SEED};
use crate::sliding::observe::PointQuantity;
use crate::sliding::spectrogram::Window;
use crate::sliding_keys::{SLIDING_KEYS, SlidingKey};
use crate::structure::analysis::{MODES, MODES_LIMIT, Modes};
use crate::structure::body::BodyKeys;

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
        ("contact", contact()),
        ("motion", motion()),
        ("observe", observe()),
        ("analysis", analyses(&KINDS, setting)),
        ("sweep", reference("sweeps")),
    ]);
    let required = ["model", "structure", "contact", "motion"];
    table("one structure slides along another", properties, &required)
}

/// The name of a sliding case's key among the definitions: it shares paths with those of other models.
pub(super) fn definition(path: &str) -> String {
    format!("sliding.{path}")
}

fn number(key: SlidingKey) -> Json {
    reference(&definition(key.entry().path))
}

/// The numeric keys whose path is this table and one name.
fn numbers(section: &str) -> Map<String, Json> {
    let own = SLIDING_KEYS.iter().filter(|entry| {
        entry.path.strip_prefix(section).and_then(|rest| rest.strip_prefix('.')) == Some(entry.name())
    });
    own.map(|entry| (entry.name().to_owned(), reference(&definition(entry.path)))).collect()
}

/// A name that dotted paths can contain.
fn name(description: &str) -> Json {
    json!({ "type": "string", "pattern": "^[A-Za-z0-9_-]{1,100}$", "description": description })
}

fn structure() -> Json {
    let own = object([
        ("name", name("by which keys call this structure")),
        ("matrices", matrices()),
        ("damping", damping()),
        ("reduction", reduction(&[])),
    ]);
    let words = "one of the two structures: a beam, a block, a mesh or matrices";
    with_declared(words, own, &BodyKeys::declarations(), &["name"])
}

/// Nodes by a set of a body, or by their numbers in a table of freedoms.
fn nodes(description: &str) -> Map<String, Json> {
    let numbers = json!({ "type": "integer", "minimum": 0 });
    object([
        ("set", text(description)),
        (
            "nodes",
            json!({ "type": "array", "items": numbers, "description": "of matrices: nodes of the table of freedoms" }),
        ),
    ])
}

fn nodes_of(description: &str) -> Json {
    let mut properties = nodes("a set of nodes");
    properties.extend(object([("structure", text("the name of a structure"))]));
    table(description, properties, &["structure"])
}

fn contact() -> Json {
    let column = |key: SlidingKey, description: &str| json!({ "type": "array", "items": number(key), "minItems": 2, "description": description });
    let friction = object([
        ("velocity", column(SlidingKey::FrictionSpeed, "sliding speeds, ascending")),
        ("coefficient", column(SlidingKey::FrictionAtSpeed, "friction coefficients there")),
    ]);
    let friction = table("friction against the sliding speed", friction, &["velocity", "coefficient"]);
    let interpolation = Interpolation::ALL.map(|(name, _)| name);
    let mut properties = numbers("contact");
    properties.extend(object([
        ("slider", nodes_of("the slider and its contact point C, one node")),
        ("track", nodes_of("the track and its contact edge, nodes in their order")),
        ("friction_coefficient", json!({ "anyOf": [number(SlidingKey::FrictionCoefficient), friction] })),
        ("interpolation", choice(interpolation, "linear", "how the edge runs between its nodes")),
    ]));
    table("who slides on what, and friction", properties, &["slider", "track"])
}

fn motion() -> Json {
    let mut load = numbers("motion.load");
    load.extend(nodes("the slider's nodes that it acts on; several must move as one"));
    load.insert("direction".to_owned(), choice(Axis::ALL.map(|(name, _)| name), "y", "its direction"));
    let mut noise = numbers("motion.noise");
    noise.insert(
        "seed".to_owned(),
        json!({ "type": "integer", "minimum": 0, "default": SEED, "description": "which one" }),
    );
    let mut properties = numbers("motion");
    properties.extend(object([
        ("load", table("the force on the slider", load, &[])),
        ("ramps", table("times of half a cosine from zero", numbers("motion.ramps"), &[])),
        (
            "initial_damping",
            table(
                "damping of both structures at the start; their own by default",
                numbers("motion.initial_damping"),
                &[],
            ),
        ),
        ("noise", table("a random force on C", noise, &[])),
    ]));
    table("path, velocity and load of the slider", properties, &["load"])
}

fn observe() -> Json {
    let mut point = nodes("a set of one node");
    point.extend(object([
        ("name", name("by which signals call this point")),
        ("structure", text("the name of a structure")),
        ("at", list(number(SlidingKey::PointAt), [2, 2], "x and y of the point, in place of set or nodes")),
    ]));
    let point = table("a point whose motion is kept", point, &["name", "structure"]);
    let points = object([("points", json!({ "type": "array", "items": point }))]);
    table("points whose motion is kept", points, &["points"])
}

fn setting(kind: &str, key: &str) -> Json {
    let switch = |default: bool, description: &str| json!({ "type": "boolean", "default": default, "description": description });
    match key {
        "structure" => text("the name of a structure"),
        "count" if kind == "locus" => {
            whole([1, MODES_LIMIT], Some(MODES), "at each value, from the lowest frequency on")
        }
        "count" | "band" => Declaration::find(&Modes::declarations(), key),
        "configuration" => choice(
            Configuration::ALL.map(|(name, _)| name),
            "undeformed",
            "about which small motions are meant",
        ),
        "damping" => switch(true, "whether the structures are damped"),
        "positions" => {
            let mut properties = numbers("analysis.positions");
            properties.insert(
                "points".to_owned(),
                whole([2, POSITIONS_LIMIT], Some(POSITIONS), "how many, both ends included"),
            );
            table("positions of the contact; the path of the motion by default", properties, &[])
        }
        "sweep" => sweep(),
        "method" => names(MarchWord::ALL.map(|(word, _)| word), "how the coupled structures are integrated"),
        "signals" => signals(),
        "signal" => text(
            "POINT.x, POINT.y (acceleration), POINT.y.velocity, POINT.y.displacement, normal-force, tangential-force or sliding-velocity; the first point's along y by default",
        ),
        "slope" => choice(
            ["none", "static"],
            "none",
            "of `subs`: whether the static slope of the deformed track is put in",
        ),
        "predictor" => choice(
            Predictor::ALL.map(|(name, _)| name),
            "with-force",
            "of `ensubs` and `film`: the displacements that the geometry of the contact is taken from",
        ),
        "sound" => json!({
            "anyOf": [{ "type": "boolean" }, { "type": "array", "items": { "type": "string" } }], "default": true,
            "description": "leave the accelerations that are kept as WAV, or these signals",
        }),
        "checkpoint_steps" => whole(
            CHECKPOINT_RANGE,
            Some(CHECKPOINT_STEPS),
            "steps between states that an interrupted march goes on from",
        ),
        "of" => text("the name of a march that stands above"),
        "window" => {
            choice(Window::ALL.map(|(name, _)| name), "hann", "how a piece of the signal fades in and out")
        }
        "reference" => {
            json!({ "type": "string", "description": "the amplitude of 0 dB, in a unit of the signal", "examples": ["1 m/s^2"] })
        }
        "range" => list(json!({ "type": "number" }), [2, 2], "levels of the colours, dB"),
        "locus" => text("the name of a locus over positions that stands above"),
        _ => reference(&definition(&format!("analysis.{key}"))),
    }
}

fn signals() -> Json {
    let quantity = json!({ "enum": PointQuantity::ALL.map(|(name, _)| name) });
    let mut properties = numbers("analysis.signals");
    properties.insert(
        "quantities".to_owned(),
        json!({
            "type": "array", "items": quantity, "default": ["acceleration"],
            "description": "what is kept of the motion of every observed point",
        }),
    );
    table("how signals are sampled, and what is kept of the observed points", properties, &[])
}

fn sweep() -> Json {
    let end =
        json!({ "type": ["number", "string"], "description": "a number, or a quantity with the key's unit" });
    let key = json!({ "type": "string", "description": "dotted path of a number of structures, contact, motion or parameters" });
    let values = json!({ "type": "array", "items": end, "minItems": 2 });
    let of_list = object([("key", key.clone()), ("values", values)]);
    let of_list = table("a key with a list of values", of_list, &["key", "values"]);
    json!({ "oneOf": [super::sweep(key, &end, "a key over a range", None), of_list] })
}
