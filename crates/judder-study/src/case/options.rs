//! Options, written into the text of a case.

use crate::case::text::CaseText;
use judder_keys::cause::Cause;
use judder_keys::edited;
use judder_keys::error::{CaseError, Fault, Place};
use toml_edit::{DocumentMut, TomlError};

/// The text with the options written into it.
pub fn with_options(name: &str, text: &str, set: &[String]) -> Result<DocumentMut, CaseError> {
    let source = CaseText::new(name, text, set);
    // what cannot be set is refused by the tree, in the same words as ever
    source.tree().map_err(|fault| source.faulty(fault))?;
    let mut document: DocumentMut = text.parse().map_err(|error| source.faulty(syntax(&error)))?;
    for (index, option) in set.iter().enumerate() {
        edited::apply_option(document.as_item_mut(), index + 1, option)
            .map_err(|fault| source.faulty(fault))?;
    }
    Ok(document)
}

/// What is wrong with a text that is no TOML.
pub(crate) fn syntax(error: &TomlError) -> Fault {
    let span = error.span().unwrap_or(0..0);
    let place = Place { source: 0, start: span.start, end: span.end };
    Cause::Syntax { message: error.message().to_owned() }.at(place)
}
