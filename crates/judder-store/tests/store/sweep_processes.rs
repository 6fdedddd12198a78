//! Sweeps by many processes: killed, racing, on disks whose clock jumps. The bytes are those of one process that nothing disturbed.

use std::collections::BTreeMap;
use std::env;
use std::fs::{self, File, FileTimes, OpenOptions};
use std::io::Write;
use std::path::Path;
use std::process::{self, Child, Command, Stdio};
use std::thread;
use std::time::{Duration, SystemTime};

use judder_store::{ClaimAnswer, PointFailure, SweepLayout};

use crate::{chunk_values, contents, joined, sweep};

const CHILD_FOLDER: &str = "JUDDER_TEST_SWEEP_FOLDER";
/// 400 chunks, of 20 or 19 points.
fn layout() -> SweepLayout {
    sweep("h", &[("a", 80, 1), ("b", 99, 20)])
}

/// Works on the study in a folder until nothing is left to claim; writes down which chunks it claimed.
fn work(folder: &Path) {
    let layout = layout();
    let mut log = OpenOptions::new().create(true).append(true).open(folder.join("log")).unwrap();
    let study = joined(&folder.join("study"));
    let store = study.sweep(&layout).unwrap();
    for (chunk, _) in store.done_chunks().unwrap().iter().enumerate().filter(|(_, done)| !**done) {
        let ClaimAnswer::Claimed(claim) = store.claim(chunk).unwrap() else { continue };
        log.write_all(format!("{} {chunk}\n", process::id()).as_bytes()).unwrap();
        thread::sleep(Duration::from_millis(1));
        let failure = PointFailure { index: chunk % 4, reason: format!("point {chunk} diverged") };
        store.write(claim, &chunk_values(&layout, chunk), &[failure]).unwrap();
    }
    drop(store);
    drop(study.leave().unwrap());
}

#[test]
#[ignore = "run and killed by the other tests"]
fn in_the_child() {
    if let Some(folder) = env::var_os(CHILD_FOLDER) {
        work(Path::new(&folder));
    }
}

fn child(folder: &Path) -> Child {
    Command::new(env::current_exe().unwrap())
        .args(["--exact", "sweep_processes::in_the_child", "--ignored"])
        .env(CHILD_FOLDER, folder)
        .stdout(Stdio::null())
        .spawn()
        .unwrap()
}

fn ends_well(mut child: Child) {
    assert!(child.wait().unwrap().success());
}

/// The study as one process leaves it that nothing disturbs.
fn undisturbed() -> BTreeMap<String, Vec<u8>> {
    let folder = tempfile::tempdir().unwrap();
    work(folder.path());
    contents(&folder.path().join("study"))
}

/// Who claimed each chunk, in the order of time.
fn claims(folder: &Path) -> BTreeMap<usize, Vec<u32>> {
    let log = fs::read_to_string(folder.join("log")).unwrap();
    let mut claims = BTreeMap::<usize, Vec<u32>>::new();
    for line in log.lines() {
        let (process, chunk) = line.split_once(' ').unwrap();
        claims.entry(chunk.parse().unwrap()).or_default().push(process.parse().unwrap());
    }
    claims
}

/// The same pseudo-random numbers in every run, below `limit`.
struct Instants(u64);

impl Instants {
    fn next(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }
}

/// As a clock that jumps would have it.
fn move_times(folder: &Path, time: SystemTime) {
    // what another process makes or moves meanwhile may be gone by now
    let Ok(entries) = fs::read_dir(folder) else { return };
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.is_dir() {
            move_times(&path, time);
        } else {
            let times = FileTimes::new().set_modified(time).set_accessed(time);
            let _ = File::open(path).and_then(|file| file.set_times(times));
        }
    }
}

/// A chunk is claimed again only after the death of a process that held it, which held no other.
fn check_claims(folder: &Path, killed: &[u32]) {
    let mut lost = Vec::new();
    for (chunk, mut claimants) in claims(folder) {
        claimants.pop();
        for claimant in claimants {
            assert!(killed.contains(&claimant), "chunk {chunk} was computed twice");
            assert!(
                !lost.contains(&claimant),
                "{claimant} held several chunks, or its last one was not kept"
            );
            lost.push(claimant);
        }
    }
}

/// Starts children and kills them after pseudo-random times until one comes to the end.
fn until_done(folder: &Path, instants: &mut Instants) -> Vec<u32> {
    let mut killed = Vec::new();
    loop {
        let mut child = child(folder);
        // a little more each time, for machines on which nothing happens in so short a time
        thread::sleep(Duration::from_micros(instants.next(40_000 + 500 * killed.len() as u64)));
        if child.try_wait().unwrap().is_some() {
            ends_well(child);
            return killed;
        }
        child.kill().unwrap();
        if child.wait().unwrap().success() {
            return killed;
        }
        killed.push(child.id());
        if killed.len() % 4 == 0 {
            let century = Duration::from_secs(100 * 365 * 86_400);
            let past = SystemTime::UNIX_EPOCH + Duration::from_secs(1);
            let time = if killed.len() % 8 == 0 { past } else { past + 2 * century };
            move_times(folder, time);
        }
    }
}

#[test]
fn kills_at_any_instant_change_no_byte() {
    let folder = tempfile::tempdir().unwrap();
    let killed = until_done(folder.path(), &mut Instants(7));
    assert!(killed.len() >= 20, "only {} kills", killed.len());
    assert_eq!(claims(folder.path()).len(), layout().chunk_count());
    check_claims(folder.path(), &killed);
    assert_eq!(contents(&folder.path().join("study")), undisturbed());
}

#[test]
fn racing_processes_share_the_work_and_change_no_byte() {
    let folder = tempfile::tempdir().unwrap();
    let children = [child(folder.path()), child(folder.path())];
    let ids = [children[0].id(), children[1].id()];
    children.into_iter().for_each(ends_well);
    let claims = claims(folder.path());
    assert_eq!(claims.len(), layout().chunk_count());
    assert!(claims.values().all(|claimants| claimants.len() == 1), "a chunk was computed twice");
    for id in ids {
        assert!(claims.values().any(|claimants| claimants[0] == id), "{id} did nothing");
    }
    assert_eq!(contents(&folder.path().join("study")), undisturbed());
}

#[test]
fn processes_that_are_killed_do_not_disturb_others() {
    let folder = tempfile::tempdir().unwrap();
    let undisturbed_one = child(folder.path());
    let killed = until_done(folder.path(), &mut Instants(11));
    ends_well(undisturbed_one);
    // what the last one killed held may still be to do
    ends_well(child(folder.path()));
    check_claims(folder.path(), &killed);
    assert_eq!(contents(&folder.path().join("study")), undisturbed());
}
