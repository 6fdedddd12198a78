//! What others share with the drawings, written for them and checked to be current: the palette, which the interactive chart and Python take
//! from here, and marks of axes, with which those of the chart are compared. `JUDDER_GOLDEN=write` writes all of it anew.

use crate::axis::{Axis, Scale};
use crate::palette::{
    Colour, ColourMap, DASH_CYCLE, Dash, GRADED_END, GROUND, INK, MARKER_CYCLE, QUALITATIVE, QUIET, Role,
    Style,
};
use crate::scale::PlacedAxis;
use crate::ticks::ticks;
use serde_json::{Map, Value, json};
use std::path::Path;

/// Compares a file of the sources with what it should be, or writes it.
fn check(file: &str, wanted: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
    if std::env::var("JUDDER_GOLDEN").is_ok_and(|mode| mode == "write") {
        std::fs::write(&path, wanted).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap();
    assert!(
        found == wanted,
        "{file} is not current: JUDDER_GOLDEN=write writes it, `make page` builds with it"
    );
}

const PAGE: &str = "crates/judder-explorer/web";

/// The name under which a figure's JSON speaks of a meaning, a dash or a marker.
fn name(value: impl serde::Serialize) -> String {
    serde_json::to_value(value).unwrap().as_str().unwrap().to_owned()
}

fn hex(colours: &[Colour]) -> Vec<String> {
    colours.iter().map(ToString::to_string).collect()
}

fn line(role: Role) -> Value {
    let Style { dash, marker, width, .. } = role.into();
    json!({ "colour": role.colour().to_string(), "dash": dash, "marker": marker, "width": width })
}

const AREAS: [Role; 18] = [
    Role::Stable,
    Role::Flutter,
    Role::NegativeDamping,
    Role::Both,
    Role::NormalForceCoupling,
    Role::DestabilisedByDamping,
    Role::Unresolved,
    Role::Knock,
    Role::KnockUnknown,
    Role::WithinLaw,
    Role::TurningNormal,
    Role::ConvectedSlip,
    Role::AcrossSlip,
    Role::UnknownGrowth,
    Role::UnstableZone,
    Role::Stick,
    Role::SlipAhead,
    Role::LiftOff,
];
const LINES: [Role; 4] =
    [Role::FullBoundary, Role::ConservativeBoundary, Role::DecoupledBoundary, Role::Reference];

fn palette() -> Value {
    let dashes = [Dash::Solid, Dash::Dashed, Dash::DashDotted, Dash::Dotted];
    let named = |roles: &[Role], of: &dyn Fn(Role) -> Value| -> Map<String, Value> {
        roles.iter().map(|role| (name(role), of(*role))).collect()
    };
    json!({
        "ink": INK.to_string(),
        "quiet": QUIET.to_string(),
        "ground": GROUND.to_string(),
        "areas": named(&AREAS, &|role| json!(role.colour().to_string())),
        "lines": named(&LINES, &line),
        "series": {
            "colours": hex(&QUALITATIVE), "dashes": DASH_CYCLE, "markers": MARKER_CYCLE, "width": Style::from(Role::Series(0)).width,
        },
        "graded": { "end": GRADED_END, "width": Style::from(Role::Graded { index: 0, count: 1 }).width },
        "dashes": dashes.map(|dash| (name(dash), json!(dash.pattern()))).into_iter().collect::<Map<String, Value>>(),
        "stops": {
            "sequential": hex(ColourMap::Sequential.stops()), "diverging": hex(ColourMap::Diverging.stops()),
        },
    })
}

#[test]
fn the_golden_palette_of_the_chart_is_this_one() {
    let mut palette = palette();
    palette.sort_all_objects();
    let palette = serde_json::to_string_pretty(&palette).unwrap();
    let head = "/** Colours, dashes and markers by meaning, written by the tests of `judder-report` from its palette: change them there. */";
    check(
        &format!("{PAGE}/src/chart/meanings.ts"),
        &format!("{head}\nexport const MEANINGS = {palette} as const;\n"),
    );
}

#[test]
fn the_golden_palette_of_python_is_this_one() {
    let named = |name: &str, roles: &[Role]| {
        let colours: String =
            roles.iter().map(|role| format!("    {}: \"{}\",\n", json!(role), role.colour())).collect();
        format!("{name}: Final = {{\n{colours}}}\n")
    };
    let head = "\"\"\"Colours by meaning, written by the tests of `judder-report` from its palette: change them there.\"\"\"";
    let series = QUALITATIVE.map(|colour| format!("\"{colour}\""));
    let (areas, lines) = (named("AREAS", &AREAS), named("LINES", &LINES));
    check(
        "python/judder/_palette.py",
        &format!(
            "{head}\n\nfrom __future__ import annotations\n\nfrom typing import Final\n\n{areas}{lines}SERIES: Final = ({})\n\"\"\"The colours of curves that have no order.\"\"\"\n",
            series.join(", ")
        ),
    );
}

/// Axes of every kind, wide and narrow, on both sides of zero.
fn axes() -> Vec<(Scale, f64, f64)> {
    let mut axes = Vec::new();
    for (from, to) in [
        (-1.0, 1.0),
        (0.0, 400.0),
        (0.0, 3e-6),
        (-2e5, 7e5),
        (0.12, 0.13),
        (1e-3, 2.5),
        (999.0, 1001.0),
        (-0.37, 1e-4),
        (3.0, 3.000_01),
        (0.0, 0.9),
    ] {
        axes.push((Scale::Linear, from, to));
    }
    for (from, to) in [
        (1e-2, 1e1),
        (1e-8, 1e2),
        (2.0, 6.0),
        (0.5, 30.0),
        (3e-7, 4e-7),
        (1e-40, 1e60),
        (0.09, 11.0),
        (1.5, 8e4),
    ] {
        axes.push((Scale::Log, from, to));
    }
    for (linear, from, to) in [
        (1e-2, -0.1, 1.0),
        (0.1, -10.0, 10.0),
        (1e-3, -1e5, 0.0),
        (1.0, -0.5, 0.5),
        (0.1, 2.0, 6.0),
        (2e-4, -3.0, 50.0),
        (1e-9, -1e9, 1e9),
    ] {
        axes.push((Scale::SymmetricLog { linear }, from, to));
    }
    axes
}

#[test]
fn the_golden_marks_with_which_those_of_the_chart_are_compared_are_these() {
    let marks: Vec<String> = axes()
        .into_iter()
        .flat_map(|(scale, from, to)| [3, 6, 11].map(|room| (scale, from, to, room)))
        .map(|(scale, from, to, room)| {
            let axis = Axis { scale, ..Axis::linear("") }.with_range(from, to);
            let ticks = ticks(&PlacedAxis::new(&axis, std::iter::empty(), 0.0), room);
            let major: Vec<(f64, &str)> =
                ticks.major.iter().map(|tick| (tick.value, tick.label.as_str())).collect();
            let (minor, exponent) = (&ticks.minor, ticks.exponent);
            let mut marks = json!({
                "scale": scale, "range": [from, to], "room": room, "major": major, "minor": minor, "exponent": exponent,
            });
            marks.sort_all_objects();
            marks.to_string()
        })
        .collect();
    check(&format!("{PAGE}/tests/ticks.json"), &format!("[\n{}\n]\n", marks.join(",\n")));
}
