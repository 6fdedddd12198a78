//! Keys and values of sweeps of the whole case that are refused, when the case is read and at a point.

use super::bad_study_sweep::{OVER, QUANTITIES, over, sweep};
use super::study_sweep::oscillator;
use super::{help_of, with_file};

#[test]
fn ranges_that_cannot_be() {
    let entry = "key = \"contact.shear_strength\", from = 0, to = 1, points = 5, scale = \"log\"";
    over(
        "grid",
        entry,
        "a logarithmic range cannot touch or pass zero: 0.0 to 1.0",
        &format!("{{ {entry} }}"),
        r#"let both ends have one sign, or use scale = "linear""#,
    );
    let entry = "key = \"contact.shear_strength\", from = 0.5, to = 0.5";
    over(
        "sobol",
        entry,
        "the range is empty: from and to are both 0.5",
        &format!("{{ {entry} }}"),
        "let `from` and `to` differ",
    );
    over(
        "sobol",
        "key = \"operation.velocity\", from = \"1 mm/s\", to = 3",
        "`over.from` is a speed, but `over.to` is a plain number",
        "3",
        "give both in units of the key that varies",
    );
    over(
        "sobol",
        "key = \"operation.velocity\", from = \"1 mm/s\", to = \"3 furlong/s\"",
        "`over.to` is not a quantity: unknown unit `furlong`",
        "furlong",
        "write a plain number, or a number with a unit in quotes: \"10 mm\"",
    );
}

#[test]
fn keys_that_cannot_be_swept() {
    let advice = "give the dotted path of a number of the case: operation.velocity, structure.NAME.width, analysis.NAME.tolerance";
    for key in ["", "operation.", "title", "model", "sweep.robustness.points", "a.b.c.d.e.f.g.h.i"] {
        let entry = format!("key = '{key}', from = 0, to = 1, points = 3");
        let place = if key.is_empty() { "" } else { key };
        over("grid", &entry, &format!("`{key}` cannot be swept"), place, advice);
    }
    let keys = |key: &str, message: &str, help: &str| {
        over("grid", &format!("key = \"{key}\", from = 0.1, to = 1, points = 3"), message, key, help);
    };
    keys(
        "operation.velocty",
        "`operation.velocty` cannot be swept: unknown key `velocty` in [operation]",
        "did you mean `velocity`? keys here: velocity, normal_load",
    );
    keys(
        "oscilator.damping_x",
        "`oscilator.damping_x` cannot be swept: unknown key `oscilator` in an oscillator case",
        "did you mean `oscillator`? keys here: title, model, substrate, indenter, contact, oscillator, operation, analysis, sweep",
    );
    keys(
        "analysis.cyle.tolerance",
        "`analysis.cyle.tolerance` cannot be swept: unknown key `cyle` in `analysis`",
        "did you mean `cycle`? keys here: cycle",
    );
    keys(
        "analysis.cycle.kind.x",
        "`analysis.cycle.kind.x` cannot be swept: `kind` is a string, but must be a table",
        "sweep a number of the case",
    );
}

#[test]
fn values_that_the_case_cannot_have() {
    let entry = "key = \"operation.velocity\", from = 0.1, to = -0.1, points = 2";
    over(
        "grid",
        entry,
        "with `operation.velocity` = -0.1: `operation.velocity` must be positive, but is -0.1",
        &format!("{{ {entry} }}"),
        "sweep values that the key can take",
    );
    let entry = "key = \"operation.velocity\", from = \"1 mm\", to = \"2 mm\"";
    over(
        "sobol",
        entry,
        "with `operation.velocity` = 0.001 m: `operation.velocity` must be a speed, but this is a length",
        &format!("{{ {entry} }}"),
        "write a speed, such as \"30 mm/s\", or a plain number: v_d τ/R",
    );
    let entry = "key = \"substrate.glassy_modulus\", values = [\"20 MPa\", \"0.1 MPa\", \"30 MPa\"]";
    over(
        "list",
        entry,
        "with `substrate.glassy_modulus` = 100000 Pa: the glassy modulus 1e5 Pa is not above the rubbery modulus 1e6 Pa",
        &format!("{{ {entry} }}"),
        "E∞ must be above E0; only the law \"hertz\" takes E∞ = E0",
    );
    let entry = "key = \"contact.law\", from = 0, to = 1, points = 3";
    over(
        "grid",
        entry,
        "with `contact.law` = 0: `contact.law` is an integer, but must be a string",
        &format!("{{ {entry} }}"),
        "sweep values that the key can take",
    );
    let entry = "key = \"analysis.cycle.steps\", from = 1000, to = 2000";
    let error = super::parse(
        &oscillator(&format!("method = \"sobol\"\npoints = 4\nover = [{{ {entry} }}]\n{QUANTITIES}")),
        &[],
    )
    .unwrap_err();
    let message = error.to_string();
    assert!(message.ends_with("`steps` is a number, but must be an integer"), "{message}");
}

