//! No room: the error says so, nothing half-written is left, what stood before still stands.
#![cfg(unix)]

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

use judder_store::{ClaimAnswer, Dataset, StoreError, StreamWriter, StudyFolder, Summary, Variable};

const CHILD_FOLDER: &str = "JUDDER_TEST_LIMITED_FOLDER";

/// 2 MiB that no compression makes smaller.
fn noise() -> Vec<f64> {
    let mut state = 1_u64;
    let mut number = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from_bits(state >> 2)
    };
    (0..262_144).map(|_| number()).collect()
}

fn large() -> Dataset {
    let noise = noise();
    Dataset::new().with(Variable::new("noise", &["point"], &[noise.len()], noise)).unwrap()
}

fn small_summary() -> Summary {
    Summary { case_hash: "small".to_owned(), ..Summary::default() }
}

/// A study with a little of everything, written while there is room.
fn prepare(folder: &Path) -> StudyFolder {
    let study = StudyFolder::create(folder).unwrap();
    study.write_dataset("a", "old", &crate::constant(1.0, 10)).unwrap();
    study.write_summary(&small_summary(), Some("a")).unwrap();
    study.write_file("figures/a.svg", b"old").unwrap();
    study
}

/// Everything that [`prepare`] wrote is as it was, and nothing else is there.
fn check_untouched(study: &StudyFolder) {
    assert_eq!(study.read_dataset("a").unwrap(), crate::constant(1.0, 10));
    assert_eq!(study.read_summary().unwrap().unwrap(), small_summary());
    assert_eq!(fs::read(study.path().join("figures/a.svg")).unwrap(), b"old");
    let names: Vec<String> = crate::names(study.path()).into_iter().filter(|name| name != "filler").collect();
    assert_eq!(names, [".judder.lock", "figures", "results.zarr", "summary.json"]);
    assert_eq!(crate::names(&study.path().join("results.zarr")), ["a", "zarr.json"]);
}

fn check_full(written: Result<(), StoreError>, end_of_path: &str, least: u64) {
    match written.unwrap_err() {
        StoreError::DiskFull { path, bytes, .. } => {
            assert!(path.ends_with(end_of_path), "{}", path.display());
            assert!(bytes >= least, "{bytes}");
        }
        other => panic!("{other}"),
    }
}

/// Writes that find no room, with a summary, a file and datasets larger than it.
fn write_without_room(study: &StudyFolder) {
    let summary = Summary { warnings: vec!["long".repeat(500_000)], ..small_summary() };
    check_full(study.write_dataset("a", "new", &large()), "results.zarr/a", 2 << 20);
    check_untouched(study);
    check_full(study.write_dataset("b", "new", &large()), "results.zarr/b", 2 << 20);
    check_full(study.write_summary(&summary, Some("a")), "summary.json", 2_000_000);
    check_full(study.write_file("figures/a.svg", &[0; 2 << 20]).map(drop), "figures/a.svg", 2 << 20);
    check_untouched(study);
    stream_without_room(study);
    check_untouched(study);
    chunk_without_room(study);
    check_untouched(study);
}

/// An append that finds no room takes none, and a smaller one goes on where the last whole one ended.
fn stream_without_room(study: &StudyFolder) {
    let force = Variable::new("force", &["time"], &[0], Vec::<f64>::new());
    let mut stream = StreamWriter::open(study, "march", "h", &[force]).unwrap();
    stream.append(b"1", &[[1.0][..].into()]).unwrap();
    check_full(stream.append(b"2", &[vec![2.0; 262_144][..].into()]), ".stream-march/force.f64", 2 << 20);
    let values = study.path().join(".stream-march/force.f64");
    assert_eq!(fs::metadata(&values).unwrap().len(), 8);
    assert_eq!((stream.len(), stream.checkpoint()), (1, Some(&b"1"[..])));
    stream.append(b"2", &[[2.0][..].into()]).unwrap();
    assert_eq!(stream.len(), 2);
    fs::remove_dir_all(study.path().join(".stream-march")).unwrap();
}

