//! Ctrl-C, SIGTERM, SIGHUP.

#![cfg(unix)]

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::desk::{Desk, Said};

/// One analysis of a blink, then one of minutes that looks for Ctrl-C at every point.
const LONG: &str = r#"
model = "oscillator"

[[analysis]]
name = "blink"
kind = "equivalent-damping"
sweep = { key = "operation.velocity", from = 1e-5, to = 1e-2, points = 5, scale = "log" }

[[analysis]]
name = "long"
kind = "critical-load"
sweep = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 400000, scale = "log" }
"#;

/// A map of seconds, which looks for Ctrl-C only when it is decided.
const DEAF: &str = r#"
model = "oscillator"

[[analysis]]
name = "deaf"
kind = "stability-map"
x = { key = "operation.velocity", from = 1e-8, to = 1e2, points = 4000, scale = "log" }
y = { key = "oscillator.coupling", from = 0.5, to = 1.5, points = 2000 }
method = "every-point"
boundaries = false
"#;

fn start(desk: &Desk, arguments: &[&str]) -> Child {
    let mut command = desk.command(arguments);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn send(child: &Child, signal: &str) {
    let status = Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(status.success());
}

fn press_ctrl_c(child: &Child) {
    send(child, "-INT");
}

/// Waits until a file on the desk is there.
fn wait_for(desk: &Desk, file: &str) {
    let start = Instant::now();
    while !desk.path(file).exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "{file} did not come");
        sleep(Duration::from_millis(10));
    }
}

#[test]
fn the_first_ends_cleanly_and_keeps_what_is_done() {
    let desk = Desk::with_case(LONG);
    let child = start(&desk, &["run", "case.toml", "--json"]);
    wait_for(&desk, "out/case/summary.json");
    press_ctrl_c(&child);
    let said = Said::of(child.wait_with_output().unwrap());
    assert_eq!(said.code, 1, "{}", said.stderr);
    said.says("ending, and keeping what is done");
    said.says("× interrupted");
    said.says("help: what was done is kept, and the same command goes on from there");
    assert_eq!(said.json()["error"]["message"], "interrupted");

    let summary = desk.read_json("out/case/summary.json");
    assert_eq!(summary["analyses"]["blink"]["status"], "done");
    assert!(summary["analyses"]["long"].is_null());
    desk.succeed(&["run", "case.toml", "--only", "blink"]).says("done before: blink");
}

#[test]
fn the_second_ends_at_once() {
    let desk = Desk::with_case(DEAF);
    let child = start(&desk, &["run", "case.toml"]);
    wait_for(&desk, "out/case/.judder.lock");
    sleep(Duration::from_millis(200));
    press_ctrl_c(&child);
    sleep(Duration::from_millis(200));
    press_ctrl_c(&child);
    let said = Said::of(child.wait_with_output().unwrap());
    assert_eq!(said.code, 1);
    said.says("Ctrl-C once more ends at once");
    assert!(!said.stderr.contains("× interrupted"), "it waited: {}", said.stderr);
}

#[test]
fn terminate_and_hang_up_end_like_ctrl_c() {
    for signal in ["-TERM", "-HUP"] {
        let desk = Desk::with_case(LONG);
        let child = start(&desk, &["run", "case.toml", "--json"]);
        wait_for(&desk, "out/case/summary.json");
        send(&child, signal);
        let said = Said::of(child.wait_with_output().unwrap());
        said.says("ending, and keeping what is done; a second signal ends at once");
        assert_eq!(said.code, 1, "{signal}: {}", said.stderr);
        said.says("× interrupted");
        assert!(!said.stderr.contains("Ctrl-C"), "{}", said.stderr);
        assert_eq!(said.json()["error"]["message"], "interrupted");
        assert_eq!(desk.read_json("out/case/summary.json")["analyses"]["blink"]["status"], "done");
    }
}

/// Beside a run that holds the study and has stopped.
#[test]
fn what_is_waited_for_is_told() {
    let sweep = "[[sweep]]\nname = \"speeds\"\nquantities = [\"growth_rate\"]\nover = [{ key = \"operation.velocity\", \
        from = 1e-4, to = 1.0, points = 4, scale = \"log\" }]\n";
    let desk = Desk::with_case(&format!("{LONG}\n{sweep}"));
    let mut first = start(&desk, &["run", "case.toml", "-q"]);
    wait_for(&desk, "out/case/summary.json");
    send(&first, "-STOP");
    let mut second = start(&desk, &["run", "case.toml"]);
    let began = Instant::now();
    let mut line = String::new();
    BufReader::new(second.stderr.take().unwrap()).read_line(&mut line).unwrap();
    let held = format!("waiting for out/case/.judder.lock, held by process {}", first.id());
    assert!(line.contains(&held) && line.contains("this ends after 120 s"), "{line}");
    assert!(!line.contains(",;"), "{line}");
    assert!(began.elapsed() < Duration::from_secs(3), "{:?}", began.elapsed());
    send(&second, "-TERM");
    assert_eq!(second.wait().unwrap().code(), Some(1));
    // who does not wait is told too
    let said = desk.judder(&["report", "out/case"]);
    assert_eq!(said.code, 1);
    said.says(&format!("another judder (process {}", first.id()));
    first.kill().unwrap();
    first.wait().unwrap();
}

/// As below `nohup`: the terminal goes, the run stays.
#[cfg(target_os = "linux")]
#[test]
fn an_ignored_hang_up_stays_ignored() {
    let desk = Desk::with_case(LONG);
    let mut command = Command::new("sh");
    command.args(["-c", "trap '' HUP; exec \"$JUDDER\" run case.toml"]);
    command.env("JUDDER", env!("CARGO_BIN_EXE_judder")).current_dir(desk.path("."));
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    wait_for(&desk, "out/case/summary.json");
    send(&child, "-HUP");
    sleep(Duration::from_millis(1500));
    assert!(child.try_wait().unwrap().is_none(), "it has ended");
    send(&child, "-TERM");
    let said = Said::of(child.wait_with_output().unwrap());
    assert_eq!(said.code, 1, "{}", said.stderr);
}

#[test]
fn a_step_that_does_not_hear_is_ended() {
    let desk = Desk::with_case(DEAF);
    let child = start(&desk, &["run", "case.toml", "--json"]);
    wait_for(&desk, "out/case/.judder.lock");
    sleep(Duration::from_millis(200));
    press_ctrl_c(&child);
    let pressed = Instant::now();
    let said = Said::of(child.wait_with_output().unwrap());
    assert!(pressed.elapsed() < Duration::from_millis(2500), "{:?}", pressed.elapsed());
    assert_eq!(said.code, 1);
    assert_eq!(said.json()["error"]["message"], "interrupted");
}

#[test]
fn an_end_at_once_is_a_document_too() {
    let desk = Desk::with_case(DEAF);
    let child = start(&desk, &["run", "case.toml", "--json"]);
    wait_for(&desk, "out/case/.judder.lock");
    sleep(Duration::from_millis(200));
    press_ctrl_c(&child);
    sleep(Duration::from_millis(200));
    send(&child, "-TERM");
    let said = Said::of(child.wait_with_output().unwrap());
    assert_eq!(said.code, 1);
    assert_eq!(said.json()["error"]["message"], "ended at once");
}
