//! Sweeps by one process: what is stored comes back, for this crate and for the array library, and claims are kept.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::Barrier;

use judder_store::{
    AnalysisRecord, ChunkClaim, ChunkState, ClaimAnswer, PointFailure, SharedStudy, Status, StoreError,
    StudyFolder, Summary, SweepDimension, SweepFailure, SweepLayout, SweepQuantity, SweepStore, Variable,
    VariableValues, verify,
};
use proptest::prelude::*;

use crate::{chunk_values, contents, joined, names, sweep};

/// The claim of a chunk that nobody has.
fn claimed(store: &SweepStore, chunk: usize) -> ChunkClaim {
    match store.claim(chunk).unwrap() {
        ClaimAnswer::Claimed(claim) => claim,
        other => panic!("chunk {chunk}: {other:?}"),
    }
}

fn write_all(store: &SweepStore) {
    for chunk in 0..store.layout().chunk_count() {
        store.write(claimed(store, chunk), &chunk_values(store.layout(), chunk), &[]).unwrap();
    }
}

#[test]
fn a_sweep_reads_back_as_one_array() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let layout = sweep("h", &[("a", 5, 2), ("b", 4, 4), ("c", 7, 3)])
        .with(Variable::coordinate("a", vec![0.0, 0.25, 0.5, 0.75, 1.0]).units("m/s"))
        .unwrap()
        .attribute("method", "grid")
        .unwrap();
    let store = study.sweep(&layout).unwrap();
    assert_eq!(store.done_chunks().unwrap(), [false; 9]);
    assert!(matches!(study.read_dataset("sweep"), Err(StoreError::DatasetUnreadable { .. })), "not done");
    let chosen = study.read_points("sweep", |_| vec![vec![0], vec![0], vec![0]]);
    assert!(matches!(chosen, Err(StoreError::DatasetUnreadable { .. })), "not done");
    assert!(matches!(study.read_points("none", |_| Vec::new()), Err(StoreError::NoDataset { .. })));
    write_all(&store);
    assert_eq!(store.done_chunks().unwrap(), [true; 9]);
    assert_eq!(store.verify().unwrap(), []);

    let dataset = study.read_dataset("sweep").unwrap();
    assert_eq!(dataset.variable("a").unwrap().units, "m/s");
    assert_eq!(dataset.attributes()["method"], "grid");
    let values = dataset.variable("values").unwrap();
    assert_eq!((&values.shape[..], &values.dimensions[3][..]), (&[5, 4, 7, 2][..], "quantity"));
    let VariableValues::F64(values) = &values.data else { panic!("{values:?}") };
    let mut pairs = values.as_chunks::<2>().0.iter();
    for (a, b, c) in (0..5).flat_map(|a| (0..4).flat_map(move |b| (0..7).map(move |c| (a, b, c)))) {
        let place = f64::from(a * 10_000 + b * 100 + c);
        assert_eq!(pairs.next().unwrap(), &[place.sin(), place]);
    }
    let texts = |name| match &dataset.variable(name).unwrap().data {
        VariableValues::Text(texts) => texts.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(texts("quantity"), ["growth_rate", "verdict"]);

    let chosen = study.read_points("sweep", |dimensions| {
        assert_eq!(dimensions, [("a".to_owned(), 5), ("b".to_owned(), 4), ("c".to_owned(), 7)]);
        vec![vec![4, 0, 5], vec![2], vec![0, 3, 6]]
    });
    let chosen = chosen.unwrap();
    assert_eq!(
        chosen.variable("a").unwrap().data,
        VariableValues::F64(vec![1.0, 0.0]),
        "in the order that was asked for"
    );
    let expected: Vec<f64> = [40_200.0, 40_203.0, 40_206.0, 200.0, 203.0, 206.0]
        .iter()
        .flat_map(|place: &f64| [place.sin(), *place])
        .collect();
    assert_eq!(chosen.variable("values").unwrap().data, VariableValues::F64(expected));
    assert_eq!(chosen.attributes(), dataset.attributes());
    assert_eq!(texts("quantity_units"), ["1/s", ""]);
    assert_eq!(texts("quantity_flag_values"), ["", "0 2"]);
    assert_eq!(texts("quantity_flag_meanings"), ["", "stable negative_damping"]);
    let group = names(&folder.path().join("results.zarr/sweep/values"));
    assert_eq!((group.len(), &group[8][..], &group[9][..]), (10, "c.2.0.2.0", "zarr.json"));
}