/// A chunk that finds no room leaves nothing behind, and can be claimed again.
fn chunk_without_room(study: &StudyFolder) {
    let store = study.sweep(&crate::sweep("h", &[("sample", 131_073, 131_072)])).unwrap();
    let write = |chunk, values: &[f64]| {
        let ClaimAnswer::Claimed(claim) = store.claim(chunk).unwrap() else { panic!("chunk {chunk}") };
        store.write(claim, values, &[])
    };
    write(1, &[1.0, 2.0]).unwrap();
    let before = crate::contents(study.path());
    check_full(write(0, &noise()), "results.zarr/sweep/values/c.0.0", 1 << 20);
    let claim = BTreeMap::from([(".sweep-sweep/0.claim".to_owned(), Vec::new())]);
    assert_eq!(crate::contents(study.path()), before.into_iter().chain(claim).collect());
    write(0, &[1.0; 262_144]).unwrap();
    assert_eq!(store.done_chunks().unwrap(), [true, true]);
    for folder in [".sweep-sweep", "results.zarr/sweep"] {
        fs::remove_dir_all(study.path().join(folder)).unwrap();
    }
    study.consolidate().unwrap();
    assert!(!fs::read_to_string(study.path().join("results.zarr/zarr.json")).unwrap().contains("sweep"));
}

/// A file may not grow beyond a limit that the shell sets: works without privileges.
#[test]
fn a_limit_on_file_size() {
    let folder = tempfile::tempdir().unwrap();
    let child = Command::new("sh")
        .args(["-c", r#"trap "" XFSZ; ulimit -f 512; exec "$0" "$@""#])
        .arg(env::current_exe().unwrap())
        .args(["--exact", "disk_full::in_the_limited_child", "--ignored", "--nocapture"])
        .env(CHILD_FOLDER, folder.path())
        .output()
        .unwrap();
    let output = String::from_utf8_lossy(&child.stdout) + String::from_utf8_lossy(&child.stderr);
    assert!(child.status.success() && output.contains("1 passed"), "{output}");
}

#[test]
#[ignore = "run by a_limit_on_file_size, in a process with that limit"]
fn in_the_limited_child() {
    if let Some(folder) = env::var_os(CHILD_FOLDER) {
        write_without_room(&prepare(Path::new(&folder)));
    }
}

/// A small disk of its own, unmounted when dropped.
struct SmallDisk(tempfile::TempDir);

impl SmallDisk {
    fn mount() -> Option<Self> {
        let folder = tempfile::tempdir().unwrap();
        let mounted = Command::new("mount")
            .args(["-t", "tmpfs", "-o", "size=1m", "tmpfs"])
            .arg(folder.path())
            .output()
            .is_ok_and(|output| output.status.success());
        mounted.then(|| Self(folder))
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        let unmounted = Command::new("umount").arg("--lazy").arg(self.0.path()).status();
        assert!(unmounted.is_ok_and(|status| status.success()));
    }
}

/// A disk that is really full: needs root, to mount a small one.
#[test]
fn a_full_disk() {
    let Some(disk) = SmallDisk::mount() else {
        eprintln!("SKIPPED: a_full_disk needs root and mount; a_limit_on_file_size covers the same writes");
        return;
    };
    let study = prepare(&disk.0.path().join("study"));
    write_without_room(&study);

    let mut filler = fs::File::create(study.path().join("filler")).unwrap();
    let full = std::io::copy(&mut std::io::repeat(1), &mut filler).unwrap_err();
    assert_eq!(full.kind(), ErrorKind::StorageFull);
    check_full(
        study.write_summary(&Summary { case_hash: "new".to_owned(), ..small_summary() }, Some("a")),
        "summary.json",
        1,
    );
    check_full(study.write_dataset("a", "new", &crate::constant(2.0, 10)), "results.zarr/a", 80);
    check_untouched(&study);

    drop(filler);
    fs::remove_file(study.path().join("filler")).unwrap();
    study.write_dataset("a", "new", &crate::constant(2.0, 10)).unwrap();
    assert_eq!(study.read_dataset("a").unwrap(), crate::constant(2.0, 10));
}
