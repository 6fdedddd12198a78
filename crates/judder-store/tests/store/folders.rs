//! Which folders are taken, which are refused, and what a killed run leaves.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use judder_store::{AnalysisRecord, Finding, Status, StoreError, StudyFolder, Summary, verify};

#[test]
fn a_new_folder_is_made_with_its_parents() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out/case");
    assert_eq!(StudyFolder::create(&path).unwrap().path(), path);
}

#[test]
fn a_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "mine").unwrap();
    for path in [file.clone(), file.join("below")] {
        let refused = StudyFolder::create(&path).unwrap_err();
        assert!(matches!(refused, StoreError::NotAFolder { .. }), "{refused}");
    }
    assert!(matches!(StudyFolder::open(&file).unwrap_err(), StoreError::NotAFolder { .. }));
    assert_eq!(fs::read(&file).unwrap(), b"mine");
}

#[test]
fn a_folder_of_someone_else_is_refused_and_left_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thesis.tex"), "mine").unwrap();
    fs::write(folder.path().join("data.csv"), "mine").unwrap();
    let refused = StudyFolder::create(folder.path()).unwrap_err();
    assert!(matches!(&refused, StoreError::ForeignFolder { holds, .. } if holds == "data.csv"), "{refused}");
    assert_eq!(crate::names(folder.path()), ["data.csv", "thesis.tex"]);
}

#[test]
fn a_study_is_taken_up_whether_it_ended_or_not() {
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(StudyFolder::open(folder.path()).unwrap_err(), StoreError::NoStudy { .. }));
    let killed = StudyFolder::create(folder.path()).unwrap();
    killed.write_table("a", &judder_store::Table::new()).unwrap();
    drop(killed);
    let ended = StudyFolder::create(folder.path()).unwrap();
    ended.write_summary(&Summary::default(), Some("a")).unwrap();
    drop(ended);
    fs::remove_file(folder.path().join(".judder.lock")).unwrap();
    drop(StudyFolder::create(folder.path()).unwrap());
    StudyFolder::open(folder.path()).unwrap();
}

#[test]
fn a_study_belongs_to_one_run_at_a_time() {
    let folder = tempfile::tempdir().unwrap();
    let first = StudyFolder::create(folder.path()).unwrap();
    let refused = StudyFolder::create(folder.path()).unwrap_err();
    assert!(matches!(refused, StoreError::Locked { .. }), "{refused}");
    drop(first);
    StudyFolder::create(folder.path()).unwrap();
}

#[cfg(unix)]
#[test]
fn a_folder_without_permission_is_refused() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o555)).unwrap();
    if fs::write(folder.path().join("probe"), "").is_ok() {
        eprintln!("SKIPPED: this user may write everywhere");
        return;
    }
    for path in [folder.path().to_owned(), folder.path().join("below")] {
        let refused = StudyFolder::create(path).unwrap_err();
        assert!(matches!(refused, StoreError::NotWritable { .. }), "{refused}");
    }
}

#[test]
fn what_a_killed_run_left_is_swept_and_the_store_made_whole() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    study.write_dataset("a", "h", &crate::constant(1.0, 2)).unwrap();
    drop(study);
    let whole = fs::read(folder.path().join("results.zarr/zarr.json")).unwrap();
    fs::create_dir_all(folder.path().join(".partial-killed/group/value/c")).unwrap();
    fs::write(folder.path().join(".partial-killed/group/value/c/0"), "half").unwrap();
    fs::write(
        folder.path().join("results.zarr/zarr.json"),
        r#"{"zarr_format":3,"node_type":"group","attributes":{}}"#,
    )
    .unwrap();

    let study = StudyFolder::create(folder.path()).unwrap();
    assert_eq!(crate::names(folder.path()), [".judder.lock", "results.zarr"]);
    assert_eq!(fs::read(folder.path().join("results.zarr/zarr.json")).unwrap(), whole);
    assert_eq!(study.read_dataset("a").unwrap(), crate::constant(1.0, 2));
}

#[test]
fn a_rerun_resumes_only_what_is_done_and_there() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let summary = |status| {
        let record = AnalysisRecord { hash: "h".to_owned(), status, wall_time_s: 1.0, warnings: Vec::new() };
        Summary { analyses: [("a".to_owned(), record)].into(), ..Summary::default() }
    };
    let done = || study.is_done("a", "h").unwrap();
    assert!(!done());
    study.write_summary(&summary(Status::Done), Some("a")).unwrap();
    assert!(!done(), "without arrays");
    study.write_dataset("a", "h", &crate::constant(1.0, 2)).unwrap();
    assert!(done());
    assert!(!study.is_done("a", "other").unwrap());
    assert!(!study.is_done("b", "h").unwrap());
    study.write_dataset("a", "other", &crate::constant(1.0, 2)).unwrap();
    assert!(!done(), "with the arrays of another case");
    study.write_dataset("a", "h", &crate::constant(1.0, 2)).unwrap();
    study.write_summary(&summary(Status::Failed { reason: "no convergence".to_owned() }), Some("a")).unwrap();
    assert!(!done(), "after a failure");
    study.forget(|_| false).unwrap();
    assert!(matches!(study.read_dataset("a").unwrap_err(), StoreError::NoDataset { .. }));
    assert!(study.read_summary().unwrap().is_none());
    assert_eq!(crate::names(folder.path()), [".judder.lock"]);
}

