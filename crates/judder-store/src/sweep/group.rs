//! The group of a sweep in `results.zarr`, the same bytes whoever begins it.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Map, Value};

use super::layout::{SweepLayout, VALUES};
use super::shard;
use crate::group_store::{GroupStore, WrittenFiles};
use crate::metadata::{self, BUILD_ATTRIBUTE, HASH_ATTRIBUTE};
use crate::staging::{self, Stage};
use crate::zarr::{self, WriteFailure};
use crate::{StoreError, Variable, results};

/// How many folders the chunks of a sweep lie below their study.
pub(super) const DEPTH: usize = 3;

/// Begins the group of a sweep where there is none, else compares; returns the folder of its chunks.
pub(super) fn join(study: &Path, layout: &SweepLayout) -> Result<PathBuf, StoreError> {
    let group = place(study, layout);
    if !group.exists() && begin(study, layout).map_err(|failure| failed(&group, failure))? {
        return Ok(group.join(VALUES));
    }
    compared(&group, layout)
}

/// Compares the group of a sweep, where there is one; returns the folder of its chunks.
pub(super) fn look(study: &Path, layout: &SweepLayout) -> Result<Option<PathBuf>, StoreError> {
    let group = place(study, layout);
    if group.exists() { compared(&group, layout).map(Some) } else { Ok(None) }
}

fn place(study: &Path, layout: &SweepLayout) -> PathBuf {
    study.join(results::FOLDER).join(layout.name())
}

fn failed(group: &Path, failure: WriteFailure) -> StoreError {
    match failure {
        WriteFailure::Io(source) => StoreError::write(group, 0, source),
        WriteFailure::Refused(source) => StoreError::DatasetUnwritable { path: group.to_owned(), source },
    }
}

/// The folder of the chunks of a group that is of this sweep.
fn compared(group: &Path, layout: &SweepLayout) -> Result<PathBuf, StoreError> {
    let describe = |store: &_, variable: &Variable| {
        if variable.name == VALUES {
            zarr::array_metadata(&shard::build_array(store, layout, variable)?)
        } else {
            zarr::describe_variable(store, variable)
        }
    };
    let expected = zarr::group_store(group)
        .and_then(|store| zarr::describe_group_by(&store, layout.hash(), layout.dataset(), describe));
    compare(group, layout, &expected.map_err(|failure| failed(group, failure))?)?;
    Ok(group.join(VALUES))
}

/// Whether nothing says that a group lacks what frames its chunks: its metadata, which are the first to go and the last to come where it is mended.
pub(crate) fn has_frame(study: &Path, layout: &SweepLayout) -> Result<bool, StoreError> {
    let group = place(study, layout);
    match metadata::read(&group) {
        Ok(_) => Ok(true),
        Err(StoreError::DatasetUnreadable { .. } | StoreError::Oversized { .. }) => Ok(false),
        Err(StoreError::FileSystem { source, .. })
            if matches!(source.kind(), ErrorKind::NotFound | ErrorKind::InvalidInput) =>
        {
            Ok(!group.exists())
        }
        Err(error) => Err(error),
    }
}

/// Writes anew all of a group but for its chunks, which say themselves whose they are.
pub(crate) fn mend(study: &Path, layout: &SweepLayout) -> Result<(), StoreError> {
    let group = place(study, layout);
    let write = || -> Result<(), WriteFailure> {
        let stage = Stage::new(study)?;
        let staged = stage.place("group");
        write(&staged, layout)?;
        staging::sync_tree(&staged)?;
        judder_disk::create_folders(&group)?;
        let own = group.join(metadata::FILE);
        judder_disk::remove(&own)?;
        for entry in fs::read_dir(&staged)? {
            let name = entry?.file_name();
            let (from, to) = (staged.join(&name), group.join(&name));
            if name == VALUES {
                judder_disk::create_folders(&to)?;
                staging::put(&from.join(metadata::FILE), &to.join(metadata::FILE))?;
            } else if name != metadata::FILE {
                staging::put(&from, &to)?;
            }
        }
        Ok(staging::put(&staged.join(metadata::FILE), &own)?)
    };
    write().map_err(|failure| failed(&group, failure))
}

/// Makes the group; whether no other process was faster.
fn begin(study: &Path, layout: &SweepLayout) -> Result<bool, WriteFailure> {
    let stage = Stage::new(study)?;
    let staged = stage.place("group");
    write(&staged, layout)?;
    Ok(results::add(&stage, &staged, study, layout.name())?)
}

/// Writes the group without a chunk.
fn write(staged: &Path, layout: &SweepLayout) -> Result<(), WriteFailure> {
    let write = |store: &_, variable: &_| write_variable(layout, store, variable);
    zarr::write_group_by(staged, layout.hash(), layout.dataset(), write).map(drop)
}

/// The files of a group in a study but for its chunks, with size and hash; nothing is read or written.
pub(crate) fn frame(study: &Path, layout: &SweepLayout) -> Result<WrittenFiles, StoreError> {
    let group = place(study, layout);
    let write = |store: &_, variable: &_| write_variable(layout, store, variable);
    zarr::files_of_group_by(&group, layout.hash(), layout.dataset(), write)
        .map_err(|failure| failed(&group, failure))
}

/// Writes a variable, of the values of all points the metadata alone.
fn write_variable(
    layout: &SweepLayout,
    store: &Arc<GroupStore>,
    variable: &Variable,
) -> Result<Value, WriteFailure> {
    if variable.name == VALUES {
        let array = shard::build_array(store, layout, variable)?;
        zarr::store_metadata(&array)?;
        zarr::array_metadata(&array)
    } else {
        zarr::write_variable(store, variable)
    }
}

/// Refuses a group of another build, of another case, or of another layout.
fn compare(group: &Path, layout: &SweepLayout, expected: &Map<String, Value>) -> Result<(), StoreError> {
    let stands = metadata::read(group)?;
    if stands == *expected {
        return Ok(());
    }
    let path = group.to_owned();
    let of_group = |name| stands.get("attributes")?.get(name)?.as_str();
    let found = of_group(HASH_ATTRIBUTE).unwrap_or("none");
    if found == layout.hash() {
        return Err(StoreError::OtherLayout { path });
    }
    let expected = layout.dataset().attributes().get(BUILD_ATTRIBUTE).and_then(Value::as_str);
    match (expected, of_group(BUILD_ATTRIBUTE)) {
        (Some(expected), Some(found)) if expected != found => {
            let (expected, found) = (expected.to_owned(), found.to_owned());
            Err(StoreError::OtherBuild { path, expected, found })
        }
        _ => {
            let (expected, found) = (layout.hash().to_owned(), found.to_owned());
            Err(StoreError::ForeignSweep { path, expected, found })
        }
    }
}
