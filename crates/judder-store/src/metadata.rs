//! The metadata (`zarr.json`) of the groups of `results.zarr`.
//!
//! A group holds the metadata of its members inline, in the form that zarr-python calls consolidated: a reader opens
//! everything with one read, and `xarray` does so without a flag and without a warning.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use crate::{StoreError, plain};

/// The attribute that binds a dataset to the analysis that made it.
pub(crate) const HASH_ATTRIBUTE: &str = "judder_hash";

/// The attribute of a sweep that names the build that computes it.
pub(crate) const BUILD_ATTRIBUTE: &str = "judder_version";

/// The name of a metadata file.
pub(crate) const FILE: &str = "zarr.json";

const CONSOLIDATED: &str = "consolidated_metadata";

/// The metadata of a group; `members` holds that of everything below it, by path.
pub(crate) fn group(
    attributes: Map<String, Value>,
    members: Option<Map<String, Value>>,
) -> Map<String, Value> {
    let mut group = Map::new();
    group.insert("zarr_format".into(), json!(3));
    group.insert("node_type".into(), json!("group"));
    group.insert("attributes".into(), Value::Object(attributes));
    if let Some(members) = members {
        let inline = json!({ "kind": "inline", "must_understand": false, "metadata": members });
        group.insert(CONSOLIDATED.into(), inline);
    }
    group
}

/// The metadata of the root of the store, from its groups: name and folder.
///
/// # Errors
/// A group whose metadata cannot be read.
pub(crate) fn root(groups: &BTreeMap<String, PathBuf>) -> Result<Map<String, Value>, StoreError> {
    let mut members = Map::new();
    for (name, folder) in groups {
        let mut group = read(folder)?;
        let below = take_members(&mut group).unwrap_or_default();
        members.insert(name.clone(), Value::Object(group));
        members.extend(below.into_iter().map(|(member, metadata)| (format!("{name}/{member}"), metadata)));
    }
    Ok(group(Map::new(), Some(members)))
}

/// The metadata of the group or array in a folder.
pub(crate) fn read(folder: &Path) -> Result<Map<String, Value>, StoreError> {
    let path = folder.join(FILE);
    let content = plain::read_json(&path).map_err(|source| StoreError::read(&path, source))?;
    serde_json::from_slice(&content).map_err(|source| StoreError::unreadable(&path, source))
}

/// Takes the metadata of the members out of that of a group; `None` where it was never consolidated.
pub(crate) fn take_members(group: &mut Map<String, Value>) -> Option<Map<String, Value>> {
    let Value::Object(mut consolidated) = group.remove(CONSOLIDATED)? else { return None };
    take_object(&mut consolidated, "metadata")
}

/// Takes an object out of an object.
pub(crate) fn take_object(from: &mut Map<String, Value>, key: &str) -> Option<Map<String, Value>> {
    match from.remove(key)? {
        Value::Object(object) => Some(object),
        _ => None,
    }
}

/// Takes a text out of an object; empty where there is none.
pub(crate) fn take_text(from: &mut Map<String, Value>, key: &str) -> String {
    match from.remove(key) {
        Some(Value::String(text)) => text,
        _ => String::new(),
    }
}

/// The file content of metadata.
pub(crate) fn content(metadata: &Map<String, Value>) -> Vec<u8> {
    format!("{:#}\n", Value::Object(metadata.clone())).into_bytes()
}
