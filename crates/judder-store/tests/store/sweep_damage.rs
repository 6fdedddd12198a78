//! Chunks that are not as they were written: found, named, computed again or refused.

use std::fs;
use std::path::{Path, PathBuf};

use judder_store::{
    ChunkDamage, ChunkState, ClaimAnswer, SharedStudy, StoreError, StudyFolder, SweepChunks, SweepLayout,
    SweepStore,
};

use crate::{chunk_values, contents, sweep};

fn layout() -> SweepLayout {
    sweep("h", &[("sample", 10, 4)])
}

/// A sweep of three whole chunks, and where the one in the middle lies.
fn whole(folder: &Path) -> (SweepStore, PathBuf) {
    let store = SharedStudy::join(folder).unwrap().sweep(&layout()).unwrap();
    for chunk in 0..3 {
        compute(&store, chunk);
    }
    (store, folder.join("results.zarr/sweep/values/c.1.0"))
}

fn compute(store: &SweepStore, chunk: usize) {
    let ClaimAnswer::Claimed(claim) = store.claim(chunk).unwrap() else { panic!("chunk {chunk}") };
    store.write(claim, &chunk_values(store.layout(), chunk), &[]).unwrap();
}

/// The damage is found in every way of reading, and computing again repairs it.
fn check_found(store: &SweepStore, is_expected: impl Fn(&ChunkDamage) -> bool, what: &str) {
    let ChunkState::Damaged(damage) = store.state(1).unwrap() else { panic!("{what}: {:?}", store.state(1)) };
    assert!(is_expected(&damage), "{what}: {damage}");
    assert_eq!(store.verify().unwrap(), [(1, ChunkState::Damaged(damage))], "{what}");
    let refused = store.read(1).unwrap_err();
    assert!(matches!(refused, StoreError::DamagedChunk { .. }), "{what}: {refused}");
    assert!(refused.to_string().contains("c.1.0"), "{what}: {refused}");
}

#[test]
fn every_cut_is_found_and_repaired() {
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    let before = contents(&folder.path().join("results.zarr"));
    let content = fs::read(&path).unwrap();
    for length in 0..content.len() {
        fs::write(&path, &content[..length]).unwrap();
        check_found(&store, |damage| *damage == ChunkDamage::NoRecord, &format!("cut to {length} bytes"));
        assert!(matches!(store.failures(), Err(StoreError::DamagedChunk { .. })), "cut to {length} bytes");
    }
    assert_eq!(store.done_chunks().unwrap(), [true; 3], "a list does not look into files");
    compute(&store, 1);
    assert_eq!(contents(&folder.path().join("results.zarr")), before);
}

#[test]
fn every_changed_byte_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    let content = fs::read(&path).unwrap();
    for place in 0..content.len() {
        let mut damaged = content.clone();
        damaged[place] ^= 1;
        fs::write(&path, &damaged).unwrap();
        check_found(&store, |_| true, &format!("byte {place}"));
    }
    let longer = [&content[..], b"more"].concat();
    fs::write(&path, longer).unwrap();
    check_found(&store, |damage| *damage == ChunkDamage::NoRecord, "longer");
    let shifted = [b"more", &content[..]].concat();
    fs::write(&path, shifted).unwrap();
    check_found(&store, |damage| *damage == ChunkDamage::Values, "shifted");
    assert!(matches!(store.failures(), Err(StoreError::DamagedChunk { .. })));
}

#[test]
fn a_chunk_in_the_place_of_another_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    let before = contents(&folder.path().join("results.zarr"));
    fs::copy(path.with_file_name("c.0.0"), &path).unwrap();
    check_found(&store, |damage| *damage == ChunkDamage::OtherChunk { found: 0 }, "chunk 0");
    let shape = sweep("h", &[("sample", 10, 5)]).encode(1, &[0.0; 10], &[]).unwrap();
    fs::write(&path, shape).unwrap();
    check_found(&store, |damage| *damage == ChunkDamage::OtherShape { points: 5, quantities: 2 }, "5 points");
    compute(&store, 1);
    assert_eq!(contents(&folder.path().join("results.zarr")), before);
}

#[test]
fn a_chunk_of_another_case_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    let foreign = sweep("other", &[("sample", 10, 4)]).encode(1, &[0.0; 8], &[]).unwrap();
    fs::write(&path, &foreign).unwrap();
    let state = ChunkState::Foreign { hash: "other".to_owned() };
    assert_eq!(store.state(1).unwrap(), state);
    assert_eq!(store.verify().unwrap(), [(1, state)]);
    let own = store.layout().encode(1, &[0.0; 8], &[]).unwrap();
    for refused in [
        store.claim(1).map(drop).unwrap_err(),
        store.read(1).map(drop).unwrap_err(),
        store.failures().map(drop).unwrap_err(),
        store.write_encoded(1, &own).unwrap_err(),
    ] {
        assert!(
            matches!(&refused, StoreError::ForeignChunk { path: named, expected, found }
                if *named == path && expected == "h" && found == "other"),
            "{refused}"
        );
        assert!(refused.to_string().contains("--fresh"), "{refused}");
    }
    assert_eq!(fs::read(&path).unwrap(), foreign, "left as it is");
    fs::remove_file(&path).unwrap();
    compute(&store, 1);
}

