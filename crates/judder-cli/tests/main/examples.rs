//! `judder examples` and `judder demo`.

use std::fs;

use crate::desk::Desk;

#[test]
fn examples_are_listed_printed_and_written_whole() {
    let desk = Desk::new();
    let listed = desk.succeed(&["examples"]).stdout;
    assert!(
        listed
            .lines()
            .any(|line| line.starts_with("tutorials/own-rubber ") && line.ends_with("A rubber of one's own"))
    );
    let document = desk.succeed(&["examples", "--json"]).json();
    assert_eq!(document.as_array().unwrap().len(), listed.lines().count());
    let own = desk.succeed(&["examples", "own-rubber"]);
    assert!(own.stdout.starts_with("# From measured moduli"));
    assert!(
        own.stderr.contains("`judder examples tutorials/own-rubber -o own-rubber` writes both"),
        "{}",
        own.stderr
    );
    desk.succeed(&["examples", "own-rubber", "-o", "rubber"]);
    assert_eq!(fs::read_to_string(desk.path("rubber/own-rubber.toml")).unwrap(), own.stdout);
    desk.succeed(&["check", "rubber/own-rubber.toml"]);
    desk.refused(&["examples", "coupling"], "there is no example `coupling`", "assembly/mode-coupling or");
}

#[test]
fn a_demo_runs_a_case_that_can_be_changed() {
    let desk = Desk::new();
    desk.succeed(&["demo", "mode-coupling"]);
    assert!(desk.path("out/mode-coupling/report.html").is_file());
    desk.succeed(&["run", "out/demo/mode-coupling.toml"]);
    desk.write("out/demo/mode-coupling.toml", "mine");
    desk.refused(
        &["demo", "mode-coupling"],
        "is not the example any more",
        "`judder run out/demo/mode-coupling.toml`",
    );
    desk.refused(
        &["demo", "python/own-rubber-to-map"],
        "is a script of Python",
        "python own-rubber-to-map.py",
    );
}
