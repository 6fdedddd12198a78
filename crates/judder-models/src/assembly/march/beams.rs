//! The beams paper as an assembly: the tip of a beam travels along another, against the march of sliding structures, step by step.

use crate::assembly::build::BuiltAssembly;
use crate::assembly::case::AssemblyCase;
use crate::sliding::case::SlidingCase;
use crate::sliding::system::ReducedPair;
use judder_nonsmooth::course::{Course, TimeFactor};
use judder_nonsmooth::excitation::{DrivingSignal, Excitation};
use judder_nonsmooth::gauss_seidel::ContactAccuracy;
use judder_nonsmooth::march::{NonsmoothMarch, NonsmoothSettings};
use judder_nonsmooth::scheme::ContactScheme;
use judder_sliding::march::{ContactMethod, March, MarchSample, MarchSettings, Predictor};

const STRUCTURES: &str = r#"
[[structure]]
name = "oblique"
beam = { length = "75 mm", thickness = "1.5 mm", elements = [75, 2], angle = "-30 deg", start = "guided", ORIGIN }
width = "10 mm"
material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
damping = { rayleigh = { alpha = "0.2 1/s", beta = "4e-8 s" } }
reduction = { count = 8 }

[[structure]]
name = "horizontal"
block = { element = "quad4", size = ["100 mm", "2 mm"], cells = [100, 2] }
width = "20 mm"
material = { youngs_modulus = "2.38 GPa", poisson_ratio = 0.40, density = "1200 kg/m^3" }
damping = { rayleigh = { alpha = "40 1/s", beta = "4e-8 s" } }
supports = [{ set = "x-min", fixed = ["x", "y"] }]
reduction = { count = 4 }
"#;
const START: f64 = 0.06;
const SPEED: f64 = 0.03;
const LOAD: f64 = 0.2;
/// Times over which speed and load rise, in s.
const RISE: [f64; 2] = [4e-3, 2e-3];
const STEPS: u64 = 100_000;

fn sliding() -> String {
    format!(
        r#"model = "sliding"{}
[contact]
slider = {{ structure = "oblique", set = "end-lower" }}
track = {{ structure = "horizontal", set = "y-max" }}
friction_coefficient = 0.3

[motion]
start = "{START} m"
end = "98.5 mm"
velocity = "{SPEED} m/s"
load = {{ set = "start", direction = "y", force = "-{LOAD} N" }}
ramps = {{ velocity = "{} s", load = "{} s", friction = "0 s", gap = "0 s" }}

[[analysis]]
kind = "locus"
count = 2
positions = {{ from = "70 mm", to = "71 mm", points = 2 }}
"#,
        STRUCTURES.replace("ORIGIN", "end = \"free\""),
        RISE[0],
        RISE[1],
    )
}

fn assembly() -> String {
    let (sine, cosine) = (-30.0_f64).to_radians().sin_cos();
    // the lower corner of the beam's end lies on the track at the start
    let (length, half) = (0.075, 0.00075);
    let [x, y] = [START - length * cosine - half * sine, 0.002 - length * sine + half * cosine];
    format!(
        r#"model = "assembly"{}
[[contact]]
name = "tip"
slider = {{ structure = "oblique", set = "end-lower" }}
track = {{ structure = "horizontal", set = "y-max" }}
sliding = {{ velocity = "{SPEED} m/s", direction = [-1, 0] }}
travel = "linear"
friction_coefficient = 0.3

[[load]]
structure = "oblique"
set = "start"
direction = "y"
force = "-{LOAD} N"

[[analysis]]
kind = "steady-sliding"
"#,
        STRUCTURES.replace("ORIGIN", &format!("origin = [\"{x} m\", \"{y} m\"]")),
    )
}

/// Forces of every step, from rest of the bodies as meshed, while load and speed rise, the frame of the slider with it.
#[test]
fn the_march_of_the_beams_paper_is_that_of_an_assembly() {
    let file = crate::parse("sliding.toml", &sliding(), &[]).unwrap();
    let Ok(ReducedPair { pair, motion, .. }) = ReducedPair::new(file.case.of::<SlidingCase>().unwrap())
    else {
        unreachable!("the pair is that of the paper")
    };
    let settings = |step: f64| MarchSettings {
        method: ContactMethod::Film,
        predictor: Predictor::WithForce,
        step,
        motion,
    };
    let step = 0.5 * March::beyond_limit(&pair, settings(1e-9)).unwrap().step_limit();
    let mut march = March::new(&pair, settings(step)).unwrap();
    let mut expected = Vec::new();
    march.advance(STEPS, &mut |sample: &MarchSample, _: &[f64]| expected.push(*sample)).unwrap();

    let file = crate::parse("assembly.toml", &assembly(), &[]).unwrap();
    let case = file.case.of::<AssemblyCase>().unwrap();
    let Ok(built) = BuiltAssembly::new(case) else { unreachable!("the bodies are those of the paper") };
    let (scheme, accuracy) = (ContactScheme::ForwardIncrement, ContactAccuracy::default());
    let settings = NonsmoothSettings { scheme, step, accuracy, cut_off: None };
    let mut march = NonsmoothMarch::travelling(&built.assembly, &built.travelling, &[], settings).unwrap();
    march.set_force_scale(LOAD);
    let [speed, load] = RISE.map(TimeFactor::Rise);
    let inertia = Excitation {
        signal: DrivingSignal::Rate(speed.clone()),
        forces: built.carried_along(case, "").unwrap_or_default(),
    };
    march.follow(Course { speed, load, friction: Vec::new() }, &[inertia]).unwrap();
    let rest = vec![0.0; built.assembly.size()];
    march.start(&rest, &rest);
    let (mut worst, mut pressed) = ([0.0_f64; 2], 0.0_f64);
    for sample in &expected {
        march.advance().unwrap();
        let [normal, along, _] = march.force(0);
        worst[0] = worst[0].max((normal - sample.normal_force).abs());
        worst[1] = worst[1].max((along + sample.tangential_force).abs());
        pressed = pressed.max(normal);
    }
    assert!(expected.len() as u64 == STEPS && pressed > 0.5 * LOAD, "{pressed}");
    // of the same modes it is 1e-9 (judder-nonsmooth); here modes of each beam stand against those of both together, whose phases drift apart by rounding
    assert!(worst.iter().all(|own| *own < 2e-7 * pressed), "{worst:?} of {pressed}");
}
