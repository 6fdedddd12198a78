//! The canonical form of a substrate.

use super::{Substrate, SubstrateKeys};
use crate::oscillator::inputs::TimeForm;
use judder_keys::declared::Settings;
use serde_json::{Map, Value as Json, json};

/// How the relaxation was given, and what a substrate has beside its numeric keys.
pub(crate) fn substrate(substrate: &Substrate, time_form: TimeForm) -> Json {
    let given_as = substrate.source.key().unwrap_or(time_form.name());
    let mut json = Map::from_iter([("given_as".to_owned(), json!(given_as))]);
    SubstrateKeys::from(substrate).write_table(&mut json);
    Json::Object(json)
}
