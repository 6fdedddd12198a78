//! Studies whose list is damaged or not there yet, and what lies in them that no list knows.

use std::fs;

use crate::desk::Desk;

/// An analysis, and a sweep of three chunks.
const CASE: &str = r#"
model = "oscillator"
[[analysis]]
name = "loci"
kind = "spectrum"
sweep = { key = "contact.shear_strength", from = 1e-4, to = 1.0, points = 5, scale = "log" }
[[sweep]]
name = "speeds"
over = [{ key = "operation.velocity", from = 1e-5, to = 1e-2, points = 6, scale = "log" }]
quantities = ["growth_rate"]
chunk = 2
"#;

fn finished() -> Desk {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml", "-o", "study"]);
    desk
}

/// What `judder verify` says, which must find the study as it should be, or not.
fn verified(desk: &Desk, code: i32) -> String {
    let said = desk.judder(&["verify", "study"]);
    assert_eq!(said.code, code, "{}{}", said.stdout, said.stderr);
    said.stdout + &said.stderr
}

#[test]
fn files_of_others_among_those_of_a_sweep_stay_theirs() {
    let desk = finished();
    let group = desk.path("study/results.zarr/speeds");
    fs::write(group.join("notes.txt"), "mine").unwrap();
    fs::write(group.join("values/c.9.0"), "mine").unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("/dev/zero", group.join("values/zero")).unwrap();
    fs::create_dir(desk.path("study/results.zarr/mine")).unwrap();
    fs::write(desk.path("study/results.zarr/mine/file"), "mine").unwrap();
    let extra = |told: &str| told.matches(": it is not in the manifest").count();
    let before = extra(&verified(&desk, 0));
    assert!(before >= 3);
    // what is computed again is listed again
    fs::remove_file(desk.path("study/speeds.csv")).unwrap();
    desk.succeed(&["run", "case.toml", "-o", "study"]);
    assert_eq!(extra(&verified(&desk, 0)), before);
    assert_eq!(fs::read_to_string(group.join("notes.txt")).unwrap(), "mine");
}

#[test]
fn a_damaged_list_is_told() {
    for command in ["run", "merge"] {
        let desk = finished();
        let list = desk.path("study/manifest.json");
        let content = fs::read(&list).unwrap();
        fs::write(&list, &content[..content.len() / 2]).unwrap();
        let report = desk.judder(&["report", "study"]);
        assert_eq!(report.code, 1);
        report.says("this list of what the study holds is damaged");
        let said = desk.succeed(&[command, "case.toml", "-o", "study"]);
        said.says("`manifest.json` is damaged, so that nothing says");
        said.says("they do not count: loci, speeds");
    }
}

/// Each job of a cluster computes a part; nobody has merged them.
#[test]
fn a_study_in_parts_is_not_called_damaged() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml", "-o", "study", "--shard", "1/2"]);
    let told = verified(&desk, 1);
    assert!(told.contains("a run is at work on the others, or was interrupted"), "{told}");
    assert!(
        told.contains("it is of a result that no run has finished") && !told.contains("damaged"),
        "{told}"
    );
    desk.succeed(&["run", "case.toml", "-o", "study"]);
    verified(&desk, 0);
}

#[test]
fn a_report_tells_what_is_not_computed_yet() {
    let desk = Desk::with_case(CASE);
    desk.succeed(&["run", "case.toml", "-o", "study", "--only", "loci"]);
    let page = || fs::read_to_string(desk.path("study/report.html")).unwrap();
    assert!(page().contains("1 of 2 analyses and sweeps done") && page().contains("Not computed: speeds."));
    desk.succeed(&["report", "study"]).says("not computed yet: speeds; `judder run` computes them");
    desk.succeed(&["run", "case.toml", "-o", "study"]);
    assert!(page().contains("2 of 2 analyses and sweeps done") && !page().contains("Not computed"));
}

#[test]
fn what_is_no_folder_is_no_study() {
    let desk = Desk::with_case(CASE);
    for command in ["verify", "report"] {
        desk.refused(&[command, "case.toml"], "a study needs a folder, and this is a file", "-o");
        desk.refused(&[command, "nowhere"], "no study here", "judder run");
    }
}

/// Links that lead to themselves: whatever they hold, nobody can read it.
#[cfg(unix)]
#[test]
fn what_cannot_be_read_is_not_called_damaged() {
    let desk = finished();
    let (group, away) = (desk.path("study/results.zarr/loci"), desk.path("away"));
    fs::rename(&group, &away).unwrap();
    std::os::unix::fs::symlink(&group, &group).unwrap();
    let told = verified(&desk, 1);
    assert!(told.contains("cannot be read, and nothing is known of them"), "{told}");
    assert!(!told.contains("its content is not what was written"), "{told}");
    let said = desk.judder(&["run", "case.toml", "-o", "study"]);
    assert_eq!(said.code, 1);
    said.says("which does not say that it is damaged");
    fs::remove_file(&group).unwrap();
    fs::rename(&away, &group).unwrap();
    verified(&desk, 0);
}

#[cfg(unix)]
#[test]
fn a_link_in_the_place_of_the_folder_of_figures_is_named() {
    let desk = finished();
    let figures = desk.path("study/figures");
    fs::rename(&figures, desk.path("elsewhere")).unwrap();
    std::os::unix::fs::symlink(desk.path("elsewhere"), &figures).unwrap();
    let said = desk.judder(&["report", "study"]);
    assert_eq!(said.code, 1);
    said.says("study/figures: a link stands in the place of a folder of the study");
}
