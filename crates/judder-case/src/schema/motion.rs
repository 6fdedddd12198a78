//! The settings of the analyses of motion, and the belt case.

use serde_json::{Map, Value as Json, json};

use super::{analyses, choice, key, object, reference, sweep, table};
use crate::belt_case::{self, BELT_KEYS, BELT_SECTIONS, BeltKeys};
use crate::engines_analysis::{ENGINES, EnginesKey, LADDER_POINTS, TIME_STEP, TIME_STEPS, WIDTH, WIDTHS};
use crate::keys::{Key, Range};
use crate::motion_analysis::{
    BASIN, BASIN_SAMPLES, BASIN_SEED, BIFURCATION, BRANCHES, DISTURBANCE, HISTORY, HISTORY_POINTS,
    HISTORY_POINTS_LIMITS, LIMIT_CYCLE, MOTION_STEPS, MotionKeys, MotionKind, SAMPLES_LIMITS, SEED_LIMITS,
    STEPS_LIMITS, SweepDirection, TOLERANCE_RANGE, TRANSIENT_SHARE,
};

/// Whether a kind is one of motion.
fn kind(name: &str) -> Option<&'static MotionKind> {
    const KINDS: [&MotionKind; 5] = [&HISTORY, &LIMIT_CYCLE, &BIFURCATION, &BASIN, &ENGINES];
    KINDS.into_iter().find(|kind| kind.name == name)
}

/// A setting of an analysis of motion that is no sweep; `None` for another kind.
pub(super) fn setting<S: MotionKeys>(kind_name: &str, name: &str) -> Option<Json> {
    let kind = kind(kind_name)?;
    Some(match name {
        "start" => start::<S>(),
        "within" => {
            let range =
                json!({ "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2 });
            let ranges = S::COORDINATES.iter().map(|name| ((*name).to_owned(), range.clone())).collect();
            table(
                "ranges [from, to] of the starts; what is left out stands as in steady sliding",
                ranges,
                &[],
            )
        }
        "duration" | "transient" => {
            let mut json = key(S::time());
            let is_duration = name == "duration";
            let share = if is_duration { 1.0 } else { TRANSIENT_SHARE };
            json["default"] = json!(share * kind.duration);
            json["description"] = json!(match (is_duration, kind.name == HISTORY.name) {
                (true, true) => "time that the motion is followed",
                (true, false) => "time within which a motion settles",
                (false, _) => "first part of the duration, which averages leave out; half of it by default",
            });
            json
        }
        "points" => whole(HISTORY_POINTS_LIMITS, HISTORY_POINTS, "points of the grid of time that is kept"),
        "samples" => whole(SAMPLES_LIMITS, BASIN_SAMPLES, "number of starts"),
        "seed" => whole(SEED_LIMITS, BASIN_SEED, "which starts are drawn"),
        "steps" => whole(STEPS_LIMITS, MOTION_STEPS, "most steps of one motion"),
        "direction" => {
            choice(SweepDirection::ALL.map(|(name, _)| name), "both", "which way the key is followed")
        }
        "tolerance" => tolerance(kind),
        "time_step" => ladder(&TIME_STEP, TIME_STEPS),
        "width" => ladder(&WIDTH, WIDTHS),
        "branches" => {
            json!({ "type": "boolean", "default": BRANCHES, "description": "follow the branches of cycles through the diagram" })
        }
        _ => return None,
    })
}

/// A range of steps or widths.
fn ladder(entry: &Key<EnginesKey>, (from, to, points): (f64, f64, usize)) -> Json {
    let count = json!({ "type": "integer", "minimum": 2, "maximum": LADDER_POINTS, "default": points });
    let entries = object([("from", key(entry)), ("to", key(entry)), ("points", count)]);
    let mut json = table("a range, with equal ratios between its points", entries, &["from", "to"]);
    json["default"] = json!({ "from": from, "to": to, "points": points });
    json
}

fn tolerance(kind: &MotionKind) -> Json {
    let mut json = json!({
        "type": "number", "default": kind.tolerance,
        "description": "local error of a step, relative to the magnitudes of steady sliding",
    });
    if let Range::Interval { above, up_to } = TOLERANCE_RANGE {
        json["exclusiveMinimum"] = json!(above);
        json["maximum"] = json!(up_to);
    }
    json
}

fn start<S: MotionKeys>() -> Json {
    let number = json!({ "type": "number" });
    let state: Map<_, _> = S::COORDINATES.iter().map(|name| ((*name).to_owned(), number.clone())).collect();
    let disturbance = object([("disturbance", number)]);
    let disturbed =
        table("steady sliding with x moved by this share of |x_e|", disturbance, &["disturbance"]);
    let state = table("a state; what is left out stands as in steady sliding", state, &[]);
    json!({ "oneOf": [disturbed, state], "default": { "disturbance": DISTURBANCE }, "description": "where the motion starts" })
}

fn whole([from, to]: [usize; 2], default: usize, description: &str) -> Json {
    json!({ "type": "integer", "minimum": from, "maximum": to, "default": default, "description": description })
}

pub(super) fn belt_case() -> Json {
    let mut properties = object([
        ("title", json!({ "type": "string" })),
        ("model", json!({ "const": "belt" })),
        ("analysis", analyses(&belt_case::KINDS, belt_setting)),
        ("sweep", reference("sweeps")),
    ]);
    for section in BELT_SECTIONS {
        let entries = BELT_KEYS.iter().filter(|entry| entry.section() == section);
        let keys =
            entries.map(|entry| (entry.name().to_owned(), reference(&definition(entry.path)))).collect();
        properties.insert(section.to_owned(), table("", keys, &[]));
    }
    table("one mass on a moving belt, friction that falls with speed", properties, &["model"])
}

/// The name of a belt's key among the definitions: it shares paths with the oscillator's.
pub(super) fn definition(path: &str) -> String {
    format!("belt.{path}")
}

fn belt_setting(kind: &str, name: &str) -> Json {
    setting::<BeltKeys>(kind, name).unwrap_or_else(|| {
        sweep(reference("belt-key"), &json!({ "type": "number" }), "a key over a range", None)
    })
}
