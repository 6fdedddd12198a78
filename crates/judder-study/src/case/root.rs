//! What a case of any model has: a title, analyses and sweeps beside what its model declares.

use crate::case::analysis::Planned;
use judder_keys::declared::{Settings, both};
use judder_keys::document::Node;
use judder_keys::error::Fault;
use judder_keys::schema::object;
use judder_keys::section::Section;
use serde_json::{Map, Value as Json, json};

/// The keys of every case that no model declares.
pub const COMMON: [&str; 4] = [TITLE, MODEL, ANALYSIS, SWEEP];
pub(crate) const TITLE: &str = "title";
pub(crate) const MODEL: &str = "model";
pub(crate) const ANALYSIS: &str = "analysis";
pub(crate) const SWEEP: &str = "sweep";

/// The title of a case and what its model declares, or all that is wrong with them.
pub type Own<T> = Result<(String, T), Fault>;

/// The root of a case, and what it says beside its analyses.
///
/// # Errors
/// A root that is no table.
pub fn read_root<T: Settings>(node: &Node) -> Result<(Section<'_>, Own<T>), Fault> {
    let root = Section::of_case(node, T::TITLE.unwrap_or("the case"))?;
    let known = [vec![TITLE, MODEL], T::keys(), vec![ANALYSIS, SWEEP]].concat();
    let own = both(root.text(TITLE).map(|text| text.unwrap_or_default().to_owned()), T::read_table(&root));
    let own = both(root.refuse_others(&known), own).map(|((), own)| own);
    Ok((root, own))
}

/// A canonical form of model, title and analyses alone.
pub fn document<K>(
    model: &str,
    title: &str,
    analyses: &[Planned<K>],
    write: impl Fn(&K, &mut Map<String, Json>),
) -> Map<String, Json> {
    let written = |planned: &Planned<K>| {
        let mut json = Map::new();
        write(&planned.kind, &mut json);
        json.extend(object([("kind", json!(planned.kind_name)), ("name", json!(planned.name))]));
        Json::Object(json)
    };
    let analyses: Json = analyses.iter().map(written).collect();
    object([("model", json!(model)), ("title", json!(title)), ("analysis", analyses)])
}