proptest! {
    // each makes a study, with all that is forced to the disk
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_values_come_back(
        lengths in prop::collection::vec((1_usize..5, 1_usize..6), 1..4),
        bits in prop::collection::vec(any::<u64>(), 128),
    ) {
        let folder = tempfile::tempdir().unwrap();
        let study = SharedStudy::join(folder.path()).unwrap();
        let names = ["a", "b", "c"];
        let dimensions: Vec<_> = lengths.iter().zip(names).map(|(&(length, chunk), name)| (name, length, chunk)).collect();
        let layout = sweep("h", &dimensions);
        let store = study.sweep(&layout).unwrap();
        let chunk = layout.chunk_count() - 1;
        let count = layout.points(chunk).unwrap().count() * 2;
        let values: Vec<f64> = bits.iter().take(count).map(|bits| f64::from_bits(*bits)).collect();
        store.write(claimed(&store, chunk), &values, &[]).unwrap();
        let read = store.read(chunk).unwrap().values;
        prop_assert_eq!(read.len(), values.len());
        for (read, written) in read.iter().zip(&values) {
            let expected = if written.is_nan() { 0x7ff8_0000_0000_0000 } else { written.to_bits() };
            prop_assert_eq!(read.to_bits(), expected);
        }
    }
}

#[test]
fn failures_stay_with_their_points() {
    let folder = tempfile::tempdir().unwrap();
    let study = SharedStudy::join(folder.path()).unwrap();
    let store = study.sweep(&sweep("h", &[("a", 4, 2), ("b", 5, 3)])).unwrap();
    let failure = |index, reason: &str| PointFailure { index, reason: reason.to_owned() };
    let values = [f64::NAN; 8];
    // 2 × 2 points at the end of both dimensions
    store.write(claimed(&store, 3), &values, &[failure(3, "no cycle: ξ > 1"), failure(0, "")]).unwrap();
    store.write(claimed(&store, 0), &[1.0; 12], &[failure(4, "diverged")]).unwrap();
    let read = store.read(3).unwrap();
    assert_eq!(read.failures, [failure(0, ""), failure(3, "no cycle: ξ > 1")]);
    assert!(read.values.iter().all(|value| value.is_nan()));
    let placed = |chunk, position: &[usize], reason: &str| SweepFailure {
        chunk,
        position: position.to_vec(),
        reason: reason.to_owned(),
    };
    let expected =
        [placed(0, &[1, 1], "diverged"), placed(3, &[2, 3], ""), placed(3, &[3, 4], "no cycle: ξ > 1")];
    assert_eq!(store.failures().unwrap(), expected);
    assert_eq!(store.state(3).unwrap(), ChunkState::Done { failures: 2 });
    assert_eq!(store.state(1).unwrap(), ChunkState::Missing);
}

#[test]
fn the_same_values_give_the_same_bytes() {
    let layout = sweep("h", &[("sample", 3000, 1000)]);
    let failures = [7, 3].map(|index| PointFailure { index, reason: "diverged".to_owned() });
    let values = chunk_values(&layout, 1);
    let encode = || layout.encode(1, &values, &failures).unwrap();
    let first = encode();
    std::thread::scope(|scope| {
        let others: Vec<_> = (0..4).map(|_| scope.spawn(encode)).collect();
        for other in others {
            assert_eq!(other.join().unwrap(), first);
        }
    });
    let not_a_number = |bits| layout.encode(1, &[f64::from_bits(bits); 2000], &[]).unwrap();
    assert_eq!(not_a_number(0x7ff8_0000_0000_0000), not_a_number(0xfff8_0000_0000_0001));
}

