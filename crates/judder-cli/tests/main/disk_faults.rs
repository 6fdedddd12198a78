//! A disk that fails at any of its calls, in the manner of SQLite: full from a call on, broken at one, or the process ends there.
//!
//! Whatever call it is: an error that names a file of the study, nothing that `judder verify` takes for sound and is not so, and the same bytes
//! once the command is given again. The calls are those of `judder-disk`, which all of a study is written through.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use judder_disk::FAULT_VARIABLE;
use serde_json::Value;

use crate::desk::{Desk, files_below};

const OSCILLATOR: &str = r#"
model = "oscillator"
[contact]
shear_strength = "40 kPa"
[substrate]
rubbery_modulus = "1 MPa"
glassy_modulus = "10 MPa"
retardation_time = "5 ms"
[operation]
velocity = "5 mm/s"
normal_load = "0.2 N"
"#;

/// Arrays, a table, a sound, and a march that keeps what it has.
const ANALYSES: &str = r#"
[[analysis]]
name = "spectrum"
kind = "spectrum"
sweep = { key = "operation.velocity", from = "1 mm/s", to = "1 m/s", points = 4, scale = "log" }
[[analysis]]
name = "motion"
kind = "motion"
duration = "0.1 s"
points = 64
sound = true
"#;

/// Three chunks.
const SWEEP: &str = r#"
[[sweep]]
name = "speeds"
over = [{ key = "operation.velocity", from = "1 mm/s", to = "1 m/s", points = 6, scale = "log" }]
quantities = ["growth_rate", "verdict"]
chunk = 2
"#;

/// What a command does while the disk fails.
struct Walk {
    analyses: &'static str,
    /// What was done before.
    before: &'static [&'static [&'static str]],
    command: &'static [&'static str],
    /// What is done afterwards to have all.
    again: &'static [&'static [&'static str]],
}

const RUN: &[&str] = &["run", "case.toml", "-o", "study", "--threads", "1", "--no-report"];
const DRAWN_RUN: &[&str] = &["run", "case.toml", "-o", "study", "--threads", "1"];
const MERGE: &[&str] = &["merge", "case.toml", "-o", "study"];
const REPORT: &[&str] = &["report", "study"];
const EXPORT: &[&str] = &["report", "study", "-o", "page"];
const PARTS: &[&[&str]] = &[
    &["run", "case.toml", "-o", "study", "--shard", "1/2"],
    &["run", "case.toml", "-o", "study", "--shard", "2/2"],
];

const A_RUN: Walk = Walk { analyses: ANALYSES, before: &[], command: RUN, again: &[RUN] };
const A_DRAWN_RUN: Walk = Walk { analyses: ANALYSES, before: &[], command: DRAWN_RUN, again: &[DRAWN_RUN] };
const A_SWEEP: Walk = Walk { analyses: SWEEP, before: &[], command: RUN, again: &[RUN] };
const A_MERGE: Walk = Walk { analyses: SWEEP, before: PARTS, command: MERGE, again: &[MERGE] };
// a study that is drawn anew is complete again after the next run
const A_REPORT: Walk = Walk { analyses: SWEEP, before: &[DRAWN_RUN], command: REPORT, again: &[REPORT, RUN] };
const AN_EXPORT: Walk = Walk { analyses: SWEEP, before: &[DRAWN_RUN], command: EXPORT, again: &[EXPORT] };

/// How many calls were struck, and how many of those the command did without.
#[derive(Debug, Default)]
struct Struck {
    calls: usize,
    unheard: usize,
}

impl Walk {
    /// Strikes every so many calls, until the command ends without a fault.
    fn walk(&self, fault: &str, every: usize) -> Struck {
        let desk = Desk::with_case(&format!("{OSCILLATOR}{}", self.analyses));
        self.before.iter().for_each(|command| drop(desk.succeed(command)));
        let before = contents(&desk.path("."));
        desk.succeed(self.command);
        let undisturbed = contents(&desk.path("."));
        let mut struck = Struck::default();
        for call in (every.div_ceil(2)..).step_by(every) {
            restore(&desk.path("."), &before);
            let asked = format!("{fault}@{call}");
            let said = desk.command(self.command).env(FAULT_VARIABLE, &asked).output().unwrap();
            let stderr = String::from_utf8_lossy(&said.stderr).into_owned();
            let Some(hit) = stderr.lines().find(|line| line.starts_with("the disk fails")) else {
                assert!(said.status.success(), "{asked}: {stderr}");
                return struck;
            };
            let what = format!("{asked}, {hit}");
            struck.calls += 1;
            struck.unheard += usize::from(said.status.success());
            check_said(&what, fault, &said, &stderr.replacen(hit, "", 1));
            // only what cleans up, or names who holds a lock, may fail without a word
            let is_needed =
                ["Sync", "Rename", "CreateFolder", "CreateFile"].iter().any(|call| hit.contains(call));
            assert!(!(fault == "broken" && said.status.success() && is_needed), "{what}: nobody heard it");
            check_believed(&what, &desk, &undisturbed, said.status.success());
            self.again.iter().for_each(|command| {
                let said = desk.judder(command);
                assert_eq!(said.code, 0, "{what}, then {command:?}: {}", said.stderr);
            });
            let now = contents(&desk.path("."));
            assert!(now.keys().eq(undisturbed.keys()), "{what}: {:?}", difference(&now, &undisturbed));
            let other = now.iter().find(|(path, content)| is_result(path) && undisturbed[*path] != **content);
            assert!(other.is_none(), "{what}: {:?} is another", other.map(|(path, _)| path));
            let verified = desk.judder(&["verify", "study"]);
            assert_eq!(verified.code, 0, "{what}: {}", verified.stdout);
        }
        struck
    }

