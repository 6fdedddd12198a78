//! The locus of the beams paper at a held position: one point on a track, undeformed and deformed, against the model of the paper.

use crate::{number, run_into};
use judder_models::parse;
use num_complex::Complex64;
use serde_json::Value;
use std::f64::consts::TAU;

/// The beams of the paper; the horizontal one of four-node elements, along whose edge points may lie anywhere.
const STRUCTURES: &str = r#"
[[structure]]
name = "oblique"
beam = { length = "75 mm", thickness = "1.5 mm", elements = [75, 2], angle = "-30 deg", start = "guided", ORIGIN }
width = "10 mm"
material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
damping = { rayleigh = { alpha = "0.2 1/s", beta = "4e-8 s" } }
reduction = { count = 4 }

[[structure]]
name = "horizontal"
block = { element = "quad4", size = ["100 mm", "2 mm"], cells = [100, 2] }
width = "20 mm"
material = { youngs_modulus = "2.38 GPa", poisson_ratio = 0.40, density = "1200 kg/m^3" }
damping = { rayleigh = { alpha = "40 1/s", beta = "4e-8 s" } }
supports = [{ set = "x-min", fixed = ["x", "y"] }]
reduction = { count = 4 }
"#;

/// Where the modes at 3.52 kHz flutter if the bodies are deformed, in m.
const POSITION: f64 = 0.07384;

/// Modes that are compared.
const COUNT: usize = 10;

/// The locus of sliding structures from that position on.
fn sliding() -> Value {
    let locus = |configuration: &str| {
        format!(
            "[[analysis]]\nname = \"{configuration}\"\nkind = \"locus\"\nconfiguration = \"{configuration}\"\ncount = {COUNT}\n\
             positions = {{ from = \"{POSITION} m\", to = \"75 mm\", points = 2 }}\n"
        )
    };
    let text = format!(
        "model = \"sliding\"\n{}{}{}{}",
        STRUCTURES.replace("ORIGIN", "end = \"free\""),
        r#"
[contact]
slider = { structure = "oblique", set = "end-lower" }
track = { structure = "horizontal", set = "y-max" }
friction_coefficient = 0.3

[motion]
start = "10 mm"
end = "98.5 mm"
velocity = "30 mm/s"
load = { set = "start", direction = "y", force = "-0.2 N" }

"#,
        locus("undeformed"),
        locus("deformed"),
    );
    let folder = tempfile::tempdir().unwrap();
    let file = parse("case.toml", &text, &[]).unwrap();
    serde_json::to_value(run_into(folder.path(), &file, &[]).summary.results).unwrap()
}

/// The same as an assembly.
fn assembly(configuration: &str) -> Vec<Complex64> {
    let (sine, cosine) = (-30.0_f64).to_radians().sin_cos();
    // the lower corner of the beam's end lies on the track at the position
    let (length, half) = (0.075, 0.00075);
    let [x, y] = [POSITION - length * cosine - half * sine, 0.002 - length * sine + half * cosine];
    let text = format!(
        "model = \"assembly\"\n{}{}count = {COUNT}\n",
        STRUCTURES.replace("ORIGIN", &format!("origin = [\"{x} m\", \"{y} m\"]")),
        r#"
[[contact]]
name = "tip"
slider = { structure = "oblique", set = "end-lower" }
track = { structure = "horizontal", set = "y-max" }
sliding = { velocity = "30 mm/s", direction = [-1, 0] }
configuration = "CONFIGURATION"
friction_coefficient = 0.3

[[load]]
structure = "oblique"
set = "start"
direction = "y"
force = "-0.2 N"

[[analysis]]
name = "modes"
kind = "eigen"
"#
        .replace("CONFIGURATION", configuration)
    );
    let folder = tempfile::tempdir().unwrap();
    let file = parse("case.toml", &text, &[]).unwrap();
    let results = run_into(folder.path(), &file, &[]).summary.results;
    let modes = results["modes"]["eigenvalues"].as_array().unwrap();
    modes.iter().map(|own| Complex64::new(number(&own["re"]), number(&own["im"]))).collect()
}

#[test]
fn the_locus_of_the_beams_paper_at_a_held_position_is_that_of_an_assembly() {
    let other = sliding();
    let of = |name: &str| {
        let row = |key: &str| other[name][key][0].as_array().unwrap().iter().map(number).collect::<Vec<_>>();
        let (rates, frequencies) = (row("growth_rates"), row("frequencies_hz"));
        rates.into_iter().zip(frequencies).map(|(re, f)| Complex64::new(re, TAU * f)).collect::<Vec<_>>()
    };
    let (undeformed, deformed) = (of("undeformed"), of("deformed"));
    // the slope terms decide: about the deformed bodies alone a mode grows
    let fastest = |all: &[Complex64]| all.iter().map(|own| own.re).fold(f64::NEG_INFINITY, f64::max);
    assert!(fastest(&undeformed) < 0.0 && fastest(&deformed) > 50.0, "{deformed:?} {undeformed:?}");
    for (name, expected) in [("undeformed", undeformed), ("deformed", deformed)] {
        let found = assembly(name);
        assert_eq!((found.len(), expected.len()), (COUNT, COUNT));
        // rounding in the stiffness is that of the fastest mode in all λ²
        let scale = expected.iter().map(Complex64::norm_sqr).fold(0.0, f64::max);
        for (own, expected) in found.iter().zip(&expected) {
            let off = (own * own - expected * expected).norm() / scale;
            assert!(off < 1e-10, "{name}: {own} {expected}, {off:.1e}");
        }
    }
}