#[test]
fn a_claim_is_held_by_one() {
    let folder = tempfile::tempdir().unwrap();
    let study = SharedStudy::join(folder.path()).unwrap();
    let layout = sweep("h", &[("sample", 10, 5)]);
    let (one, other) = (study.sweep(&layout).unwrap(), study.sweep(&layout).unwrap());
    let claim = claimed(&one, 1);
    assert!(matches!(other.claim(1).unwrap(), ClaimAnswer::Busy));
    assert!(matches!(other.claim(0).unwrap(), ClaimAnswer::Claimed(_)), "another chunk");
    drop(claim);
    let claim = claimed(&other, 1);
    other.write(claim, &chunk_values(&layout, 1), &[]).unwrap();
    assert!(matches!(one.claim(1).unwrap(), ClaimAnswer::Done));
    assert!(matches!(one.claim(2), Err(StoreError::NoSuchChunk { count: 2, .. })));
    // what ended without a chunk leaves its file
    assert_eq!(names(&folder.path().join(".sweep-sweep")), ["0.claim"]);
}

#[test]
fn a_claim_ends_when_its_chunk_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let study = SharedStudy::join(folder.path()).unwrap();
    let store = study.sweep(&sweep("h", &[("sample", 10, 4)])).unwrap();
    let refused = store.write(claimed(&store, 2), &[1.0; 8], &[]).unwrap_err();
    assert!(matches!(refused, StoreError::ChunkSize { chunk: 2, expected: 4, found: 8, .. }), "{refused}");
    let outside = [PointFailure { index: 2, reason: String::new() }];
    let refused = store.write(claimed(&store, 2), &[1.0; 4], &outside).unwrap_err();
    assert!(matches!(refused, StoreError::FailureOutside { index: 2, points: 2, .. }), "{refused}");
    assert_eq!(store.done_chunks().unwrap(), [false; 3]);
    claimed(&store, 2);
}

#[test]
fn a_chunk_from_elsewhere_is_the_same_file() {
    let layout = sweep("h", &[("sample", 10, 4)]);
    let study = |folder: &Path| SharedStudy::join(folder).unwrap().sweep(&layout).unwrap();
    let (here, there) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let (written, sent) = (study(here.path()), study(there.path()));
    for chunk in 0..3 {
        let values = chunk_values(&layout, chunk);
        written.write(claimed(&written, chunk), &values, &[]).unwrap();
        let content = layout.encode(chunk, &values, &[]).unwrap();
        let refused = sent.write_encoded((chunk + 1) % 3, &content).unwrap_err();
        assert!(matches!(refused, StoreError::DamagedChunk { .. }), "{refused}");
        let refused = sent.write_encoded(chunk, &content[..content.len() - 1]).unwrap_err();
        assert!(matches!(refused, StoreError::DamagedChunk { .. }), "{refused}");
        sent.write_encoded(chunk, &content).unwrap();
        sent.write_encoded(chunk, &content).unwrap();
    }
    let results = |folder: &Path| contents(&folder.join("results.zarr"));
    assert_eq!(results(here.path()), results(there.path()));
    assert!(names(&there.path().join(".sweep-sweep")).is_empty());
    let other = sweep("other", &[("sample", 10, 4)]).encode(0, &[0.0; 8], &[]).unwrap();
    let refused = sent.write_encoded(0, &other).unwrap_err();
    assert!(matches!(&refused, StoreError::ForeignChunk { found, .. } if found == "other"), "{refused}");
}

#[test]
fn who_shares_keeps_ordinary_runs_out_and_the_last_to_leave_completes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("deep/study");
    let layout = sweep("h", &[("sample", 4, 4)]);
    let (one, other) = (SharedStudy::join(&path).unwrap(), SharedStudy::join(&path).unwrap());
    assert!(matches!(StudyFolder::create(&path), Err(StoreError::Locked { .. })));
    let store = other.sweep(&layout).unwrap();
    write_all(&store);
    let root = path.join("results.zarr/zarr.json");
    assert!(!fs::read_to_string(&root).unwrap().contains("consolidated_metadata"));
    assert!(one.leave().unwrap().is_none());
    let kept = store.clone();
    drop(store);
    assert!(other.leave().unwrap().is_none(), "a store of this process is at work");
    drop(kept);
    let last = SharedStudy::join(&path).unwrap();
    let alone = last.leave().unwrap().unwrap();
    assert!(matches!(SharedStudy::join(&path), Err(StoreError::Locked { .. })));
    assert!(fs::read_to_string(&root).unwrap().contains("sweep/values"));
    assert_eq!(names(&path), [".judder.lock", "results.zarr"]);

    drop(alone);
    assert_eq!(SharedStudy::join(&path).unwrap().path(), path);
}

