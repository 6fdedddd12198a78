//! The same case on another processor: what is stored does not depend on which code the system's C library chooses.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::desk::{CASE, Desk, files_below};

/// Takes from glibc what processors have had since 2011, as on an old one.
const WITHOUT_NEW_INSTRUCTIONS: &str = "glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX2,-AVX,-FMA,-FMA4";

/// Everything of a study but the three files that tell when and how long.
fn stored(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    files_below(folder)
        .into_iter()
        .filter(|path| path.is_file())
        .map(|path| (path.strip_prefix(folder).unwrap().to_owned(), fs::read(&path).unwrap()))
        .filter(|(path, _)| {
            !["summary.json", "manifest.json", "report.html"].iter().any(|own| path == Path::new(own))
        })
        .collect()
}

/// Whether the processor has what is taken away here: a program would be compared with itself else.
fn has_new_instructions() -> bool {
    #[cfg(all(target_arch = "x86_64", target_env = "gnu"))]
    let has = std::is_x86_feature_detected!("avx");
    #[cfg(not(all(target_arch = "x86_64", target_env = "gnu")))]
    let has = false;
    has
}

/// Runs a case with all of the C library and with the oldest part of it.
fn is_the_same(desk: &Desk, case: &str) {
    if !has_new_instructions() {
        eprintln!("SKIPPED, nothing is compared of {case}: there is no AVX that glibc could be kept from");
        return;
    }
    desk.succeed(&["run", case, "-o", "as-it-is"]);
    let old = desk
        .command(&["run", case, "-o", "old"])
        .env("GLIBC_TUNABLES", WITHOUT_NEW_INSTRUCTIONS)
        .output()
        .unwrap();
    assert!(old.status.success(), "{}", String::from_utf8_lossy(&old.stderr));
    let (ours, theirs) = (stored(&desk.path("as-it-is")), stored(&desk.path("old")));
    assert!(ours.len() > 10, "{case} left {} files", ours.len());
    assert!(ours.keys().eq(theirs.keys()), "{case}");
    let differ: Vec<&PathBuf> = ours.keys().filter(|path| ours[*path] != theirs[*path]).collect();
    assert!(differ.is_empty(), "{case}: {differ:?}");
    for folder in ["as-it-is", "old"] {
        fs::remove_dir_all(desk.path(folder)).unwrap();
    }
}

/// Runs cases of the project.
fn are_the_same(cases: &[&str]) {
    let desk = Desk::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    for case in cases {
        is_the_same(&desk, root.join(case).to_str().unwrap());
    }
}

#[test]
#[cfg_attr(not(all(target_arch = "x86_64", target_env = "gnu")), ignore = "needs glibc on x86-64")]
fn an_old_c_library_tells_the_same_of_an_oscillator() {
    is_the_same(&Desk::with_case(CASE), "case.toml");
}

#[test]
#[cfg_attr(not(all(target_arch = "x86_64", target_env = "gnu")), ignore = "needs glibc on x86-64")]
fn an_old_c_library_tells_the_same_of_small_cases() {
    are_the_same(&[
        "benchmarks/belt-in-si.toml",
        "benchmarks/damped-hopf.toml",
        "contact/sliding-sphere.toml",
    ]);
}

#[test]
#[ignore = "expensive: run by make validate"]
fn an_old_c_library_tells_the_same_of_all_kinds_but_those_with_fourier_transforms() {
    are_the_same(&[
        "assembly/mass-on-belt.toml",
        "assembly/mode-coupling.toml",
        "assembly/stop.toml",
        "benchmarks/belt-own-friction.toml",
        "benchmarks/belt.toml",
        "benchmarks/block.toml",
        "benchmarks/minimal-mode-coupling.toml",
        "benchmarks/ring.toml",
        "benchmarks/wang-knothe.toml",
        "contact/continuous-spectrum.toml",
        "contact/cylinder.toml",
        "contact/rough-surface.toml",
        "contact/two-retardation-times.toml",
        "sweeps/friction.toml",
        "sweeps/grid.toml",
        "sweeps/list.toml",
        "tutorials/first-map.toml",
        "tutorials/wiper.toml",
    ]);
}
