//! Studies that are looked at and not held: part by part, beside who holds them, and nothing outside.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;

use judder_memory::MemoryBudget;
use judder_store::{
    Dataset, LARGEST_DOCUMENT, StoreError, StudyFolder, StudyReader, Summary, Variable, VariableValues,
    verify,
};

/// A study with one long signal, a matrix, a scalar, labels and codes.
fn study(folder: &Path) -> StudyFolder {
    let study = StudyFolder::create(folder).unwrap();
    let time: Vec<f64> = (0..3_000_000).map(f64::from).collect();
    let signal: Vec<f64> = time.iter().map(|t| t.sin()).collect();
    let dataset = Dataset::new()
        .with(Variable::coordinate("time", time).units("s").long_name("time"))
        .and_then(|d| d.with(Variable::new("signal", &["time"], &[3_000_000], signal).units("m")))
        .and_then(|d| {
            d.with(Variable::new("matrix", &["row", "column"], &[3, 2], vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]))
        })
        .and_then(|d| d.with(Variable::new("scalar", &[], &[], vec![7.0])))
        .and_then(|d| {
            d.with(Variable::new("label", &["row"], &[3], ["a", "b", "c"].map(String::from).to_vec()))
        })
        .and_then(|d| {
            d.with(Variable::classes("code", &["row"], &[3], vec![0, 1, 0], &[(0, "no"), (1, "yes")]))
        })
        .and_then(|d| d.attribute("kind", "march"))
        .unwrap();
    study.write_dataset("march", "hash", &dataset).unwrap();
    study.write_summary(&Summary { case_hash: "c".into(), ..Summary::default() }, Some("a")).unwrap();
    study
}

#[test]
fn a_study_is_read_while_another_holds_it() {
    let folder = tempfile::tempdir().unwrap();
    let held = study(folder.path());
    let reader = StudyReader::open(folder.path()).unwrap();
    assert_eq!(reader.read_summary().unwrap(), held.read_summary().unwrap());
    assert_eq!(reader.names().unwrap(), ["march"]);
    let (head, whole) = (reader.head("march").unwrap(), held.read_dataset("march").unwrap());
    assert_eq!(&head.attributes, whole.attributes());
    assert_eq!(head.variables.len(), whole.variables().len());
    for (head, variable) in head.variables.iter().zip(whole.variables()) {
        assert!(
            head.data.is_empty()
                && std::mem::discriminant(&head.data) == std::mem::discriminant(&variable.data)
        );
        assert_eq!(&reader.read_rows("march", &head.name, 0..usize::MAX).unwrap().data, &variable.data);
        assert_eq!(head, &Variable { data: head.data.clone(), ..variable.clone() });
    }
}

#[test]
fn a_document_longer_than_any_is_refused_unread() {
    let folder = tempfile::tempdir().unwrap();
    drop(study(folder.path()));
    let long = |name: &str| {
        let path = folder.path().join(name);
        fs::File::create(&path).unwrap().set_len(3 << 30).unwrap();
        path
    };
    let refused = |of: &str, error: StoreError| match error {
        StoreError::Oversized { path, size, largest } => {
            assert!(
                path.ends_with(of) && size == 3 << 30 && largest == LARGEST_DOCUMENT,
                "{}",
                path.display()
            );
        }
        other => panic!("{of}: {other}"),
    };
    let reader = StudyReader::open(folder.path()).unwrap();
    let held = StudyFolder::open(folder.path()).unwrap();
    let of = "results.zarr/march/matrix/zarr.json";
    long(of);
    refused(of, reader.head("march").unwrap_err());
    refused(of, reader.read_rows("march", "matrix", 0..1).unwrap_err());
    refused(of, held.read_dataset("march").unwrap_err());
    let of = "results.zarr/march/zarr.json";
    long(of);
    refused(of, reader.head("march").unwrap_err());
    refused(of, held.read_attributes("march").unwrap_err());
    long("summary.json");
    refused("summary.json", reader.read_summary().unwrap_err());
    refused("summary.json", held.read_summary().unwrap_err());
    drop(held);
    long("manifest.json");
    refused("manifest.json", reader.is_complete().unwrap_err());
    refused("manifest.json", verify(folder.path(), |_, _| true).unwrap_err());
    assert!(!StudyFolder::open(folder.path()).unwrap().has_manifest(), "a run computes anew");
}

#[test]
fn rows_are_read_alone() {
    let folder = tempfile::tempdir().unwrap();
    let _held = study(folder.path());
    let reader = StudyReader::open(folder.path()).unwrap();
    let rows = reader.read_rows("march", "time", 1_499_999..1_500_002).unwrap();
    assert_eq!(rows.data, VariableValues::F64(vec![1_499_999.0, 1_500_000.0, 1_500_001.0]));
    assert_eq!(rows.shape, [3]);
    let rows = reader.read_rows("march", "matrix", 1..9).unwrap();
    assert_eq!((rows.data, rows.shape), (VariableValues::F64(vec![3.0, 4.0, 5.0, 6.0]), vec![2, 2]));
    let rows = reader.read_rows("march", "label", 2..3).unwrap();
    assert_eq!(rows.data, VariableValues::Text(vec!["c".to_owned()]));
    assert_eq!(reader.read_rows("march", "scalar", 5..6).unwrap().data, VariableValues::F64(vec![7.0]));
    for nothing in [3_000_000..3_000_001, 7..7, usize::MAX..usize::MAX] {
        assert!(reader.read_rows("march", "signal", nothing).unwrap().data.is_empty());
    }
    let part = reader.rows_of_a_file("march", "signal").unwrap();
    assert!((100_000..3_000_000).contains(&part), "{part}");
    assert!(matches!(reader.read_rows("march", "none", 0..1), Err(StoreError::NoDataset { .. })));
    assert!(matches!(reader.head("none"), Err(StoreError::NoDataset { .. })));
}

