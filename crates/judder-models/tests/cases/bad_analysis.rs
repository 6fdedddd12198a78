//! Analyses that are refused for their kind, keys or name.

use super::refused;

/// A sweep that is in order, beside which something else is wrong.
const SWEEP: &str =
    r#"sweep = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 21, scale = "log" }"#;

/// An oscillator case with one analysis of these settings.
pub(crate) fn analysis(kind: &str, settings: &str) -> String {
    format!("model = \"oscillator\"\n[[analysis]]\nkind = \"{kind}\"\n{settings}\n")
}

/// An oscillator case with one analysis: a sweep in order and another setting.
pub(crate) fn beside_sweep(kind: &str, setting: &str) -> String {
    analysis(kind, &format!("{SWEEP}\n{setting}"))
}

#[test]
fn a_table_in_place_of_the_list() {
    refused(
        r#"model = "oscillator"
[analysis]
kind = "spectrum"
"#,
        "`analysis` is a table, but must be a list, each item headed [[analysis]]",
        "[analysis]",
        "",
    );
}

#[test]
fn an_analysis_without_kind() {
    refused(
        r#"model = "oscillator"
[[analysis]]
name = "x"
"#,
        "this analysis lacks the key `kind`",
        "[[analysis]]",
        r#"give kind = "…", one of equivalent-damping, spectrum, critical-shear-strength, critical-load, stability-map, motion, limit-cycle, bifurcation, basin, engines"#,
    );
}

#[test]
fn an_unknown_kind() {
    refused(
        &analysis("stability_map", ""),
        "unknown analysis kind `stability_map`",
        "stability_map",
        "did you mean `stability-map`? known: equivalent-damping, spectrum, critical-shear-strength, critical-load, stability-map, motion, limit-cycle, bifurcation, basin, engines",
    );
}

#[test]
fn a_kind_of_another_model() {
    refused(
        &analysis("march", ""),
        "the analysis kind `march` belongs to another model",
        "march",
        "available: equivalent-damping, spectrum, critical-shear-strength, critical-load, stability-map, motion, limit-cycle, bifurcation, basin, engines",
    );
}

#[test]
fn a_missing_sweep() {
    refused(
        &analysis("spectrum", ""),
        "an analysis of kind `spectrum` lacks the key `sweep`",
        "[[analysis]]",
        "give sweep = { key = …, from = …, to = …, points = … }",
    );
}

#[test]
fn two_analyses_of_one_name() {
    refused(
        r#"model = "oscillator"
[[analysis]]
kind = "spectrum"
sweep = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 21, scale = "log" }
[[analysis]]
name = "Spectrum"
kind = "equivalent-damping"
sweep = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 21, scale = "log" }
"#,
        "there are two analyses named `Spectrum`",
        r#""Spectrum""#,
        "give each analysis a `name` of its own",
    );
}
