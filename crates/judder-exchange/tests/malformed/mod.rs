//! Malformed files, one of each kind, with what is said about them.

mod matrices;
mod meshes;

use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// A file of this name with this content.
fn written(name: &str, content: impl AsRef<[u8]>) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, content).unwrap();
    (folder, path)
}
