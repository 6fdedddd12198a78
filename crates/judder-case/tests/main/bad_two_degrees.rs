//! Two-degrees cases that are refused.

use crate::refused;

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
        "keys here: title, model, parameters, matrices, analysis",
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