    fn all(&self, name: &str, every: [usize; 3]) {
        for (fault, every) in ["full", "broken", "end"].into_iter().zip(every) {
            let struck = self.walk(fault, every);
            println!("{name}, {fault}: {struck:?}");
            assert!(struck.calls > 1, "{name}, {fault}: {struck:?}");
        }
    }
}

/// A failure says which file of the desk it is about; a process that ends says nothing.
fn check_said(what: &str, fault: &str, said: &Output, stderr: &str) {
    assert!(!stderr.contains("panicked"), "{what}: {stderr}");
    if fault == "end" {
        assert!(!said.status.success(), "{what}");
    } else if !said.status.success() {
        assert_eq!(said.status.code(), Some(1), "{what}: {stderr}");
        let is_named = stderr.contains("× study") || stderr.contains("× page");
        assert!(is_named, "{what}: {stderr}");
    }
}

/// What the list of the study holds is what an undisturbed run writes; the whole is sound only where the results are.
fn check_believed(what: &str, desk: &Desk, undisturbed: &BTreeMap<PathBuf, Vec<u8>>, is_done: bool) {
    let verified = desk.judder(&["verify", "study"]);
    assert!(!verified.stderr.contains("panicked"), "{what}: {}", verified.stderr);
    assert!(verified.code == 0 || !is_done, "{what}, said to be done: {}", verified.stdout);
    let now = contents(&desk.path("."));
    let same = |path: &Path| now.get(path) == undisturbed.get(path);
    if verified.code == 0 {
        let other = undisturbed.keys().find(|path| is_result(path) && !same(path));
        assert!(other.is_none(), "{what}: sound without {other:?}");
    }
    let Some(manifest) = now.get(Path::new("study/manifest.json")) else { return };
    let manifest: Value = serde_json::from_slice(manifest).unwrap();
    for path in manifest["files"].as_object().unwrap().keys() {
        let path = Path::new("study").join(path);
        assert!(!is_result(&path) || same(&path), "{what}: {} is listed, and is another", path.display());
    }
}

/// Whether a file holds results: the same bytes whenever they are computed.
fn is_result(path: &Path) -> bool {
    path.starts_with("study/results.zarr") || path.extension().is_some_and(|end| end == "csv" || end == "wav")
}

/// The files of the desk by their paths, but for locks.
fn contents(desk: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let files =
        files_below(desk).into_iter().filter(|path| path.is_file() && !path.ends_with(".judder.lock"));
    let read = |path: PathBuf| (path.strip_prefix(desk).unwrap().to_owned(), fs::read(&path).unwrap());
    files.map(read).collect()
}

/// Makes the desk what it was.
fn restore(desk: &Path, files: &BTreeMap<PathBuf, Vec<u8>>) {
    for folder in ["study", "page"].map(|name| desk.join(name)).iter().filter(|folder| folder.exists()) {
        fs::remove_dir_all(folder).unwrap();
    }
    for (path, content) in files {
        let path = desk.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }
    if desk.join("study").exists() {
        fs::write(desk.join("study/.judder.lock"), "").unwrap();
    }
}

/// The paths that only one of both has.
fn difference<'a>(
    one: &'a BTreeMap<PathBuf, Vec<u8>>,
    other: &'a BTreeMap<PathBuf, Vec<u8>>,
) -> Vec<&'a PathBuf> {
    let only = |one: &'a BTreeMap<PathBuf, _>, other: &'a BTreeMap<PathBuf, Vec<u8>>| {
        one.keys().filter(|path| !other.contains_key(*path))
    };
    only(one, other).chain(only(other, one)).collect()
}

#[test]
fn some_calls_of_a_run_fail() {
    A_DRAWN_RUN.all("run with a report", [173, 151, 187]);
}

#[test]
fn some_calls_of_a_sweep_fail() {
    A_SWEEP.all("sweep", [83, 97, 71]);
}

#[test]
fn some_calls_of_a_merge_a_report_and_an_export_fail() {
    A_MERGE.all("merge", [29, 31, 23]);
    A_REPORT.all("report", [17, 15, 16]);
    AN_EXPORT.all("export", [11, 13, 12]);
}

#[test]
#[ignore = "minutes: every call of a run, and some of one that draws"]
fn every_call_of_a_run_fails() {
    A_RUN.all("run", [1; 3]);
    A_DRAWN_RUN.all("run with a report", [19, 17, 23]);
}

#[test]
#[ignore = "minutes: every call of a sweep"]
fn every_call_of_a_sweep_fails() {
    A_SWEEP.all("sweep", [1; 3]);
}

#[test]
#[ignore = "minutes: every call of a merge, a report, an export"]
fn every_call_of_a_merge_a_report_and_an_export_fails() {
    A_MERGE.all("merge", [1; 3]);
    A_REPORT.all("report", [1; 3]);
    AN_EXPORT.all("export", [1; 3]);
}
