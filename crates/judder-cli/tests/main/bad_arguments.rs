//! Command lines that are refused.

use crate::desk::{CASE, Desk};

fn refused(arguments: &[&str], message: &str, help: &str) {
    Desk::with_case(CASE).refused(arguments, message, help);
}

#[test]
fn an_unknown_command_is_told_its_neighbour() {
    refused(&["rnu"], "there is no command `rnu`", "did you mean `run`?");
    refused(&["reprodcue"], "there is no command `reprodcue`", "did you mean `reproduce`?");
    refused(
        &["sing"],
        "there is no command `sing`",
        "commands: demo, examples, new, check, run, merge, point, report, verify, reproduce, schema, completions, explore",
    );
}

#[test]
fn words_and_options() {
    refused(&["new", "oscilator"], "there is no template `oscilator`", "did you mean `oscillator`?");
    refused(&["reproduce", "oscilator-paper"], "invalid value 'oscilator-paper'", "'oscillator-paper'");
    refused(&["run", "case.toml", "--frsh"], "unexpected argument '--frsh' found", "'--fresh'");
    refused(&["run"], "required arguments were not provided", "Usage: judder run");
    refused(&["run", "case.toml", "-q", "-v"], "cannot be used with", "Usage: judder run");
}

#[test]
fn numbers_of_threads() {
    for threads in ["0", "-1", "two", "1000000"] {
        let option = format!("--threads={threads}");
        refused(&["run", "case.toml", "--threads", threads], &format!("invalid value '{threads}'"), "");
        refused(&["run", "case.toml", &option], &format!("invalid value '{threads}'"), "from 1 to 4096");
    }
}

#[test]
fn an_analysis_that_the_case_does_not_have() {
    refused(
        &["run", "case.toml", "--only", "mapp"],
        "no analysis or sweep `mapp`",
        "it has map, loci, damping, strengths, loads",
    );
    Desk::with_case("model = \"oscillator\"").refused(
        &["run", "case.toml", "--only", "map"],
        "no analysis or sweep `map`",
        "none at all",
    );
}

#[test]
fn point_is_for_oscillators() {
    let case = "model = \"two-degrees\"\n[matrices]\nstiffness = [[2, 0], [0, 1]]";
    let message = "`judder point` takes an oscillator case; this one is of model `two-degrees`";
    Desk::with_case(case).refused(
        &["point", "case.toml"],
        message,
        "`judder check` and `judder run` take it",
    );
}

#[test]
fn errors_are_documents_too() {
    let desk = Desk::new();
    for arguments in
        [&["--json"][..], &["rnu", "--json"], &["run", "--json"], &["explore", "no.toml", "--json"]]
    {
        let said = desk.judder(arguments);
        assert_eq!(said.code, 2, "{arguments:?}");
        let error = said.json()["error"].clone();
        assert!(error["message"].is_string() && error["help"].is_string(), "{arguments:?}: {error}");
        assert!(error["place"].is_null());
    }
}

#[test]
fn help_and_version_are_documents_too() {
    let desk = Desk::new();
    let help = desk.succeed(&["run", "--help", "--json"]).json();
    assert!(help["help"].as_str().unwrap().contains("Usage: judder run"));
    let version = desk.succeed(&["--json", "--version"]).json();
    assert!(version["version"].as_str().unwrap().starts_with("judder "));
}