#[test]
fn of_those_who_leave_together_one_completes() {
    let folder = tempfile::tempdir().unwrap();
    for _ in 0..200 {
        let together = Barrier::new(3);
        let leave = || {
            let study = joined(folder.path());
            together.wait();
            study.leave().unwrap().is_some()
        };
        let completed = std::thread::scope(|scope| {
            let threads: Vec<_> = (0..3).map(|_| scope.spawn(leave)).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).filter(|completed| *completed).count()
        });
        assert!(completed > 0);
    }
}

#[test]
fn whoever_begins_a_study_or_a_sweep_is_not_refused_by_another() {
    let layout = sweep("h", &[("sample", 4, 1)]);
    for _ in 0..20 {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("study");
        let begin = || SharedStudy::join(&path).unwrap().sweep(&layout).unwrap();
        std::thread::scope(|scope| {
            let threads: Vec<_> = (0..4).map(|_| scope.spawn(begin)).collect();
            for thread in threads {
                assert_eq!(thread.join().unwrap().done_chunks().unwrap(), [false; 4]);
            }
        });
    }
}

/// Ends a study of which `sweep` is done.
fn seal(study: &StudyFolder) {
    let record =
        AnalysisRecord { hash: "h".to_owned(), status: Status::Done, wall_time_s: 0.0, warnings: Vec::new() };
    let analyses = [("sweep".to_owned(), record)].into();
    study.write_summary(&Summary { analyses, ..Summary::default() }, Some("sweep")).unwrap();
    study.seal("build").unwrap();
}

#[test]
fn chunks_are_listed_as_they_were_read() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let layout = sweep("h", &[("sample", 40, 3)]);
    let store = study.sweep(&layout).unwrap();
    write_all(&store);
    let read = (0..14).map(|chunk| store.read_to_list(chunk).unwrap());
    let (content, files): (Vec<_>, Vec<_>) = read.unzip();
    assert_eq!(content[13], store.read(13).unwrap());
    study.list_sweep(&layout, files).unwrap();
    seal(&study);
    let found = verify(folder.path(), |_, _| true).unwrap();
    assert_eq!(found.findings, [], "all that is there is listed as it is");
    let list = fs::read_to_string(folder.path().join("manifest.json")).unwrap();
    assert_eq!(list.matches("values/c.").count(), 14);
}

/// What somebody else has laid among the files of a sweep is not judder's, whatever it is.
#[cfg(unix)]
#[test]
fn what_lies_among_the_files_of_a_sweep_is_not_listed() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let layout = sweep("h", &[("sample", 4, 2)]);
    let store = study.sweep(&layout).unwrap();
    write_all(&store);
    let group = folder.path().join("results.zarr/sweep");
    let others = ["notes.txt", "values/c.9.0", "values/link", "values/pipe", "quantity/c/1", "mine/file"];
    for other in &others[..2] {
        fs::write(group.join(other), "mine").unwrap();
    }
    std::os::unix::fs::symlink("/nowhere", group.join(others[2])).unwrap();
    assert!(Command::new("mkfifo").arg(group.join(others[3])).status().unwrap().success());
    fs::create_dir(group.join("mine")).unwrap();
    for other in &others[4..] {
        fs::write(group.join(other), "mine").unwrap();
    }
    let files = (0..2).map(|chunk| store.read_to_list(chunk).unwrap().1).collect();
    study.list_sweep(&layout, files).unwrap();
    seal(&study);
    let found = verify(folder.path(), |_, _| true).unwrap();
    let mut extra: Vec<&str> =
        found.findings.iter().map(|own| own.path().rsplit_once("sweep/").unwrap().1).collect();
    extra.sort_by_key(|path| others.iter().position(|other| other == path));
    assert_eq!(extra, others);
}

