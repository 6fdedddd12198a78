//! Texts and options that are refused before any section is read.

use std::fs;

use super::{help_of, refused, refused_with};
use judder_keys::cause::Cause;
use miette::Diagnostic;

#[test]
fn an_empty_text() {
    refused(
        "# only a comment\n",
        "`case.toml` is empty",
        "",
        "`judder new` prints a case file to start from",
    );
}

#[test]
fn a_text_that_is_not_toml() {
    refused(
        r#"model = "oscillator"
[operation]
velocity = 30 mm/s
"#,
        "this is not TOML: string values must be quoted, expected literal string",
        "30 mm/s",
        r#"text and quantities stand in quotes: velocity = "30 mm/s""#,
    );
}

#[test]
fn a_key_given_twice() {
    refused(
        r#"model = "oscillator"
title = "a"
title = "b"
"#,
        "this is not TOML: duplicate key",
        "title",
        "",
    );
}

#[test]
fn no_model() {
    refused(
        "title = \"x\"\n",
        "the case lacks the key `model`",
        "",
        r#"give model = "oscillator" or model = "contact" or model = "belt" or model = "two-degrees" or model = "structure" or model = "sliding" or model = "assembly""#,
    );
}

#[test]
fn an_unknown_model() {
    refused(
        "model = \"oscilator\"\n",
        "unknown model `oscilator`",
        "oscilator",
        "did you mean `oscillator`? known: oscillator, contact, belt, two-degrees, structure, sliding, assembly",
    );
}

#[test]
fn an_option_without_a_value() {
    refused_with(
        "model = \"oscillator\"\n",
        &["operation.velocity"],
        "`--set operation.velocity` is not of the form key=value",
        "--set operation.velocity",
        r#"write the dotted key, `=`, the value: --set "operation.velocity=30 mm/s""#,
    );
}

#[test]
fn an_option_with_an_empty_step() {
    refused_with(
        "model = \"oscillator\"\n",
        &["operation..velocity=1"],
        "`--set operation..velocity=1` is not of the form key=value",
        "--set operation..velocity=1",
        r#"write the dotted key, `=`, the value: --set "operation.velocity=30 mm/s""#,
    );
}

#[test]
fn an_option_of_an_unknown_key() {
    refused_with(
        "model = \"oscillator\"\n",
        &["operation.velocty=30 mm/s"],
        "unknown key `velocty` in [operation]",
        "--set velocty",
        "did you mean `velocity`? keys here: velocity, normal_load",
    );
}

#[test]
fn an_option_with_a_wrong_unit() {
    refused_with(
        "model = \"oscillator\"\n",
        &["title=x", "operation.velocity = 30 N"],
        "`operation.velocity` must be a speed, but this is a force",
        "--set 30 N",
        r#"write a speed, such as "30 mm/s", or a plain number: v_d τ/R"#,
    );
}

#[test]
fn an_option_below_a_value() {
    refused_with(
        "model = \"oscillator\"\n",
        &["model.name=1"],
        "`model` is a string, but must be a table",
        "--set name",
        "",
    );
}

#[test]
fn an_option_that_is_not_a_number() {
    refused_with(
        "model = \"oscillator\"\n",
        &["operation.velocity=nan"],
        "`operation.velocity` is not a finite number",
        "--set nan",
        "nan, inf and numbers beyond 1e308 are not values of a case",
    );
}

fn read_error(path: &std::path::Path) -> judder_keys::error::CaseError {
    judder_models::read(path, &[]).expect_err("the file must be refused")
}

#[test]
fn a_file_that_does_not_exist() {
    let folder = tempfile::tempdir().unwrap();
    let error = read_error(&folder.path().join("none.toml"));
    assert!(matches!(error.cause(), Cause::Missing { path } if path.ends_with("none.toml")));
    assert!(error.to_string().starts_with("there is no file `"));
    assert_eq!(help_of(&error), "`judder new` prints a case file to start from");
}

#[test]
fn a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let error = read_error(folder.path());
    assert!(matches!(error.cause(), Cause::Folder { .. }));
    assert!(error.to_string().ends_with("is a folder, not a case file"));
}

#[test]
fn a_path_through_a_file() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("file"), "x").unwrap();
    let error = read_error(&folder.path().join("file/case.toml"));
    assert!(matches!(error.cause(), Cause::Unreadable { .. }));
    assert!(std::error::Error::source(&error).is_some());
}

#[test]
fn a_binary_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    fs::write(&path, b"model = \"\xff\xfe\0\"").unwrap();
    let error = read_error(&path);
    assert!(matches!(error.cause(), Cause::Binary { offset: 9, .. }));
    assert!(error.to_string().ends_with("is not a text file: the byte at offset 9 is not UTF-8"));
}

#[cfg(unix)]
#[test]
fn a_device() {
    let error = read_error("/dev/zero".as_ref());
    assert!(matches!(error.cause(), Cause::NotAFile { .. }));
    assert_eq!(error.to_string(), "`/dev/zero` is a device, pipe or socket, not a case file");
    assert_eq!(help_of(&error), "`judder new` prints a case file to start from");
}

#[cfg(unix)]
#[test]
fn a_socket() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    let _socket = std::os::unix::net::UnixListener::bind(&path).unwrap();
    assert!(matches!(read_error(&path).cause(), Cause::NotAFile { .. }));
}

#[cfg(unix)]
#[test]
fn a_pipe() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    let made = std::process::Command::new("mkfifo").arg(&path).status().unwrap();
    assert!(made.success());
    assert!(matches!(read_error(&path).cause(), Cause::NotAFile { .. }));
}

#[test]
fn a_file_of_the_size_limit_and_one_beyond() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    let text = "model = \"oscillator\"\n#";
    fs::write(&path, format!("{text}{}", "x".repeat((1 << 20) - text.len()))).unwrap();
    assert!(judder_models::read(&path, &[]).is_ok());
    fs::write(&path, "#".repeat((1 << 20) + 1)).unwrap();
    let error = read_error(&path);
    assert!(matches!(error.cause(), Cause::TooLong { size: 1_048_577, limit: 1_048_576, .. }));
    assert!(error.to_string().ends_with("has 1048577 bytes, but a case file has at most 1048576 (1 MiB)"));
}

#[test]
fn an_overlong_line_is_not_quoted_whole() {
    let text = format!("model = \"{}\"\n", "x".repeat(1 << 19));
    let error = judder_models::parse("case.toml", &text, &[]).expect_err("an unknown model");
    assert!(error.to_string().ends_with("xxx…") && error.to_string().len() < 2100);
    let label = error.labels().unwrap().next().unwrap();
    let quoted = error.source_code().unwrap().read_span(label.inner(), 1, 1).unwrap();
    assert!(quoted.data().starts_with(b"model = \"xxx") && quoted.data().len() < 5000);
    assert_eq!((quoted.name(), quoted.line()), (Some("case.toml"), 0));
}
