//! Streams: who says what where, and with which colours.

use std::process::Stdio;

use crate::desk::{CASE, Desk, Said};

#[test]
fn alone_it_prints_help() {
    let desk = Desk::new();
    let help = desk.succeed(&[]).stdout;
    for command in ["new", "check", "run", "point", "report", "reproduce", "schema"] {
        assert!(help.contains(&format!("\n  {command} ")), "{command} is not in\n{help}");
        let own = desk.succeed(&[command, "--help"]).stdout;
        assert!(own.contains("Example"), "{own}");
    }
    assert!(help.contains("Exit codes:"));
    assert!(desk.succeed(&["--version"]).stdout.starts_with("judder "));
}

#[test]
fn quiet_says_nothing() {
    let desk = Desk::with_case(CASE);
    let said = desk.succeed(&["run", "case.toml", "-q"]);
    assert_eq!((said.stdout.as_str(), said.stderr.as_str()), ("", ""));
    let said = desk.succeed(&["report", "out/case", "--quiet"]);
    assert_eq!((said.stdout.as_str(), said.stderr.as_str()), ("", ""));
    assert!(!desk.succeed(&["point", "case.toml", "-q"]).stdout.is_empty());
    desk.refused(&["-q", "run", "missing.toml"], "there is no file", "judder new");
}

#[test]
fn verbose_says_more() {
    let desk = Desk::with_case(CASE);
    let said = desk.succeed(&["run", "case.toml"]);
    assert_eq!(said.stdout, "");
    said.says("report: out/case/report.html");
    assert!(!said.stderr.contains("loci: 11 of 11 steps"));
    let said = desk.succeed(&["run", "case.toml", "--fresh", "-v"]);
    said.says("loci: 11 of 11 steps in ");
    said.says("wall time: ");
    assert!(!said.stderr.contains("folder: "));
    desk.succeed(&["run", "case.toml", "-vv"]).says("folder: out/case");
}

#[test]
fn documents_stand_alone() {
    let desk = Desk::with_case(CASE);
    let summary = desk.succeed(&["run", "case.toml", "--json", "-vv"]).json();
    assert_eq!(summary, desk.read_json("out/case/summary.json"));
    let report = desk.succeed(&["--json", "report", "out/case"]).json();
    assert_eq!(report, serde_json::json!({ "report": "out/case/report.html" }));
}

#[test]
fn progress_is_lines_of_json_where_asked_for() {
    let desk = Desk::with_case(CASE);
    let said = desk.succeed(&["run", "case.toml", "--progress", "json"]);
    let lines: Vec<serde_json::Value> =
        said.stderr.lines().map(|line| serde_json::from_str(line).expect(line)).collect();
    let of = |event: &str, name: &str| {
        lines.iter().position(|line| line["event"] == event && line["name"] == name).unwrap()
    };
    assert!(of("begin", "loci") < of("end", "loci"));
    assert_eq!(
        (&lines[of("end", "loci")]["done"], &lines[of("end", "loci")]["steps"]),
        (&11.into(), &11.into())
    );
    let message = &lines.last().unwrap()["text"];
    assert!(message.as_str().unwrap().ends_with("report: out/case/report.html"), "{message}");
    let said = desk.succeed(&["run", "case.toml", "--fresh", "--progress", "none", "-q"]);
    assert_eq!(said.stderr, "");
}

#[test]
fn errors_are_lines_of_json_too() {
    let desk = Desk::new();
    for arguments in [&["run"][..], &["run", "--threads", "x", "a.toml"], &["frob"], &["check", "nope.toml"]]
    {
        for form in [&["--progress", "json"][..], &["--progress=json"]] {
            let mut command = desk.command(&[form, arguments].concat());
            let said = Said::of(command.env("CLICOLOR_FORCE", "1").output().unwrap());
            assert_eq!(said.code, 2, "{}", said.stderr);
            let line: serde_json::Value = serde_json::from_str(said.stderr.trim_end()).expect(&said.stderr);
            let text = line["text"].as_str().unwrap();
            assert!(text.contains('×') && !text.contains('\u{1b}'), "{line}");
        }
    }
}

#[test]
fn control_characters_of_a_case_do_not_reach_the_terminal() {
    let desk = Desk::with_case("model = \"oscillator\"\ntitle = \"a\\u001b[2Jb\\u0000c\\u009b2J\"\n");
    let told = desk.succeed(&["check", "case.toml"]).stdout;
    assert!(told.starts_with("a\\u{1b}[2Jb\\u{0}c\\u{9b}2J\n"), "{told:?}");
    let mut command = desk.command(&["check", "\u{1b}[2J.toml"]);
    let said = Said::of(command.env("CLICOLOR_FORCE", "1").output().unwrap());
    said.says("there is no file `\\u{1b}[2J.toml`");
    assert!(said.stderr.contains("\u{1b}["), "colours stay");
}

#[test]
fn colours_are_asked_for() {
    let desk = Desk::new();
    let coloured = |variables: &[(&str, &str)]| {
        let mut command = desk.command(&["run", "missing.toml"]);
        command.envs(variables.iter().copied());
        Said::of(command.output().unwrap()).stderr.contains('\u{1b}')
    };
    assert!(!coloured(&[]), "no terminal, no colours");
    assert!(coloured(&[("CLICOLOR_FORCE", "1")]));
    assert!(!coloured(&[("NO_COLOR", "1")]));
    assert!(!coloured(&[("CLICOLOR", "0")]));
}

#[test]
fn a_reader_that_has_gone_is_no_failure() {
    let desk = Desk::with_case(CASE);
    for arguments in [&["schema"][..], &["new"], &["point", "case.toml", "--json"], &["--help"], &[]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = desk.command(arguments);
        let said = Said::of(command.stdout(writer).stderr(Stdio::piped()).output().unwrap());
        assert_eq!((said.code, said.stderr.as_str()), (0, ""), "{arguments:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_result_that_cannot_be_written_is_missing() {
    let desk = Desk::with_case(CASE);
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    for arguments in [&["schema"][..], &["--help"], &["run", "--help"], &["--version"], &[]] {
        let full = full.try_clone().unwrap();
        let said = Said::of(desk.command(arguments).stdout(full).output().unwrap());
        assert_eq!(said.code, 1, "{arguments:?}");
        said.says("standard output could not be written: No space left on device");
    }
}
