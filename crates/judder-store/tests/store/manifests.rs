//! What is damaged of a finished study is found, whatever it is.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use judder_store::{
    AnalysisRecord, FileDamage, Finding, Status, StoreError, StreamWriter, StudyFolder, StudyReader, Summary,
    Table, Variable, verify,
};
use serde_json::json;

const BUILD: &str = "0.0.0+test";
/// The metadata of arrays of judder's.
const GROUP: &str = r#"{"zarr_format": 3, "node_type": "group", "attributes": {"judder_hash": "h"}, "consolidated_metadata": {"metadata": {}}}"#;

fn summary(names: &[&str]) -> Summary {
    let record = || AnalysisRecord {
        hash: "h".to_owned(),
        status: Status::Done,
        wall_time_s: 1.0,
        warnings: Vec::new(),
    };
    let results =
        |name: &&str| ((*name).to_owned(), [("peak".to_owned(), json!(name.len()))].into_iter().collect());
    Summary {
        analyses: names.iter().map(|name| ((*name).to_owned(), record())).collect(),
        results: names.iter().map(results).collect(),
        extra: [("study".to_owned(), json!({ "checks": { names[0]: [{ "figure": 1.0 }] } }))]
            .into_iter()
            .collect(),
        ..Summary::default()
    }
}

/// A study of two analyses with arrays, tables and a sound.
fn finished(folder: &Path) -> Summary {
    let study = StudyFolder::create(folder).unwrap();
    for (name, value) in [("one", 1.0), ("other", 2.0)] {
        study.write_dataset(name, "h", &crate::constant(value, 40)).unwrap();
        study.write_table(name, &Table::new().column("x", "m", vec![value]).unwrap()).unwrap();
    }
    study.write_file_of(Some("one"), Path::new("sound.wav"), b"RIFF").unwrap();
    study.write_file("figures/one.svg", b"<svg/>").unwrap();
    let summary = summary(&["one", "other"]);
    study.write_summary(&summary, None).unwrap();
    study.seal(BUILD).unwrap();
    summary
}

fn all(_: &str, _: u64) -> bool {
    true
}

/// All files of a study but for its lock, by their paths in it.
fn files(study: &Path) -> Vec<PathBuf> {
    let (mut found, mut folders) = (Vec::new(), vec![study.to_owned()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { folders.push(path) } else { found.push(path) }
        }
    }
    found.retain(|path| !path.ends_with(".judder.lock"));
    found.sort();
    found
}

fn copied(from: &Path, to: &Path) {
    for file in files(from) {
        let target = to.join(file.strip_prefix(from).unwrap());
        fs::create_dir_all(target.parent().unwrap()).unwrap();
        fs::copy(file, target).unwrap();
    }
    fs::write(to.join(".judder.lock"), "").unwrap();
}

/// A way to damage a file.
type Damaging = fn(&Path, &Path);

/// Ways to damage a file; the second is some other file of the study.
const DAMAGES: [(&str, Damaging); 7] = [
    ("flip", |file, _| {
        let mut content = fs::read(file).unwrap();
        let middle = content.len() / 2;
        content[middle] ^= 1;
        fs::write(file, content).unwrap();
    }),
    ("cut", |file, _| {
        let content = fs::read(file).unwrap();
        fs::write(file, &content[..content.len() - 1]).unwrap();
    }),
    ("empty", |file, _| fs::write(file, "").unwrap()),
    ("longer", |file, _| fs::write(file, [fs::read(file).unwrap(), b" ".to_vec()].concat()).unwrap()),
    ("swapped", |file, other| {
        fs::copy(other, file).unwrap();
    }),
    ("gone", |file, _| fs::remove_file(file).unwrap()),
    ("folder", |file, _| {
        fs::remove_file(file).unwrap();
        fs::create_dir(file).unwrap();
    }),
];

#[test]
fn a_study_is_sound_until_any_of_its_files_is_touched() {
    let (origin, work) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    finished(origin.path());
    let untouched = verify(origin.path(), all).unwrap();
    assert!(untouched.is_sound(), "{untouched:?}");
    let names = files(origin.path());
    assert_eq!(untouched.sound, names.len() - 1, "all but the manifest itself");
    let (mut tried, mut missed) = (0, Vec::new());
    for (index, file) in names.iter().enumerate() {
        let inside = file.strip_prefix(origin.path()).unwrap();
        for (what, damage) in DAMAGES {
            let study = work.path().join(format!("{what}-{index}"));
            copied(origin.path(), &study);
            let other = names[(index + 1) % names.len()].strip_prefix(origin.path()).unwrap();
            if fs::read(study.join(inside)).unwrap() == fs::read(study.join(other)).unwrap() {
                continue;
            }
            damage(&study.join(inside), &study.join(other));
            tried += 1;
            let is_found = match verify(&study, all) {
                Ok(found) => {
                    found.findings.iter().any(|finding| Path::new(finding.path()) == inside)
                        && !found.is_sound()
                }
                // of the manifest itself
                Err(
                    StoreError::NoManifest { .. }
                    | StoreError::ManifestDamaged { .. }
                    | StoreError::FileSystem { .. },
                ) => inside == Path::new("manifest.json"),
                Err(_) => false,
            };
            if !is_found {
                missed.push(format!("{what} of {}", inside.display()));
            }
        }
    }
    assert!(missed.is_empty() && tried > 80, "of {tried}: {missed:?}");
}

