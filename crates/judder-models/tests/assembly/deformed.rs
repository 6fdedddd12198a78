//! Points of the deformed configuration, against the other model that has them.

use crate::{number, run_into};
use judder_models::parse;
use serde_json::Value;
use std::f64::consts::TAU;

const STRUCTURES: &str = r#"
[[structure]]
name = "slider"
beam = { length = "75 mm", thickness = "1.5 mm", elements = [15, 1], angle = "-30 deg", start = "guided", ORIGIN }
width = "10 mm"
material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
reduction = { count = 30 }

[[structure]]
name = "track"
block = { element = "quad4", size = ["100 mm", "2 mm"], cells = [20, 1] }
width = "20 mm"
material = { youngs_modulus = "2.38 GPa", poisson_ratio = 0.40, density = "1200 kg/m^3" }
supports = [{ set = "x-min", fixed = ["x", "y"] }]
reduction = { count = 30 }
"#;

/// A slider on a track, whose point C lies at 74 mm.
fn sliding() -> Value {
    let text = format!(
        "model = \"sliding\"\n{}{}",
        STRUCTURES.replace("ORIGIN", "end = \"free\""),
        r#"
[contact]
slider = { structure = "slider", set = "end-lower" }
track = { structure = "track", set = "y-max" }
friction_coefficient = 0.3

[motion]
start = "70 mm"
end = "90 mm"
velocity = "300 mm/s"
load = { set = "start", direction = "y", force = "-2 N" }

[[analysis]]
name = "undeformed"
kind = "locus"
count = 4
positions = { from = "74 mm", to = "76 mm", points = 2 }

[[analysis]]
name = "deformed"
kind = "locus"
configuration = "deformed"
count = 4
positions = { from = "74 mm", to = "76 mm", points = 2 }
"#
    );
    let folder = tempfile::tempdir().unwrap();
    let file = parse("case.toml", &text, &[]).unwrap();
    serde_json::to_value(run_into(folder.path(), &file, &[]).summary.results).unwrap()
}

/// The same as an assembly.
fn assembly(configuration: &str) -> Vec<[f64; 2]> {
    let (sine, cosine) = (-30.0_f64).to_radians().sin_cos();
    // the lower corner of the beam's end lies on the track at 74 mm
    let (length, half) = (0.075, 0.00075);
    let [x, y] = [0.074 - length * cosine - half * sine, 0.002 - length * sine + half * cosine];
    let text = format!(
        "model = \"assembly\"\n{}{}",
        STRUCTURES.replace("ORIGIN", &format!("origin = [\"{x} m\", \"{y} m\"]")),
        r#"
[[contact]]
name = "tip"
slider = { structure = "slider", set = "end-lower" }
track = { structure = "track", set = "y-max" }
sliding = { velocity = "300 mm/s", direction = [-1, 0] }
configuration = "CONFIGURATION"
friction_coefficient = 0.3

[[load]]
structure = "slider"
set = "start"
direction = "y"
force = "-2 N"

[[analysis]]
name = "modes"
kind = "eigen"
count = 4
"#
        .replace("CONFIGURATION", configuration)
    );
    let folder = tempfile::tempdir().unwrap();
    let file = parse("case.toml", &text, &[]).unwrap();
    let results = run_into(folder.path(), &file, &[]).summary.results;
    let modes = results["modes"]["eigenvalues"].as_array().unwrap();
    modes.iter().map(|own| [number(&own["im"]) / TAU, number(&own["re"])]).collect()
}

#[test]
fn one_point_on_a_deformed_track_is_that_of_sliding_structures() {
    let other = sliding();
    let of = |name: &str| {
        let row = |key: &str| other[name][key][0].as_array().unwrap().iter().map(number).collect::<Vec<_>>();
        row("frequencies_hz").into_iter().zip(row("growth_rates")).map(|(f, g)| [f, g]).collect::<Vec<_>>()
    };
    let (undeformed, deformed) = (of("undeformed"), of("deformed"));
    // the slope terms show
    assert!((deformed[0][0] / undeformed[0][0] - 1.0).abs() > 1e-4, "{deformed:?} {undeformed:?}");
    for (name, expected) in [("undeformed", undeformed), ("deformed", deformed)] {
        for (own, expected) in assembly(name).iter().zip(&expected) {
            let scale = expected[0];
            assert!((own[0] - expected[0]).abs() < 1e-6 * scale, "{name}: {own:?} {expected:?}");
            assert!((own[1] - expected[1]).abs() < 1e-5 * scale, "{name}: {own:?} {expected:?}");
        }
    }
}