#[test]
fn another_case_and_another_layout_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let study = SharedStudy::join(folder.path()).unwrap();
    study.sweep(&sweep("h", &[("sample", 4, 2)])).unwrap();
    let before = contents(&folder.path().join("results.zarr"));
    let refused = study.sweep(&sweep("other", &[("sample", 4, 2)])).unwrap_err();
    assert!(
        matches!(&refused, StoreError::ForeignSweep { expected, found, .. } if expected == "other" && found == "h"),
        "{refused}"
    );
    assert!(refused.to_string().contains("--fresh"), "{refused}");
    let of_build = |name: &str, build| sweep(name, &[("sample", 4, 2)]).build(build).unwrap();
    let built = tempfile::tempdir().unwrap();
    let of_one = SharedStudy::join(built.path()).unwrap();
    of_one.sweep(&of_build("h", "0.1.0+a")).unwrap();
    let refused = of_one.sweep(&of_build("h of b", "0.1.0+b")).unwrap_err();
    let told = "holds a sweep that judder 0.1.0+a computes, and this is judder 0.1.0+b";
    assert!(refused.to_string().contains(told), "{refused}");
    let refused = of_one.sweep(&of_build("other", "0.1.0+a")).unwrap_err();
    assert!(matches!(refused, StoreError::ForeignSweep { .. }), "{refused}");
    let one_point_less = sweep("h", &[("sample", 3, 2)]);
    let other_chunks = sweep("h", &[("sample", 4, 1)]);
    let other_units = sweep("h", &[("sample", 4, 2)])
        .with(Variable::coordinate("sample", vec![0.0, 1.0, 2.0, 3.0]).units("m"))
        .unwrap();
    for layout in [one_point_less, other_chunks, other_units] {
        let refused = study.sweep(&layout).unwrap_err();
        assert!(matches!(&refused, StoreError::OtherLayout { .. }), "{refused}");
    }
    assert_eq!(contents(&folder.path().join("results.zarr")), before);
    study.leave().unwrap().unwrap().forget(|_| false).unwrap();
    assert_eq!(names(folder.path()), [".judder.lock"]);
    SharedStudy::join(folder.path()).unwrap().sweep(&sweep("other", &[("sample", 4, 2)])).unwrap();
}

#[test]
fn what_is_no_sweep_is_refused() {
    let dimension = |length, chunk| SweepDimension { name: "sample".to_owned(), length, chunk };
    let growth = || SweepQuantity::new("growth_rate", "1", "");
    let new =
        |name: &str, dimensions, quantities| SweepLayout::new(name, "h", dimensions, quantities).unwrap_err();
    for (dimensions, quantities) in [
        (vec![], vec![growth()]),
        (vec![dimension(1, 1)], vec![]),
        (vec![dimension(0, 1)], vec![growth()]),
        (vec![dimension(1, 0)], vec![growth()]),
    ] {
        assert!(matches!(new("s", dimensions, quantities), StoreError::EmptySweep { .. }));
    }
    for large in [dimension(usize::MAX, 1), dimension(1 << 28, 1 << 28)] {
        assert!(matches!(new("s", vec![large], vec![growth()]), StoreError::SweepTooLarge { .. }));
    }
    assert!(matches!(new("a/b", vec![dimension(1, 1)], vec![growth()]), StoreError::InvalidName { .. }));
    let twice = [dimension(1, 1), dimension(1, 1)].to_vec();
    assert!(matches!(new("s", twice, vec![growth()]), StoreError::Duplicate { what: "dimension", .. }));
    let twice = vec![growth(), growth()];
    assert!(matches!(new("s", vec![dimension(1, 1)], twice), StoreError::Duplicate { what: "quantity", .. }));
    let short = sweep("h", &[("sample", 4, 2)]).with(Variable::coordinate("sample", vec![1.0])).unwrap_err();
    assert!(matches!(short, StoreError::DimensionConflict { expected: 4, found: 1, .. }), "{short}");
}
