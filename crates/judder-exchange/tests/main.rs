//! Files of other programs, by the kind of evidence.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod malformed;
mod property;
mod validation;

use std::path::{Path, PathBuf};

/// A file of the folder of a kind of evidence.
fn file(place: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(place)
}
