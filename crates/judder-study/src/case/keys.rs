//! What a case may say, as data: for programs that show keys, set them or vary them.

use crate::case::root::ANALYSIS;
use crate::registry::{ModelKind, Registry};
use judder_keys::declared::{Listed, listed};
use serde_json::{Value as Json, json};
use std::collections::BTreeSet;

/// Every key of the cases of a model by its dotted `path`, `*` for an item of a list or a name, with what [`Declaration::document`](judder_keys::declared::Declaration::document) tells of it; those
/// of analyses with the kind that they belong to, `analysis`; and whether the analyses can vary it, `varied`. `None` where there is no such model.
pub fn keys(registry: Registry, model: &str) -> Option<Json> {
    let model = registry.models().iter().find(|own| own.name == model)?;
    let varied = (model.swept)();
    let of_case = listed("", &(model.declared)());
    let of_case = of_case.iter().map(|key| {
        let mut json = document(key);
        json["varied"] = json!(varied.contains(&key.path.as_str()));
        json
    });
    Some(of_case.chain(of_analyses(model)).collect())
}

/// A key with its path.
fn document(Listed { path, key }: &Listed) -> Json {
    let mut json = key.document();
    json["path"] = json!(path);
    json
}

/// Those of each kind of analysis.
fn of_analyses(model: &ModelKind) -> impl Iterator<Item = Json> {
    (model.kinds)().into_iter().flat_map(move |kind| {
        let keys = listed(&format!("{ANALYSIS}.*."), &(kind.declared)());
        keys.into_iter().map(move |key| {
            let mut json = document(&key);
            json["analysis"] = json!(kind.name);
            json
        })
    })
}

/// The dotted paths of all numbers, with a unit or without, in a case of some model outside of its analyses.
pub fn number_paths(registry: Registry) -> BTreeSet<String> {
    let declared = registry.models().iter().flat_map(|model| listed("", &(model.declared)()));
    declared.filter(Listed::is_number).map(|own| own.path).collect()
}

/// Keys of the cases of a model that take one of a few words, among other things, outside of lists, names and analyses.
pub fn worded(registry: Registry, model: &str) -> Vec<Listed> {
    let declared = registry.models().iter().filter(|own| own.name == model).flat_map(|own| (own.declared)());
    let mut keys = listed("", &declared.collect::<Vec<_>>());
    keys.retain(|key| !key.path.contains('*') && !key.words().is_empty());
    keys
}

/// The names of all keys that name a file.
pub(crate) fn file_keys(registry: Registry) -> BTreeSet<&'static str> {
    let of_model = |model: &ModelKind| {
        let of_analyses = (model.kinds)().into_iter().flat_map(|kind| listed("", &(kind.declared)()));
        listed("", &(model.declared)()).into_iter().chain(of_analyses).collect::<Vec<_>>()
    };
    let declared = registry.models().iter().flat_map(|model| of_model(model));
    declared.filter(Listed::is_file).map(|own| own.key.name).collect()
}
