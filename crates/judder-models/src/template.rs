//! The commented case files that `judder new` prints, a file in the folder of each model; lines of numbers are made from what is declared.

use crate::REGISTRY;
use judder_keys::cause::Cause;
use judder_keys::error::CaseError;
use judder_study::registry::{ModelKind, Template};

/// The names of the templates; the first is the default of `judder new`.
#[must_use]
pub fn templates() -> Vec<&'static str> {
    REGISTRY.models().iter().map(|model| model.template.name).collect()
}

/// The commented case file of this name.
///
/// # Errors
/// [`Cause::UnknownTemplate`] names the known ones.
pub fn template(name: &str) -> Result<String, CaseError> {
    if let Some(model) = REGISTRY.models().iter().find(|model| model.template.name == name) {
        return Ok(filled(model));
    }
    let known = templates().into_iter().map(str::to_owned).collect();
    Err(CaseError::without_place(Cause::UnknownTemplate { name: name.to_owned(), known }, name))
}

fn filled(ModelKind { template, declared, .. }: &ModelKind) -> String {
    let Template { text, lines, .. } = template;
    let fill = |text: String, section: &str| text.replace(&format!("{{{section}}}\n"), &lines(section));
    declared().iter().fold((*text).to_owned(), |text, section| fill(text, section.name))
}
