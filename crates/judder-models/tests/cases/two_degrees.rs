//! Two-degrees cases that are read.

use super::parse;
use judder_keys::cause::Cause;
use judder_models::sweep::{ParameterKey, StabilityMapAnalysis};
use judder_models::two_degrees::case::TwoDegreesCase;
use judder_models::two_degrees::critical::ParameterThresholds;

/// The damped Hopf benchmark: damping of one degree destabilises.
const HOPF: &str = r#"
model = "two-degrees"
[parameters]
mu = 0.5
c2 = 0.002
angle = 0.25
[matrices]
damping = [[0.02, 0], [0, "c2"]]
stiffness = [["sqrt(4)", "1 - 4*mu/3"], ["sin(2*pi*angle)", "2.4 * cos(0)^2 * exp(0)"]]
[[analysis]]
kind = "critical"
sweep = { key = "parameters.mu", from = 0, to = 1.5 }
[[analysis]]
kind = "stability-map"
x = { key = "mu", from = 0, to = 1, points = 5 }
y = { key = "c2", from = 1e-4, to = 1, points = 5, scale = "log" }
"#;

fn two_degrees(text: &str, overrides: &[&str]) -> TwoDegreesCase {
    parse(text, overrides).unwrap().of::<TwoDegreesCase>().expect("its model").clone()
}

#[test]
fn matrices_follow_the_parameters() {
    let case = two_degrees(HOPF, &["parameters.c2=0.01"]);
    let names: Vec<_> = case.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    assert_eq!(names, ["mu", "c2", "angle"]);
    let mut values = case.values();
    assert_eq!(values, [0.5, 0.01, 0.25]);
    let sweep = &case.analyses[0].settings::<ParameterThresholds>().unwrap().sweep;
    assert_eq!((sweep.points, sweep.path.as_str()), (400, "parameters.mu"));
    sweep.set(&mut values, 0.75);
    let matrices = case.matrices(&values).unwrap();
    assert_eq!(matrices.mass, [[1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(matrices.damping, [[0.02, 0.0], [0.0, 0.01]]);
    assert_eq!(matrices.stiffness, [[2.0, 0.0], [1.0, 2.4]]);
    let map = case.analyses[1].settings::<StabilityMapAnalysis<ParameterKey>>().unwrap();
    assert_eq!((map.x.key.index(), map.y.key.index()), (0, 1));
}

#[test]
fn an_entry_that_is_not_finite_is_named_with_its_point() {
    let case = two_degrees(&HOPF.replace("[0, \"c2\"]", "[0, \"1/(mu - 1)\"]"), &[]);
    assert!(case.matrices(&case.values()).is_ok());
    let error = case.matrices(&[1.0, 0.0, 0.25]).unwrap_err();
    assert!(matches!(error, Cause::NotFiniteEntry { matrix: "damping", row: 1, column: 1, .. }));
    assert_eq!(error.to_string(), "damping[1][1] is inf, at mu = 1");
    assert!(case.matrices(&[]).is_err());
}

#[test]
fn what_an_analysis_varies_is_left_to_the_run() {
    let text = HOPF
        .replace("\"c2\"]", "\"1/(mu - 0.5)\"]")
        .replace("[matrices]", "[matrices]\nmass = [[\"mu - 0.5\", 0], [0, 1]]");
    let case = two_degrees(&text, &[]);
    let error = case.matrices(&case.values()).unwrap_err();
    assert_eq!(error.to_string(), "damping[1][1] is inf, at mu = 0.5");
    assert!(case.matrices(&[1.0, 0.0, 0.25]).is_ok());
}

#[test]
fn the_resolved_case_keeps_the_expressions() {
    let json = parse(HOPF, &[]).unwrap().resolved();
    assert_eq!(json["matrices"]["stiffness"][0][1], "1 - 4*mu/3");
    assert_eq!(json["matrices"]["mass"], serde_json::json!([["1", "0"], ["0", "1"]]));
    assert_eq!(json["parameters"], serde_json::json!([["mu", 0.5], ["c2", 0.002], ["angle", 0.25]]));
    assert_eq!(json["analysis"][0]["sweep"]["points"], 400);
}