#[test]
fn what_is_not_listed_is_extra_or_unfinished() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    fs::write(folder.path().join("notes.txt"), "mine").unwrap();
    // no arrays of judder's
    let begun = folder.path().join("results.zarr/begun");
    fs::create_dir(&begun).unwrap();
    fs::write(begun.join("c"), "").unwrap();
    let found = verify(folder.path(), all).unwrap();
    let extra = |path: &str| Finding::Extra { path: path.to_owned(), of: None };
    assert_eq!(found.findings, [extra("notes.txt"), extra("results.zarr/begun/c")]);
    assert!(found.is_sound());
    // whoever begins such has said so before
    fs::write(begun.join("zarr.json"), GROUP).unwrap();
    StudyFolder::open(folder.path()).unwrap().consolidate().unwrap();
    let found = verify(folder.path(), all).unwrap();
    let unfinished = |path: &str| Finding::Unfinished { path: path.to_owned() };
    let [c, metadata] = ["results.zarr/begun/c", "results.zarr/begun/zarr.json"];
    assert_eq!(found.findings, [extra("notes.txt"), unfinished(c), unfinished(metadata)]);
    assert!(!found.is_sound());
}

/// Of what is handed on as it is read the size is compared before, the content until the last byte: however long it is, the first ones come at once.
#[test]
fn a_file_that_is_handed_on_is_compared_as_it_is_read() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    let (sound, reader) = (folder.path().join("sound.wav"), StudyReader::open(folder.path()).unwrap());
    let read = |content: &str| {
        fs::write(&sound, content).unwrap();
        let mut file = reader.open_file("sound.wav", "wav").unwrap();
        let (mut came, mut part) = (0, [0; 3]);
        loop {
            match file.read(&mut part) {
                Ok(0) => return (came, None),
                Ok(count) => came += count,
                Err(error) => return (came, Some(error.to_string())),
            }
        }
    };
    assert_eq!(read("RIFF"), (4, None));
    assert_eq!(read("RIFX"), (3, Some("its content is not what was written".to_owned())));
    fs::write(&sound, "RIFFS").unwrap();
    let refused = reader.open_file("sound.wav", "wav").unwrap_err();
    assert!(refused.to_string().contains("5 bytes, where 4 were written"), "{refused}");
}

#[test]
fn a_damaged_result_is_not_done_and_the_others_are() {
    let folder = tempfile::tempdir().unwrap();
    let summary = finished(folder.path());
    let damaged = |file: &str, content: &str| {
        let path = folder.path().join(file);
        let before = fs::read(&path).unwrap();
        fs::write(&path, content).unwrap();
        let study = StudyFolder::open(folder.path()).unwrap();
        let found: Vec<String> =
            study.damages(&study.read_summary().unwrap().unwrap()).unwrap().into_keys().collect();
        let vouched = study.vouch(&summary).is_ok();
        drop(study);
        fs::write(path, before).unwrap();
        (found, vouched)
    };
    assert_eq!(damaged("sound.wav", "RIFX"), (vec!["one".to_owned()], true));
    assert_eq!(damaged("other.csv", "x\n3\n"), (vec!["other".to_owned()], true));
    let text = fs::read_to_string(folder.path().join("summary.json")).unwrap();
    let other_number = text.replacen("\"peak\": 5", "\"peak\": 6", 1);
    assert_ne!(other_number, text);
    assert_eq!(damaged("summary.json", &other_number), (vec!["other".to_owned()], false));
    let other_check = text.replacen("\"figure\": 1.0", "\"figure\": 0.0", 1);
    assert_ne!(other_check, text);
    assert_eq!(damaged("summary.json", &other_check), (vec!["one".to_owned()], false));
}

