//! Options, written into the text of a case.

use crate::case::file::read_tree;
use judder_keys::cause::Cause;
use judder_keys::edited;
use judder_keys::error::{CaseError, Fault, Place, Sources};
use toml_edit::{DocumentMut, TomlError};

/// The text with the options written into it.
pub fn with_options(name: &str, text: &str, set: &[String]) -> Result<DocumentMut, CaseError> {
    let sources = Sources::new(name, text, set);
    // what cannot be set is refused by the tree, in the same words as ever
    read_tree(name, text, set).map_err(|fault| sources.error(fault))?;
    let mut document: DocumentMut = text.parse().map_err(|error| sources.error(syntax(&error)))?;
    for (index, option) in set.iter().enumerate() {
        edited::apply_option(document.as_item_mut(), index + 1, option)
            .map_err(|fault| sources.error(fault))?;
    }
    Ok(document)
}

/// What is wrong with a text that is no TOML.
pub(crate) fn syntax(error: &TomlError) -> Fault {
    let span = error.span().unwrap_or(0..0);
    let place = Place { source: 0, start: span.start, end: span.end };
    Cause::Syntax { message: error.message().to_owned() }.at(place)
}