#[test]
fn what_a_killed_writer_left_is_in_nobodys_way_and_goes_when_the_study_is_taken_alone() {
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    fs::remove_file(&path).unwrap();
    let claims = folder.path().join(".sweep-sweep");
    fs::write(claims.join("1.claim"), "").unwrap();
    fs::write(claims.join("1.killed.partial"), "half").unwrap();
    compute(&store, 1);
    assert_eq!(crate::names(&claims), ["1.killed.partial"]);
    drop(store);
    StudyFolder::create(folder.path()).unwrap();
    assert!(!claims.exists());
}

#[test]
fn who_believes_to_be_alone_and_clears_the_claims_stops_no_writer() {
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    fs::remove_file(&path).unwrap();
    let ClaimAnswer::Claimed(claim) = store.claim(1).unwrap() else { panic!("nobody else is here") };
    fs::remove_dir_all(folder.path().join(".sweep-sweep")).unwrap();
    store.write(claim, &chunk_values(store.layout(), 1), &[]).unwrap();
    assert!(matches!(store.state(1).unwrap(), ChunkState::Done { .. }));
}

#[test]
fn a_look_writes_nothing_and_takes_no_lock() {
    let folder = tempfile::tempdir().unwrap();
    assert!(SweepChunks::look(folder.path().join("none"), &layout()).unwrap().is_none());
    let (store, _) = whole(folder.path());
    let before = crate::names(folder.path());
    let looked = SweepChunks::look(folder.path(), &layout()).unwrap().unwrap();
    assert_eq!(looked.done_chunks().unwrap(), [true; 3]);
    drop(store);
    let alone = StudyFolder::create(folder.path()).unwrap();
    assert_eq!(
        looked.read(0).unwrap(),
        SweepChunks::look(folder.path(), &layout()).unwrap().unwrap().read(0).unwrap()
    );
    drop(alone);
    assert_eq!(
        crate::names(folder.path()),
        before.into_iter().filter(|name| !name.starts_with(".sweep-")).collect::<Vec<_>>()
    );
}

#[cfg(unix)]
#[test]
fn a_folder_that_became_read_only_is_named() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    fs::remove_file(&path).unwrap();
    let chunks = path.parent().unwrap();
    let mode = |mode| fs::set_permissions(chunks, fs::Permissions::from_mode(mode)).unwrap();
    mode(0o555);
    if fs::write(chunks.join("probe"), "").is_ok() {
        eprintln!("SKIPPED: this user may write everywhere");
        return;
    }
    let ClaimAnswer::Claimed(claim) = store.claim(1).unwrap() else { panic!() };
    let refused = store.write(claim, &chunk_values(store.layout(), 1), &[]).unwrap_err();
    assert!(matches!(&refused, StoreError::NotWritable { path: named, .. } if *named == path), "{refused}");
    mode(0o755);
    compute(&store, 1);
}

#[test]
fn a_folder_in_the_place_of_a_chunk_is_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let (store, place) = whole(folder.path());
    let before = fs::read(&place).unwrap();
    fs::remove_file(&place).unwrap();
    fs::create_dir_all(place.join("inside")).unwrap();
    check_found(&store, |damage| *damage == ChunkDamage::NoRecord, "a folder");
    compute(&store, 1);
    assert_eq!(fs::read(&place).unwrap(), before);
}

#[test]
fn a_frame_that_was_being_mended_when_a_run_was_killed_is_mended() {
    let folder = tempfile::tempdir().unwrap();
    drop(whole(folder.path()));
    let before = contents(&folder.path().join("results.zarr/sweep"));
    let mended = || {
        let study = StudyFolder::open(folder.path()).unwrap();
        study.mend_sweep(&layout()).unwrap()
    };
    assert!(!mended(), "nothing is wrong with it");
    for name in ["zarr.json", "values/zarr.json"] {
        fs::remove_file(folder.path().join("results.zarr/sweep").join(name)).unwrap();
    }
    assert!(mended());
    let after = contents(&folder.path().join("results.zarr/sweep"));
    assert_eq!(before, after);
}

#[cfg(unix)]
#[test]
fn a_link_to_a_whole_chunk_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let (store, path) = whole(folder.path());
    let before = contents(&folder.path().join("results.zarr"));
    let aside = tempfile::tempdir().unwrap();
    let chunk = aside.path().join("chunk");
    fs::rename(&path, &chunk).unwrap();
    std::os::unix::fs::symlink(&chunk, &path).unwrap();
    check_found(&store, |damage| *damage == ChunkDamage::NoRecord, "a link");
    compute(&store, 1);
    assert!(fs::symlink_metadata(&path).unwrap().is_file());
    assert_eq!(contents(&folder.path().join("results.zarr")), before);
}
