//! Two-degrees cases that are refused.

use super::{refused, refused_with};

fn case(parameters: &str, stiffness: &str, rest: &str) -> String {
    format!(
        "model = \"two-degrees\"\n[parameters]\n{parameters}\n[matrices]\nstiffness = {stiffness}\n{rest}\n"
    )
}

fn stiffness(entries: &str) -> String {
    case("mu = 0.5", entries, "")
}

fn parameter(setting: &str) -> String {
    case(setting, "[[2, 1], [1, 2]]", "")
}

fn rest(rest: &str) -> String {
    case("mu = 0.5", "[[2, 1], [1, 2]]", rest)
}

#[test]
fn no_matrices() {
    refused(
        "model = \"two-degrees\"\n",
        "a two-degrees case lacks the key `matrices`",
        "",
        "give [matrices] with stiffness = [[…, …], […, …]]",
    );
}

#[test]
fn no_stiffness() {
    refused(
        r#"model = "two-degrees"
[matrices]
mass = [[1, 0], [0, 1]]
"#,
        "[matrices] lacks the key `stiffness`",
        "[matrices]",
        r#"give stiffness = [["2", "1 - mu"], [1, 2]]"#,
    );
}

#[test]
fn a_section_of_the_oscillator() {
    refused(
        &rest(
            r#"[operation]
velocity = 1"#,
        ),
        "unknown key `operation` in a two-degrees case",
        "operation",
        "keys here: title, model, parameters, matrices, analysis, sweep",
    );
}

#[test]
fn an_unknown_symbol() {
    refused(
        &stiffness(r#"[[2, "1 - 4*nu/3"], [1, 2]]"#),
        "unknown symbol `nu`",
        "nu",
        "did you mean `mu`? known symbols: mu, pi; functions: sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs",
    );
}

#[test]
fn an_unfinished_expression() {
    refused(
        &stiffness(r#"[[2, "1 - "], [1, 2]]"#),
        "a number, a name or `(` is missing",
        "",
        r#"as in "1 - 4*mu/3": + - * / ^ ( ), pi, sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs"#,
    );
}

#[test]
fn a_matrix_of_three_columns() {
    refused(
        &stiffness("[[2, 1, 0], [1, 2, 0]]"),
        "`matrices.stiffness` must be two rows of two entries",
        "[2, 1, 0]",
        r#"as in [["2", "1 - mu"], [1, 2]]"#,
    );
}

#[test]
fn a_matrix_that_is_no_list() {
    refused(&stiffness("2"), "`matrices.stiffness` is an integer, but must be a list", "2", "");
}

#[test]
fn an_entry_of_the_wrong_type() {
    refused(
        &stiffness("[[2, true], [1, 2]]"),
        "`matrices.stiffness` is a boolean, but must be a number or an expression in quotes",
        "true",
        "",
    );
}

#[test]
fn an_entry_that_is_not_finite() {
    refused(
        &stiffness("[[2, nan], [1, 2]]"),
        "`matrices.stiffness` is not a finite number",
        "nan",
        "nan, inf and numbers beyond 1e308 are not values of a case",
    );
}

#[test]
fn a_parameter_with_a_unit() {
    refused(
        &parameter(r#"mu = "1 N""#),
        "`parameters.mu` is a string, but must be a plain number",
        r#""1 N""#,
        "",
    );
}

#[test]
fn a_parameter_that_is_not_finite() {
    refused(
        &parameter("mu = inf"),
        "`parameters.mu` is not a finite number",
        "inf",
        "nan, inf and numbers beyond 1e308 are not values of a case",
    );
}

#[test]
fn a_parameter_called_like_a_function() {
    refused(
        &parameter("sin = 0.5"),
        "`sin` cannot name a parameter",
        "sin",
        "a letter, then letters, digits or _; functions and pi are taken",
    );
}

#[test]
fn a_sweep_of_an_unknown_parameter() {
    refused(
        &rest(
            r#"[[analysis]]
kind = "spectrum"
sweep = { key = "parameters.nu", from = 0, to = 1, points = 5 }"#,
        ),
        "unknown swept key `parameters.nu`",
        "parameters.nu",
        "did you mean `parameters.mu`? known: parameters.mu",
    );
}

#[test]
fn a_kind_of_the_oscillator() {
    refused(
        &rest(
            r#"[[analysis]]
kind = "critical-load""#,
        ),
        "the analysis kind `critical-load` belongs to another model",
        "critical-load",
        "available: spectrum, stability-map, critical",
    );
}

const FINITE: &str =
    "an entry must be finite: mind division by zero, roots and logarithms of negative numbers";

#[test]
fn a_constant_entry_that_is_infinite() {
    refused(&stiffness(r#"[[2, 1], [1, "1/0"]]"#), "stiffness[1][1] is inf", "1/0", FINITE);
}

#[test]
fn a_constant_entry_that_is_no_number() {
    let damping = stiffness("[[2, 1], [1, 2]]").replace("stiffness", "damping");
    refused(
        &format!("{}stiffness = [[2, 1], [1, 2]]\n", damping.replace("[[2, 1]", "[[\"sqrt(-1)\", 1]")),
        "damping[0][0] is NaN",
        "sqrt(-1)",
        FINITE,
    );
}

#[test]
fn an_option_that_makes_an_entry_infinite() {
    refused_with(
        &stiffness("[[2, 1], [1, 2]]"),
        &[r#"matrices.stiffness=[[2, 1], ["1/0", 2]]"#],
        "stiffness[1][0] is inf",
        "--set 1/0",
        FINITE,
    );
}

#[test]
fn an_entry_that_is_not_finite_at_the_parameters_of_the_case() {
    let text = case(
        "mu = 1\nnu = 2\nkappa = 3",
        r#"[["nu", "kappa/(mu - 1)"], [1, 2]]"#,
        r#"[[analysis]]
kind = "spectrum"
sweep = { key = "nu", from = 0, to = 1, points = 5 }"#,
    );
    refused(&text, "stiffness[0][1] is inf, at mu = 1, kappa = 3", "kappa/(mu - 1)", FINITE);
}

fn mass_refused(mass: &str, message: &str, help: &str) {
    let text = stiffness(&format!("[[2, 1], [1, 2]]\nmass = {mass}"));
    refused(&text, message, mass, help);
}

#[test]
fn a_singular_mass() {
    let help = "mass[0][0] and the determinant must be positive, as in [[2, 1], [1, 2]]";
    mass_refused("[[1, 1], [1, 1]]", "the mass matrix [[1.0, 1.0], [1.0, 1.0]] is singular", help);
    // no analysis varies mu
    mass_refused(
        r#"[[1, 0], [0, "mu - 0.5"]]"#,
        "the mass matrix [[1.0, 0.0], [0.0, 0.0]] is singular",
        help,
    );
}

#[test]
fn a_mass_that_is_not_positive_definite() {
    mass_refused(
        r#"[["-1", 0], [0, 1]]"#,
        "the mass matrix [[-1.0, 0.0], [0.0, 1.0]] is not positive definite",
        "mass[0][0] and the determinant must be positive, as in [[2, 1], [1, 2]]",
    );
}

#[test]
fn a_mass_that_is_not_symmetric() {
    mass_refused(
        "[[1, 0.5], [0, 1]]",
        "the mass matrix [[1.0, 0.5], [0.0, 1.0]] is not symmetric",
        "let mass[0][1] and mass[1][0] be equal, as in [[2, 1], [1, 2]]",
    );
}
