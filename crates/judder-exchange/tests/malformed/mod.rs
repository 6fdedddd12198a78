//! Malformed files, one of each kind, with what is said about them.

mod matrices;
mod meshes;

use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A file of this name with this content.
fn written(name: &str, content: impl AsRef<[u8]>) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, content).unwrap();
    (folder, path)
}

/// The first bytes of a file, as many as each of these numbers says, one after the other.
fn each_cut(name: &str, whole: &[u8], lengths: impl Iterator<Item = usize>, check: impl Fn(usize, &Path)) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    for length in lengths {
        fs::write(&path, &whole[..length]).unwrap();
        check(length, &path);
    }
}