#[test]
fn a_run_that_is_killed_leaves_a_list_of_which_every_entry_is_true() {
    let folder = tempfile::tempdir().unwrap();
    let summary = finished(folder.path());
    let study = StudyFolder::open(folder.path()).unwrap();
    study.begin_results(&["one"]).unwrap();
    study.write_dataset("one", "h", &crate::constant(3.0, 40)).unwrap();
    study.write_summary(&summary, Some("one")).unwrap();
    drop(study); // killed before the list was written
    let found = verify(folder.path(), all).unwrap();
    assert!(!found.is_complete);
    let is_open = |finding: &Finding| matches!(finding, Finding::Unfinished { .. } | Finding::Extra { .. });
    assert!(found.findings.iter().all(is_open), "{found:?}");
    let study = StudyFolder::open(folder.path()).unwrap();
    assert!(!study.is_done("one", "h").unwrap() && study.is_done("other", "h").unwrap());
    assert!(matches!(study.vouch(&summary), Err(StoreError::NotListed { name, .. }) if name == "one"));
}

#[test]
fn damaged_arrays_are_refused_where_they_are_read() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    let chunk = files(folder.path()).into_iter().find(|path| path.ends_with("one/value/c/0")).unwrap();
    // a whole chunk of another array, which has its own checksum
    fs::copy(folder.path().join("results.zarr/other/value/c/0"), &chunk).unwrap();
    let read = StudyFolder::open(folder.path()).unwrap().read_dataset("one");
    assert!(matches!(read, Err(StoreError::Damaged { .. })), "{read:?}");
    let reader = StudyReader::open(folder.path()).unwrap();
    let read = reader.read_rows("one", "value", 0..2);
    assert!(matches!(read, Err(StoreError::Damaged { .. })), "{read:?}");
    reader.read_rows("other", "value", 0..2).unwrap();
    let _: Variable = reader.head("one").unwrap().variables.remove(0);
}

#[cfg(unix)]
#[test]
fn links_pipes_and_devices_are_refused_as_what_they_are() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    let place = folder.path().join("summary.json");
    fs::remove_file(&place).unwrap();
    std::os::unix::fs::symlink("/dev/zero", &place).unwrap();
    let found = verify(folder.path(), all).unwrap();
    let damage = FileDamage::Other("a link");
    assert!(
        matches!(&found.findings[..], [Finding::Damaged { damage: own, .. }] if *own == damage),
        "{found:?}"
    );
    let refused = StudyFolder::open(folder.path()).unwrap().read_summary().unwrap_err().to_string();
    assert!(refused.contains("a link stands in its place"), "{refused}");
}

#[test]
fn files_that_are_drawn_anew_cost_one_write_of_the_list() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    let list = || fs::read_to_string(folder.path().join("manifest.json")).unwrap();
    let study = StudyFolder::open(folder.path()).unwrap();
    study.write_file("figures/other.svg", b"<svg/>").unwrap();
    study.seal_as_before(BUILD).unwrap();
    assert!(list().contains("figures/one.svg") && list().contains("figures/other.svg"));
    study.begin_files(|path| path.starts_with("figures/")).unwrap();
    let begun = list();
    assert!(!begun.contains("figures/"), "{begun}");
    study.write_file("figures/one.svg", b"<svg />").unwrap();
    study.write_file("figures/other.svg", b"<svg />").unwrap();
    assert_eq!(list(), begun);
    study.seal_as_before(BUILD).unwrap();
    assert!(verify(folder.path(), all).unwrap().is_sound());
}

#[test]
fn a_finished_study_is_taken_up_again_with_one_write_of_the_list() {
    let folder = tempfile::tempdir().unwrap();
    let summary = finished(folder.path());
    let list = || fs::read_to_string(folder.path().join("manifest.json")).unwrap();
    let study = StudyFolder::open(folder.path()).unwrap();
    study.begin_results(&[]).unwrap();
    let begun = list();
    assert!(!begun.contains("summary.json") && begun.contains("one.csv"), "{begun}");
    study.write_summary(&summary, None).unwrap();
    study.keep_manifest(BUILD).unwrap();
    assert_eq!(list(), begun);
}

/// What a finished study lists of a result that its summary no longer has is of an earlier case: named, no damage whatever became of it.
#[test]
fn what_an_earlier_case_has_left_is_extra() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    let study = StudyFolder::open(folder.path()).unwrap();
    study.write_summary(&summary(&["one"]), None).unwrap();
    study.seal(BUILD).unwrap();
    drop(study);
    let left = |found: &[Finding]| -> Vec<String> {
        let of_other = |finding: &Finding| finding.kind() == "extra" && finding.of() == Some("other");
        assert!(found.iter().all(of_other), "{found:?}");
        found.iter().map(|finding| finding.path().to_owned()).collect()
    };
    let found = verify(folder.path(), all).unwrap();
    let paths = left(&found.findings);
    assert!(found.is_sound() && paths.contains(&"other.csv".to_owned()), "{found:?}");
    assert!(paths.iter().any(|path| path.starts_with("results.zarr/other/value/c/")), "{paths:?}");
    fs::write(folder.path().join("other.csv"), "mine").unwrap();
    fs::remove_dir_all(folder.path().join("results.zarr/other/value")).unwrap();
    let now = verify(folder.path(), all).unwrap();
    assert!(left(&now.findings).len() < paths.len(), "{now:?}");
}

