//! Analyses of motion that are read.

use super::parse;
use judder_keys::numeric_key::{Form, Value};
use judder_models::belt::case::BeltCase;
use judder_models::belt::case::BeltKey;
use judder_models::motion::MotionAnalysis;
use judder_models::motion::basin::BasinAnalysis;
use judder_models::motion::bifurcation::{Bifurcation, SweepDirection};
use judder_models::motion::history::HistoryAnalysis;
use judder_models::motion::limit_cycle::LimitCycle;
use judder_models::motion::settings::MotionStart;
use judder_models::oscillator::case::OscillatorCase;
use judder_models::oscillator::engines::settings::EnginesSettings;
use judder_models::oscillator::keys::OscillatorKey;

fn oscillator<A: Clone + 'static>(settings: &str) -> A {
    let case = parse(&format!("model = \"oscillator\"\n[[analysis]]\n{settings}"), &[])
        .unwrap()
        .of::<OscillatorCase>()
        .unwrap()
        .clone();
    case.analyses[0].settings::<MotionAnalysis<A>>().unwrap().0.clone()
}

#[test]
fn a_motion_of_defaults() {
    let history: HistoryAnalysis = oscillator("kind = \"motion\"");
    assert_eq!(history.start, MotionStart::USUAL);
    assert_eq!((history.duration, history.transient), (Value::group(2000.0), Value::group(1000.0)));
    assert_eq!((history.tolerance, history.steps, history.points), (1e-8, 10_000_000, 4096));
}

#[test]
fn a_motion_in_seconds_from_the_air() {
    let history: HistoryAnalysis = oscillator(
        "kind = \"motion\"\nduration = \"50 s\"\ntransient = \"20 s\"\nstart = { y = -0.5, velocity_y = 1 }",
    );
    assert!(matches!(history.start, MotionStart::State { .. }));
    assert_eq!(history.start.state(), [None, Some(Value::group(-0.5)), None, Some(Value::group(1.0))]);
    assert_eq!((history.duration, history.transient), (Value::si(50.0), Value::si(20.0)));
}

#[test]
fn a_limit_cycle_and_a_diagram_have_tolerances_of_their_own() {
    let cycle: LimitCycle = oscillator("kind = \"limit-cycle\"");
    assert_eq!((cycle.tolerance, cycle.duration), (1e-10, Value::group(2e4)));
    let Bifurcation { sweep, diagram } = oscillator::<Bifurcation<OscillatorKey>>(
        "kind = \"bifurcation\"\nsweep = { key = \"contact.shear_strength\", from = 1e-4, to = 5e-2, points = 3 }\n\
         direction = \"backward\"\ntolerance = 1e-7",
    );
    assert_eq!((sweep.key, sweep.form, diagram.tolerance), (OscillatorKey::ShearStrength, Form::Group, 1e-7));
    assert_eq!(diagram.direction, SweepDirection::Backward);
    assert!(!diagram.branches, "branches take minutes where cycles stick and lift off");
    assert_eq!(diagram.direction.sweeps(), [SweepDirection::Backward]);
}

fn engines(settings: &str) -> EnginesSettings {
    let text = format!("model = \"oscillator\"\n[[analysis]]\nkind = \"engines\"\n{settings}");
    let case = parse(&text, &[]).unwrap().of::<OscillatorCase>().unwrap().clone();
    case.analyses[0].settings::<EnginesSettings>().unwrap().clone()
}

#[test]
fn a_comparison_of_engines() {
    let settings = engines("");
    assert_eq!((settings.tolerance, settings.duration), (1e-10, Value::group(2e4)));
    assert_eq!((settings.time_step.points, settings.width.points), (11, 13));
    // the width of most codes is among the defaults
    assert!(settings.width.values().iter().any(|width| (width - 0.1).abs() < 1e-12));
    let settings = engines(
        "time_step = { from = \"10 us\", to = \"1 ms\" }\nwidth = { from = 1e-3, to = 1, points = 4 }",
    );
    assert_eq!((settings.time_step.form, settings.time_step.points), (Form::Si, 11));
    assert_eq!(settings.width.values().len(), 4);
}

const BELT: &str = r#"
model = "belt"
[oscillator]
damping = 0.05
[friction]
at_rest = 1.0
[operation]
velocity = 1.5
[[analysis]]
kind = "basin"
within = { x = [-2, 2], velocity_x = [0, 2] }
samples = 50
seed = 7
[[analysis]]
kind = "bifurcation"
sweep = { key = "operation.velocity", from = 1, to = 2, points = 5 }
"#;

#[test]
fn a_mass_on_a_belt() {
    let case = parse(BELT, &["friction.at_speed=0.4"]).unwrap().of::<BeltCase>().unwrap().clone();
    assert_eq!((case.inputs.number(BeltKey::Velocity), case.inputs.number(BeltKey::AtSpeed)), (1.5, 0.4));
    let basin = &case.analyses[0].settings::<MotionAnalysis<BasinAnalysis>>().unwrap().0;
    assert_eq!(
        basin.within.state(),
        [Some([-2.0, 2.0].map(Value::group)), Some([0.0, 2.0].map(Value::group))]
    );
    assert_eq!((basin.samples, basin.seed, basin.tolerance), (50, 7, 1e-6));
}

#[test]
fn friction_of_a_belt_may_be_a_table() {
    let table = "[friction]\nvelocity = [0, 0.5]\ncoefficient = [1.0, 0.6]\ninterpolation = \"monotone\"";
    let text = BELT.replace("[friction]\nat_rest = 1.0", table);
    let case = parse(&text, &[]).unwrap().of::<BeltCase>().unwrap().clone();
    let friction = case.curve.as_ref().unwrap().friction().unwrap();
    assert!(
        (friction.at(0.0).coefficient - 1.0).abs() < 1e-15
            && (friction.at(0.25).coefficient - 0.8).abs() < 1e-15
    );
    let written =
        serde_json::json!({ "velocity": [0.0, 0.5], "coefficient": [1.0, 0.6], "interpolation": "monotone" });
    assert_eq!(parse(&text, &[]).unwrap().resolved()["friction"], written);
}

#[test]
fn the_resolved_case_shows_what_is_taken() {
    let json = parse(BELT, &[]).unwrap().resolved();
    assert_eq!(
        json["friction"],
        serde_json::json!({ "at_rest": 1.0, "at_speed": 0.5, "decay_speed": 0.5, "viscous": 0.0, "exponent": 1.0 })
    );
    let basin = &json["analysis"][0];
    assert_eq!(basin["within"], serde_json::json!({ "x": [-2.0, 2.0], "velocity_x": [0.0, 2.0] }));
    assert_eq!((&basin["duration"], &basin["seed"]), (&serde_json::json!(2e4), &serde_json::json!(7)));
    assert_eq!(json["analysis"][1]["start"], serde_json::json!({ "disturbance": 0.2 }));
    assert_eq!(json["analysis"][1]["direction"], "both");
}
