//! Ctrl-C.

#![cfg(unix)]

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

fn press_ctrl_c(child: &Child) {
    let status = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(status.success());
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