#[test]
fn files_that_came_by_other_ways_are_listed() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    fs::create_dir(folder.path().join("inputs")).unwrap();
    fs::write(folder.path().join("inputs/mass.npz"), "m").unwrap();
    let study = StudyFolder::open(folder.path()).unwrap();
    study.list_files("inputs").unwrap();
    assert!(matches!(study.list_files("results.zarr"), Err(StoreError::OutsideFolder { .. })));
    study.seal_as_before(BUILD).unwrap();
    let found = verify(folder.path(), all).unwrap();
    assert!(found.is_sound() && found.findings.is_empty(), "{found:?}");
    fs::write(folder.path().join("inputs/mass.npz"), "n").unwrap();
    assert!(!verify(folder.path(), all).unwrap().is_sound());
}

#[test]
fn what_was_sound_and_is_as_it_was_is_not_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let summary = finished(folder.path());
    let table = folder.path().join("one.csv");
    let (content, time) = (fs::read(&table).unwrap(), fs::metadata(&table).unwrap().modified().unwrap());
    let study = StudyFolder::open(folder.path()).unwrap();
    assert!(study.damages(&summary).unwrap().is_empty());
    let sound = study.sound_files();
    drop(study);
    let other: Vec<u8> = content.iter().map(|byte| byte ^ 1).collect();
    let damages = |time| {
        fs::write(&table, &other).unwrap();
        fs::File::options().write(true).open(&table).unwrap().set_modified(time).unwrap();
        let study = StudyFolder::open(folder.path()).unwrap();
        study.trust(sound.clone());
        study.damages(&summary).unwrap().len()
    };
    assert_eq!(damages(time), 0, "by its stamp it is not read");
    assert_eq!(damages(time + std::time::Duration::from_secs(1)), 1);
}

/// What a killed run has left of results that the case no longer has is of an earlier case, too; what it has of those of the case is unfinished.
#[test]
fn what_a_killed_run_has_left_of_an_earlier_case_is_extra() {
    let folder = tempfile::tempdir().unwrap();
    finished(folder.path());
    let group = folder.path().join("results.zarr/begun/c");
    fs::create_dir_all(&group).unwrap();
    fs::write(group.join("0"), "half").unwrap();
    fs::write(folder.path().join("results.zarr/begun/zarr.json"), GROUP).unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    for name in ["begun", "stopped", "gone"] {
        study.scratch(name, "h").unwrap().keep("line").unwrap();
    }
    let grows = Variable::new("time", &["time"], &[0], Vec::<f64>::new());
    drop(StreamWriter::open(&study, "gone", "h", &[grows]).unwrap());
    assert_eq!(study.list_left(&["one", "other", "stopped"]).unwrap(), ["begun", "gone"]);
    study.seal(BUILD).unwrap();
    let found = verify(folder.path(), all).unwrap();
    let told: Vec<(&str, &str, Option<&str>)> =
        found.findings.iter().map(|own| (own.path(), own.kind(), own.of())).collect();
    let expected = [
        (".scratch-of-begun", "extra", Some("begun")),
        (".scratch-of-gone", "extra", Some("gone")),
        (".scratch-of-stopped", "unfinished", None),
        (".stream-gone/time.f64", "extra", Some("gone")),
        ("results.zarr/begun/c/0", "extra", Some("begun")),
        ("results.zarr/begun/zarr.json", "extra", Some("begun")),
    ];
    assert_eq!(told, expected);
    // a run says it once, and takes it up where the case has it again
    assert!(study.list_left(&["one", "other", "stopped"]).unwrap().is_empty());
    assert_eq!(study.scratch("begun", "h").unwrap().lines(), ["line"]);
    study.begin_results(&["begun"]).unwrap();
    study.scratch("begun", "h").unwrap().keep("another").unwrap();
    study.seal(BUILD).unwrap();
    let found = verify(folder.path(), all).unwrap();
    assert_eq!(found.findings[0].kind(), "unfinished", "{found:?}");
    study.forget(|_| false).unwrap();
    for left in [".scratch-of-gone", ".stream-gone", "results.zarr/begun"] {
        assert!(!folder.path().join(left).exists(), "{left}");
    }
}
