//! A golden file: compared, or written anew.

use super::agreement::{self, Difference, Numbers};
use super::layout;
use serde_json::Value;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Differences that are shown; the rest is counted.
const SHOWN: usize = 12;

/// What is to be done with golden files.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    Compare,
    Bytes,
    Write,
}

impl Mode {
    fn of_environment() -> Self {
        match std::env::var("JUDDER_GOLDEN").as_deref() {
            Ok("write") => Self::Write,
            Ok("bytes") => Self::Bytes,
            Ok(other) => panic!("JUDDER_GOLDEN is `write` or `bytes`, not `{other}`"),
            Err(_) => Self::Compare,
        }
    }
}

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/main/golden/files").join(name)
}

/// The content of a golden file.
pub(super) fn read(name: &str) -> Value {
    let text =
        std::fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("golden file `{name}`: {error}"));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("golden file `{name}`: {error}"))
}

/// Compares what was found with the golden file of this name.
pub(super) fn check(name: &str, found: &Value, numbers: Numbers) {
    let difference = difference(name, found, numbers);
    assert!(difference.is_none(), "{}", difference.unwrap_or_default());
}

/// How what was found differs from the golden file of this name.
pub(super) fn difference(name: &str, found: &Value, numbers: Numbers) -> Option<String> {
    let mode = Mode::of_environment();
    if mode == Mode::Write {
        let path = path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, layout::text(found)).unwrap();
        return None;
    }
    let numbers = if mode == Mode::Bytes { Numbers::Exact } else { numbers };
    let differences = agreement::differences(&read(name), found, numbers);
    (!differences.is_empty()).then(|| told(name, &differences))
}

/// Where a golden file and what was found differ, and what to do about it.
fn told(name: &str, differences: &[Difference]) -> String {
    let mut text = format!("the golden file `{name}` differs in {} places\n", differences.len());
    for Difference { place, expected, found } in differences.iter().take(SHOWN) {
        writeln!(text, "  {place}\n    - {expected}\n    + {found}").unwrap();
    }
    text + "if all of it is meant: JUDDER_GOLDEN=write cargo nextest run --workspace -E 'test(/golden/)'"
}
