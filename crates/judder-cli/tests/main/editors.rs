//! `new`, `schema`, `completions`, `check`.

use crate::desk::{CASE, Desk};

#[test]
fn every_template_is_checked_and_runs() {
    for template in ["oscillator", "two-degrees"] {
        let desk = Desk::new();
        let text = desk.succeed(&["new", template]).stdout;
        assert_eq!(desk.succeed(&["new", template, "--json"]).json()["text"], text.as_str());
        desk.write("case.toml", text);
        assert!(!desk.succeed(&["check", "case.toml"]).stdout.is_empty());
        desk.succeed(&["run", "case.toml"]);
        assert!(desk.path("out/case/report.html").is_file(), "{template}");
    }
    // the laws of this one take seconds
    let desk = Desk::new();
    desk.write("case.toml", desk.succeed(&["new", "contact"]).stdout);
    let shown = desk.succeed(&["check", "case.toml"]).stdout;
    for words in ["A paraboloid on rubber", "E∞/E0", "collapse, 51 × 16 points", "cells", " MB"] {
        assert!(shown.contains(words), "{words:?} is not in\n{shown}");
    }
    desk.succeed(&["run", "case.toml", "--only", "modulus"]);
}

#[test]
fn the_first_template_is_the_oscillator() {
    let desk = Desk::new();
    assert_eq!(desk.succeed(&["new"]).stdout, desk.succeed(&["new", "oscillator"]).stdout);
}

#[test]
fn the_schema_is_json() {
    let desk = Desk::new();
    let schema = desk.succeed(&["schema"]).json();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    assert_eq!(desk.succeed(&["schema", "--json"]).json(), schema);
}

#[test]
fn every_shell_is_told_of_every_command() {
    let desk = Desk::new();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = desk.succeed(&["completions", shell]).stdout;
        assert!(script.contains("reproduce") && script.contains("only"), "{shell}");
        assert_eq!(desk.succeed(&["completions", shell, "--json"]).json()["script"], script.as_str());
    }
    desk.refused(&["completions", "tcsh"], "tcsh", "zsh");
}

#[test]
fn check_shows_the_case_and_runs_nothing() {
    let desk = Desk::with_case(CASE);
    let before = desk.files();
    let text = desk.succeed(&["check", "case.toml"]).stdout;
    for words in ["A small case", "operation.velocity", "critical load", "points"] {
        assert!(text.contains(words), "{words:?} is not in\n{text}");
    }
    let document = desk.succeed(&["check", "case.toml", "--json", "--set", "operation.velocity=2e-4"]).json();
    assert_eq!(document["point"]["groups"]["velocity"], 2e-4);
    for part in ["case", "groups", "estimate", "warnings"] {
        assert!(!document[part].is_null(), "{part}");
    }
    assert_eq!(desk.files(), before);
}
