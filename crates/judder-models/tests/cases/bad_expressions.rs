//! Expressions in the place of numbers of assemblies that are refused.

use super::bad_assembly::{BLOCK, spoilt};
use super::{help_of, parse, refused};

/// The block with a temperature and this friction coefficient.
fn with_friction(own: &str) -> String {
    let text = spoilt(BLOCK, "[[structure]]", "[parameters]\ntemperature = 20.0\n\n[[structure]]");
    let (before, after) = text.split_once("friction_coefficient = ").unwrap();
    let (_, after) = after.split_once('\n').unwrap();
    format!("{before}friction_coefficient = {own}\n{after}")
}

/// The block with a temperature and this Young's modulus.
fn with_modulus(own: &str) -> String {
    let text = with_friction("0.3");
    let (before, after) = text.split_once("youngs_modulus = ").unwrap();
    let (_, after) = after.split_once(", poisson").unwrap();
    format!("{before}youngs_modulus = {own}, poisson{after}")
}

#[test]
fn names_that_are_no_parameters() {
    let error = parse(&with_friction("\"0.45 - 4e-4*temprature\""), &[]).unwrap_err();
    assert_eq!((error.to_string().as_str(), error.place()), ("unknown symbol `temprature`", "temprature"));
    assert!(help_of(&error).starts_with("did you mean `temperature`?"), "{}", help_of(&error));
    let error = parse(&with_modulus("{ expression = \"210 - T\", unit = \"GPa\" }"), &[]).unwrap_err();
    assert_eq!((error.to_string().as_str(), error.place()), ("unknown symbol `T`", "T"));
}

#[test]
fn what_is_not_finite_or_out_of_range() {
    refused(
        &with_friction("\"0.1/(temperature - 20)\""),
        "`contact.sole.friction_coefficient` is inf, at temperature = 20",
        "0.1/(temperature - 20)",
        "a number must be finite: mind division by zero, roots and logarithms of negative numbers",
    );
    let error = parse(&with_friction("\"0.1 - temperature\""), &[]).unwrap_err();
    assert_eq!(
        (error.to_string().as_str(), error.place()),
        (
            "`contact.sole.friction_coefficient` must be zero or positive, but is -19.9",
            "\"0.1 - temperature\""
        )
    );
}

#[test]
fn units_of_another_dimension_or_none() {
    let told = |text: &str| {
        let error = parse(text, &[]).unwrap_err();
        (error.to_string(), error.place().to_owned())
    };
    let key = "structure.block.material.youngs_modulus";
    let of_unit =
        |unit: &str| told(&with_modulus(&format!("{{ expression = \"temperature\", unit = \"{unit}\" }}")));
    assert_eq!(
        of_unit("mm"),
        (format!("`{key}` must be a stress, but this is a length"), "\"mm\"".to_owned())
    );
    assert_eq!(of_unit("GPx"), (format!("`{key}` is not a stress: unknown unit `GPx`"), "GPx".to_owned()));
    let none = "{ expression = \"temperature\" }";
    assert_eq!(told(&with_modulus(none)).0, format!("`{key}` needs a unit: it has no dimensionless form"));
    let text = told(&with_modulus("\"210*temperature\"")).0;
    assert_eq!(text, format!("`{key}` is an expression without a unit"));
    // what names no parameter is a quantity, as ever
    assert!(told(&with_modulus("\"210*3\"")).0.starts_with(&format!("`{key}` is not a stress")));
    let friction = "{ expression = \"temperature\", unit = \"m\" }";
    assert!(told(&with_friction(friction)).0.contains("this is a length"));
    assert!(told(&with_modulus("{ expresion = \"temperature\", unit = \"GPa\" }")).0.contains("`expresion`"));
}

/// What is wrong with the parameters is told before what that makes of expressions.
#[test]
fn parameters_that_are_none() {
    let text = with_friction("\"temperature\"").replace("temperature = 20.0", "temperature = \"20 degC\"");
    let error = parse(&text, &[]).unwrap_err();
    assert!(error.to_string().contains("`parameters.temperature`"), "{error}");
}

/// A value of a sweep with which there is no case is told with the key that cannot be.
#[test]
fn values_of_a_parameter_without_a_case() {
    let sweep = "[[analysis]]\nname = \"own\"\nkind = \"eigen-sweep\"\nband = [\"1 kHz\", \"8 kHz\"]\nsweep = { key = \"parameters.temperature\", from = 0.0, to = 100.0, points = 3 }";
    let text = format!("{}\n{sweep}\n", with_friction("\"0.4 - 0.01*temperature\""));
    let error = parse(&text, &[]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "with `parameters.temperature` = 100: `contact.sole.friction_coefficient` must be zero or positive, but is -0.6"
    );
}
