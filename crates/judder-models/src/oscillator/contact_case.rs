//! The contact of an oscillator case as a case of its own.

use crate::REGISTRY;
use judder_keys::cause::Cause;
use judder_keys::edited;
use judder_keys::error::CaseError;
use judder_study::case::file::{CaseFile, given_error};
use judder_study::case::options::with_options;
use toml_edit::Item;

/// The contact case of an oscillator case with the options `set`: its substrate and its indenter, without analyses.
///
/// # Errors
/// Those of [`CaseFile::parse`] with these options; [`Cause::OtherModel`] of a case that is of no oscillator.
pub fn contact_case_of(name: &str, text: &str, set: &[String]) -> Result<CaseFile, CaseError> {
    const KEPT: [&str; 4] = ["title", "model", "substrate", "indenter"];
    let mut document = with_options(name, text, set)?;
    let model = document.get("model").and_then(Item::as_str).unwrap_or_default().to_owned();
    if model != "oscillator" {
        let cause = Cause::UnknownName { what: "model", name: model, known: vec!["oscillator".to_owned()] };
        return Err(CaseError::without_place(cause, name));
    }
    document.retain(|key, _| KEPT.contains(&key));
    let title = document.get("title").and_then(Item::as_str).map(|title| format!("{title}: its contact"));
    for (key, value) in [("title", title), ("model", Some("contact".to_owned()))] {
        if let Some(value) = value {
            edited::set(document.as_item_mut(), &[key], value.into());
        }
    }
    CaseFile::parse(REGISTRY, name, &document.to_string(), &[]).map_err(|composed| {
        let dropped = ["contact", "oscillator", "operation", "analysis", "sweep"];
        given_error(REGISTRY, name, text, set, &dropped).unwrap_or(composed)
    })
}
