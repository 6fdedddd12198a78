//! What users have in hands and scripts rely on, frozen as it is: resolved cases and their hashes, results, the schema, messages.
//!
//! `JUDDER_GOLDEN=write` writes the files below `files/` anew; `JUDDER_GOLDEN=bytes` lets no bit of a number differ. Otherwise numbers may differ as
//! they do between processors, and nothing else may.

mod agreement;
mod cases;
mod declared;
mod file;
mod generated;
mod layout;
mod messages;
mod results;
mod snapshot;

use agreement::Numbers;
use std::path::{Path, PathBuf};

/// A path of the workspace; tests run in the folder of their crate, and messages keep relative paths.
fn workspace(path: &str) -> PathBuf {
    Path::new("../..").join(path)
}

/// The small cases: one of each kind of analysis of each model at least.
fn small_cases() -> PathBuf {
    workspace("crates/judder-models/tests/small")
}

/// The case files below a folder, by their sorted paths.
fn case_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = crate::desk::files_below(folder);
    files.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    files
}

#[test]
fn the_schema() {
    let schema = crate::desk::Desk::new().succeed(&["schema"]).json();
    file::check("schema.json", &schema, Numbers::Exact);
}
