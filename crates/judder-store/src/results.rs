//! `results.zarr`: the store of all analyses of a study, a group each.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde_json::{Map, Value};

use crate::group_store::WrittenFiles;
use crate::staging::{self, Stage};
use crate::zarr::{self, Elsewhere, WriteFailure};
use crate::{Dataset, StoreError, metadata, plain};

/// The name of the store in a study folder.
pub(crate) const FOLDER: &str = "results.zarr";

/// Writes the group of an analysis, in place of one of that name; gives back its files.
///
/// Everything is on the disk before anything that a reader sees changes. Then three renames: the root of the store
/// forgets its consolidated metadata, the group takes its place, the root learns the new metadata. So a reader never
/// meets metadata of one run with arrays of another, and a kill in between costs a reader some speed, no truth.
///
/// `publishing` is taken for the last part alone: the encoding runs on a pool of threads, of which one may meanwhile
/// come here with another dataset.
pub(crate) fn write(
    study: &Path,
    publishing: &Mutex<()>,
    analysis: &str,
    hash: &str,
    dataset: &Dataset,
    elsewhere: &Elsewhere,
) -> Result<WrittenFiles, StoreError> {
    let results = study.join(FOLDER);
    let target = results.join(analysis);
    let failed = |source| StoreError::write(&target, dataset.byte_count(), source);

    let stage = Stage::new(study).map_err(failed)?;
    let staged = stage.place("group");
    let written = zarr::write_group(&staged, hash, dataset, elsewhere).map_err(|failure| match failure {
        WriteFailure::Io(source) => failed(source),
        WriteFailure::Refused(source) => StoreError::DatasetUnwritable { path: target.clone(), source },
    })?;
    staging::sync_tree(&staged).map_err(failed)?;

    let _publishing = publishing.lock().unwrap_or_else(PoisonError::into_inner);
    let mut groups = groups(&results)?;
    groups.insert(analysis.to_owned(), staged.clone());
    let forgetful = metadata::group(Map::new(), None);
    let knowing = metadata::root(&groups)?;

    let publish = || -> io::Result<()> {
        let forgetful = stage.file("forgetful", &metadata::content(&forgetful))?;
        let knowing = stage.file("knowing", &metadata::content(&knowing))?;
        judder_disk::create_folders(&results)?;
        let root = results.join(metadata::FILE);
        staging::rename(&forgetful, &root)?;
        staging::replace_folder(&stage, &staged, &target)?;
        staging::rename(&knowing, &root)
    };
    publish().map_err(failed)?;
    let moved = |(path, listed): (PathBuf, _)| Some((target.join(path.strip_prefix(&staged).ok()?), listed));
    Ok(written.into_iter().filter_map(moved).collect())
}

/// Completes the metadata of the root where a killed run left them without those of the groups.
pub(crate) fn repair(study: &Path) -> Result<(), StoreError> {
    let results = study.join(FOLDER);
    let consolidated = |mut root: Map<String, Value>| metadata::take_members(&mut root).is_some();
    if !results.is_dir() || metadata::read(&results).is_ok_and(consolidated) {
        return Ok(());
    }
    consolidate(study)
}

/// Writes the metadata of the root from those of the groups, where they differ.
pub(crate) fn consolidate(study: &Path) -> Result<(), StoreError> {
    let results = study.join(FOLDER);
    if !results.is_dir() {
        return Ok(());
    }
    let root = derived(&results)?;
    let path = results.join(metadata::FILE);
    if !plain::is_link(&path)
        && plain::read_small_file(&path, root.len() as u64).is_ok_and(|stands| stands == root)
    {
        return Ok(());
    }
    staging::write_file(study, &path, &root)
}

/// The content of the metadata of the root, from those of the groups.
pub(crate) fn derived(results: &Path) -> Result<Vec<u8>, StoreError> {
    Ok(metadata::content(&metadata::root(&groups(results)?)?))
}

/// Puts a staged group where there is none yet, for several processes that may do so together; whether this one did.
///
/// The root of the store forgets its consolidated metadata first, which [`repair`] brings back: two that add groups of their own
/// cannot write them for both.
pub(crate) fn add(stage: &Stage, staged: &Path, study: &Path, name: &str) -> io::Result<bool> {
    let results = study.join(FOLDER);
    let target = results.join(name);
    staging::sync_tree(staged)?;
    judder_disk::create_folders(&results)?;
    let forgetful = stage.file("forgetful", &metadata::content(&metadata::group(Map::new(), None)))?;
    staging::rename(&forgetful, &results.join(metadata::FILE))?;
    match judder_disk::rename(staged, &target) {
        Ok(()) => judder_disk::sync_folder(&results).map(|()| true),
        Err(_) if target.exists() => Ok(false),
        Err(source) => Err(source),
    }
}

/// The sound groups of the store, by name; [`StoreError::Unreadable`] where whether one is sound is not known.
fn groups(results: &Path) -> Result<BTreeMap<String, PathBuf>, StoreError> {
    let entries = match fs::read_dir(results) {
        Ok(entries) => entries,
        Err(source) if source.kind() == io::ErrorKind::NotFound => return Ok(BTreeMap::new()),
        Err(source) => return Err(StoreError::read(results, source)),
    };
    let mut groups = BTreeMap::new();
    for entry in entries {
        let entry = entry.map_err(|source| StoreError::read(results, source))?;
        let folder = entry.path();
        let Ok(name) = entry.file_name().into_string() else { continue };
        if zarr::stored_hash(&folder).is_some() {
            groups.insert(name, folder);
        } else if let Some(reason) = unreadable(&folder.join(metadata::FILE)) {
            return Err(StoreError::Unreadable { path: folder.join(metadata::FILE), reason });
        }
    }
    Ok(groups)
}

/// Why a file cannot be read, where it may be there.
fn unreadable(path: &Path) -> Option<String> {
    use io::ErrorKind::{InvalidInput, NotADirectory, NotFound};
    let failure = plain::open(path).err()?;
    // it is not, or something else is
    (!matches!(failure.kind(), NotFound | NotADirectory | InvalidInput)).then(|| failure.to_string())
}