#[test]
fn rows_for_which_there_is_no_memory_are_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let _held = study(folder.path());
    let reader = StudyReader::open(folder.path()).unwrap();
    let all = MemoryBudget::of_process().ask(u128::MAX).unwrap_err().budget;
    // a part of ten megabytes, where the signal has 24
    let read = |rows| MemoryBudget::shared(all / 10_000_000, || reader.read_rows("march", "signal", rows));
    let refused = read(0..3_000_000).unwrap_err().to_string();
    assert!(refused.contains("of memory are needed"), "{refused}");
    assert_eq!(reader.read_rows("march", "signal", 0..3_000_000).unwrap().data.len(), 3_000_000);
}

#[test]
fn no_name_leads_out() {
    let folder = tempfile::tempdir().unwrap();
    let _held = study(&folder.path().join("study"));
    fs::write(folder.path().join("secret.wav"), "secret").unwrap();
    let reader = StudyReader::open(folder.path().join("study")).unwrap();
    for name in
        ["..", ".", "../study", "march/signal", "march/../march", "/etc", "", "a\0b", "..\\x", "%2e%2e"]
    {
        assert!(matches!(reader.head(name), Err(StoreError::InvalidName { .. })), "{name}");
        assert!(reader.read_rows("march", name, 0..1).is_err(), "{name}");
        assert!(reader.rows_of_a_file("march", name).is_err(), "{name}");
        assert!(matches!(reader.open_file(name, "wav"), Err(StoreError::OutsideFolder { .. })), "{name}");
    }
    for path in
        ["../secret.wav", "/etc/passwd", "summary.json", "results.zarr/zarr.json", "sub/../a.wav", "./a.wav"]
    {
        fs::write(folder.path().join("study/a.wav"), "sound").unwrap();
        assert!(matches!(reader.open_file(path, "wav"), Err(StoreError::OutsideFolder { .. })), "{path}");
    }
    assert_eq!(std::io::read_to_string(reader.open_file("a.wav", "wav").unwrap()).unwrap(), "sound");
}

#[test]
fn no_link_leads_out() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("study");
    let _held = study(&inside);
    let _other = study(&folder.path().join("other"));
    let theirs = folder.path().join("other/results.zarr/march");
    fs::write(folder.path().join("secret.wav"), "secret").unwrap();
    let reader = StudyReader::open(&inside).unwrap();
    let outside = |result: Result<(), StoreError>, what: &str| {
        assert!(matches!(result, Err(StoreError::OutsideFolder { .. })), "{what}: {result:?}");
    };
    // a whole group
    symlink(&theirs, inside.join("results.zarr/linked")).unwrap();
    assert_eq!(reader.names().unwrap(), ["march"]);
    outside(reader.head("linked").map(drop), "group");
    // one chunk, metadata of an array, metadata of a group, the summary
    let ours = inside.join("results.zarr/march");
    for (file, what) in [("matrix/c/0/0", "chunk"), ("matrix/zarr.json", "array"), ("zarr.json", "metadata")]
    {
        let before = fs::read(ours.join(file)).unwrap();
        fs::remove_file(ours.join(file)).unwrap();
        symlink(theirs.join(file), ours.join(file)).unwrap();
        outside(reader.read_rows("march", "matrix", 0..3).map(drop), what);
        fs::remove_file(ours.join(file)).unwrap();
        fs::write(ours.join(file), before).unwrap();
        reader.read_rows("march", "matrix", 0..3).unwrap();
    }
    fs::remove_file(inside.join("summary.json")).unwrap();
    symlink(folder.path().join("other/summary.json"), inside.join("summary.json")).unwrap();
    outside(reader.read_summary().map(drop), "summary");
    // sounds, and folders of them
    symlink(folder.path().join("secret.wav"), inside.join("secret.wav")).unwrap();
    symlink(folder.path(), inside.join("up")).unwrap();
    fs::create_dir_all(inside.join("sounds/loud/very/too")).unwrap();
    for place in
        ["a.wav", "sounds/b.wav", "sounds/loud/c.wav", "sounds/loud/very/too/deep.wav", "sounds/.hidden.wav"]
    {
        fs::write(inside.join(place), "sound").unwrap();
    }
    let listed: Vec<String> = reader.files("wav").unwrap().into_iter().map(|(path, _)| path).collect();
    assert_eq!(listed, ["a.wav", "sounds/b.wav", "sounds/loud/c.wav"]);
    outside(reader.open_file("secret.wav", "wav").map(drop), "sound");
    outside(reader.open_file("up/secret.wav", "wav").map(drop), "folder of sounds");
}

#[test]
fn what_is_no_study_is_not_looked_at() {
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(StudyReader::open(folder.path()), Err(StoreError::NoStudy { .. })));
    fs::write(folder.path().join("file"), "").unwrap();
    assert!(matches!(StudyReader::open(folder.path().join("file")), Err(StoreError::NotAFolder { .. })));
    let _held = study(&folder.path().join("study"));
    let reader = StudyReader::open(folder.path().join("study")).unwrap();
    let chunk = folder.path().join("study/results.zarr/march/matrix/c/0/0");
    fs::write(&chunk, "damaged").unwrap();
    assert!(matches!(reader.read_rows("march", "matrix", 0..3), Err(StoreError::DatasetUnreadable { .. })));
    fs::remove_file(&chunk).unwrap();
    assert!(matches!(reader.read_rows("march", "matrix", 0..3), Err(StoreError::DatasetUnreadable { .. })));
}
