//! Datasets come back as they were stored; what readers would misunderstand never gets in.

use std::fs;

use judder_store::{Complex64, Dataset, StoreError, StudyFolder, Variable, VariableValues};
use proptest::prelude::*;

fn stored(dataset: &Dataset) -> Dataset {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    study.write_dataset("analysis", "hash", dataset).unwrap();
    study.read_dataset("analysis").unwrap()
}

#[test]
fn every_kind_of_value_comes_back() {
    let complex = vec![Complex64::new(1.0, -2.0), Complex64::new(f64::INFINITY, 0.0)];
    let labels = vec!["ξ".to_owned(), String::new()];
    let dataset = Dataset::new()
        .attribute("title", "t")
        .unwrap()
        .with(Variable::coordinate("x", vec![1e-300, f64::MAX]).units("m/s").long_name("speed"))
        .unwrap()
        .with(Variable::new("eigenvalues", &["x"], &[2], complex))
        .unwrap()
        .with(Variable::new("label", &["x"], &[2], labels).as_coordinate())
        .unwrap()
        .with(Variable::new("count", &[], &[], vec![i64::MIN]).attribute("note", 3))
        .unwrap()
        .with(Variable::classes("verdict", &["y", "x"], &[1, 2], vec![0, 255], &[(0, "a b"), (255, "c")]))
        .unwrap()
        .with(Variable::new("roots", &["x", "root"], &[2, 0], Vec::<f64>::new()))
        .unwrap();
    let read = stored(&dataset);
    assert_eq!(read, dataset);
    assert_eq!(read.variable("verdict").unwrap().attributes["flag_meanings"], "a_b c");
}

#[test]
fn an_array_of_many_chunks_comes_back() {
    let (rows, columns) = (1201, 1999);
    let values: Vec<f64> = (0..rows * columns).map(|i| i as f64).collect();
    let dataset = Dataset::new().with(Variable::new("a", &["y", "x"], &[rows, columns], values)).unwrap();
    assert!(stored(&dataset) == dataset);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn any_bits_come_back(bits in proptest::collection::vec(any::<u64>(), 0..50), text in ".{0,20}") {
        let values: Vec<f64> = bits.iter().copied().map(f64::from_bits).collect();
        let dataset = Dataset::new()
            .with(Variable::new("a", &["x"], &[values.len()], values).long_name(&text)).unwrap()
            .with(Variable::new("b", &[], &[], vec![text])).unwrap();
        let read = stored(&dataset);
        let VariableValues::F64(values) = &read.variable("a").unwrap().data else { panic!("the kind changed") };
        prop_assert_eq!(values.iter().map(|value| value.to_bits()).collect::<Vec<_>>(), bits);
        prop_assert_eq!(&read.variable("b").unwrap().data, &dataset.variable("b").unwrap().data);
        prop_assert_eq!(&read.variable("a").unwrap().long_name, &dataset.variable("a").unwrap().long_name);
    }
}

#[test]
fn the_same_dataset_gives_the_same_bytes() {
    let bytes = |folder: &std::path::Path| {
        let study = StudyFolder::create(folder).unwrap();
        study.write_dataset("a", "h", &crate::constant(0.1, 3_000_000)).unwrap();
        let mut files = Vec::new();
        let mut left = vec![folder.join("results.zarr")];
        while let Some(place) = left.pop() {
            for name in crate::names(&place) {
                let entry = place.join(name);
                if entry.is_dir() { left.push(entry) } else { files.push(fs::read(entry).unwrap()) }
            }
        }
        files
    };
    let (one, other) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    assert!(bytes(one.path()) == bytes(other.path()));
}

#[test]
fn what_readers_would_misunderstand_is_refused() {
    let with =
        |variable| Dataset::new().with(Variable::coordinate("x", vec![1.0, 2.0])).unwrap().with(variable);
    let values = || vec![0.0; 2];
    let refused = with(Variable::new("a", &["x"], &[3], values())).unwrap_err();
    assert!(matches!(refused, StoreError::ShapeMismatch { found: 2, .. }), "{refused}");
    let refused = with(Variable::new("a", &["x", "y"], &[2], values())).unwrap_err();
    assert!(matches!(refused, StoreError::ShapeMismatch { .. }), "{refused}");
    let refused = with(Variable::new("a", &["y", "z"], &[usize::MAX, 2], values())).unwrap_err();
    assert!(matches!(refused, StoreError::ShapeMismatch { .. }), "{refused}");
    let refused = with(Variable::new("a", &["x"], &[1], vec![0.0])).unwrap_err();
    assert!(matches!(refused, StoreError::DimensionConflict { expected: 2, found: 1, .. }), "{refused}");
    let refused = with(Variable::new("x", &["x"], &[2], values())).unwrap_err();
    assert!(matches!(refused, StoreError::Duplicate { what: "variable", .. }), "{refused}");
    let refused = with(Variable::new("a", &["y", "y"], &[1, 2], values())).unwrap_err();
    assert!(matches!(refused, StoreError::Duplicate { what: "dimension", .. }), "{refused}");
    let refused = with(Variable::new("y", &["x"], &[2], values()))
        .unwrap()
        .with(Variable::new("b", &["y"], &[2], values()))
        .unwrap_err();
    assert!(matches!(&refused, StoreError::NotACoordinate { variable } if variable == "y"), "{refused}");
    let refused = with(Variable::new("a/b", &["x"], &[2], values())).unwrap_err();
    assert!(matches!(refused, StoreError::InvalidName { what: "a variable", .. }), "{refused}");
    let refused = with(Variable::new("a", &["x y"], &[2], values())).unwrap_err();
    assert!(matches!(refused, StoreError::InvalidName { what: "a dimension", .. }), "{refused}");
    let refused = with(Variable::new("a", &["x"], &[2], values()).attribute("scale_factor", 2)).unwrap_err();
    assert!(matches!(refused, StoreError::ReservedAttribute { .. }), "{refused}");
    let refused = with(Variable::new("a", &["x"], &[2], values()).units("seconds")).unwrap_err();
    assert!(matches!(refused, StoreError::DateUnits { .. }), "{refused}");
    assert!(Dataset::new().attribute("coordinates", "a").is_err());
}

#[test]
fn damage_is_an_error_and_not_a_result() {
    let folder = tempfile::tempdir().unwrap();
    // opened anew each time, without a manifest that would find it first
    let study = || StudyFolder::create(folder.path()).unwrap();
    let group = folder.path().join("results.zarr/a");
    let chunk = group.join("value/c/0");
    let write = || study().write_dataset("a", "h", &crate::constant(1.0, 8)).unwrap();
    let refused = || {
        let refused = study().read_dataset("a").unwrap_err();
        assert!(matches!(refused, StoreError::DatasetUnreadable { .. }), "{refused}");
        refused.to_string()
    };

    write();
    let mut content = fs::read(&chunk).unwrap();
    content[5] ^= 1;
    fs::write(&chunk, content).unwrap();
    refused();

    write();
    fs::remove_file(&chunk).unwrap();
    assert!(refused().contains("a part is missing"));

    write();
    let metadata = group.join("value/zarr.json");
    let huge = fs::read_to_string(&metadata).unwrap().replace('8', "1000000000000000000");
    fs::write(&metadata, huge).unwrap();
    refused();

    for damaged in ["{", "{}", "[]", "\u{0}"] {
        fs::write(group.join("zarr.json"), damaged).unwrap();
        refused();
    }
    assert!(!study().is_done("a", "h").unwrap());
    write();
    study().read_dataset("a").unwrap();
}
