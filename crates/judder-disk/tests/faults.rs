//! A file that is there whole or not at all, on a disk that fails at any call.

// a program without debug assertions knows no fault
#![cfg(debug_assertions)]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::env;
use std::fs;
use std::io;
use std::path::Path;
use std::process::{Command, Output};

use judder_disk::{FAULT_VARIABLE, write_whole};

/// Where the process that a test starts writes.
const PLACE: &str = "JUDDER_TEST_WRITTEN_FILE";

/// More than one write.
static NEW: [u8; 20_000] = [7; 20_000];

/// What the process does; nothing where nobody has started it for that.
#[test]
fn written() {
    if let Some(place) = env::var_os(PLACE) {
        let written: io::Result<()> =
            write_whole(Path::new(&place), |out| NEW.chunks(999).try_for_each(|part| out.write_all(part)));
        written.unwrap();
    }
}

fn written_by_another(place: &Path, fault: &str) -> Output {
    let mut process = Command::new(env::current_exe().unwrap());
    process.args(["--exact", "written", "--nocapture"]).env(PLACE, place).env(FAULT_VARIABLE, fault);
    process.output().unwrap()
}

#[test]
fn the_old_or_the_new_is_there_whichever_call_fails() {
    let mut struck = 0;
    for fault in ["full", "broken", "end"] {
        for call in 1.. {
            let folder = tempfile::tempdir().unwrap();
            let place = folder.path().join("file");
            fs::write(&place, "old").unwrap();
            let said = written_by_another(&place, &format!("{fault}@{call}"));
            let stderr = String::from_utf8_lossy(&said.stderr);
            if !stderr.contains("the disk fails") {
                assert!(said.status.success() && call > 5, "{stderr}");
                break;
            }
            struck += 1;
            let now = fs::read(&place).unwrap();
            let is_new = now == NEW;
            assert!(is_new || now == b"old", "{fault}@{call}: {} bytes", now.len());
            assert!(is_new || !said.status.success(), "{fault}@{call}: said to be done");
            assert!(written_by_another(&place, "").status.success());
            assert!(fs::read(&place).unwrap() == NEW, "{fault}@{call}");
        }
    }
    println!("{struck} calls were struck");
    assert!(struck > 20, "{struck}");
}