/// The last value of one key is to blame, though every other stands at its first.
#[test]
fn the_key_to_blame_is_named() {
    let second = r#"{ key = "oscillator.damping_x", from = 0.1, to = -0.1, points = 2 }"#;
    sweep(
        &format!(
            "over = [{{ key = \"operation.velocity\", from = 0.1, to = 1, points = 2 }}, {second}]\n{QUANTITIES}"
        ),
        "with `oscillator.damping_x` = -0.1: `oscillator.damping_x` must be zero or positive, but is -0.1",
        second,
        "sweep values that the key can take",
    );
}

/// Points that were not tried when the case was read.
#[test]
fn a_point_that_cannot_be() {
    let file = with_file(&oscillator(&format!("{OVER}{QUANTITIES}")));
    let error = file.at(&file.sweeps[0], &[-1.0]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "with `operation.velocity` = -1: `operation.velocity` must be positive, but is -1.0"
    );
    assert_eq!(error.place(), "{ key = \"operation.velocity\", from = 1e-4, to = 1e-2, points = 3 }");
    let dotted = oscillator(&format!("{OVER}{QUANTITIES}")).replace("\"robustness\"", "\"v1.2\"");
    let dotted = with_file(&dotted);
    let error = dotted.at(&dotted.sweeps[0], &[-1.0]).unwrap_err();
    assert_eq!(error.place(), "{ key = \"operation.velocity\", from = 1e-4, to = 1e-2, points = 3 }");
    let error = file.at(&file.sweeps[0], &[]).unwrap_err();
    assert_eq!(error.to_string(), "a point of the sweep `robustness` has 1 values, but 0 are given");
    let error = file.at(&file.sweeps[0], &[f64::NAN]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "with `operation.velocity` = NaN: `operation.velocity` is not a finite number"
    );
}

/// A parameter that the case does not have stands in no expression: whatever varies it gets the same case over and over.
#[test]
fn parameters_that_the_case_does_not_have() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/assembly/lumped-brake.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let nope = "key = \"parameters.nope\", from = 0.0, to = 1.0, points = 3";
    let region = "region = { re = [-500.0, 500.0], im = [1.0, 1000.0] }";
    let friction = "key = \"contact.linear.friction_coefficient\", from = 0.1, to = 0.4, points = 3";
    for added in [
        format!("[[analysis]]\nname = \"own\"\nkind = \"bifurcation\"\nsweep = {{ {nope} }}"),
        format!("[[analysis]]\nname = \"own\"\nkind = \"eigen-sweep\"\nsweep = {{ {nope} }}\n{region}"),
        format!(
            "[[analysis]]\nname = \"own\"\nkind = \"stability-map\"\nx = {{ {nope} }}\ny = {{ {friction} }}\n{region}"
        ),
        format!(
            "[[analysis]]\nname = \"own\"\nkind = \"squeal\"\nband = [\"40 Hz\", \"120 Hz\"]\nmargin = {{ {nope} }}"
        ),
        format!("[[sweep]]\nname = \"own\"\nover = [{{ {nope} }}]\nquantities = [\"modes.unstable\"]"),
    ] {
        let error = judder_models::parse("case.toml", &format!("{text}\n{added}\n"), &[]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "`parameters.nope` cannot be swept: unknown parameter `parameters.nope`",
            "{added}"
        );
        assert!(help_of(&error).contains("known: parameters.eta"), "{added}: {}", help_of(&error));
    }
    let near = text.replace("key = \"parameters.eta\"", "key = \"parameters.etta\"");
    let error = judder_models::parse("case.toml", &near, &[]).unwrap_err();
    assert!(help_of(&error).starts_with("did you mean `parameters.eta`?"), "{}", help_of(&error));
    // keys that the case leaves out for their defaults can be varied as before
    let own = text.replace("key = \"parameters.eta\"", "key = \"contact.stiffening.friction_coefficient\"");
    judder_models::parse("case.toml", &own, &[]).unwrap();
}