#[test]
fn a_run_from_nothing_forgets_files_of_results_and_what_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let law = Path::new("law.json");
    study.write_file_of(Some("law"), law, b"{}").unwrap();
    for whole in ["figures/law.svg", "report.html", "inputs/mass.mtx"] {
        study.write_file(whole, b"content").unwrap();
    }
    fs::write(folder.path().join("figures/notes.txt"), "of the user").unwrap();
    study.keep_manifest("build").unwrap();
    study.forget(|path| path == "report.html" || path.starts_with("figures/")).unwrap();
    for gone in ["law.json", "figures/law.svg", "report.html"] {
        assert!(!folder.path().join(gone).exists(), "{gone}");
    }
    for stays in ["inputs/mass.mtx", "figures/notes.txt"] {
        assert!(folder.path().join(stays).exists(), "{stays}");
    }
    study.seal("build").unwrap();
    drop(study);
    let found = verify(folder.path(), |_, _| true).unwrap();
    assert_eq!(found.findings, [Finding::Extra { path: "figures/notes.txt".to_owned(), of: None }]);
}

/// Names the folder of the study that a child forgets.
const FORGOTTEN_FOLDER: &str = "JUDDER_TEST_FORGOTTEN_FOLDER";

#[test]
#[ignore = "run and killed by the other tests"]
fn forgets_in_the_child() {
    if let Some(folder) = env::var_os(FORGOTTEN_FOLDER) {
        StudyFolder::create(folder).unwrap().forget(|path| path.starts_with("figures/")).unwrap();
    }
}

/// Forgets a study in a process that ends before the n-th call to the disk; whether it came to its end before.
fn forgets_until(call: usize, folder: &Path) -> bool {
    let child = Command::new(env::current_exe().unwrap())
        .args(["--exact", "folders::forgets_in_the_child", "--ignored"])
        .env(FORGOTTEN_FOLDER, folder)
        .env(judder_disk::FAULT_VARIABLE, format!("end@{call}"))
        .output();
    child.unwrap().status.success()
}

#[test]
fn a_run_from_nothing_that_is_killed_leaves_nothing_that_the_next_takes_for_somebodys() {
    let folder = tempfile::tempdir().unwrap();
    for call in 1.. {
        let path = folder.path().join(call.to_string());
        let study = StudyFolder::create(&path).unwrap();
        study.write_dataset("law", "h", &crate::constant(1.0, 2)).unwrap();
        for law in ["law.json", "law.csv"] {
            study.write_file_of(Some("law"), Path::new(law), b"{}").unwrap();
        }
        study.write_file("figures/law.svg", b"content").unwrap();
        study.write_summary(&Summary::default(), Some("law")).unwrap();
        study.seal("build").unwrap();
        drop(study);
        let is_whole = forgets_until(call, &path);
        let found = verify(&path, |_, _| true).unwrap().findings;
        assert!(
            !found.iter().any(|finding| matches!(finding, Finding::Extra { of: None, .. })),
            "{call}: {found:?}"
        );
        let next = StudyFolder::create(&path).unwrap();
        next.forget(|path| path.starts_with("figures/")).unwrap();
        next.seal("build").unwrap();
        drop(next);
        let found = verify(&path, |_, _| true).unwrap();
        assert!(found.is_sound() && found.findings.is_empty(), "{call}: {found:?}");
        if is_whole {
            assert!(call > 10, "it was killed {call} times");
            return;
        }
    }
}

#[test]
fn files_stay_inside_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path().join("study")).unwrap();
    let path = study.write_file("figures/deep/map.svg", b"<svg/>").unwrap();
    assert_eq!(fs::read(path).unwrap(), b"<svg/>");
    let absolute = folder.path().join("elsewhere").display().to_string();
    for bad in [
        "",
        ".",
        "../x",
        "a/../../x",
        &absolute,
        ".judder.lock",
        "a/.hidden",
        "summary.json",
        "results.zarr/x",
    ] {
        let refused = study.write_file(bad, b"").unwrap_err();
        assert!(matches!(refused, StoreError::OutsideFolder { .. }), "{bad}: {refused}");
    }
    #[cfg(unix)]
    {
        let outside = folder.path().join("outside");
        fs::create_dir(&outside).unwrap();
        std::os::unix::fs::symlink(&outside, study.path().join("link")).unwrap();
        let refused = study.write_file("link/new/x.svg", b"").unwrap_err();
        assert!(matches!(&refused, StoreError::LinkInPlace { path } if path.ends_with("link")), "{refused}");
        assert!(crate::names(&outside).is_empty());
    }
    assert!(study.write_table("../x", &judder_store::Table::new()).is_err());
    assert!(study.write_dataset("..", "h", &crate::constant(1.0, 1)).is_err());
    assert!(study.read_dataset("../../x").is_err());
}

#[test]
fn a_relative_path_works() {
    // Tests share the working directory, so it is not changed: a path from there to the temporary folder is built.
    let folder = tempfile::tempdir().unwrap();
    let up: PathBuf = std::env::current_dir().unwrap().ancestors().skip(1).map(|_| "..").collect();
    let path = up.join(folder.path().strip_prefix("/").unwrap_or(Path::new("x"))).join("study");
    let study = StudyFolder::create(&path).unwrap();
    study.write_dataset("a", "h", &crate::constant(1.0, 2)).unwrap();
    study.write_file("figures/a.svg", b"").unwrap();
    assert_eq!(study.read_dataset("a").unwrap(), crate::constant(1.0, 2));
}
