//! A reader that looks while a study is written sees the old content or the new.

use std::env;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use judder_store::{StudyFolder, Summary};

const CHILD_FOLDER: &str = "JUDDER_TEST_KILLED_FOLDER";

/// Runs `write` some hundred times while `read` looks on.
fn while_reading(write: impl Fn(usize), read: impl Fn() + Send + Sync) {
    let writing = AtomicBool::new(true);
    thread::scope(|scope| {
        let reader = scope.spawn(|| {
            let mut looks = 0;
            while writing.load(Ordering::Relaxed) {
                read();
                looks += 1;
            }
            looks
        });
        (0..100).for_each(write);
        writing.store(false, Ordering::Relaxed);
        assert!(reader.join().unwrap() > 10);
    });
}

#[test]
fn a_summary_is_never_half() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let summary =
        |run: usize| Summary { warnings: vec!["long".repeat(2000); run % 2 * 50], ..Summary::default() };
    study.write_summary(&summary(0), Some("a")).unwrap();
    while_reading(
        |run| study.write_summary(&summary(run), Some("a")).unwrap(),
        || assert!(matches!(study.read_summary().unwrap().unwrap().warnings.len(), 0 | 50)),
    );
}

#[cfg(any(target_os = "linux", target_vendor = "apple"))]
#[test]
fn a_dataset_is_always_there_and_whole() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let constant = |run: usize| crate::constant((run % 2) as f64, 1000);
    study.write_dataset("a", "h", &constant(0)).unwrap();
    while_reading(
        |run| study.write_dataset("a", "h", &constant(run)).unwrap(),
        || {
            let read = study.read_dataset("a").unwrap();
            assert!(read == constant(0) || read == constant(1));
            let root = fs::read(folder.path().join("results.zarr/zarr.json")).unwrap();
            serde_json::from_slice::<serde_json::Value>(&root).unwrap();
        },
    );
    assert_eq!(crate::names(folder.path()), [".judder.lock", "results.zarr"]);
}

/// Kills a process that keeps replacing a dataset, at various moments of its work.
#[test]
fn a_killed_run_leaves_a_sound_study() {
    let folder = tempfile::tempdir().unwrap();
    prepare(folder.path());
    for moment in 0..12 {
        let mut child = Command::new(env::current_exe().unwrap())
            .args(["--exact", "replacement::until_killed", "--ignored"])
            .env(CHILD_FOLDER, folder.path())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        while !folder.path().join("started").exists() {
            thread::sleep(Duration::from_millis(1));
        }
        thread::sleep(Duration::from_micros(1700 * moment));
        assert!(child.try_wait().unwrap().is_none(), "the child ended by itself");
        child.kill().unwrap();
        child.wait().unwrap();
        fs::remove_file(folder.path().join("started")).unwrap();

        let study = StudyFolder::create(folder.path()).unwrap();
        let read = study.read_dataset("a").unwrap();
        assert!(read == crate::constant(0.0, 1000) || read == crate::constant(1.0, 1000));
        let root = fs::read_to_string(folder.path().join("results.zarr/zarr.json")).unwrap();
        assert!(root.contains("consolidated_metadata"));
        assert_eq!(crate::names(folder.path()), [".judder.lock", "results.zarr"]);
    }
}

fn prepare(folder: &Path) {
    StudyFolder::create(folder).unwrap().write_dataset("a", "h", &crate::constant(0.0, 1000)).unwrap();
}

#[test]
#[ignore = "run and killed by a_killed_run_leaves_a_sound_study"]
fn until_killed() {
    let Some(folder) = env::var_os(CHILD_FOLDER) else { return };
    let study = StudyFolder::create(&folder).unwrap();
    fs::write(Path::new(&folder).join("started"), "").unwrap();
    for run in 0.. {
        study.write_dataset("a", "h", &crate::constant(f64::from(run % 2), 1000)).unwrap();
    }
}

#[test]
fn threads_do_not_forget_each_others_datasets() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    thread::scope(|scope| {
        for i in 0..8 {
            let study = &study;
            scope
                .spawn(move || study.write_dataset(&format!("a{i}"), "h", &crate::constant(1.0, 5)).unwrap());
        }
    });
    let root = fs::read(folder.path().join("results.zarr/zarr.json")).unwrap();
    let root: serde_json::Value = serde_json::from_slice(&root).unwrap();
    let members = root["consolidated_metadata"]["metadata"].as_object().unwrap();
    assert_eq!(members.len(), 16);
}
